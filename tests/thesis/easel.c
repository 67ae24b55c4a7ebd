/* easel.c -- implementation of easel.h: renders pictures of a tank with the kiosk's renderer and
 * without a screen. One of the cameras looks through the side wall of the tank, which the kiosk's
 * camera never does. */
#include "tests/thesis/easel.h"

#include <stdio.h>
#include <string.h>

#include "core/core.h"
#include "platform/os/png.h"
#include "platform/render/display_gl.h"

#define ASPECT ((float)EASEL_WIDTH / (float)EASEL_HEIGHT)
/* Distance of the side camera from the tank. The distance is so large that near and far fish appear
 * almost equally large. */
#define SIDE_EYE_M 6.5f

/* Core that fills the scene for the renderer. Its tick function is never called. */
static struct core core;
static struct scene scene;
static struct display_gl display;
static uint8_t fine[EASEL_WIDTH * EASEL_FINER_MAX * EASEL_HEIGHT * EASEL_FINER_MAX * 3u];
static uint32_t finer, fine_width, fine_height;
static uint8_t picture[EASEL_WIDTH * EASEL_HEIGHT * 3u];

int easel_open(uint32_t times)
{
    const struct core_config config = { .preset = TANK_PRESET_THESIS, .fish_count = 1 };
    finer = times;
    fine_width = EASEL_WIDTH * finer;
    fine_height = EASEL_HEIGHT * finer;
    display.config = (struct display_gl_config){
        .width = fine_width,
        .height = fine_height,
        .off_screen = true,
        /* If the scale is 0, the renderer selects the scale itself, as in the kiosk. Time
         * measurements need the kiosk's scale. */
        .scene_scale = finer > 1u ? 1.0f : 0.0f,
    };
    const struct hal_display device = display_gl_device(&display);
    if (core_init(&core, &config) != CORE_OK || device.ops->open(device.self) != HAL_OK) {
        fprintf(stderr, "no pictures: %s\n", device.ops->describe(device.self));
        return -1;
    }
    return 0;
}

const char *easel_describe(void)
{
    return display.renderer.gl_name;
}

void easel_close(void)
{
    const struct hal_display device = display_gl_device(&display);
    device.ops->close(device.self);
}

/* ---- Cameras -------------------------------------------------------------------------------- */

/* Returns a view of `target_m` from the position `target_m` + `away_m`. At the target, the picture
 * is `width_m` wide. */
static struct view view_of(vec3 target_m, vec3 away_m, float width_m)
{
    return (struct view){
        .eye_m = v3_add(target_m, away_m),
        .target_m = target_m,
        .half_height_tan = 0.5f * width_m / ASPECT / v3_length(away_m),
        .aspect_min = 1.0f,
    };
}

static struct view camera(const struct easel_shot *shot, vec3 size_m)
{
    const vec3 middle = { 0.0f, 0.0f, 0.0f };
    switch (shot->camera) {
    case CAMERA_TOP:
        return view_of(middle, v3(0.0f, 3.0f, 0.0f), 1.10f * size_m.x);
    case CAMERA_CENTRE:
        return view_of(middle, v3(0.0f, 1.6f, 0.0f), 0.42f);
    case CAMERA_SIDE:
        return view_of(v3(0.0f, -0.5f * size_m.y, 0.0f), v3(0.0f, 0.0f, SIDE_EYE_M),
                       1.13f * size_m.x);
    case CAMERA_SLANT:
        return view_of(v3(0.0f, 0.0f, 0.05f), v3(0.0f, 2.252f, 1.30f), 1.18f * size_m.x);
    case CAMERA_SHADE:
        return view_of(middle, v3(0.0f, 2.0f, 0.0f), 0.90f);
    case CAMERA_NOSES:
        return view_of(v3(0.0f, 0.0f, 0.02f), v3(0.0f, 0.75f, 0.75f), 0.60f);
    default:
        return view_of(shot->look_at_m, v3(0.0f, 0.8f, 0.0f), shot->width_m);
    }
}

/* ---- Drawing -------------------------------------------------------------------------------- */

/* Adds the shadows of the fans that the options place. The fans themselves are not drawn, because
 * they would hide the fish. */
static void show_shades(const struct tank_lab *lab)
{
    const double now_s = (double)lab->tick / CORE_TICK_HZ;
    for (uint32_t i = 0; i < lab->plan->shade_count; i++) {
        const struct plan_shade *shade = &lab->plan->shade[i];
        scene.fan[i] = (struct scene_fan){
            .present = now_s >= shade->from_s && now_s < shade->to_s,
            .unseen = 1,
            .x_m = (float)shade->x_m,
            .z_m = (float)shade->z_m,
            .radius_m = (float)shade->radius_m,
            .dark = SHADE_FAN_DARK,
        };
    }
}

static void show(const struct tank_lab *lab, const struct view *view)
{
    core.world.tank = lab->tank;
    core.game.tick = lab->tick;
    core_scene(&core, &scene);
    scene.phase = PHASE_WORDLESS;
    scene.bowl[0].present = 0;
    show_shades(lab);
    if (view) {
        scene.view = *view;
    }
}

static float near_wall_m(void)
{
    return SIDE_EYE_M - 0.5f * scene.tank_size_m.z;
}

/* Returns the row of pixels, counted from the bottom, in which the height `y_m` on the near wall
 * appears. */
static GLint row_of(const struct view *view, float y_m)
{
    const float tan_y = view_half_height_tan(view, ASPECT);
    const float share = (y_m - view->eye_m.y) / (tan_y * near_wall_m());
    return (GLint)(0.5f * (1.0f + share) * (float)fine_height);
}

static void fill_rows(GLint low, GLint high, float red, float green, float blue)
{
    const float tan_y = view_half_height_tan(&scene.view, ASPECT);
    const float half = 0.5f * scene.tank_size_m.x / (tan_y * ASPECT * near_wall_m());
    const GLint left = (GLint)(0.5f * (1.0f - half) * (float)fine_width);
    glEnable(GL_SCISSOR_TEST);
    glScissor(left, low, (GLint)fine_width - 2 * left, high - low);
    glClearColor(red, green, blue, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/* Fills the picture with a floor and with water that becomes darker with depth. The walls are not
 * drawn, because the side camera looks through them. */
static void fill_water(void)
{
    const GLint floor = row_of(&scene.view, -scene.tank_size_m.y);
    const GLint surface = row_of(&scene.view, 0.0f);
    const int bands = 32;
    glClearColor(0.96f, 0.95f, 0.93f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < bands; i++) {
        const float up = ((float)i + 0.5f) / (float)bands;
        const GLint low = floor + (surface - floor) * i / bands;
        const GLint high = floor + (surface - floor) * (i + 1) / bands;
        fill_rows(low, high, 0.42f + 0.36f * up, 0.72f + 0.19f * up, 0.82f + 0.13f * up);
    }
    fill_rows(floor - 10, floor, 0.30f, 0.52f, 0.60f);
    fill_rows(surface - 3, surface, 0.96f, 1.00f, 1.00f);
}

static void draw_side(struct renderer *renderer)
{
    const GLuint caustics = renderer->light.caustics.texture;
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)fine_width, (float)fine_height);
    renderer->frame.is_day = true;
    frame_begin(&renderer->frame, &scene, &transform,
                (const uint32_t[2]){ fine_width, fine_height },
                (const uint32_t[2]){ fine_width, fine_height });
    fish_pass_prepare(&renderer->fish, &scene, &renderer->frame, &renderer->quality);
    light_pass_shades(&renderer->light, &renderer->frame.shades);
    light_pass_caustics(&renderer->light, &renderer->textures);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, (GLsizei)fine_width, (GLsizei)fine_height);
    fill_water();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    for (enum fish_group group = FISH_SMALL; group <= FISH_NEAR; group++) {
        fish_pass_bodies(&renderer->fish, group, false, &renderer->textures, caustics);
    }
    for (enum fish_group group = FISH_SMALL; group <= FISH_NEAR; group++) {
        fish_pass_fins(&renderer->fish, group, caustics);
    }
    glDisable(GL_DEPTH_TEST);
}

/* Reduces the picture to its final size. Each pixel of the result is the mean of `finer` x `finer`
 * drawn pixels. */
static void shrink(void)
{
    const uint32_t area = finer * finer;
    for (uint32_t i = 0; i < EASEL_WIDTH * EASEL_HEIGHT * 3u; i++) {
        const uint32_t channel = i % 3u, x = i / 3u % EASEL_WIDTH, y = i / 3u / EASEL_WIDTH;
        uint32_t sum = 0;
        for (uint32_t k = 0; k < area; k++) {
            const uint32_t fx = x * finer + k % finer;
            const uint32_t fy = y * finer + k / finer;
            sum += fine[(fy * fine_width + fx) * 3u + channel];
        }
        picture[i] = (uint8_t)((sum + area / 2u) / area);
    }
}

int easel_shoot(const struct tank_lab *lab, const struct easel_shot *shot, const char *path)
{
    struct hal_image image = { .rgb = fine, .size = sizeof fine };
    const struct view view = camera(shot, lab->tank.size_m);
    show(lab, &view);
    renderer_draw(&display.renderer, &scene);
    if (shot->camera == CAMERA_SIDE) {
        draw_side(&display.renderer);
    }
    const int read = renderer_read(&display.renderer, &image);
    if (read != HAL_OK || image.width != fine_width || image.height != fine_height) {
        fprintf(stderr, "%s: no picture from the renderer\n", path);
        return -1;
    }
    shrink();
    /* Keeps only the middle 2/5 of the rows in a picture of CAMERA_SIDE, because the other rows
     * show nothing of the tank. */
    const uint32_t rows = shot->camera == CAMERA_SIDE ? EASEL_HEIGHT * 2u / 5u : EASEL_HEIGHT;
    const uint32_t skip = (EASEL_HEIGHT - rows) / 2u;
    const int error = png_write(path, picture + skip * EASEL_WIDTH * 3u, EASEL_WIDTH, rows);
    if (error) {
        fprintf(stderr, "%s: %s\n", path, strerror(-error));
    }
    return error ? -1 : 0;
}

void easel_draw(const struct tank_lab *lab)
{
    const struct hal_display device = display_gl_device(&display);
    show(lab, NULL);
    device.ops->present(device.self, &scene);
    glFinish();
}
