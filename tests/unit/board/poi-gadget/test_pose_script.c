/* test_pose_script.c -- tests scripts of poses, in which each line is a pose. The tests parse,
 * reject, write and interpolate lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <unistd.h>

#include "board/poi-gadget/pose_script.h"
#include "core/base/rng.h"

static void feed(struct pose_tape *tape, const char *text)
{
    const size_t size = strlen(text);
    assert_true(size <= POSE_TAPE_SIZE - tape->size);
    memcpy(tape->text + tape->size, text, size);
    tape->size += (uint32_t)size;
}

static void test_a_line_contains_position_angles_time_and_keys(void **state)
{
    (void)state;
    struct pose_line line;
    const char *why;
    assert_int_equal(pose_line_read(&line, " +400  120 -50 30.5  -25 0 190  OK FAN # down\n", &why),
                     1);
    assert_float_equal(line.glide_s, 0.4f, 1e-6f);
    assert_float_equal(line.target.position_m.x, 0.12f, 1e-6f);
    assert_float_equal(line.target.position_m.y, -0.05f, 1e-6f);
    assert_float_equal(line.target.position_m.z, 0.0305f, 1e-6f);
    assert_float_equal(line.target.angles.pitch_rad, -25.0f * F_DEG, 1e-5f);
    /* The script gives 190 degrees, which is the same angle as -170 degrees. */
    assert_float_equal(line.target.angles.roll_rad, -170.0f * F_DEG, 1e-5f);
    assert_int_equal(line.buttons, POI_BUTTON_OK | POI_BUTTON_FAN);
    assert_int_equal(pose_line_read(&line, "lost START", &why), 1);
    assert_true(line.lost && line.buttons == POI_BUTTON_START);
    assert_int_equal(pose_line_read(&line, "  # a remark", &why), 0);
    assert_int_equal(pose_line_read(&line, "\r\n", &why), 0);
}

static void test_an_invalid_line_is_rejected_with_a_reason(void **state)
{
    (void)state;
    /* clang-format off */
    static const struct bad {
        const char *text, *why;
    } bad[] = {
        { "1 2 3 4 5", "six numbers" },       { "+100", "six numbers" },
        { "1 2 3 4 5 x", "angle" },           { "1 1001 3 4 5 6", "place" },
        { "nan 2 3 4 5 6", "place" },         { "1 2 3 4 5 361", "angle" },
        { "1 2 3 4 5 inf", "angle" },         { "+-1 1 2 3 4 5 6", "glide" },
        { "+600001 1 2 3 4 5 6", "glide" },   { "1 2 3 4 5 6 JUMP", "key" },
        { "lost 1", "key" },                  { "1e99 2 3 4 5 6", "place" },
    };
    /* clang-format on */
    char endless[300];
    memset(endless, '1', sizeof endless - 1);
    endless[sizeof endless - 1] = '\0';
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct pose_line line = { .glide_s = 77.0f };
        const char *why = "";
        assert_int_equal(pose_line_read(&line, bad[i].text, &why), -1);
        assert_non_null(strstr(why, bad[i].why));
        assert_float_equal(line.glide_s, 77.0f, 0.0f);
    }
    struct pose_line line;
    const char *why;
    assert_int_equal(pose_line_read(&line, endless, &why), -1);
}

static void test_a_line_is_unchanged_by_writing_and_reading(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 2000; n++) {
        float d[6];
        for (uint32_t k = 0; k < 6; k++) {
            d[k] = rng_range((struct rng_key){ 13, n, k, RNG_TEST }, -0.99f, 0.99f);
        }
        const struct poi_report report = {
            .target = { .position_m = { d[0], d[1], d[2] },
                        .angles = { d[3] * F_PI, d[4] * F_PI, d[5] * F_PI } },
            .buttons = (uint8_t)(n & 31u),
        };
        char text[POSE_LINE_SIZE];
        struct pose_line line;
        const char *why;
        pose_line_write(&report, text);
        assert_int_equal(pose_line_read(&line, text, &why), 1);
        assert_float_equal(line.target.position_m.y, d[1], 6e-6f);
        assert_float_equal(line.target.angles.yaw_rad, d[3] * F_PI, 1e-4f);
        assert_float_equal(line.target.angles.pitch_rad, d[4] * F_PI, 1e-4f);
        assert_int_equal(line.buttons, n & 31u);
    }
}

static void test_an_interpolation_takes_its_time_and_ends_at_its_target(void **state)
{
    (void)state;
    struct pose_tape tape = { 0 };
    struct poi_report out = { 0 };
    feed(&tape, "0 0 0 0 170 0\n+100 100 0 0 0 -170 0 OK\n50 0 0 0 0 0\n");
    tape.ended = 1;
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
    assert_float_equal(out.target.position_m.x, 0.0f, 0.0f);
    float before_m = 0.0f;
    for (uint32_t i = 1; i <= 10; i++) {
        assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
        assert_true(out.target.position_m.x > before_m);
        assert_int_equal(out.buttons, POI_BUTTON_OK);
        /* Between 170 and -170 degrees, the interpolation must take the shorter way through 180
         * degrees, not through 0. */
        assert_true(f_abs(out.target.angles.yaw_rad) > 169.0f * F_DEG);
        if (i == 5) {
            assert_float_equal(out.target.position_m.x, 0.05f, 1e-5f);
        }
        before_m = out.target.position_m.x;
    }
    assert_float_equal(out.target.position_m.x, 0.1f, 1e-6f);
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
    assert_float_equal(out.target.position_m.x, 0.05f, 0.0f);
    assert_int_equal(out.buttons, 0);
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 0);
}

static void test_a_script_that_waits_for_input_keeps_the_pose(void **state)
{
    (void)state;
    struct pose_tape tape = { 0 };
    struct poi_report out = { 0 };
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 0);
    feed(&tape, "100 0 0 0");
    /* The text has no line end yet, so the line is not executed. */
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 0);
    feed(&tape, " 0 0\n");
    for (uint32_t i = 0; i < 20; i++) {
        assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
        assert_float_equal(out.target.position_m.x, 0.1f, 0.0f);
    }
    feed(&tape, "lost\n200 0 0 0 0 0");
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
    assert_false(f_is_finite(out.target.position_m.x));
    /* The last line of a file is executed even if it has no line end. */
    tape.ended = 1;
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
    assert_float_equal(out.target.position_m.x, 0.2f, 0.0f);
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 0);
}

static void test_an_invalid_line_is_reported_with_its_number(void **state)
{
    (void)state;
    struct pose_tape tape = { 0 };
    struct poi_report out = { 0 };
    feed(&tape, "# a\n0 0 0 0 0 0\n\nnonsense\n");
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), 1);
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), -1);
    assert_int_equal(tape.line, 4);
    assert_non_null(tape.why);
}

static void test_a_line_that_is_too_long_is_rejected(void **state)
{
    (void)state;
    struct pose_tape tape = { 0 };
    struct poi_report out = { 0 };
    char junk[POSE_TAPE_SIZE + 1];
    memset(junk, 'x', POSE_TAPE_SIZE);
    junk[POSE_TAPE_SIZE] = '\0';
    feed(&tape, junk);
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), -1);
    memset(&tape, 0, sizeof tape);
    memset(tape.text, 0, 10);
    tape.size = 10;
    tape.ended = 1;
    assert_int_equal(pose_tape_step(&tape, 0.01f, &out), -1);
}

static void test_missed_periods_skip_lines_and_keep_their_keys(void **state)
{
    (void)state;
    static struct pose_script_source script;
    struct poi_report out = { 0 };
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    struct pose_source source = pose_script_source(&script, ends[0], "a pipe", 100);
    const char text[] = "10 0 0 0 0 0\n20 0 0 0 0 0 START\n30 0 0 0 0 0\n40 0 0 0 0 0\n"
                        "+40 80 0 0 0 0 0\n90 0 0 0 0 0\n";
    assert_int_equal(write(ends[1], text, sizeof text - 1), sizeof text - 1);
    close(ends[1]);
    assert_int_equal(source.step(source.self, 0.01f, &out), POSE_NEW);
    assert_float_equal(out.target.position_m.x, 0.010f, 2e-5f);
    /* The step of 0.02 s is two periods, so one pose of the script was skipped. Its START must
     * still be reported. */
    assert_int_equal(source.step(source.self, 0.02f, &out), POSE_NEW);
    assert_float_equal(out.target.position_m.x, 0.030f, 2e-5f);
    assert_int_equal(out.buttons, POI_BUTTON_START);
    assert_int_equal(source.step(source.self, 0.01f, &out), POSE_NEW);
    assert_float_equal(out.target.position_m.x, 0.040f, 2e-5f);
    assert_int_equal(out.buttons, 0);
    /* The line "+40 80" interpolates from 40 mm to 80 mm. Half of its time has passed. */
    assert_int_equal(source.step(source.self, 0.02f, &out), POSE_NEW);
    assert_float_equal(out.target.position_m.x, 0.060f, 2e-5f);
    /* The interpolation has ended, so the pose of the next line (90 mm) is reported. */
    assert_int_equal(source.step(source.self, 0.50f, &out), POSE_NEW);
    assert_float_equal(out.target.position_m.x, 0.090f, 2e-5f);
    assert_int_equal(source.step(source.self, 0.01f, &out), POSE_END);
    close(ends[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_line_contains_position_angles_time_and_keys),
        cmocka_unit_test(test_an_invalid_line_is_rejected_with_a_reason),
        cmocka_unit_test(test_a_line_is_unchanged_by_writing_and_reading),
        cmocka_unit_test(test_an_interpolation_takes_its_time_and_ends_at_its_target),
        cmocka_unit_test(test_a_script_that_waits_for_input_keeps_the_pose),
        cmocka_unit_test(test_an_invalid_line_is_reported_with_its_number),
        cmocka_unit_test(test_a_line_that_is_too_long_is_rejected),
        cmocka_unit_test(test_missed_periods_skip_lines_and_keep_their_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
