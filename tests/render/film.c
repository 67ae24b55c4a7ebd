/* film.c -- renders the first twelve ticks of a fish's escape turn (C-start) as twelve pictures
 * side by side. A developer tool: `make film ARGS="-o out/film.png"`. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/core.h"
#include "core/tank/behavior/startle.h"
#include "platform/cpu.h"
#include "platform/kiosk/demo.h"
#include "platform/os/png.h"
#include "platform/render/display_gl.h"

#define SIDE_PX 960u
#define LENGTH_M 0.07f
/* Middle of the path that the fish takes during the twelve ticks. The camera points at this
 * position. */
#define MIDDLE_X_M 0.015f
#define MIDDLE_Z_M 0.027f
#define EYE_M 0.30f /* Height of the camera above the water. */
/* Tangent of half the view angle. With this angle, the picture shows 11 cm at the depth of the
 * fish. */
#define HALF_TAN 0.165f

static struct core core;
static struct scene scene;
static struct display_gl display;
static uint8_t pixels[SIDE_PX * SIDE_PX * 3u];
static uint8_t sheet_rgb[2048u * 2048u * 3u];

static void tick(void)
{
    static struct output output;
    const struct input input = { 0 };
    output.sound_count = 0;
    /* Restores the floating-point mode of the processor, which the display library may have
     * changed. */
    cpu_set_float();
    if (core_tick(&core, &input, &output) != CORE_OK) {
        fputs("film: " CPU_FLOAT_WRONG "\n", stderr);
        exit(70);
    }
}

/* Places a resting fish at half the depth of the water and startles it from its left side. */
static void stage(void)
{
    const struct core_config config = { .seed = 2014u, .fish_count = 1 };
    if (core_init(&core, &config) != CORE_OK) {
        exit(2);
    }
    struct fish *const fish = &core.world.tank.fish[0];
    fish_grow(fish, LENGTH_M, tank_behavior_params(&core.world.tank));
    fish->position_m = v3(0.0f, -0.04f, 0.03f);
    fish->angles = (struct angles){ 0.0f, 0.0f, 0.0f };
    fish->heading_rad = 0.0f;
    /* Bit field of the fish's look: completely red, with a medium temperament. */
    fish->look = 0x00010080u;
    fish->gait = GAIT_REST;
    fish->gait_left_s = 5.0f;
    fish->startle = STARTLE_PRESSURE;
    fish->startle_from_m = v3(-0.06f, -0.04f, 0.03f);
    fish->startle_s = 1.4f * CORE_TICK_S;
}

static void look_straight_down(void)
{
    core_scene(&core, &scene);
    scene.view.eye_m = v3(MIDDLE_X_M, EYE_M, MIDDLE_Z_M + 0.001f);
    scene.view.target_m = v3(MIDDLE_X_M, 0.0f, MIDDLE_Z_M);
    scene.view.half_height_tan = HALF_TAN;
    scene.view.aspect_min = 1.0f;
    scene.phase = PHASE_WORDLESS;
    scene.poi[0].present = 0;
    scene.hint = HINT_NONE;
    scene.veil = 0.0f;
}

static void show(const struct hal_display *device, struct contact_sheet *sheet, uint32_t index)
{
    const struct fish *fish = &core.world.tank.fish[0];
    struct hal_image image = { .rgb = pixels, .size = sizeof pixels };
    look_straight_down();
    device->ops->present(device->self, &scene);
    if (device->ops->capture(device->self, &image) != HAL_OK) {
        exit(1);
    }
    demo_sheet_put(sheet, index, pixels, image.width, image.height);
    printf("tick %2u: yaw %4.0f, bend %4.0f degrees, %5.2f lengths/s, tail %4.1f Hz x %.2f\n",
           index, (double)(fish->angles.yaw_rad / F_DEG), (double)(fish->bend_rad / F_DEG),
           (double)(fish->speed_m_s / fish->length_m), (double)fish->tail_beat_hz,
           (double)fish->tail_amplitude);
}

int main(int argc, char **argv)
{
    const char *const out = argc == 3 && !strcmp(argv[1], "-o") ? argv[2] : "out/film.png";
    struct contact_sheet sheet = { .rgb = sheet_rgb };
    display.config =
        (struct display_gl_config){ .width = SIDE_PX, .height = SIDE_PX, .off_screen = true };
    const struct hal_display device = display_gl_device(&display);
    if (demo_sheet_plan(&sheet, SIDE_PX, SIDE_PX) > sizeof sheet_rgb) {
        return 1;
    }
    stage();
    if (device.ops->open(device.self) != HAL_OK) {
        fprintf(stderr, "%s\n", device.ops->describe(device.self));
        return 1;
    }
    demo_sheet_clear(&sheet);
    for (uint32_t i = 0; i < SHEET_PICTURES; i++) {
        tick();
        show(&device, &sheet, i);
    }
    device.ops->close(device.self);
    return png_write(out, sheet.rgb, sheet.width, sheet.height) == 0 ? 0 : 1;
}
