/* poi_pad.c -- implements the poi, fan and button devices of a game pad. */
#include "drivers/poi_pad.h"

#include <SDL.h>

#include "core/base/panic.h"

#define RUMBLE_MS 250           /* The motors stop after this time if the kiosk hangs. */
#define RUMBLE_AGAIN_NS 100000000ull
#define RUMBLE_STEP 2048        /* Smallest change that a thumb can feel, of 65,535. */

int pads_is_there(void *self)
{
    struct pad *pad = self;
    pads_pump(pad->pads);
    return pad->controller != NULL;
}

static int pad_open(void *self)
{
    struct pad *pad = self;
    return pads_is_there(pad)     ? HAL_OK
           : pad->pads->is_open ? (int)HAL_ERR_GONE
                                : (int)HAL_ERR_NONE;
}

static int pad_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct pad *pad = self;
    pads_pump(pad->pads);
    if (!pad->controller) {
        return HAL_ERR_GONE;
    }
    return (int)pad_track_take(&pad->track, pads_now_ns(pad->pads), out, max);
}

static uint32_t apart(uint16_t a, uint16_t b)
{
    return a > b ? (uint32_t)(a - b) : (uint32_t)(b - a);
}

/* Sets the motor levels when they change, and again before the pad would stop them. */
static int pad_feel(void *self, const struct poi_force *force)
{
    struct pad *pad = self;
    if (!pad->controller || pad->cannot_rumble) {
        return HAL_ERR_NONE;
    }
    const struct pad_rumble rumble = pad_rumble_of(force);
    const uint64_t now = pads_now_ns(pad->pads);
    const int hums = rumble.slow > 0 || rumble.fast > 0;
    const int is_other = apart(rumble.slow, pad->rumble.slow) >= RUMBLE_STEP ||
                         apart(rumble.fast, pad->rumble.fast) >= RUMBLE_STEP ||
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

static void pad_look(void *self, const struct view *view, const struct showing *showing)
{
    struct pad *pad = self;
    (void)showing; /* A stick refers to the water, not to the screen. */
    pad->pads->view = *view;
    pad_hand_look(&pad->track.hand, view);
}

static const char *pad_describe(void *self)
{
    const struct pad *pad = self;
    return pad->text;
}

static int fan_open(void *self)
{
    const struct pad *pad = self;
    return pad->controller ? (int)HAL_OK : (int)HAL_ERR_GONE;
}

static int fan_poll(void *self, struct shade_input *out)
{
    struct pad *pad = self;
    if (!pad->controller) {
        return HAL_ERR_GONE;
    }
    *out = pad_hand_fan(&pad->track.hand, pads_now_ns(pad->pads));
    return HAL_OK;
}

static const char *fan_describe(void *self)
{
    (void)self;
    return "a pad's left stick while its left shoulder button is held";
}

struct hal_poi pads_poi(struct pads *pads, uint32_t index)
{
    static const struct hal_poi_ops ops = {
        .open = pad_open,
        .poll = pad_poll,
        .feel = pad_feel,
        .look = pad_look,
        .describe = pad_describe,
    };
    CORE_ASSERT(index < PADS_MAX);
    return (struct hal_poi){ .ops = &ops, .self = &pads->pad[index] };
}

struct hal_shade pads_fan(struct pads *pads, uint32_t index)
{
    static const struct hal_shade_ops ops = {
        .open = fan_open,
        .poll = fan_poll,
        .describe = fan_describe,
    };
    CORE_ASSERT(index < PADS_MAX);
    return (struct hal_shade){ .ops = &ops, .self = &pads->pad[index] };
}

/* Merges the buttons of all pads. A pad without a slot can also press START. */
static int buttons_poll(void *self, struct button_sample *out)
{
    struct pads *pads = self;
    int result = HAL_ERR_NONE;
    pads_pump(pads);
    *out = (struct button_sample){ 0 };
    for (uint32_t i = 0; i < PADS_MAX; i++) {
        struct pad *pad = &pads->pad[i];
        struct button_sample own = { 0 };
        if (!pad->controller) {
            continue;
        }
        pad_track_buttons(&pad->track, &own);
        out->held |= own.held;
        out->pressed |= own.pressed;
        result = HAL_OK;
    }
    return result;
}

static const char *buttons_describe(void *self)
{
    const struct pads *pads = self;
    return pads->text;
}

struct hal_buttons pads_buttons(struct pads *pads)
{
    static const struct hal_buttons_ops ops = {
        .poll = buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = pads };
}
