/* gpio_lines1.c -- lines through libgpiod 1.6, which speaks the kernel's first GPIO interface.
 *
 * There each input line has a descriptor and a queue of its own: 16 edges, and what comes when it
 * is full is dropped without a word. No edge has a number, so that a loss is inferred: a queue that
 * was found full, and behind it an edge in the direction that the line already had. */
#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <string.h>

#include "drivers/gpio_chips.h"
#include "drivers/gpio_dev.h"

#define QUEUE_SIZE 16u /* LINEEVENT's kfifo in gpiolib-cdev.c. */
#define NS_PER_S 1000000000ull

struct held {
    struct gpiod_chip *chip; /* Null: not held. Each line has its chip opened for itself. */
    struct gpiod_line *line;
    uint8_t active;          /* Where the last edge went. */
    uint8_t was_full;        /* The queue, when it was last read. */
};

static struct lines1 {
    struct held held[GPIO_ROLE_COUNT];
    int fds[GPIO_INPUT_COUNT]; /* -1: no such line. */
    struct gpio_dev_looks looks;
    uint8_t went;              /* A chip went away, which is still to be told. */
    char text[HAL_TEXT_SIZE];
} lines1;

/* ---- Finding -------------------------------------------------------------------------------- */

static struct gpiod_line *line_on(struct gpiod_chip *chip, const struct gpio_wire *wire)
{
    if (wire->chip[0] && strcmp(gpiod_chip_label(chip), wire->chip) != 0) {
        return NULL;
    }
    if (wire->name[0]) {
        return gpiod_chip_find_line(chip, wire->name);
    }
    return wire->offset < gpiod_chip_num_lines(chip) ? gpiod_chip_get_line(chip, wire->offset)
                                                     : NULL;
}

static bool find_line(const struct gpio_wire *wire, struct held *held, char why[HAL_TEXT_SIZE])
{
    struct gpio_dev_walk walk = { 0 };
    char denied[sizeof walk.path] = "";
    while (gpio_dev_next(&walk)) {
        held->chip = gpiod_chip_open(walk.path);
        if (!held->chip) {
            if (errno == EACCES || errno == EPERM) {
                memcpy(denied, walk.path, sizeof denied);
            }
            continue;
        }
        held->line = line_on(held->chip, wire);
        if (held->line) {
            gpio_dev_end(&walk);
            return true;
        }
        gpiod_chip_close(held->chip);
    }
    held->chip = NULL;
    gpio_dev_why_missing(why, wire, denied, walk.count);
    return false;
}

/* ---- Holding -------------------------------------------------------------------------------- */

static void let_go(struct lines1 *lines, enum gpio_role role)
{
    struct held *held = &lines->held[role];
    if (held->chip) {
        gpiod_chip_close(held->chip); /* Releases its line. */
    }
    *held = (struct held){ 0 };
    if (gpio_role_is_input(role)) {
        lines->fds[role] = -1;
        lines->looks.roles &= ~(1u << role);
    }
}

static int request(struct gpiod_line *line, const struct gpio_wire *wire, enum gpio_role role,
                   int type)
{
    static const int bias_flags[] = {
        [GPIO_BIAS_AS_IS] = 0,
        [GPIO_BIAS_UP] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP,
        [GPIO_BIAS_DOWN] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
        [GPIO_BIAS_OFF] = GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE,
    };
    const struct gpiod_line_request_config config = {
        .consumer = "kingyo",
        .request_type = type,
        .flags = bias_flags[wire->bias] |
                 (wire->active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0),
    };
    return gpiod_line_request(line, &config, gpio_role_begins_active(role));
}

static void hold(struct lines1 *lines, const struct gpio_wire *wire, enum gpio_role role,
                 char why[HAL_TEXT_SIZE])
{
    struct held *held = &lines->held[role];
    if (!find_line(wire, held, why)) {
        return;
    }
    const bool is_input = gpio_role_is_input(role);
    int failed = request(held->line, wire, role,
                         is_input ? GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES
                                  : GPIOD_LINE_REQUEST_DIRECTION_OUTPUT);
    if (!failed && is_input) {
        lines->fds[role] = gpiod_line_event_get_fd(held->line);
        held->active = gpiod_line_get_value(held->line) == 1;
    } else if (failed && is_input && gpio_dev_lacks_edges(errno)) {
        failed = request(held->line, wire, role, GPIOD_LINE_REQUEST_DIRECTION_INPUT);
        if (!failed) {
            gpio_dev_look_from_now(&lines->looks, role, gpiod_line_get_value(held->line));
        }
    }
    if (failed) {
        gpio_dev_why_refused(why, wire, errno, gpiod_line_consumer(held->line));
        let_go(lines, role);
    }
}

static int lines1_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                       char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    struct lines1 *lines = self;
    struct gpio_dev_walk walk = { 0 };
    uint32_t had = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        why[role][0] = '\0';
        if (wires[role].wired && !lines->held[role].chip) {
            hold(lines, &wires[role], role, why[role]);
        }
        had |= lines->held[role].chip ? 1u << role : 0u;
    }
    if (had == 0 && !gpio_dev_next(&walk)) {
        return HAL_ERR_NONE;
    }
    gpio_dev_end(&walk);
    return (int)had;
}

static void lines1_close(void *self)
{
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        let_go(self, role);
    }
}

/* ---- Edges ---------------------------------------------------------------------------------- */

static struct gpio_edge edge_of(struct held *held, enum gpio_role role,
                                const struct gpiod_line_event *event)
{
    const uint8_t active = event->event_type == GPIOD_LINE_EVENT_RISING_EDGE;
    const struct gpio_edge edge = {
        .time_ns = (uint64_t)event->ts.tv_sec * NS_PER_S + (uint64_t)event->ts.tv_nsec,
        .role = (uint8_t)role,
        .active = active,
        .lost_before = held->was_full && active == held->active,
    };
    held->active = active;
    held->was_full = 0;
    return edge;
}

/* How many edges came; -1: the chip is gone. */
static int read_edges(struct lines1 *lines, enum gpio_role role, struct gpio_edge *out,
                      uint32_t max)
{
    struct gpiod_line_event events[QUEUE_SIZE];
    struct held *held = &lines->held[role];
    const uint32_t wanted = max < QUEUE_SIZE ? max : QUEUE_SIZE;
    const int count = gpiod_line_event_read_fd_multiple(lines->fds[role], events, wanted);
    for (int i = 0; i < count; i++) {
        out[i] = edge_of(held, role, &events[i]);
    }
    held->was_full |= count == (int)QUEUE_SIZE;
    return count;
}

/* ---- Levels --------------------------------------------------------------------------------- */

/* What a call that failed means: the chip is gone, or this time went wrong. */
static int failed(struct lines1 *lines, enum gpio_role role)
{
    if (errno != ENODEV) {
        return HAL_ERR_IO;
    }
    let_go(lines, role);
    return HAL_ERR_GONE;
}

static int lines1_level(void *self, enum gpio_role role)
{
    struct lines1 *lines = self;
    if (!lines->held[role].chip) {
        return HAL_ERR_GONE;
    }
    const int level = gpiod_line_get_value(lines->held[role].line);
    return level < 0 ? failed(lines, role) : level;
}

static int lines1_set(void *self, enum gpio_role role, int active)
{
    struct lines1 *lines = self;
    if (!lines->held[role].chip) {
        return HAL_ERR_GONE;
    }
    return gpiod_line_set_value(lines->held[role].line, active != 0) == 0 ? HAL_OK
                                                                          : failed(lines, role);
}

/* The first interface has no word for it. */
static int lines1_debounces(void *self, enum gpio_role role)
{
    (void)self;
    (void)role;
    return 0;
}

/* ---- Waiting -------------------------------------------------------------------------------- */

/* A line without edges; 1: there was one nevertheless. */
static uint32_t look(struct lines1 *lines, enum gpio_role role, struct gpio_edge *out)
{
    const int level = lines1_level(lines, role);
    lines->went |= level == HAL_ERR_GONE;
    return gpio_dev_look(&lines->looks, role, level, out);
}

static int lines1_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    struct lines1 *lines = self;
    const struct gpio_dev_ready ready = gpio_dev_wait(
        lines->fds, lines->went ? 0 : gpio_dev_look_ms(&lines->looks, timeout_ms));
    uint32_t count = 0;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        if (lines->looks.roles & 1u << role && count < max) {
            count += look(lines, role, out + count);
            continue;
        }
        int taken = ready.gone & 1u << role ? -1 : 0;
        if (ready.readable & 1u << role && count < max) {
            taken = read_edges(lines, role, out + count, max - count);
        }
        if (taken < 0) {
            let_go(lines, role);
            lines->went = 1;
        }
        count += taken > 0 ? (uint32_t)taken : 0u;
    }
    if (lines->went && count == 0) { /* What the others said comes first. */
        lines->went = 0;
        return HAL_ERR_GONE;
    }
    return (int)count;
}

/* ---- The device ----------------------------------------------------------------------------- */

static int lines1_list(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                       void *context)
{
    (void)self;
    return gpio_chips_list(tell, context);
}

static const char *lines1_describe(void *self)
{
    struct lines1 *lines = self;
    snprintf(lines->text, sizeof lines->text, "libgpiod %s", gpiod_version_string());
    return lines->text;
}

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_lines_ops ops = {
        .open = lines1_open,
        .wait = lines1_wait,
        .level = lines1_level,
        .set = lines1_set,
        .debounces = lines1_debounces,
        .list = lines1_list,
        .close = lines1_close,
        .describe = lines1_describe,
    };
    lines1_close(&lines1); /* A fresh state: no descriptor is 0. */
    return (struct gpio_lines){ .ops = &ops, .self = &lines1 };
}
