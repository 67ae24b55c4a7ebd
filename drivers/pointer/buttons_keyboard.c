/* buttons_keyboard.c -- maps the keys of a keyboard to cabinet buttons. */
#include "drivers/pointer/buttons_keyboard.h"

#include <SDL.h>

#include "core/base/panic.h"

#define EVENT_BATCH 32

struct key {
    SDL_Keycode code;
    uint32_t button; /* Cabinet buttons of the key (enum input_button). 0 means that the key is no
                        cabinet button. */
    uint8_t coin;    /* Coin line of the key plus 1. 0 means that the key inserts no coin. */
    bool quit, full_screen;
};

static const struct key keys[] = {
    { .code = SDLK_SPACE, .button = INPUT_START },
    { .code = SDLK_RETURN, .button = INPUT_START },
    { .code = SDLK_KP_ENTER, .button = INPUT_START },
    { .code = SDLK_LEFT, .button = INPUT_LEFT },
    { .code = SDLK_RIGHT, .button = INPUT_RIGHT },
    { .code = SDLK_DOWN, .button = INPUT_OK | INPUT_DOWN },
    { .code = SDLK_UP, .button = INPUT_OK | INPUT_UP },
    { .code = SDLK_l, .button = INPUT_LANGUAGE },
    { .code = SDLK_F2, .button = INPUT_TEST },
    { .code = SDLK_F3, .button = INPUT_SERVICE },
    { .code = SDLK_F4, .button = INPUT_TILT },
    { .code = SDLK_5, .coin = 1 }, /* Keys 5, 6 and 7 insert coins, because arcade emulators use key
                                      5 for coins. */
    { .code = SDLK_6, .coin = 2 },
    { .code = SDLK_7, .coin = 3 },
    { .code = SDLK_F11, .full_screen = true },
    { .code = SDLK_ESCAPE, .quit = true },
    { .code = SDLK_q, .quit = true },
};

static void buttons_keyboard_take_event(struct buttons_keyboard *keyboard, const SDL_Event *event,
                                        struct button_sample *out)
{
    static const struct key unknown = { 0 };
    const struct key *key = &unknown;
    if (event->type != SDL_KEYDOWN && event->type != SDL_KEYUP) {
        return;
    }
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        key = keys[i].code == event->key.keysym.sym ? &keys[i] : key;
    }
    if (event->type == SDL_KEYUP) {
        keyboard->held &= ~key->button;
    } else if (!event->key.repeat) {
        CORE_ASSERT(key->coin <= sizeof out->coin_count / sizeof out->coin_count[0]);
        keyboard->held |= key->button;
        out->pressed |= key->button;
        if (key->coin > 0) {
            out->coin_count[key->coin - 1u]++;
        }
        out->quit |= key->quit;
        out->full_screen |= key->full_screen;
    }
}

static int buttons_keyboard_poll(void *self, struct button_sample *out)
{
    CORE_ASSERT(out);
    struct buttons_keyboard *keyboard = self;
    SDL_Event events[EVENT_BATCH];
    *out = (struct button_sample){ 0 };
    int taken;
    do { /* The requested range of event types also contains text input events, which no other code
            reads. */
        taken = SDL_PeepEvents(events, EVENT_BATCH, SDL_GETEVENT, SDL_KEYDOWN, SDL_MOUSEMOTION - 1);
        for (int i = 0; i < taken; i++) {
            buttons_keyboard_take_event(keyboard, &events[i], out);
        }
    } while (taken == EVENT_BATCH);
    out->held = out->raw = keyboard->held;
    return HAL_OK;
}

static const char *buttons_keyboard_describe(void *self)
{
    (void)self;
    return "keyboard: Space starts, arrows choose, 5 6 7 coins, F2 menu, F3 service, L language, "
           "F11 full screen, Esc quits";
}

struct hal_buttons buttons_keyboard_device(struct buttons_keyboard *keyboard)
{
    CORE_ASSERT(keyboard);
    static const struct hal_buttons_ops ops = {
        .poll = buttons_keyboard_poll,
        .describe = buttons_keyboard_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = keyboard };
}
