/* gpio_lines2.c -- lines through libgpiod 2.x, which speaks the kernel's second GPIO interface.
 *
 * Each line is a request of its own, so that each has a queue of its own and one that chatters
 * starves none. Edges are numbered: what the queue dropped is known. The kernel debounces. */
#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <string.h>

#include "drivers/gpio_chips.h"
#include "drivers/gpio_dev.h"

#define QUEUE_SIZE GPIO_EDGES_MAX /* Asked of the kernel, which gives 16 a line unasked. */

struct held {
    struct gpiod_line_request *request; /* Null: not held. */
    unsigned int offset;
    uint32_t seen;                      /* Number of the last edge that came; 0: none did. */
    uint8_t debounces;                  /* The kernel does. */
};

static struct lines2 {
    struct held held[GPIO_ROLE_COUNT];
    int fds[GPIO_INPUT_COUNT];              /* -1: no such line. */
    struct gpio_dev_looks looks;
    uint8_t went;                           /* A chip went away, which is still to be told. */
    struct gpiod_edge_event_buffer *buffer; /* Null: no room, and then no line is held. */
    char text[HAL_TEXT_SIZE];
} lines2;

/* ---- Finding -------------------------------------------------------------------------------- */

/* The wire's line on `chip`; -1: it is not there. */
static int offset_on(struct gpiod_chip *chip, const struct gpio_wire *wire)
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip);
    int offset = -1;
    if (!info) {
        return -1;
    }
    if (!wire->chip[0] || strcmp(gpiod_chip_info_get_label(info), wire->chip) == 0) {
        offset = wire->name[0] ? gpiod_chip_get_line_offset_from_name(chip, wire->name)
                 : wire->offset < gpiod_chip_info_get_num_lines(info) ? (int)wire->offset
                                                                      : -1;
    }
    gpiod_chip_info_free(info);
    return offset;
}

/* The chip that has the wire's line, which the caller closes; null: none has, and `why` says so. */
static struct gpiod_chip *find_chip(const struct gpio_wire *wire, unsigned int *offset,
                                    char why[HAL_TEXT_SIZE])
{
    struct gpio_dev_walk walk = { 0 };
    char denied[sizeof walk.path] = "";
    while (gpio_dev_next(&walk)) {
        struct gpiod_chip *chip = gpiod_chip_open(walk.path);
        if (!chip && (errno == EACCES || errno == EPERM)) {
            memcpy(denied, walk.path, sizeof denied);
        }
        const int found = chip ? offset_on(chip, wire) : -1;
        if (found >= 0) {
            *offset = (unsigned int)found;
            gpio_dev_end(&walk);
            return chip;
        }
        if (chip) {
            gpiod_chip_close(chip);
        }
    }
    gpio_dev_why_missing(why, wire, denied, walk.count);
    return NULL;
}

/* ---- Holding -------------------------------------------------------------------------------- */

static void let_go(struct lines2 *lines, enum gpio_role role)
{
    struct held *held = &lines->held[role];
    if (held->request) {
        gpiod_line_request_release(held->request);
    }
    *held = (struct held){ 0 };
    if (gpio_role_is_input(role)) {
        lines->fds[role] = -1;
        lines->looks.roles &= ~(1u << role);
    }
}

/* Where a turn's time is no matter. The kernel dates what it debounced when its work queue came
 * round to it, in steps of 4 ms and late when the machine is busy: of coins' pulses of 40 ms on an
 * emulated machine it made some of 15 ms and some of 75. Edges as they came are dated exactly. */
static bool kernel_may_debounce(enum gpio_role role)
{
    return role != GPIO_COIN && role != GPIO_TILT;
}

static int set_up(struct gpiod_line_settings *settings, const struct gpio_wire *wire,
                  enum gpio_role role, bool has_edges)
{
    static const enum gpiod_line_bias biases[] = {
        [GPIO_BIAS_AS_IS] = GPIOD_LINE_BIAS_AS_IS,
        [GPIO_BIAS_UP] = GPIOD_LINE_BIAS_PULL_UP,
        [GPIO_BIAS_DOWN] = GPIOD_LINE_BIAS_PULL_DOWN,
        [GPIO_BIAS_OFF] = GPIOD_LINE_BIAS_DISABLED,
    };
    const bool is_input = gpio_role_is_input(role);
    gpiod_line_settings_set_active_low(settings, wire->active_low != 0);
    int failed = gpiod_line_settings_set_bias(settings, biases[wire->bias]);
    failed |= gpiod_line_settings_set_direction(
        settings, is_input ? GPIOD_LINE_DIRECTION_INPUT : GPIOD_LINE_DIRECTION_OUTPUT);
    if (is_input && has_edges) {
        failed |= gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
        failed |= gpiod_line_settings_set_event_clock(settings, GPIOD_LINE_CLOCK_MONOTONIC);
        gpiod_line_settings_set_debounce_period_us(
            settings, kernel_may_debounce(role) ? wire->debounce_us : 0);
    } else if (!is_input) {
        failed |= gpiod_line_settings_set_output_value(
            settings, gpio_role_begins_active(role) ? GPIOD_LINE_VALUE_ACTIVE
                                                    : GPIOD_LINE_VALUE_INACTIVE);
    }
    return failed;
}

/* Null: it was refused, and errno says why. */
static struct gpiod_line_request *request(struct gpiod_chip *chip, unsigned int offset,
                                          const struct gpio_wire *wire, enum gpio_role role,
                                          bool has_edges)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    struct gpiod_line_request *got = NULL;
    if (settings && lines && config && set_up(settings, wire, role, has_edges) == 0 &&
        gpiod_line_config_add_line_settings(lines, &offset, 1, settings) == 0) {
        gpiod_request_config_set_consumer(config, "kingyo");
        gpiod_request_config_set_event_buffer_size(config, QUEUE_SIZE);
        got = gpiod_chip_request_lines(chip, config, lines);
    }
    const int error = errno;
    gpiod_request_config_free(config);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    errno = error;
    return got;
}

static void tell_refusal(struct gpiod_chip *chip, unsigned int offset,
                         const struct gpio_wire *wire, char why[HAL_TEXT_SIZE])
{
    const int error = errno;
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip, offset);
    gpio_dev_why_refused(why, wire, error, info ? gpiod_line_info_get_consumer(info) : NULL);
    gpiod_line_info_free(info);
}

static void hold(struct lines2 *lines, const struct gpio_wire *wire, enum gpio_role role,
                 char why[HAL_TEXT_SIZE])
{
    struct held *held = &lines->held[role];
    struct gpiod_chip *chip = find_chip(wire, &held->offset, why);
    if (!chip) {
        return;
    }
    const bool is_input = gpio_role_is_input(role);
    held->request = request(chip, held->offset, wire, role, true);
    if (held->request && is_input) {
        held->debounces = kernel_may_debounce(role) && wire->debounce_us > 0;
        lines->fds[role] = gpiod_line_request_get_fd(held->request);
    } else if (!held->request && is_input && gpio_dev_lacks_edges(errno)) {
        held->request = request(chip, held->offset, wire, role, false);
        if (held->request) {
            gpio_dev_look_from_now(
                &lines->looks, role,
                gpiod_line_request_get_value(held->request, held->offset));
        }
    }
    if (!held->request) {
        tell_refusal(chip, held->offset, wire, why);
    }
    gpiod_chip_close(chip); /* A request outlives it. */
}

static int lines2_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                       char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    struct lines2 *lines = self;
    struct gpio_dev_walk walk = { 0 };
    uint32_t had = 0;
    if (!lines->buffer) {
        lines->buffer = gpiod_edge_event_buffer_new(GPIO_EDGES_MAX);
    }
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        why[role][0] = '\0';
        if (wires[role].wired && !lines->held[role].request && lines->buffer) {
            hold(lines, &wires[role], role, why[role]);
        }
        had |= lines->held[role].request ? 1u << role : 0u;
    }
    if (had == 0 && !gpio_dev_next(&walk)) {
        return HAL_ERR_NONE;
    }
    gpio_dev_end(&walk);
    return (int)had;
}

static void lines2_close(void *self)
{
    struct lines2 *lines = self;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        let_go(lines, role);
    }
    if (lines->buffer) {
        gpiod_edge_event_buffer_free(lines->buffer);
        lines->buffer = NULL;
    }
}

/* ---- Edges ---------------------------------------------------------------------------------- */

static struct gpio_edge edge_of(struct held *held, enum gpio_role role,
                                struct gpiod_edge_event *event)
{
    const uint32_t number = (uint32_t)gpiod_edge_event_get_line_seqno(event);
    const struct gpio_edge edge = {
        .time_ns = gpiod_edge_event_get_timestamp_ns(event),
        .role = (uint8_t)role,
        .active = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
        .lost_before = number - held->seen - 1u, /* They begin at 1. */
    };
    held->seen = number;
    return edge;
}

/* How many edges came; -1: the chip is gone. */
static int read_edges(struct lines2 *lines, enum gpio_role role, struct gpio_edge *out,
                      uint32_t max)
{
    struct held *held = &lines->held[role];
    const int count = gpiod_line_request_read_edge_events(held->request, lines->buffer, max);
    for (int i = 0; i < count; i++) {
        out[i] = edge_of(held, role,
                         gpiod_edge_event_buffer_get_event(lines->buffer, (unsigned long)i));
    }
    return count;
}

/* ---- Levels --------------------------------------------------------------------------------- */

/* What a call that failed means: the chip is gone, or this time went wrong. */
static int failed(struct lines2 *lines, enum gpio_role role)
{
    if (errno != ENODEV) {
        return HAL_ERR_IO;
    }
    let_go(lines, role);
    return HAL_ERR_GONE;
}

static int lines2_level(void *self, enum gpio_role role)
{
    struct lines2 *lines = self;
    const struct held *held = &lines->held[role];
    if (!held->request) {
        return HAL_ERR_GONE;
    }
    const enum gpiod_line_value value = gpiod_line_request_get_value(held->request, held->offset);
    return value == GPIOD_LINE_VALUE_ERROR ? failed(lines, role)
                                           : value == GPIOD_LINE_VALUE_ACTIVE;
}

static int lines2_set(void *self, enum gpio_role role, int active)
{
    struct lines2 *lines = self;
    const struct held *held = &lines->held[role];
    if (!held->request) {
        return HAL_ERR_GONE;
    }
    const enum gpiod_line_value value =
        active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return gpiod_line_request_set_value(held->request, held->offset, value) == 0
               ? HAL_OK
               : failed(lines, role);
}

static int lines2_debounces(void *self, enum gpio_role role)
{
    const struct lines2 *lines = self;
    return lines->held[role].debounces;
}

/* ---- Waiting -------------------------------------------------------------------------------- */

/* A line without edges; 1: there was one nevertheless. */
static uint32_t look(struct lines2 *lines, enum gpio_role role, struct gpio_edge *out)
{
    const int level = lines2_level(lines, role);
    lines->went |= level == HAL_ERR_GONE;
    return gpio_dev_look(&lines->looks, role, level, out);
}

static int lines2_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    struct lines2 *lines = self;
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

static int lines2_list(void *self, void (*tell)(void *context, const struct gpio_line_info *line),
                       void *context)
{
    (void)self;
    return gpio_chips_list(tell, context);
}

static const char *lines2_describe(void *self)
{
    struct lines2 *lines = self;
    snprintf(lines->text, sizeof lines->text, "libgpiod %s", gpiod_api_version());
    return lines->text;
}

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_lines_ops ops = {
        .open = lines2_open,
        .wait = lines2_wait,
        .level = lines2_level,
        .set = lines2_set,
        .debounces = lines2_debounces,
        .list = lines2_list,
        .close = lines2_close,
        .describe = lines2_describe,
    };
    lines2_close(&lines2); /* A fresh state: no descriptor is 0. */
    return (struct gpio_lines){ .ops = &ops, .self = &lines2 };
}
