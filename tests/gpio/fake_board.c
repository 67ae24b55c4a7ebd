/* fake_board.c -- simulated GPIO chips, lines and edge pipes. */
#include "tests/gpio/fake_board.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "drivers/gpio/gpio_backend.h"

struct fake_chip fake_chips[FAKE_CHIPS];

void fake_board_reset(void)
{
    static const struct fake_chip fresh[FAKE_CHIPS] = {
        { .device = "gpiochip0", .label = "soc", .lines = { [1] = { .name = "HDMI_HPD" } } },
        { .device = "gpiochip4",
          .label = "panel",
          .lines = { [0] = { .name = "BTN_START" },
                     [2] = { .name = "COIN" },
                     [3] = { .name = "LAMP" } } },
        { .device = "gpiochip11", .label = "door", .lines = { [5] = { .name = "DOOR" } } },
    };
    memcpy(fake_chips, fresh, sizeof fresh);
}

/* Replaces gpio_dev_next() by the linker option --wrap, so that the backends find the simulated
 * chips. */
bool __wrap_gpio_dev_next(struct gpio_dev_walk *walk);
void __wrap_gpio_dev_end(struct gpio_dev_walk *walk);

bool __wrap_gpio_dev_next(struct gpio_dev_walk *walk)
{
    static uint32_t next;
    next = walk->count == 0 ? 0 : next;
    while (next < FAKE_CHIPS && fake_chips[next].gone) {
        next++;
    }
    if (next == FAKE_CHIPS) {
        return false;
    }
    snprintf(walk->path, sizeof walk->path, "/dev/%s", fake_chips[next++].device);
    walk->count++;
    return true;
}

void __wrap_gpio_dev_end(struct gpio_dev_walk *walk)
{
    (void)walk;
}

struct fake_chip *fake_chip_open(const char *path)
{
    for (uint32_t i = 0; i < FAKE_CHIPS; i++) {
        struct fake_chip *chip = &fake_chips[i];
        if (strcmp(path + strlen("/dev/"), chip->device) == 0 && !chip->gone) {
            errno = EACCES;
            chip->opened += !chip->denied;
            return chip->denied ? NULL : chip;
        }
    }
    errno = ENOENT;
    return NULL;
}

void fake_chip_close(struct fake_chip *chip)
{
    assert(chip->opened > 0);
    chip->opened--;
}

int fake_line_request(struct fake_chip *chip, struct fake_line *line)
{
    errno = chip->gone                                                      ? ENODEV
            : line->refuses                                                 ? line->refuses
            : line->has_no_edges && !line->is_output && !line->is_looked_at ? ENXIO
            : line->consumer || line->requested                             ? EBUSY
                                                                            : 0;
    if (errno) {
        return -1;
    }
    line->requested = true;
    line->edges = 0;
    if (!line->is_output && !line->is_looked_at) {
        const int failed = pipe2(line->pipe, O_NONBLOCK);
        assert(!failed);
    }
    return 0;
}

void fake_line_release(struct fake_line *line)
{
    assert(line->requested);
    line->requested = false;
    if (!line->is_output && !line->is_looked_at) {
        close(line->pipe[0]);
        if (line->pipe[1] >= 0) {
            close(line->pipe[1]);
        }
    }
}

void fake_line_edge(struct fake_line *line, uint64_t time_ns, bool active, uint32_t lost)
{
    line->edges += 1u + lost;
    const struct fake_edge edge = { time_ns, line->edges, active };
    const ssize_t written = write(line->pipe[1], &edge, sizeof edge);
    assert(written == (ssize_t)sizeof edge);
    line->value = active;
}

int fake_line_read(struct fake_line *line, struct fake_edge *out, uint32_t max)
{
    int count = 0;
    ssize_t size = 0;
    while ((uint32_t)count < max &&
           (size = read(line->pipe[0], &out[count], sizeof *out)) == (ssize_t)sizeof *out) {
        count++;
    }
    if (count == 0 && size == 0) {
        errno = ENODEV;
        return -1;
    }
    return count;
}

void fake_chip_pull(struct fake_chip *chip)
{
    chip->gone = true;
    for (uint32_t i = 0; i < FAKE_LINES; i++) {
        struct fake_line *line = &chip->lines[i];
        if (line->requested && !line->is_output && !line->is_looked_at) {
            /* Closes the write end of the pipe. A thread that waits for the line then receives a
             * hang-up (POLLHUP). */
            close(line->pipe[1]);
            line->pipe[1] = -1;
        }
    }
}
