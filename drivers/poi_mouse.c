/* poi_mouse.c -- SDL mouse events into pointer reports; the decoder does the rest. */
#include "drivers/poi_mouse.h"

#include <SDL.h>
#include <stdio.h>

#define EVENT_BATCH 64

void poi_mouse_init(struct poi_mouse *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height)
{
    *mouse = (struct poi_mouse){
        .clock = clock,
        .report = {
            .x_px = 0.5f * (float)width,
            .y_px = 0.5f * (float)height,
            .width_px = width,
            .height_px = height,
        },
    };
    pointer_poi_init(&mouse->pointer, view);
    pointer_fan_init(&mouse->fan, view);
    snprintf(mouse->text, sizeof mouse->text, "mouse not opened yet");
}

static uint64_t mouse_now_ns(const struct poi_mouse *mouse)
{
    return mouse->clock.ops->now_ns(mouse->clock.self);
}

/* Keys are taken out of the queue by whoever has the buttons; this only sees them pass. Key, not
 * place on the board: it is F where F is printed. */
static int watch_key(void *self, SDL_Event *event)
{
    struct poi_mouse *mouse = self;
    if ((event->type == SDL_KEYDOWN || event->type == SDL_KEYUP) &&
        event->key.keysym.sym == SDLK_f) {
        mouse->fan_key = event->type == SDL_KEYDOWN;
    }
    return 0;
}

static int poi_mouse_open(void *self)
{
    struct poi_mouse *mouse = self;
    if (!SDL_WasInit(SDL_INIT_VIDEO)) {
        snprintf(mouse->text, sizeof mouse->text,
                 "no mouse: there is no window for it to move over");
        return HAL_ERR_NONE;
    }
    SDL_ShowCursor(SDL_DISABLE); /* The poi is the cursor. */
    const char *video = SDL_GetCurrentVideoDriver();
    snprintf(mouse->text, sizeof mouse->text, "mouse (SDL %s)", video ? video : "?");
    mouse->last_poll_ns = mouse_now_ns(mouse);
    SDL_DelEventWatch(watch_key, mouse); /* Opened again, it still watches once. */
    SDL_AddEventWatch(watch_key, mouse);
    return HAL_OK;
}

static void learn_window(struct pointer_report *report, uint32_t window_id)
{
    SDL_Window *window = SDL_GetWindowFromID(window_id);
    int width = 0;
    int height = 0;
    if (window) {
        SDL_GetWindowSize(window, &width, &height);
    }
    if (width > 0 && height > 0) {
        report->width_px = (uint32_t)width;
        report->height_px = (uint32_t)height;
    }
}

static uint32_t button_bit(uint8_t sdl_button)
{
    return sdl_button == SDL_BUTTON_LEFT    ? POINTER_DIP
           : sdl_button == SDL_BUTTON_RIGHT ? POINTER_LEVEL
                                            : 0u;
}

static void take_event(struct pointer_report *report, const SDL_Event *event)
{
    report->wheel_notches = 0.0f;
    switch (event->type) {
    case SDL_MOUSEMOTION:
        learn_window(report, event->motion.windowID);
        report->x_px = (float)event->motion.x;
        report->y_px = (float)event->motion.y;
        break;
    case SDL_MOUSEBUTTONDOWN:
        report->buttons |= button_bit(event->button.button);
        break;
    case SDL_MOUSEBUTTONUP:
        report->buttons &= ~button_bit(event->button.button);
        break;
    case SDL_MOUSEWHEEL:
        report->wheel_notches = event->wheel.direction == SDL_MOUSEWHEEL_FLIPPED
                                    ? -event->wheel.preciseY
                                    : event->wheel.preciseY;
        break;
    default:
        break;
    }
}

/* What the pointer says goes to both hands; each heeds what is its own. */
static int tell_hands(struct poi_mouse *mouse)
{
    pointer_fan_report(&mouse->fan, &mouse->report);
    return pointer_poi_report(&mouse->pointer, &mouse->report);
}

/* The key has no place in the queue among the mouse's events: it counts from the poll after. */
static void take_fan_key(struct poi_mouse *mouse, uint64_t now_ns)
{
    const uint32_t fan = mouse->fan_key ? (uint32_t)POINTER_FAN : 0u;
    if ((mouse->report.buttons & POINTER_FAN) != fan) {
        mouse->report.buttons = (mouse->report.buttons & ~(uint32_t)POINTER_FAN) | fan;
        mouse->report.wheel_notches = 0.0f;
        mouse->report.time_ns = now_ns;
        tell_hands(mouse);
    }
}

static struct poi_sample sample_at(struct poi_mouse *mouse, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .target = pointer_poi_target(&mouse->pointer, time_ns),
    };
}

/* SDL stamps a whole batch with the moment it was pumped, so the reports of a fast mouse are spread
 * evenly over the time since the last poll. The last sample is of now: the stroke goes on, and a
 * pointer at rest is still a hand. */
static int poi_mouse_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct poi_mouse *mouse = self;
    SDL_Event events[EVENT_BATCH];
    const uint64_t now_ns = mouse_now_ns(mouse);
    uint32_t count = 0;
    int taken;
    do {
        taken = SDL_PeepEvents(events, EVENT_BATCH, SDL_GETEVENT, SDL_MOUSEMOTION, SDL_MOUSEWHEEL);
        for (int i = 0; i < taken; i++) {
            const uint64_t span_ns = now_ns - mouse->last_poll_ns;
            take_event(&mouse->report, &events[i]);
            mouse->report.time_ns =
                mouse->last_poll_ns + span_ns * (uint64_t)(i + 1) / (uint64_t)taken;
            if (tell_hands(mouse) && count + 1 < max) {
                out[count++] = sample_at(mouse, mouse->report.time_ns);
            }
        }
        mouse->last_poll_ns = now_ns;
    } while (taken == EVENT_BATCH);
    take_fan_key(mouse, now_ns);
    if (count < max) {
        out[count++] = sample_at(mouse, now_ns);
    }
    return (int)count;
}

static void poi_mouse_look(void *self, const struct view *view)
{
    struct poi_mouse *mouse = self;
    mouse->pointer.view = mouse->fan.view = *view;
}

static int poi_mouse_feel(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_ERR_NONE; /* A mouse cannot push back. */
}

static const char *poi_mouse_describe(void *self)
{
    const struct poi_mouse *mouse = self;
    return mouse->text;
}

static int fan_open(void *self)
{
    (void)self;
    return SDL_WasInit(SDL_INIT_VIDEO) ? HAL_OK : HAL_ERR_NONE; /* The poi's open() did the rest. */
}

static int fan_poll(void *self, struct shade_input *out)
{
    struct poi_mouse *mouse = self;
    *out = pointer_fan_shade(&mouse->fan, mouse_now_ns(mouse));
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

struct hal_poi poi_mouse_device(struct poi_mouse *mouse)
{
    static const struct hal_poi_ops ops = {
        .open = poi_mouse_open,
        .poll = poi_mouse_poll,
        .feel = poi_mouse_feel,
        .look = poi_mouse_look,
        .describe = poi_mouse_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = mouse };
}
