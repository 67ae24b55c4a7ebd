/* shot.c -- plays the game for some seconds off screen, and saves a picture or measures the time of
 * the render passes.
 *
 * A developer tool: `make shot ARGS="--seconds 12 --size 1920x1080 -o shot.png"`. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "platform/os/png.h"
#include "platform/render/display_gl.h"
#include "tests/render/shot_menu.h"
#include "tests/render/shot_scene.h"

#define PIXELS_MAX (3840u * 2160u)
/* Number of frames that are drawn before the picture, after which the detailed textures of all
 * visible fish are complete. */
#define SKIN_FRAMES 150u
#define PASS_FRAMES 40u
#define MOVING_STEP_M 1e-4f /* Motion of the camera from frame to frame. */

static struct scene scene;
static struct display_gl display;
static uint8_t pixels[PIXELS_MAX * 3u];
static float step_m; /* Motion of the camera from frame to frame. */
static bool is_live; /* True if the picture of the rim and the counter is drawn in each frame. */

static double clock_ms(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

static double now_ms(void)
{
    return clock_ms(CLOCK_MONOTONIC);
}

/* Returns the CPU time of all threads in ms. CPU time varies less than the wall clock when other
 * processes use the same cores. */
static double cpu_ms(void)
{
    return clock_ms(CLOCK_PROCESS_CPUTIME_ID);
}

struct meter {
    double last, last_cpu, sums[STEP_COUNT], cpu_sums[STEP_COUNT];
};

static void on_step(void *context, enum render_step step)
{
    struct meter *const meter = context;
    glFinish();
    const double now = now_ms();
    meter->sums[step] += now - meter->last;
    meter->last = now;
    const double cpu = cpu_ms();
    meter->cpu_sums[step] += cpu - meter->last_cpu;
    meter->last_cpu = cpu;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

static const char *const step_names[STEP_COUNT] = { "prepare", "light", "ground", "life",
                                                    "surface", "above", "ui" };

static void write_step(void *context, enum render_step step)
{
    (void)context;
    fprintf(stderr, "STEP %s\n", step_names[step]);
}

static void present(const struct hal_display *device)
{
    scene.view.eye_m.x += step_m;
    if (is_live) {
        display.renderer.basin.kept = (struct deck_view){ 0 };
    }
    device->ops->present(device->self, &scene);
}

static void time_passes(const struct hal_display *device)
{
    struct meter meter = { 0 };
    double frames[PASS_FRAMES];
    for (uint32_t i = 0; i < PASS_FRAMES; i++) {
        const double start = now_ms();
        present(device);
        glFinish();
        frames[i] = now_ms() - start;
    }
    qsort(frames, PASS_FRAMES, sizeof *frames, by_value);
    display.renderer.on_step = on_step;
    display.renderer.on_step_context = &meter;
    for (uint32_t i = 0; i < PASS_FRAMES; i++) {
        glFinish();
        meter.last = now_ms();
        meter.last_cpu = cpu_ms();
        present(device);
    }
    display.renderer.on_step = NULL;
    for (uint32_t i = 0; i < STEP_COUNT; i++) {
        printf("%-8s %6.2f ms, %6.2f ms of CPU\n", step_names[i], meter.sums[i] / PASS_FRAMES,
               meter.cpu_sums[i] / PASS_FRAMES);
    }
    printf("%-8s %6.2f ms median, %.2f best, %.2f worst of %u\n", "frame", frames[PASS_FRAMES / 2],
           frames[0], frames[PASS_FRAMES - 1], PASS_FRAMES);
}

static void place(const struct hal_display *device, const struct shot_options *options)
{
    const struct display_settings display_settings = { .rotation = options->rotation,
                                                       .inset_x = options->inset,
                                                       .inset_y = options->inset,
                                                       .shift_x = options->shift,
                                                       .shift_y = options->shift,
                                                       .light = options->light,
                                                       .has_white_bowls = options->white,
                                                       .is_day = options->day };
    device->ops->set_transform(device->self, &display_settings);
}

static int keep_picture(const struct hal_display *device, const char *path)
{
    struct hal_image image = { .rgb = pixels, .size = sizeof pixels };
    if (device->ops->capture(device->self, &image) != HAL_OK ||
        png_write(path, pixels, image.width, image.height) != 0) {
        fprintf(stderr, "no picture at %s\n", path);
        return 1;
    }
    return 0;
}

/* Draws the pictures after the first one, each `every_s` of the game later. */
static int draw_later_pictures(const struct hal_display *device, struct shot_options options)
{
    char path[256];
    int status = 0;
    for (uint32_t i = 1; i < options.frames && status == 0; i++) {
        options.seconds += options.every_s;
        shot_scene(&options, &scene);
        shot_move_camera(&options, &scene);
        device->ops->present(device->self, &scene);
        snprintf(path, sizeof path, "%s%u.png", options.out, i);
        status = keep_picture(device, path);
    }
    return status;
}

int main(int argc, char **argv)
{
    const struct shot_options options = shot_options_parse(argc, argv);
    display.config = (struct display_gl_config){ .width = options.width,
                                                 .height = options.height,
                                                 .off_screen = true,
                                                 .scene_scale = options.scale,
                                                 .samples = options.samples };
    const struct hal_display device = display_gl_device(&display);
    if (options.menu && !shot_menu_exists(options.menu, options.step)) {
        fprintf(stderr, "shot: --menu '%s' --step %u: no such page or step\n", options.menu,
                options.step);
        return 2;
    }
    shot_scene(&options, &scene);
    const double before = now_ms();
    if (device.ops->open(device.self) != HAL_OK) {
        fprintf(stderr, "%s\n", device.ops->describe(device.self));
        return 1;
    }
    place(&device, &options);
    if (renderer_lower(&display.renderer, options.quality_step) != HAL_OK) {
        fprintf(stderr, "%s\n", display.renderer.status.text);
        return 1;
    }
    printf("%s (opened in %.0f ms)\n", device.ops->describe(device.self), now_ms() - before);
    display.renderer.on_step = options.steps ? write_step : NULL;
    /* With --steps, two frames are drawn before the picture, because the first frame also draws
     * what later frames keep. */
    const bool is_moving = options.closer || options.drift;
    const uint32_t frames =
        options.lab || options.album > 0 ? SKIN_FRAMES : 1u + (options.steps || is_moving);
    for (uint32_t i = 0; i < frames; i++) {
        present(&device);
        if (i == 0) {
            shot_move_camera(&options, &scene);
            step_m = is_moving ? MOVING_STEP_M : 0.0f;
            is_live = options.live;
        }
    }
    if (options.passes) {
        time_passes(&device);
    }
    char first[256];
    snprintf(first, sizeof first, options.frames > 1 ? "%s0.png" : "%s", options.out);
    int status = keep_picture(&device, first);
    if (status == 0) {
        status = draw_later_pictures(&device, options);
    }
    device.ops->close(device.self);
    return status;
}
