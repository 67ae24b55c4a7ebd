/* fake_gpiod2.c -- replaces the functions of libgpiod 2.x that gpio_lines2.c calls by functions
 * that use simulated chips. */
#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>
#include <string.h>

#include "tests/gpio/fake_board.h"

struct gpiod_chip {
    struct fake_chip *of;
};
struct gpiod_chip_info {
    struct fake_chip *of;
};
struct gpiod_line_info {
    struct fake_line *of;
};
struct gpiod_line_request {
    struct fake_chip *chip;
    struct fake_line *of;
};
struct gpiod_line_settings {
    struct fake_line as;
};
struct gpiod_line_config {
    unsigned int offset;
    struct fake_line as;
};
struct gpiod_request_config {
    size_t queue_size;
};
struct gpiod_edge_event {
    struct fake_edge edge;
};
struct gpiod_edge_event_buffer {
    size_t capacity;
    struct gpiod_edge_event events[64];
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
    fake_chip_close(chip->of);
    free(chip);
}

struct gpiod_chip_info *gpiod_chip_get_info(struct gpiod_chip *chip)
{
    struct gpiod_chip_info *info = calloc(1, sizeof *info);
    info->of = chip->of;
    return info;
}

void gpiod_chip_info_free(struct gpiod_chip_info *info)
{
    free(info);
}

const char *gpiod_chip_info_get_name(struct gpiod_chip_info *info)
{
    return info->of->device;
}

const char *gpiod_chip_info_get_label(struct gpiod_chip_info *info)
{
    return info->of->label;
}

size_t gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info)
{
    (void)info;
    return FAKE_LINES;
}

int gpiod_chip_get_line_offset_from_name(struct gpiod_chip *chip, const char *name)
{
    for (uint32_t i = 0; i < FAKE_LINES; i++) {
        const char *own = chip->of->lines[i].name;
        if (own && strcmp(own, name) == 0) {
            return (int)i;
        }
    }
    errno = ENOENT;
    return -1;
}

struct gpiod_line_info *gpiod_chip_get_line_info(struct gpiod_chip *chip, unsigned int offset)
{
    struct gpiod_line_info *info = calloc(1, sizeof *info);
    info->of = &chip->of->lines[offset];
    return info;
}

void gpiod_line_info_free(struct gpiod_line_info *info)
{
    free(info);
}

const char *gpiod_line_info_get_name(struct gpiod_line_info *info)
{
    return info->of->name;
}

const char *gpiod_line_info_get_consumer(struct gpiod_line_info *info)
{
    return info->of->consumer;
}

bool gpiod_line_info_is_used(struct gpiod_line_info *info)
{
    return info->of->consumer || info->of->requested;
}

enum gpiod_line_direction gpiod_line_info_get_direction(struct gpiod_line_info *info)
{
    return info->of->is_output ? GPIOD_LINE_DIRECTION_OUTPUT : GPIOD_LINE_DIRECTION_INPUT;
}

bool gpiod_line_info_is_active_low(struct gpiod_line_info *info)
{
    return info->of->active_low;
}

/* ---- Settings objects of libgpiod 2.x ------------------------------------------------------- */

struct gpiod_line_settings *gpiod_line_settings_new(void)
{
    struct gpiod_line_settings *settings = calloc(1, sizeof *settings);
    /* Default of a request. A request for edges sets this member to false. */
    settings->as.is_looked_at = true;
    return settings;
}

void gpiod_line_settings_free(struct gpiod_line_settings *settings)
{
    free(settings);
}

int gpiod_line_settings_set_direction(struct gpiod_line_settings *settings,
                                      enum gpiod_line_direction direction)
{
    settings->as.is_output = direction == GPIOD_LINE_DIRECTION_OUTPUT;
    return 0;
}

int gpiod_line_settings_set_edge_detection(struct gpiod_line_settings *settings,
                                           enum gpiod_line_edge edge)
{
    settings->as.is_looked_at = edge != GPIOD_LINE_EDGE_BOTH;
    return 0;
}

int gpiod_line_settings_set_bias(struct gpiod_line_settings *settings, enum gpiod_line_bias bias)
{
    settings->as.bias = bias == GPIOD_LINE_BIAS_PULL_UP     ? GPIO_BIAS_UP
                        : bias == GPIOD_LINE_BIAS_PULL_DOWN ? GPIO_BIAS_DOWN
                        : bias == GPIOD_LINE_BIAS_DISABLED  ? GPIO_BIAS_OFF
                                                            : GPIO_BIAS_AS_IS;
    return 0;
}

void gpiod_line_settings_set_active_low(struct gpiod_line_settings *settings, bool active_low)
{
    settings->as.active_low = active_low;
}

void gpiod_line_settings_set_debounce_period_us(struct gpiod_line_settings *settings,
                                                unsigned long period)
{
    settings->as.debounce_us = (uint32_t)period;
}

int gpiod_line_settings_set_event_clock(struct gpiod_line_settings *settings,
                                        enum gpiod_line_clock clock)
{
    (void)settings;
    return clock == GPIOD_LINE_CLOCK_MONOTONIC ? 0 : -1;
}

int gpiod_line_settings_set_output_value(struct gpiod_line_settings *settings,
                                         enum gpiod_line_value value)
{
    settings->as.value = value == GPIOD_LINE_VALUE_ACTIVE;
    return 0;
}

struct gpiod_line_config *gpiod_line_config_new(void)
{
    return calloc(1, sizeof(struct gpiod_line_config));
}

void gpiod_line_config_free(struct gpiod_line_config *config)
{
    free(config);
}

int gpiod_line_config_add_line_settings(struct gpiod_line_config *config,
                                        const unsigned int *offsets, size_t num_offsets,
                                        struct gpiod_line_settings *settings)
{
    config->offset = offsets[0];
    config->as = settings->as;
    return num_offsets == 1 ? 0 : -1;
}

struct gpiod_request_config *gpiod_request_config_new(void)
{
    return calloc(1, sizeof(struct gpiod_request_config));
}

void gpiod_request_config_free(struct gpiod_request_config *config)
{
    free(config);
}

void gpiod_request_config_set_consumer(struct gpiod_request_config *config, const char *consumer)
{
    (void)config;
    (void)consumer;
}

void gpiod_request_config_set_event_buffer_size(struct gpiod_request_config *config,
                                                size_t event_buffer_size)
{
    config->queue_size = event_buffer_size;
}

/* ---- Line requests of libgpiod 2.x ---------------------------------------------------------- */

struct gpiod_line_request *gpiod_chip_request_lines(struct gpiod_chip *chip,
                                                    struct gpiod_request_config *req_cfg,
                                                    struct gpiod_line_config *line_cfg)
{
    struct fake_line *line = &chip->of->lines[line_cfg->offset];
    line->is_output = line_cfg->as.is_output;
    line->is_looked_at = line_cfg->as.is_looked_at && !line->is_output;
    if (fake_line_request(chip->of, line) != 0) {
        return NULL;
    }
    line->active_low = line_cfg->as.active_low;
    line->bias = line_cfg->as.bias;
    line->debounce_us = line_cfg->as.debounce_us;
    line->queue_size = (uint32_t)req_cfg->queue_size;
    line->value = line->is_output ? line_cfg->as.value : line->value;
    struct gpiod_line_request *request = calloc(1, sizeof *request);
    request->chip = chip->of;
    request->of = line;
    return request;
}

void gpiod_line_request_release(struct gpiod_line_request *request)
{
    fake_line_release(request->of);
    free(request);
}

int gpiod_line_request_get_fd(struct gpiod_line_request *request)
{
    return request->of->pipe[0];
}

enum gpiod_line_value gpiod_line_request_get_value(struct gpiod_line_request *request,
                                                   unsigned int offset)
{
    (void)offset;
    errno = ENODEV;
    return request->chip->gone  ? GPIOD_LINE_VALUE_ERROR
           : request->of->value ? GPIOD_LINE_VALUE_ACTIVE
                                : GPIOD_LINE_VALUE_INACTIVE;
}

int gpiod_line_request_set_value(struct gpiod_line_request *request, unsigned int offset,
                                 enum gpiod_line_value value)
{
    (void)offset;
    errno = ENODEV;
    if (request->chip->gone) {
        return -1;
    }
    request->of->value = value == GPIOD_LINE_VALUE_ACTIVE;
    return 0;
}

/* ---- Edge events of libgpiod 2.x ------------------------------------------------------------ */

struct gpiod_edge_event_buffer *gpiod_edge_event_buffer_new(size_t capacity)
{
    struct gpiod_edge_event_buffer *buffer = calloc(1, sizeof *buffer);
    buffer->capacity = capacity < 64 ? capacity : 64;
    return buffer;
}

void gpiod_edge_event_buffer_free(struct gpiod_edge_event_buffer *buffer)
{
    free(buffer);
}

int gpiod_line_request_read_edge_events(struct gpiod_line_request *request,
                                        struct gpiod_edge_event_buffer *buffer, size_t max_events)
{
    struct fake_edge edges[64];
    const size_t room = max_events < buffer->capacity ? max_events : buffer->capacity;
    const int count = fake_line_read(request->of, edges, (uint32_t)room);
    for (int i = 0; i < count; i++) {
        buffer->events[i].edge = edges[i];
    }
    return count;
}

struct gpiod_edge_event *gpiod_edge_event_buffer_get_event(struct gpiod_edge_event_buffer *buffer,
                                                           unsigned long index)
{
    return &buffer->events[index];
}

enum gpiod_edge_event_type gpiod_edge_event_get_event_type(struct gpiod_edge_event *event)
{
    return event->edge.active ? GPIOD_EDGE_EVENT_RISING_EDGE : GPIOD_EDGE_EVENT_FALLING_EDGE;
}

uint64_t gpiod_edge_event_get_timestamp_ns(struct gpiod_edge_event *event)
{
    return event->edge.time_ns;
}

unsigned long gpiod_edge_event_get_line_seqno(struct gpiod_edge_event *event)
{
    return event->edge.number;
}

const char *gpiod_api_version(void)
{
    return "2.2.fake";
}
