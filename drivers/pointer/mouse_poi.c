/* mouse_poi.c -- converts SDL's mouse and finger events to pointer reports for the pointer
 * decoder. */
#include "drivers/pointer/mouse_poi.h"

#include <SDL.h>
#include <stdio.h>

#include "core/base/panic.h"

#define EVENT_BATCH 64
/* Smallest mouse motion that counts as use by a person, in pixels. A bump against the table moves a
 * mouse less. */
#define CREEP_PX 24.0f

void mouse_poi_init(struct mouse_poi *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height, uint32_t enabled)
{
    CORE_ASSERT(clock.ops);
    CORE_ASSERT(!(enabled & ~(uint32_t)(POINTER_FILTER_MOUSE | POINTER_FILTER_TOUCH)));
    *mouse = (struct mouse_poi){
        .clock = clock,
        .enabled = (uint8_t)enabled,
        .report = {
            .x_px = 0.5f * (float)width,
            .y_px = 0.5f * (float)height,
            .width_px = width,
            .height_px = height,
        },
    };
    pointer_poi_init(&mouse->pointer, view);
    snprintf(mouse->text, sizeof mouse->text, "mouse not opened yet");
}

/* Records the state of key F without removing its events, because the keyboard driver removes key
 * events from the queue. The key code is used instead of the scan code, so that the key labelled F
 * works in every keyboard layout. */
static int watch_key(void *self, SDL_Event *event)
{
    struct mouse_poi *mouse = self;
    if ((event->type == SDL_KEYDOWN || event->type == SDL_KEYUP) &&
        event->key.keysym.sym == SDLK_f) {
        mouse->fan_key = event->type == SDL_KEYDOWN;
    }
    return 0;
}

static int mouse_poi_open(void *self)
{
    struct mouse_poi *mouse = self;
    if (!SDL_WasInit(SDL_INIT_VIDEO)) {
        snprintf(mouse->text, sizeof mouse->text, "no mouse: there is no window");
        return HAL_ERR_ABSENT;
    }
    SDL_ShowCursor(SDL_DISABLE); /* SDL's cursor is hidden because the drawn poi serves as the
                                    cursor. */
    static const char *const names[] = { "", "mouse", "touch screen", "mouse or touch screen" };
    const char *video = SDL_GetCurrentVideoDriver();
    snprintf(mouse->text, sizeof mouse->text, "%s (SDL %s)", names[mouse->enabled & 3u],
             video ? video : "?");
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, mouse->enabled & POINTER_FILTER_TOUCH ? "0" : "1");
    mouse->last_poll_ns = hal_now_ns(mouse->clock);
    SDL_DelEventWatch(watch_key, mouse); /* An existing event watch for key F is removed first.
                                            After reopening, the watch is therefore registered only
                                            once. */
    SDL_AddEventWatch(watch_key, mouse);
    return HAL_OK;
}

/* Reads the size of the window. Without a window system a touch event has no window. The current GL
 * window is then used. */
static void learn_window(struct pointer_report *report, uint32_t window_id)
{
    SDL_Window *named = SDL_GetWindowFromID(window_id);
    SDL_Window *window = named ? named : SDL_GL_GetCurrentWindow();
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

static void take_mouse(struct mouse_poi *mouse, const SDL_Event *event)
{
    struct pointer_report *report = &mouse->report;
    switch (event->type) {
    case SDL_MOUSEMOTION:
        learn_window(report, event->motion.windowID);
        report->x_px = (float)event->motion.x;
        report->y_px = (float)event->motion.y;
        break;
    case SDL_MOUSEBUTTONDOWN:
        mouse->mouse_buttons |= button_bit(event->button.button);
        break;
    case SDL_MOUSEBUTTONUP:
        mouse->mouse_buttons &= ~button_bit(event->button.button);
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

bool mouse_poi_is_used(void *self)
{
    const struct mouse_poi *mouse = self;
    return mouse->used_ns > 0 && hal_now_ns(mouse->clock) - mouse->used_ns < POINTER_USED_NS;
}

static void mouse_poi_take_event(struct mouse_poi *mouse, const SDL_Event *event)
{
    CORE_ASSERT(event);
    const bool is_finger = event->type >= SDL_FINGERDOWN;
    const uint32_t filter = is_finger ? POINTER_FILTER_TOUCH : POINTER_FILTER_MOUSE;
    if (mouse->enabled & filter) {
        /* A window that opens under a resting pointer causes a motion event, which must not count
         * as use by a person. Use is recorded after CREEP_PX of motion. */
        const bool is_motion = event->type == SDL_MOUSEMOTION;
        mouse->crept_px += is_motion
                               ? f_abs((float)event->motion.xrel) + f_abs((float)event->motion.yrel)
                               : CREEP_PX;
        if (mouse->crept_px >= CREEP_PX) {
            mouse->used_ns = hal_now_ns(mouse->clock);
            mouse->crept_px = 0.0f;
        }
    }
    mouse->report.wheel_notches = 0.0f;
    if (is_finger && (mouse->enabled & POINTER_FILTER_TOUCH)) {
        const SDL_TouchFingerEvent *finger = &event->tfinger;
        const struct touch_event touch = {
            .kind = (uint8_t)(finger->type == SDL_FINGERDOWN ? TOUCH_DOWN
                              : finger->type == SDL_FINGERUP ? TOUCH_UP
                                                             : TOUCH_MOVE),
            .id = finger->fingerId, /* The field `time_ns` is not set, because the pointer report
                                       contains the time. */
            .x = finger->x,
            .y = finger->y,
        };
        if (touch_fingers_take(&mouse->fingers, &touch)) {
            learn_window(&mouse->report, finger->windowID);
            touch_fingers_point(&mouse->fingers, &mouse->report);
        }
    } else if (!is_finger && (mouse->enabled & POINTER_FILTER_MOUSE)) {
        take_mouse(mouse, event);
    }
    mouse->report.buttons = (mouse->report.buttons & POINTER_FAN) | mouse->mouse_buttons |
                            (mouse->fingers.dips ? (uint32_t)POINTER_DIP : 0u);
}

/* Passes the report to the pointer decoder. Returns true if the decoder accepted the report. */
static bool report_pointer(struct mouse_poi *mouse)
{
    struct pointer_report seen = pointer_report_on(&mouse->report, &mouse->display_settings);
    pointer_aid_apply(&mouse->aid, mouse->pointer.dip.scoops, &seen);
    return pointer_poi_report(&mouse->pointer, &seen);
}

static struct poi_sample sample_at(struct mouse_poi *mouse, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .target = pointer_poi_target(&mouse->pointer, time_ns),
    };
}

/* Processes events and writes a sample for each event. SDL sets the time stamp of an event when SDL
 * moves the event into its queue. Therefore the reports are spread evenly over the time from the
 * previous poll to the current poll. The last element of `out` stays free for the caller. */
static uint32_t take_events(struct mouse_poi *mouse, uint32_t first, uint32_t last, uint64_t now_ns,
                            struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(first <= last);
    CORE_ASSERT(now_ns >= mouse->last_poll_ns);
    SDL_Event events[EVENT_BATCH];
    uint32_t count = 0;
    int taken;
    do {
        taken = SDL_PeepEvents(events, EVENT_BATCH, SDL_GETEVENT, first, last);
        for (int i = 0; i < taken; i++) {
            const uint64_t span_ns = now_ns - mouse->last_poll_ns;
            mouse_poi_take_event(mouse, &events[i]);
            mouse->report.time_ns =
                mouse->last_poll_ns + span_ns * (uint64_t)(i + 1) / (uint64_t)taken;
            if (report_pointer(mouse) && count + 1 < max) {
                out[count++] = sample_at(mouse, mouse->report.time_ns);
            }
        }
        mouse->last_poll_ns = taken > 0 ? now_ns : mouse->last_poll_ns;
    } while (taken == EVENT_BATCH);
    return count;
}

/* Processes all events. The last sample is at the current time, because a dip continues between
 * events and a resting pointer is still valid. */
static int mouse_poi_poll(void *self, struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(out || max == 0);
    struct mouse_poi *mouse = self;
    const uint64_t now_ns = hal_now_ns(mouse->clock);
    uint32_t count = take_events(mouse, SDL_FINGERDOWN, SDL_FINGERMOTION, now_ns, out, max);
    count += take_events(mouse, SDL_MOUSEMOTION, SDL_MOUSEWHEEL, now_ns, out + count, max - count);
    mouse->last_poll_ns = now_ns;
    /* The state of key F takes effect at `now_ns`, because the order of the key press and the mouse
     * events is not known. */
    const uint32_t fan = mouse->fan_key ? (uint32_t)POINTER_FAN : 0u;
    if ((mouse->report.buttons & POINTER_FAN) != fan) {
        mouse->report.buttons = (mouse->report.buttons & ~(uint32_t)POINTER_FAN) | fan;
        mouse->report.wheel_notches = 0.0f;
        mouse->report.time_ns = now_ns;
        report_pointer(mouse);
    }
    if (count < max) {
        out[count++] = sample_at(mouse, now_ns);
    }
    return (int)count;
}

static void mouse_poi_set_view(void *self, const struct view *view,
                               const struct display_settings *display_settings, bool scoops)
{
    CORE_ASSERT(view && display_settings);
    struct mouse_poi *mouse = self;
    mouse->pointer.view = *view;
    const bool clicks = display_settings->dips_by_click != 0;
    if (scoops != mouse->pointer.dip.scoops || clicks != mouse->aid.clicks) {
        pointer_aid_raise(&mouse->aid);
    }
    mouse->aid.clicks = clicks;
    mouse->aid.reach_percent = display_settings->reach_percent;
    mouse->pointer.dip.scoops = scoops;
    mouse->display_settings = *display_settings;
}

static int mouse_poi_set_force(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_ERR_ABSENT; /* A mouse has no force feedback. */
}

static const char *mouse_poi_describe(void *self)
{
    const struct mouse_poi *mouse = self;
    return mouse->text;
}

/* ---- Fan and START button -------------------------------------------------------------------- */

static int mouse_poi_fan_open(void *self)
{
    (void)self;
    /* Checking SDL's video subsystem is enough, because open() of the poi device has initialized
     * everything else that the fan needs. */
    return SDL_WasInit(SDL_INIT_VIDEO) ? HAL_OK : HAL_ERR_ABSENT;
}

static int mouse_poi_fan_poll(void *self, struct shade_input *out)
{
    struct mouse_poi *mouse = self;
    *out = pointer_fan_shade(&mouse->pointer, hal_now_ns(mouse->clock));
    return HAL_OK;
}

static const char *mouse_poi_fan_describe(void *self)
{
    (void)self;
    return "the mouse while F is held";
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
    return mouse->enabled & POINTER_FILTER_TOUCH ? "three fingers start" : "";
}

struct hal_controller_devices mouse_poi_devices(struct mouse_poi *mouse)
{
    static const struct hal_poi_ops poi = {
        .open = mouse_poi_open,
        .poll = mouse_poi_poll,
        .set_force = mouse_poi_set_force,
        .set_view = mouse_poi_set_view,
        .describe = mouse_poi_describe,
    };
    static const struct hal_fan_ops fan = {
        .open = mouse_poi_fan_open,
        .poll = mouse_poi_fan_poll,
        .describe = mouse_poi_fan_describe,
    };
    static const struct hal_buttons_ops buttons = {
        .poll = mouse_poi_buttons_poll,
        .describe = buttons_describe,
    };
    return (struct hal_controller_devices){
        .poi = { &poi, mouse },
        .fan = { &fan, mouse },
        .buttons = { &buttons, mouse },
    };
}
