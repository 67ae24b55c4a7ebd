/* gamepad_poi.c -- implements the poi, fan and button devices of a game pad. */
#include "drivers/gamepad/gamepads.h"

#include <SDL.h>
#include <stdlib.h>

#include "core/base/panic.h"

/* Duration of a motor command. SDL stops the motors after this time if the kiosk hangs. */
#define RUMBLE_MS 250
#define RUMBLE_AGAIN_NS 100000000ull
/* Smallest change of a motor level that a thumb can feel. The full motor level is 65,535. */
#define RUMBLE_STEP 2048

bool gamepad_poi_is_present(void *self)
{
    struct gamepad *pad = self;
    gamepads_poll(pad->gamepads);
    return pad->controller != NULL;
}

static int pad_open(void *self)
{
    struct gamepad *pad = self;
    return gamepad_poi_is_present(pad) ? HAL_OK
           : pad->gamepads->is_open    ? (int)HAL_ERR_GONE
                                       : (int)HAL_ERR_ABSENT;
}

static int pad_poll(void *self, struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(out || max == 0);
    struct gamepad *pad = self;
    gamepads_poll(pad->gamepads);
    if (!pad->controller) {
        return HAL_ERR_GONE;
    }
    return (int)gamepad_queue_pop(&pad->track, hal_now_ns(pad->gamepads->clock), out, max);
}

/* Sends the motor levels when the levels change, and sends the levels again before SDL would stop
 * the motors. */
static int pad_set_force(void *self, const struct poi_force *force)
{
    CORE_ASSERT(force);
    struct gamepad *pad = self;
    if (!pad->controller || pad->cannot_rumble) {
        return HAL_ERR_ABSENT;
    }
    const struct gamepad_rumble rumble = gamepad_decoder_rumble(force);
    const uint64_t now = hal_now_ns(pad->gamepads->clock);
    const bool hums = rumble.slow > 0 || rumble.fast > 0;
    const bool is_other = abs(rumble.slow - pad->rumble.slow) >= RUMBLE_STEP ||
                          abs(rumble.fast - pad->rumble.fast) >= RUMBLE_STEP ||
                          (!hums && (pad->rumble.slow > 0 || pad->rumble.fast > 0));
    if (!is_other && !(hums && now - pad->rumble_ns >= RUMBLE_AGAIN_NS)) {
        return HAL_OK;
    }
    pad->rumble = rumble;
    pad->rumble_ns = now;
    const int failed =
        SDL_GameControllerRumble(pad->controller, rumble.slow, rumble.fast, hums ? RUMBLE_MS : 0);
    return failed ? (int)HAL_ERR_IO : (int)HAL_OK;
}

static void pad_set_view(void *self, const struct view *view,
                         const struct display_settings *display_settings, bool scoops)
{
    CORE_ASSERT(view);
    struct gamepad *pad = self;
    /* `display_settings` is unused, because a stick moves the poi relative to the water and not to
     * the screen. */
    (void)display_settings;
    pad->gamepads->view = *view;
    stick_motion_set_view(&pad->track.decoder.fly, view);
    pad->track.decoder.fly.dip.scoops = scoops;
}

static const char *pad_describe(void *self)
{
    const struct gamepad *pad = self;
    return pad->text;
}

static int gamepad_poi_fan_open(void *self)
{
    const struct gamepad *pad = self;
    return pad->controller ? (int)HAL_OK : (int)HAL_ERR_GONE;
}

static int gamepad_poi_fan_poll(void *self, struct shade_input *out)
{
    CORE_ASSERT(out);
    struct gamepad *pad = self;
    if (!pad->controller) {
        return HAL_ERR_GONE;
    }
    *out = stick_motion_fan(&pad->track.decoder.fly, hal_now_ns(pad->gamepads->clock));
    return HAL_OK;
}

static const char *gamepad_poi_fan_describe(void *self)
{
    (void)self;
    return "a pad's left stick while its left shoulder button is held";
}

/* Merges the buttons of all plugged-in game pads. A game pad without a slot can also press
 * START. */
static int gamepad_poi_buttons_poll(void *self, struct button_sample *out)
{
    CORE_ASSERT(out);
    struct gamepads *gamepads = self;
    int result = HAL_ERR_ABSENT;
    gamepads_poll(gamepads);
    *out = (struct button_sample){ 0 };
    for (uint32_t i = 0; i < GAMEPADS_MAX; i++) {
        struct gamepad *pad = &gamepads->pad[i];
        struct button_sample own = { 0 };
        if (!pad->controller) {
            continue;
        }
        gamepad_queue_buttons(&pad->track, &own);
        out->held |= own.held;
        out->pressed |= own.pressed;
        result = HAL_OK;
    }
    return result;
}

static const char *buttons_describe(void *self)
{
    const struct gamepads *gamepads = self;
    return gamepads->text;
}

struct hal_controller_devices gamepad_poi_devices(struct gamepads *gamepads, uint32_t index)
{
    static const struct hal_poi_ops poi = {
        .open = pad_open,
        .poll = pad_poll,
        .set_force = pad_set_force,
        .set_view = pad_set_view,
        .describe = pad_describe,
    };
    static const struct hal_fan_ops fan = {
        .open = gamepad_poi_fan_open,
        .poll = gamepad_poi_fan_poll,
        .describe = gamepad_poi_fan_describe,
    };
    static const struct hal_buttons_ops buttons = {
        .poll = gamepad_poi_buttons_poll,
        .describe = buttons_describe,
    };
    CORE_ASSERT(index < GAMEPADS_MAX);
    return (struct hal_controller_devices){
        .poi = { &poi, &gamepads->pad[index] },
        .fan = { &fan, &gamepads->pad[index] },
        .buttons = { &buttons, gamepads },
    };
}
