/* test_gl_util.c -- Tests that a texture beyond the limits of OpenGL is rejected with a message
 * that names both sizes. */
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

static const struct gl_texture_desc grey = { .internal_format = GL_R8, .width = 4, .height = 4 };

static void test_a_too_wide_texture_is_rejected_with_both_sizes(void **state)
{
    (void)state;
    struct gl_status status = { 0 };
    struct gl_texture_desc desc = grey;
    GLint side_max = 0;
    char expected[HAL_TEXT_SIZE];
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side_max);
    desc.width = (uint32_t)side_max + 1u;
    assert_int_equal(gl_texture(&status, "wall", &desc), 0);
    snprintf(expected, sizeof expected,
             "texture wall is %ux4 texels, but this OpenGL driver supports at most %dx%d",
             desc.width, side_max, side_max);
    assert_string_equal(status.text, expected);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void test_a_texture_array_with_too_many_layers_is_rejected(void **state)
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
             "texture book has %u layers, but this OpenGL driver supports at most %d", desc.layers,
             layers_max);
    assert_string_equal(status.text, expected);
}

static void test_a_texture_within_the_limits_is_created(void **state)
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
        cmocka_unit_test(test_a_too_wide_texture_is_rejected_with_both_sizes),
        cmocka_unit_test(test_a_texture_array_with_too_many_layers_is_rejected),
        cmocka_unit_test(test_a_texture_within_the_limits_is_created),
    };
    return cmocka_run_group_tests_name("gl_util", tests, open_context, close_context);
}
