/* poi_mouse_fan.c -- the fan and the START button of the pointer in poi_mouse.c. */
#include <SDL.h>

#include "drivers/poi_mouse.h"

static int fan_open(void *self)
{
    (void)self;
    /* open() of the poi has initialized the rest. */
    return SDL_WasInit(SDL_INIT_VIDEO) ? HAL_OK : HAL_ERR_NONE;
}

static int fan_poll(void *self, struct shade_input *out)
{
    struct poi_mouse *mouse = self;
    *out = pointer_fan_shade(&mouse->fan, mouse->clock.ops->now_ns(mouse->clock.self));
    return HAL_OK;
}

static const char *fan_describe(void *self)
{
    (void)self;
    return "the mouse while F is held";
}

struct hal_shade poi_mouse_fan(struct poi_mouse *mouse)
{
    static const struct hal_shade_ops ops = {
        .open = fan_open,
        .poll = fan_poll,
        .describe = fan_describe,
    };
    return (struct hal_shade){ .ops = &ops, .self = mouse };
}

static int buttons_poll(void *self, struct button_sample *out)
{
    struct poi_mouse *mouse = self;
    const uint32_t count = mouse->fingers.count;
    *out = (struct button_sample){
        .held = count >= TOUCH_START_FINGERS ? (uint32_t)INPUT_START : 0u,
        .pressed = touch_fingers_start(&mouse->fingers) ? (uint32_t)INPUT_START : 0u,
    };
    return HAL_OK;
}

static const char *buttons_describe(void *self)
{
    const struct poi_mouse *mouse = self;
    return mouse->heeds & POINTER_HEEDS_FINGERS ? "three fingers start" : "";
}

struct hal_buttons poi_mouse_buttons(struct poi_mouse *mouse)
{
    static const struct hal_buttons_ops ops = {
        .poll = buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = mouse };
}
