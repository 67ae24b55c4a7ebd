/* gpio_lines1.c -- the backend for libgpiod 1.6, which uses the first version of the kernel's GPIO
 * interface.
 *
 * Each input line has its own file descriptor and a queue of 16 edges. When the queue is full, the
 * kernel drops further edges without a report, and edges have no sequence numbers. A loss is
 * therefore inferred if the queue was full and the next edge has the same direction as the edge
 * before it. */
#include <errno.h>
#include <gpiod.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_backend.h"

/* Number of edges that the kernel's queue of a line can hold (LINEEVENT in gpiolib-cdev.c). */
#define QUEUE_SIZE 16u

static struct held {
    /* Handle of the chip, or null if the line is not held. Each line opens its chip separately. */
    struct gpiod_chip *chip;
    struct gpiod_line *line;
    bool active;   /* True if the level after the last edge is active. */
    bool was_full; /* True if the last read found a full queue. */
} lines[GPIO_ROLE_COUNT];

/* ---- Requesting lines ----------------------------------------------------------------------- */

static void release_v1(enum gpio_role role)
{
    CORE_ASSERT(lines[role].chip);
    gpiod_chip_close(lines[role].chip); /* Closing the chip releases the line. */
    lines[role] = (struct held){ 0 };
}

static int find_v1(enum gpio_role role, const char *path, const struct gpio_wire *wire)
{
    struct held *held = &lines[role];
    CORE_ASSERT(role < GPIO_ROLE_COUNT && !held->chip);
    held->chip = gpiod_chip_open(path);
    if (!held->chip) {
        return -1;
    }
    if (!wire->chip[0] || strcmp(gpiod_chip_label(held->chip), wire->chip) == 0) {
        if (wire->name[0]) {
            held->line = gpiod_chip_find_line(held->chip, wire->name);
        } else if (wire->offset < gpiod_chip_num_lines(held->chip)) {
            held->line = gpiod_chip_get_line(held->chip, wire->offset);
        }
    }
    if (!held->line) {
        release_v1(role);
        return 0;
    }
    return 1;
}

static int request_v1(enum gpio_role role, const struct gpio_wire *wire, bool has_edges,
                      char consumer[GPIO_TEXT_SIZE])
{
    static const int bias_flags[] = {
        [GPIO_BIAS_AS_IS] = 0,
        [GPIO_BIAS_UP] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP,
        [GPIO_BIAS_DOWN] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
        [GPIO_BIAS_OFF] = GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE,
    };
    const struct gpiod_line_request_config config = {
        .consumer = "kingyo",
        .request_type = !gpio_role_is_input(role) ? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT
                        : has_edges               ? GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES
                                                  : GPIOD_LINE_REQUEST_DIRECTION_INPUT,
        .flags =
            bias_flags[wire->bias] | (wire->active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0),
    };
    struct held *held = &lines[role];
    CORE_ASSERT(held->line && wire->bias <= GPIO_BIAS_OFF);
    if (gpiod_line_request(held->line, &config, gpio_role_begins_active(role)) != 0) {
        const int error = errno;
        gpio_dev_text(consumer, gpiod_line_consumer(held->line));
        errno = error;
        return -1;
    }
    held->active = has_edges && gpiod_line_get_value(held->line) == 1;
    return has_edges ? gpiod_line_event_get_fd(held->line) : 0;
}

/* ---- Edges ---------------------------------------------------------------------------------- */

static int read_edges_v1(enum gpio_role role, struct gpio_edge *out, uint32_t max)
{
    struct gpiod_line_event events[QUEUE_SIZE];
    struct held *held = &lines[role];
    CORE_ASSERT(role < GPIO_INPUT_COUNT && held->line && max > 0);
    const uint32_t wanted = max < QUEUE_SIZE ? max : QUEUE_SIZE;
    const int count =
        gpiod_line_event_read_fd_multiple(gpiod_line_event_get_fd(held->line), events, wanted);
    for (int i = 0; i < count; i++) {
        const bool active = events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE;
        out[i] = (struct gpio_edge){
            .time_ns = (uint64_t)events[i].ts.tv_sec * NS_PER_S + (uint64_t)events[i].ts.tv_nsec,
            .role = (uint8_t)role,
            .active = active,
            .lost_before = held->was_full && active == held->active,
        };
        held->active = active;
        held->was_full = false;
    }
    held->was_full |= count == (int)QUEUE_SIZE;
    return count;
}

/* ---- Lines of a chip ------------------------------------------------------------------------ */

static uint32_t list_chip_lines_v1(const char *path,
                                   void (*report)(void *context, const struct gpio_line_info *line),
                                   void *context)
{
    struct gpiod_chip *chip = gpiod_chip_open(path);
    const uint32_t line_count = chip ? gpiod_chip_num_lines(chip) : 0u;
    uint32_t count = 0;
    for (uint32_t offset = 0; offset < line_count; offset++) {
        struct gpiod_line *line = gpiod_chip_get_line(chip, offset);
        if (!line) {
            continue;
        }
        struct gpio_line_info info = {
            .offset = offset,
            .used = gpiod_line_is_used(line),
            .is_output = gpiod_line_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT,
            .active_low = gpiod_line_active_state(line) == GPIOD_LINE_ACTIVE_STATE_LOW,
        };
        gpio_dev_text(info.device, gpiod_chip_name(chip));
        gpio_dev_text(info.chip, gpiod_chip_label(chip));
        gpio_dev_text(info.name, gpiod_line_name(line));
        gpio_dev_text(info.consumer, gpiod_line_consumer(line));
        report(context, &info);
        count++;
    }
    if (chip) {
        gpiod_chip_close(chip);
    }
    return count;
}

/* ---- Levels and the backend ----------------------------------------------------------------- */

static int get_v1(enum gpio_role role)
{
    return gpiod_line_get_value(lines[role].line);
}

static int set_v1(enum gpio_role role, bool active)
{
    CORE_ASSERT(!gpio_role_is_input(role));
    return gpiod_line_set_value(lines[role].line, active);
}

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_backend_ops ops = {
        .find = find_v1,
        .request = request_v1,
        .read_edges = read_edges_v1,
        .get = get_v1,
        .set = set_v1,
        .release = release_v1,
        .list_chip_lines = list_chip_lines_v1,
        .version = gpiod_version_string,
        .debounces = false, /* The first version of the kernel's GPIO interface cannot debounce. */
    };
    static struct gpio_backend backend;
    return gpio_backend_device(&backend, &ops);
}
