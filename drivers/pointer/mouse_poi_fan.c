/* mouse_poi_fan.c -- the fan device and the START button of struct mouse_poi. */
#include <SDL.h>

#include "drivers/pointer/mouse_poi.h"

static int mouse_poi_fan_open(void *self)
{
    (void)self;
    /* Only SDL's video subsystem is checked, because open() of the poi device has initialized
     * everything else. */
    return SDL_WasInit(SDL_INIT_VIDEO) ? HAL_OK : HAL_ERR_ABSENT;
}

static int mouse_poi_fan_poll(void *self, struct shade_input *out)
{
    struct mouse_poi *mouse = self;
    *out = pointer_fan_shade(&mouse->fan, mouse->clock.ops->now_ns(mouse->clock.self));
    return HAL_OK;
}

static const char *mouse_poi_fan_describe(void *self)
{
    (void)self;
    return "the mouse while F is held";
}

struct hal_fan mouse_poi_fan(struct mouse_poi *mouse)
{
    static const struct hal_fan_ops ops = {
        .open = mouse_poi_fan_open,
        .poll = mouse_poi_fan_poll,
        .describe = mouse_poi_fan_describe,
    };
    return (struct hal_fan){ .ops = &ops, .self = mouse };
}

static int mouse_poi_buttons_poll(void *self, struct button_sample *out)
{
    struct mouse_poi *mouse = self;
    const uint32_t count = mouse->fingers.count;
    *out = (struct button_sample){
        .held = count >= TOUCH_START_FINGERS ? (uint32_t)INPUT_START : 0u,
        .pressed = touch_fingers_start(&mouse->fingers) ? (uint32_t)INPUT_START : 0u,
    };
    return HAL_OK;
}

static const char *buttons_describe(void *self)
{
    const struct mouse_poi *mouse = self;
    return mouse->heeds & POINTER_FILTER_TOUCH ? "three fingers start" : "";
}

struct hal_buttons mouse_poi_buttons(struct mouse_poi *mouse)
{
    static const struct hal_buttons_ops ops = {
        .poll = mouse_poi_buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = mouse };
}
