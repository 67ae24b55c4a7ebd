/* hal_sim.c -- implements the simulated clock, buttons, display and audio device. */
#include "drivers/sim/hal_sim.h"

#include <string.h>

#include "core/base/panic.h"

/* ---- Clock ---------------------------------------------------------------------------------- */

static uint64_t clock_sim_now_ns(void *self)
{
    const struct clock_sim *sim = self;
    return sim->now_ns;
}

struct hal_clock sim_clock_device(struct clock_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_clock_ops ops = { .now_ns = clock_sim_now_ns };
    return (struct hal_clock){ .ops = &ops, .self = sim };
}

/* ---- Buttons -------------------------------------------------------------------------------- */

static int buttons_sim_poll(void *self, struct button_sample *out)
{
    struct buttons_sim *sim = self;
    const uint64_t now_ns = hal_now_ns(sim->clock);
    CORE_ASSERT(sim->next <= sim->event_count);
    *out = (struct button_sample){ 0 };
    while (sim->next < sim->event_count && sim->events[sim->next].time_ns <= now_ns) {
        const struct button_event *event = &sim->events[sim->next++];
        out->pressed |= event->pressed;
        for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
            out->coin_count[line] += event->coin_count[line];
        }
        out->quit |= event->quit;
        out->full_screen |= event->full_screen;
        sim->held = (sim->held | event->pressed) & ~event->released;
    }
    out->held = sim->held;
    return HAL_OK;
}

static const char *buttons_sim_describe(void *self)
{
    (void)self;
    return "buttons pressed by a script";
}

struct hal_buttons sim_buttons_device(struct buttons_sim *sim)
{
    CORE_ASSERT(sim && sim->clock.ops && (sim->events || sim->event_count == 0));
    static const struct hal_buttons_ops ops = {
        .poll = buttons_sim_poll,
        .describe = buttons_sim_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = sim };
}

/* ---- Display -------------------------------------------------------------------------------- */

static int display_sim_open(void *self)
{
    struct display_sim *sim = self;
    sim->open_count++;
    sim->opened = !sim->away;
    sim->needs_open = sim->away;
    return sim->away ? HAL_ERR_GONE : HAL_OK;
}

static bool display_sim_is_gone(const struct display_sim *sim)
{
    return sim->gone_at != 0 && sim->present_count >= sim->gone_at;
}

static int display_sim_poll(void *self, struct display_events *out)
{
    struct display_sim *sim = self;
    CORE_ASSERT(out);
    *out = (struct display_events){
        .quit = sim->quit,
        .lost = display_sim_is_gone(sim),
    };
    sim->quit = false;
    sim->needs_open |= sim->away;
    return sim->needs_open ? HAL_ERR_GONE : HAL_OK;
}

static int display_sim_present(void *self, const struct scene *scene)
{
    struct display_sim *sim = self;
    CORE_ASSERT(scene != &sim->scene);
    if (display_sim_is_gone(sim) || sim->needs_open) {
        return HAL_ERR_GONE;
    }
    sim->present_count++;
    if (sim->present_count == sim->fail_at) {
        return HAL_ERR_IO;
    }
    sim->scene = *scene;
    return HAL_OK;
}

static void display_sim_set_transform(void *self, const struct display_settings *display_settings)
{
    struct display_sim *sim = self;
    CORE_ASSERT(display_settings);
    sim->display_settings = *display_settings;
}

static int display_sim_toggle(void *self)
{
    struct display_sim *sim = self;
    sim->full_screen_count++;
    return HAL_OK;
}

/* Returns an image of one pixel: black before the first present(), white afterwards. */
static int display_sim_capture(void *self, struct hal_image *image)
{
    const struct display_sim *sim = self;
    CORE_ASSERT(image && (image->rgb || image->size < 3));
    image->width = 1;
    image->height = 1;
    if (image->size < 3) {
        return HAL_ERR_IO;
    }
    memset(image->rgb, sim->present_count > 0 ? 255 : 0, 3);
    return HAL_OK;
}

static void display_sim_close(void *self)
{
    struct display_sim *sim = self;
    sim->opened = false;
}

static const char *display_sim_describe(void *self)
{
    (void)self;
    return "simulated display";
}

struct hal_display sim_display_device(struct display_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_display_ops ops = {
        .open = display_sim_open,
        .poll = display_sim_poll,
        .present = display_sim_present,
        .set_transform = display_sim_set_transform,
        .toggle_full_screen = display_sim_toggle,
        .capture = display_sim_capture,
        .close = display_sim_close,
        .describe = display_sim_describe,
    };
    return (struct hal_display){ .ops = &ops, .self = sim };
}

/* ---- Audio ---------------------------------------------------------------------------------- */

static int audio_sim_open(void *self)
{
    struct audio_sim *sim = self;
    sim->open_count++;
    return sim->gone ? HAL_ERR_ABSENT : HAL_OK;
}

static int audio_sim_play(void *self, const struct sound_event *event)
{
    struct audio_sim *sim = self;
    CORE_ASSERT(event);
    if (sim->gone) {
        return HAL_ERR_GONE;
    }
    if (sim->fails || event->sound >= SOUND_COUNT) {
        return HAL_ERR_IO;
    }
    sim->played[event->sound]++;
    sim->gain = event->gain;
    return HAL_OK;
}

static void audio_sim_set_levels(void *self, const struct sound_levels *levels)
{
    struct audio_sim *sim = self;
    CORE_ASSERT(levels);
    sim->levels = *levels;
}

static const char *audio_sim_describe(void *self)
{
    (void)self;
    return "simulated sound";
}

static void audio_sim_close(void *self)
{
    (void)self;
}

struct hal_audio sim_audio_device(struct audio_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_audio_ops ops = {
        .open = audio_sim_open,
        .play = audio_sim_play,
        .set_levels = audio_sim_set_levels,
        .describe = audio_sim_describe,
        .close = audio_sim_close,
    };
    return (struct hal_audio){ .ops = &ops, .self = sim };
}
