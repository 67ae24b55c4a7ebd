/* display_sim.c -- implements the simulated display that replaces the screen in tests. */
#include "drivers/sim/display_sim.h"

static int display_sim_open(void *self)
{
    struct display_sim *sim = self;
    sim->open_count++;
    sim->opened = !sim->away;
    sim->needs_open = sim->away;
    return sim->away ? HAL_ERR_GONE : HAL_OK;
}

static int display_sim_is_gone(const struct display_sim *sim)
{
    return sim->gone_at != 0 && sim->present_count >= sim->gone_at;
}

static int display_sim_poll(void *self, struct display_events *out)
{
    struct display_sim *sim = self;
    *out = (struct display_events){
        .quit = sim->quit,
        .lost = display_sim_is_gone(sim) ? 1 : 0,
    };
    sim->quit = 0;
    sim->needs_open |= sim->away;
    return sim->needs_open ? HAL_ERR_GONE : HAL_OK;
}

static int display_sim_present(void *self, const struct scene *scene)
{
    struct display_sim *sim = self;
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
    image->width = 1;
    image->height = 1;
    if (image->size < 3) {
        return HAL_ERR_IO;
    }
    for (int i = 0; i < 3; i++) {
        image->rgb[i] = sim->present_count > 0 ? 255 : 0;
    }
    return HAL_OK;
}

static void display_sim_close(void *self)
{
    struct display_sim *sim = self;
    sim->opened = 0;
}

static const char *display_sim_describe(void *self)
{
    (void)self;
    return "simulated display";
}

struct hal_display display_sim_device(struct display_sim *sim)
{
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
