/* test_gl_util.c -- what OpenGL cannot do is refused in one line that says what and how much. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "platform/render/gl_util.h"
#include "tests/unit/support/gl_context.h"

static int open_context(void **state)
{
    (void)state;
    open_gl_context("gl_util");
    return 0;
}

static int close_context(void **state)
{
    (void)state;
    SDL_Quit();
    return 0;
}

static const struct gl_texture_desc grey = {
    .internal_format = GL_R8, .format = GL_RED, .width = 4, .height = 4
};

static void test_a_texture_wider_than_the_driver_takes_is_refused_with_both_sizes(void **state)
{
    (void)state;
    struct gl_status status = { 0 };
    struct gl_texture_desc desc = grey;
    GLint side_max = 0;
    char expected[HAL_TEXT_SIZE];
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side_max);
    desc.width = (uint32_t)side_max + 1u;
    assert_int_equal(gl_texture(&status, "wall", &desc), 0);
    snprintf(expected, sizeof expected, "texture wall is %ux4, and this OpenGL driver takes %dx%d",
             desc.width, side_max, side_max);
    assert_string_equal(status.text, expected);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void test_an_array_of_more_layers_than_the_driver_takes_is_refused_too(void **state)
{
    (void)state;
    struct gl_status status = { 0 };
    struct gl_texture_desc desc = grey;
    GLint layers_max = 0;
    char expected[HAL_TEXT_SIZE];
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers_max);
    desc.layers = (uint32_t)layers_max + 1u;
    assert_int_equal(gl_texture(&status, "book", &desc), 0);
    snprintf(expected, sizeof expected,
             "texture book has %u layers, and this OpenGL driver takes %d", desc.layers,
             layers_max);
    assert_string_equal(status.text, expected);
}

static void test_one_that_fits_is_made(void **state)
{
    (void)state;
    struct gl_status status = { 0 };
    const GLuint texture = gl_texture(&status, "tile", &grey);
    assert_int_not_equal(texture, 0);
    assert_true(gl_is_well(&status));
    glDeleteTextures(1, &texture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_texture_wider_than_the_driver_takes_is_refused_with_both_sizes),
        cmocka_unit_test(test_an_array_of_more_layers_than_the_driver_takes_is_refused_too),
        cmocka_unit_test(test_one_that_fits_is_made),
    };
    return cmocka_run_group_tests_name("gl_util", tests, open_context, close_context);
}
