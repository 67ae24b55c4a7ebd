/* gpio_lines2.c -- the backend for libgpiod 2.x, which uses the second version of the kernel's GPIO
 * interface.
 *
 * Each line is a separate request with its own queue, so that a bouncing line cannot fill the queue
 * of another line. Edges are numbered, so the number of lost edges is exact. The kernel can
 * debounce a line. */
#include <errno.h>
#include <gpiod.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_backend.h"

/* Requested queue size. The kernel's default is 16 edges for each line. */
#define QUEUE_SIZE GPIO_EDGES_MAX

static struct held {
    struct gpiod_chip *chip; /* Handle of the chip, or null if the line is not held. */
    unsigned int offset;
    struct gpiod_line_request *request;     /* Handle of the request, or null if the line is not
                                               requested yet. */
    struct gpiod_edge_event_buffer *buffer; /* Buffer for the edges of an input with edge detection,
                                               otherwise null. */
    uint32_t seen;                          /* Sequence number of the last edge. 0 means no edge
                                               yet. */
} lines[GPIO_ROLE_COUNT];

/* ---- Finding lines -------------------------------------------------------------------------- */

static void release_v2(enum gpio_role role)
{
    struct held *held = &lines[role];
    CORE_ASSERT(held->chip);
    if (held->request) {
        gpiod_line_request_release(held->request);
    }
    if (held->buffer) {
        gpiod_edge_event_buffer_free(held->buffer);
    }
    gpiod_chip_close(held->chip);
    *held = (struct held){ 0 };
}

static int find_v2(enum gpio_role role, const char *path, const struct gpio_wire *wire)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT && !lines[role].chip);
    struct gpiod_chip *chip = lines[role].chip = gpiod_chip_open(path);
    struct gpiod_chip_info *info = chip ? gpiod_chip_get_info(chip) : NULL;
    int offset = -1;
    if (!chip) {
        return -1;
    }
    if (info && (!wire->chip[0] || strcmp(gpiod_chip_info_get_label(info), wire->chip) == 0)) {
        offset = wire->name[0] ? gpiod_chip_get_line_offset_from_name(chip, wire->name)
                 : wire->offset < gpiod_chip_info_get_num_lines(info) ? (int)wire->offset
                                                                      : -1;
    }
    gpiod_chip_info_free(info);
    lines[role].offset = (unsigned int)offset;
    if (offset < 0) {
        release_v2(role);
    }
    return offset >= 0;
}

/* ---- Requesting lines ----------------------------------------------------------------------- */

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
    CORE_ASSERT(wire->bias <= GPIO_BIAS_OFF && (is_input || !has_edges));
    gpiod_line_settings_set_active_low(settings, wire->active_low);
    int failed = gpiod_line_settings_set_bias(settings, biases[wire->bias]);
    failed |= gpiod_line_settings_set_direction(settings, is_input ? GPIOD_LINE_DIRECTION_INPUT
                                                                   : GPIOD_LINE_DIRECTION_OUTPUT);
    if (has_edges) {
        failed |= gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
        failed |= gpiod_line_settings_set_event_clock(settings, GPIOD_LINE_CLOCK_MONOTONIC);
        gpiod_line_settings_set_debounce_period_us(
            settings, gpio_backend_may_debounce(role) ? wire->debounce_us : 0);
    } else if (!is_input) {
        failed |= gpiod_line_settings_set_output_value(settings, gpio_role_begins_active(role)
                                                                     ? GPIOD_LINE_VALUE_ACTIVE
                                                                     : GPIOD_LINE_VALUE_INACTIVE);
    }
    return failed;
}

static int request_v2(enum gpio_role role, const struct gpio_wire *wire, bool has_edges,
                      char consumer[GPIO_TEXT_SIZE])
{
    struct held *held = &lines[role];
    CORE_ASSERT(held->chip && !held->request);
    if (has_edges && !held->buffer) {
        held->buffer = gpiod_edge_event_buffer_new(GPIO_EDGES_MAX);
        if (!held->buffer) {
            return -1;
        }
    }
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    struct gpiod_line_config *config = gpiod_line_config_new();
    struct gpiod_request_config *words = gpiod_request_config_new();
    if (settings && config && words && set_up(settings, wire, role, has_edges) == 0 &&
        gpiod_line_config_add_line_settings(config, &held->offset, 1, settings) == 0) {
        gpiod_request_config_set_consumer(words, "kingyo");
        gpiod_request_config_set_event_buffer_size(words, QUEUE_SIZE);
        held->request = gpiod_chip_request_lines(held->chip, words, config);
    }
    const int error = errno;
    gpiod_request_config_free(words);
    gpiod_line_config_free(config);
    gpiod_line_settings_free(settings);
    if (!held->request) {
        struct gpiod_line_info *info = gpiod_chip_get_line_info(held->chip, held->offset);
        gpio_dev_text(consumer, info ? gpiod_line_info_get_consumer(info) : NULL);
        gpiod_line_info_free(info);
        errno = error;
        return -1;
    }
    return has_edges ? gpiod_line_request_get_fd(held->request) : 0;
}

/* ---- Edges ---------------------------------------------------------------------------------- */

static int read_edges_v2(enum gpio_role role, struct gpio_edge *out, uint32_t max)
{
    struct held *held = &lines[role];
    CORE_ASSERT(held->request && held->buffer && max > 0);
    const int count = gpiod_line_request_read_edge_events(held->request, held->buffer, max);
    for (int i = 0; i < count; i++) {
        struct gpiod_edge_event *event =
            gpiod_edge_event_buffer_get_event(held->buffer, (unsigned long)i);
        const uint32_t number = (uint32_t)gpiod_edge_event_get_line_seqno(event);
        out[i] = (struct gpio_edge){
            .time_ns = gpiod_edge_event_get_timestamp_ns(event),
            .role = (uint8_t)role,
            .active = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
            .lost_before = number - held->seen - 1u, /* The kernel numbers the edges from 1. */
        };
        held->seen = number;
    }
    return count;
}

/* ---- Lines of a chip ------------------------------------------------------------------------ */

static uint32_t list_chip_lines_v2(const char *path,
                                   void (*report)(void *context, const struct gpio_line_info *line),
                                   void *context)
{
    struct gpiod_chip *chip = gpiod_chip_open(path);
    struct gpiod_chip_info *chip_info = chip ? gpiod_chip_get_info(chip) : NULL;
    const size_t line_count = chip_info ? gpiod_chip_info_get_num_lines(chip_info) : 0u;
    uint32_t count = 0;
    for (unsigned int offset = 0; offset < line_count; offset++) {
        struct gpiod_line_info *line = gpiod_chip_get_line_info(chip, offset);
        if (!line) {
            continue;
        }
        struct gpio_line_info info = {
            .offset = offset,
            .used = gpiod_line_info_is_used(line),
            .is_output = gpiod_line_info_get_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT,
            .active_low = gpiod_line_info_is_active_low(line),
        };
        gpio_dev_text(info.device, gpiod_chip_info_get_name(chip_info));
        gpio_dev_text(info.chip, gpiod_chip_info_get_label(chip_info));
        gpio_dev_text(info.name, gpiod_line_info_get_name(line));
        gpio_dev_text(info.consumer, gpiod_line_info_get_consumer(line));
        gpiod_line_info_free(line);
        report(context, &info);
        count++;
    }
    if (chip_info) {
        gpiod_chip_info_free(chip_info);
    }
    if (chip) {
        gpiod_chip_close(chip);
    }
    return count;
}

/* ---- Levels and the backend ----------------------------------------------------------------- */

static int get_v2(enum gpio_role role)
{
    const enum gpiod_line_value value =
        gpiod_line_request_get_value(lines[role].request, lines[role].offset);
    return value == GPIOD_LINE_VALUE_ERROR ? -1 : value == GPIOD_LINE_VALUE_ACTIVE;
}

static int set_v2(enum gpio_role role, bool active)
{
    CORE_ASSERT(!gpio_role_is_input(role) && lines[role].request);
    return gpiod_line_request_set_value(lines[role].request, lines[role].offset,
                                        active ? GPIOD_LINE_VALUE_ACTIVE
                                               : GPIOD_LINE_VALUE_INACTIVE);
}

struct gpio_lines gpio_lines_device(void)
{
    static const struct gpio_backend_ops ops = {
        .find = find_v2,
        .request = request_v2,
        .read_edges = read_edges_v2,
        .get = get_v2,
        .set = set_v2,
        .release = release_v2,
        .list_chip_lines = list_chip_lines_v2,
        .version = gpiod_api_version,
        .debounces = true,
    };
    static struct gpio_backend backend;
    return gpio_backend_device(&backend, &ops);
}
