/* test_warm_up.c -- Tests that the game uses no shader program for the first time in a frame. A
 * driver compiles a program when it is used first, separately for the screen and for textures. The
 * functions below replace those of OpenGL, so that the tests see each draw call. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <dlfcn.h>

#include <cmocka.h>

#include "core/core.h"
#include "platform/os/clock.h"
#include "platform/render/renderer.h"
#include "tests/unit/support/display_fixture.h"

#define PROGRAMS_MAX 512u

/* State of each program: whether it exists, and whether it was drawn into a texture ([0]) and to
 * the screen ([1]). */
static bool exists[PROGRAMS_MAX], drawn[PROGRAMS_MAX][2];
static GLuint program_now, framebuffer_now;
/* Number of draw calls that used a program for the first time, and the last such program. */
static uint32_t first_uses, last_first;

/* Defines `next`, the function of the OpenGL library with the name of the enclosing function. */
#define NEXT(name)                                                                                 \
    static __typeof__(name) *next;                                                                 \
    if (!next) {                                                                                   \
        *(void **)&next = dlsym(RTLD_NEXT, #name);                                                 \
    }

static void note_draw(void)
{
    bool *const is_drawn = &drawn[program_now % PROGRAMS_MAX][framebuffer_now == 0];
    first_uses += !*is_drawn;
    last_first = *is_drawn ? last_first : program_now;
    *is_drawn = true;
}

GLuint glCreateProgram(void)
{
    NEXT(glCreateProgram)
    const GLuint program = next();
    exists[program % PROGRAMS_MAX] = true;
    memset(drawn[program % PROGRAMS_MAX], 0, sizeof drawn[0]);
    return program;
}

void glDeleteProgram(GLuint program)
{
    NEXT(glDeleteProgram)
    exists[program % PROGRAMS_MAX] = false;
    next(program);
}

void glUseProgram(GLuint program)
{
    NEXT(glUseProgram)
    program_now = program;
    next(program);
}

void glBindFramebuffer(GLenum target, GLuint framebuffer)
{
    NEXT(glBindFramebuffer)
    framebuffer_now = target == GL_READ_FRAMEBUFFER ? framebuffer_now : framebuffer;
    next(target, framebuffer);
}

void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    NEXT(glDrawArrays)
    note_draw();
    next(mode, first, count);
}

void glDrawArraysInstanced(GLenum mode, GLint first, GLsizei count, GLsizei instances)
{
    NEXT(glDrawArraysInstanced)
    note_draw();
    next(mode, first, count, instances);
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices)
{
    NEXT(glDrawElements)
    note_draw();
    next(mode, count, type, indices);
}

void glDrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void *indices,
                             GLsizei instances)
{
    NEXT(glDrawElementsInstanced)
    note_draw();
    next(mode, count, type, indices, instances);
}

static void warm_up(void)
{
    const struct hal_clock clock = clock_device();
    const uint64_t start_ns = clock.ops->now_ns(clock.self);
    for (uint32_t i = 0; i < RENDERER_WARM_UPS; i++) {
        assert_int_equal(renderer_warm_up(&display.renderer, &display.shown, i), HAL_OK);
    }
    print_message("warm-up: %.0f ms\n", (double)(clock.ops->now_ns(clock.self) - start_ns) * 1e-6);
    assert_int_equal(display.renderer.step, 0);
    assert_float_equal(display.renderer.transform.light, 1.0f, 0.0f);
}

static void test_every_program_is_used_while_the_game_loads(void **state)
{
    (void)state;
    warm_up();
    uint32_t count = 0;
    for (uint32_t program = 0; program < PROGRAMS_MAX; program++) {
        if (exists[program] && !drawn[program][0] && !drawn[program][1]) {
            fail_msg("program %u is used first in the game", program);
        }
        count += exists[program];
    }
    print_message("%u programs\n", count);
    assert_true(count > 40);
}

/* Draws the scene, and expects that no program is used for the first time. */
static void expect_no_first_use(const char *what)
{
    first_uses = 0;
    picture(pixels[0]);
    if (first_uses > 0) {
        fail_msg("%s: %u first uses, the last of program %u", what, first_uses, last_first);
    }
}

static void test_a_game_uses_no_program_for_the_first_time(void **state)
{
    (void)state;
    static struct output output;
    warm_up();
    for (uint32_t second = 0; second < 40; second++) {
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            core_tick(&core, &(struct input){ 0 }, &output);
        }
        core_scene(&core, &scene);
        expect_no_first_use("attract");
    }
    for (uint32_t phase = PHASE_ATTRACT; phase <= PHASE_LEADERBOARD; phase++) {
        scene.phase = (uint8_t)phase;
        if (phase !=
            PHASE_LAB) { /* The growth lab needs more data; it draws what the album does. */
            expect_no_first_use("phase");
        }
    }
    scene.phase = PHASE_ROUND;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.player[i].plays = 1;
        scene.poi[i] = scene.poi[0];
        scene.poi[i].present = 1;
        scene.poi[i].shows_stress = i & 1u;
        scene.poi[i].water_m = i & 2u ? 0.002f : 0.0f;
        scene.fan[i] = (struct scene_fan){
            .present = 1, .x_m = 0.2f * (float)i, .radius_m = 0.1f, .dark = 0.8f
        };
    }
    expect_no_first_use("four players and fans");
    display.renderer.transform.light = 0.4f;
    expect_no_first_use("low brightness");
    scene.view.eye_m = v3_scale(scene.view.eye_m, 0.5f);
    expect_no_first_use("close camera");
}

static void test_a_lower_quality_uses_no_program_for_the_first_time(void **state)
{
    (void)state;
    warm_up();
    for (uint32_t step = 1; step <= QUALITY_STEP_MAX; step++) {
        assert_int_equal(renderer_lower(&display.renderer, step), HAL_OK);
        expect_no_first_use("quality step");
    }
}

/* If a screen is connected while the game runs, the artificial pictures are drawn between the
 * pictures of the game. The pictures of the game must not depend on them. */
static void test_a_picture_after_a_warm_up_is_the_same_as_without(void **state)
{
    (void)state;
    for (uint32_t step = 0; step <= QUALITY_STEP_MAX; step += QUALITY_STEP_MAX) {
        assert_int_equal(renderer_lower(&display.renderer, step), HAL_OK);
        picture(pixels[0]);
        picture(pixels[0]);
        for (uint32_t i = 0; i < RENDERER_WARM_UPS; i++) {
            assert_int_equal(renderer_warm_up(&display.renderer, &display.shown, i), HAL_OK);
            assert_int_equal(display.renderer.step, step);
            picture(pixels[1]);
            assert_memory_equal(pixels[0], pixels[1], PIXELS_SIZE);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_DISPLAY(test_every_program_is_used_while_the_game_loads),
        WITH_DISPLAY(test_a_game_uses_no_program_for_the_first_time),
        WITH_DISPLAY(test_a_lower_quality_uses_no_program_for_the_first_time),
        WITH_DISPLAY(test_a_picture_after_a_warm_up_is_the_same_as_without),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
