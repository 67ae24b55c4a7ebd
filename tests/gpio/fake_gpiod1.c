/* fake_gpiod1.c -- replaces the functions of libgpiod 1.6 that gpio_lines1.c calls by functions
 * that use simulated chips. */
#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>
#include <string.h>

#include "tests/gpio/fake_board.h"

struct gpiod_line {
    struct fake_chip *chip;
    struct fake_line *of;
    /* True if this handle was used to request the line. */
    bool requested;
};

struct gpiod_chip {
    struct fake_chip *of;
    struct gpiod_line lines[FAKE_LINES];
};

struct gpiod_chip *gpiod_chip_open(const char *path)
{
    struct fake_chip *of = fake_chip_open(path);
    struct gpiod_chip *chip = of ? calloc(1, sizeof *chip) : NULL;
    if (chip) {
        chip->of = of;
    }
    return chip;
}

void gpiod_chip_close(struct gpiod_chip *chip)
{
    for (uint32_t i = 0; i < FAKE_LINES; i++) {
        if (chip->lines[i].requested) {
            fake_line_release(chip->lines[i].of);
        }
    }
    fake_chip_close(chip->of);
    free(chip);
}

const char *gpiod_chip_label(struct gpiod_chip *chip)
{
    return chip->of->label;
}

const char *gpiod_chip_name(struct gpiod_chip *chip)
{
    return chip->of->device;
}

unsigned int gpiod_chip_num_lines(struct gpiod_chip *chip)
{
    (void)chip;
    return FAKE_LINES;
}

struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *chip, unsigned int offset)
{
    if (offset >= FAKE_LINES) {
        errno = EINVAL;
        return NULL;
    }
    struct gpiod_line *line = &chip->lines[offset];
    line->chip = chip->of;
    line->of = &chip->of->lines[offset];
    return line;
}

struct gpiod_line *gpiod_chip_find_line(struct gpiod_chip *chip, const char *name)
{
    for (uint32_t i = 0; i < FAKE_LINES; i++) {
        const char *own = chip->of->lines[i].name;
        if (own && strcmp(own, name) == 0) {
            return gpiod_chip_get_line(chip, i);
        }
    }
    errno = ENOENT;
    return NULL;
}

const char *gpiod_line_name(struct gpiod_line *line)
{
    return line->of->name;
}

const char *gpiod_line_consumer(struct gpiod_line *line)
{
    return line->of->consumer;
}

bool gpiod_line_is_used(struct gpiod_line *line)
{
    return line->of->consumer || line->of->requested;
}

int gpiod_line_direction(struct gpiod_line *line)
{
    return line->of->is_output ? GPIOD_LINE_DIRECTION_OUTPUT : GPIOD_LINE_DIRECTION_INPUT;
}

int gpiod_line_active_state(struct gpiod_line *line)
{
    return line->of->active_low ? GPIOD_LINE_ACTIVE_STATE_LOW : GPIOD_LINE_ACTIVE_STATE_HIGH;
}

int gpiod_line_request(struct gpiod_line *line, const struct gpiod_line_request_config *config,
                       int default_val)
{
    struct fake_line *of = line->of;
    of->is_output = config->request_type == GPIOD_LINE_REQUEST_DIRECTION_OUTPUT;
    of->is_looked_at = config->request_type == GPIOD_LINE_REQUEST_DIRECTION_INPUT;
    if (fake_line_request(line->chip, of) != 0) {
        return -1;
    }
    line->requested = true;
    of->active_low = (config->flags & GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW) != 0;
    of->bias = config->flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP     ? GPIO_BIAS_UP
               : config->flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN ? GPIO_BIAS_DOWN
               : config->flags & GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE   ? GPIO_BIAS_OFF
                                                                        : GPIO_BIAS_AS_IS;
    of->value = of->is_output ? (uint8_t)default_val : of->value;
    return 0;
}

int gpiod_line_event_get_fd(struct gpiod_line *line)
{
    return line->of->pipe[0];
}

int gpiod_line_event_read_fd_multiple(int fd, struct gpiod_line_event *events,
                                      unsigned int num_events)
{
    struct fake_edge edges[16];
    struct fake_line *line = NULL;
    for (uint32_t i = 0; i < FAKE_CHIPS * FAKE_LINES; i++) {
        struct fake_line *other = &fake_chips[i / FAKE_LINES].lines[i % FAKE_LINES];
        if (other->requested && !other->is_output && !other->is_looked_at && other->pipe[0] == fd) {
            line = other;
        }
    }
    const int count = line ? fake_line_read(line, edges, num_events < 16 ? num_events : 16) : -1;
    for (int i = 0; i < count; i++) {
        events[i] = (struct gpiod_line_event){
            .ts = { .tv_sec = (time_t)(edges[i].time_ns / NS_PER_S),
                    .tv_nsec = (long)(edges[i].time_ns % NS_PER_S) },
            .event_type =
                edges[i].active ? GPIOD_LINE_EVENT_RISING_EDGE : GPIOD_LINE_EVENT_FALLING_EDGE,
        };
    }
    return count;
}

int gpiod_line_get_value(struct gpiod_line *line)
{
    errno = ENODEV;
    return line->chip->gone ? -1 : line->of->value;
}

int gpiod_line_set_value(struct gpiod_line *line, int value)
{
    errno = ENODEV;
    if (line->chip->gone) {
        return -1;
    }
    line->of->value = value != 0;
    return 0;
}

const char *gpiod_version_string(void)
{
    return "1.6.fake";
}
