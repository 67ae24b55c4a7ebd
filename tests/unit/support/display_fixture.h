/* display_fixture.h -- test fixture of the real display, which draws off screen. Tests use it to
 * check pictures and faults of the display. The tank has sixty fish. The test must include cmocka.h
 * first. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_DISPLAY_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_DISPLAY_FIXTURE_H

#include <string.h>

#include "core/core.h"
#include "platform/render/display_gl.h"

#define WIDTH 320u
#define HEIGHT 180u
#define PIXELS_SIZE (WIDTH * HEIGHT * 3u)

static struct core core;
static struct scene scene;
static struct display_gl display;
static struct hal_display device;
static uint8_t pixels[2][PIXELS_SIZE];

/* Initializes the core and opens the display; a cmocka setup function. */
static inline int open_display(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 60 };
    core_init(&core, &config);
    core_scene(&core, &scene);
    memset(&display, 0, sizeof display);
    display.config =
        (struct display_gl_config){ .width = WIDTH, .height = HEIGHT, .off_screen = true };
    device = display_gl_device(&display);
    return device.ops->open(device.self);
}

/* Closes the display; a cmocka teardown function. */
static inline int close_display(void **state)
{
    (void)state;
    device.ops->close(device.self);
    return 0;
}

/* Draws the scene and copies the picture to `out`. If the display or OpenGL reports an error, the
 * test fails. */
static inline void picture(uint8_t out[PIXELS_SIZE])
{
    struct hal_image image = { .rgb = out, .size = PIXELS_SIZE };
    /* Disables the fade-in of a session, because the first picture of a fade-in is dark. */
    scene.veil = 0.0f;
    assert_int_equal(device.ops->present(device.self, &scene), HAL_OK);
    assert_int_equal(device.ops->capture(device.self, &image), HAL_OK);
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

#define WITH_DISPLAY(test) cmocka_unit_test_setup_teardown(test, open_display, close_display)

#endif
