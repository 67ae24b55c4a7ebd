/* test_tank_files.c -- Tests the input files of `kingyoctl tank`, which contain the path of a poi
 * and the positions of fish. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/ctl/tank/tank_files.h"

#define HEAD "t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n"

static char file_name[64], printed[512];
static struct tank_path path;
static struct tank_place place;
static struct tank tank;

static void write_file(const char *text)
{
    FILE *file = fopen(file_name, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

/* Calls `read` on a file with `text`. Copies the output on standard error to `printed`. */
static enum exit_code read_text(const char *text, enum exit_code (*read)(void))
{
    char log_name[80];
    snprintf(log_name, sizeof log_name, "%s.log", file_name);
    write_file(text);
    fflush(stderr);
    const int shown = dup(STDERR_FILENO);
    assert_non_null(freopen(log_name, "w", stderr));
    const enum exit_code code = read();
    fflush(stderr);
    dup2(shown, STDERR_FILENO);
    close(shown);
    FILE *log = fopen(log_name, "r");
    assert_non_null(log);
    printed[fread(printed, 1, sizeof printed - 1, log)] = '\0';
    fclose(log);
    unlink(log_name);
    return code;
}

static enum exit_code read_path(void)
{
    return tank_path_read(&path, "test", file_name);
}

static enum exit_code read_place(void)
{
    return tank_place_read(&place, "test", file_name);
}

static enum exit_code stage_place(void)
{
    struct tank_config config = tank_config_of(TANK_PRESET_THESIS);
    const enum exit_code code = read_place();
    if (code != EXIT_OK) {
        return code;
    }
    config.fish_count = place.count;
    assert_true(tank_open(&tank, &config));
    return tank_place_stage(&place, &tank, "test", file_name);
}

/* Asserts that standard error has one line, with the file name and the given position. */
static void expect_printed(const char *line_and_column)
{
    assert_non_null(strstr(printed, file_name));
    assert_non_null(strstr(printed, line_and_column));
    assert_ptr_equal(strchr(printed, '\n'), printed + strlen(printed) - 1);
}

static void test_a_path_is_interpolated_between_rows_and_constant_after_the_last(void **state)
{
    (void)state;
    assert_int_equal(read_text(HEAD "1,0,5,0,0,0,0\n3,10,-5,4,90,-20,10\n", read_path), EXIT_OK);
    const struct poi_target before = tank_path_at(&path, 0.0);
    assert_true(before.position_m.x == 0.0f && before.position_m.y == 0.05f);
    const struct poi_target half = tank_path_at(&path, 2.0);
    assert_true(fabsf(half.position_m.x - 0.05f) < 1e-6f);
    assert_true(fabsf(half.position_m.y) < 1e-6f);
    assert_true(fabsf(half.angles.yaw_rad - 45.0f * F_DEG) < 1e-6f);
    assert_true(fabsf(half.angles.pitch_rad + 10.0f * F_DEG) < 1e-6f);
    const struct poi_target after = tank_path_at(&path, 100.0);
    assert_true(after.position_m.x == 0.1f && fabsf(after.angles.roll_rad - 10.0f * F_DEG) < 1e-6f);
}

static void test_columns_are_accepted_in_any_order_after_a_byte_order_mark(void **state)
{
    (void)state;
    assert_int_equal(read_text("\xEF\xBB\xBF yaw_deg ,t_s,x_cm,y_cm,z_cm,pitch_deg,roll_deg\r\n\r\n"
                               "30,0,1,2,3,4,5\r\n",
                               read_path),
                     EXIT_OK);
    const struct poi_target pose = tank_path_at(&path, 0.0);
    assert_true(pose.position_m.x == 0.01f && fabsf(pose.angles.yaw_rad - 30.0f * F_DEG) < 1e-6f);
}

static void test_a_path_error_is_reported_with_line_and_column(void **state)
{
    static const struct {
        const char *text, *where;
    } bad[] = {
        { "", "line 1" },
        { HEAD, "line 2" },
        { "t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg\n0,0,0,0,0,0\n", "roll_deg is missing" },
        { "t_s,t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg\n", "column 1 (t_s)" },
        { HEAD "0,0,0,0,0,0,0\n1,nan,0,0,0,0,0\n", "line 3, column 2 (x_cm)" },
        { HEAD "0,0,inf,0,0,0,0\n", "line 2, column 3 (y_cm)" },
        { HEAD "0,0,0,1e9,0,0,0\n", "line 2, column 4 (z_cm)" },
        { HEAD "0,0,0,0,0,0\n", "line 2, column 7 (roll_deg)" },
        { HEAD "0,0,0,0,,0,0\n", "line 2, column 5 (yaw_deg)" },
        { HEAD "1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", "line 3, column 1 (t_s)" },
        { HEAD "-1,0,0,0,0,0,0\n", "line 2, column 1 (t_s)" },
        { "t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,note\n",
          "line 1, column 8: 'note' is none of t_s, x_cm" },
        { "t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,rol_deg\n", "line 1, column 7: 'rol_deg'" },
        { "t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,\n", "line 1, column 8: ''" },
        { HEAD "0,0,0,0,0,0,0\n1,0,0,0,0,0,0,9\n", "line 3, column 8: '9' is beyond" },
        { HEAD "0,0,0,0,0,0,0,\n", "line 2, column 8: ''" },
        { HEAD "\xEF\xBB\xBF"
               "0,0,0,0,0,0,0\n",
          "line 2, column 1 (t_s)" },
    };
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(read_text(bad[i].text, read_path), EXIT_BAD_DATA);
        expect_printed(bad[i].where);
    }
}

static void test_a_missing_file_is_not_a_data_error(void **state)
{
    (void)state;
    unlink(file_name);
    FILE *quiet = freopen("/dev/null", "w", stderr);
    assert_non_null(quiet);
    assert_int_equal(read_path(), EXIT_IO);
}

static void test_placed_fish_have_the_given_positions(void **state)
{
    (void)state;
    assert_int_equal(read_text("x_cm,y_cm,z_cm,yaw_deg,length_cm,speed_cm_s,gait,stamina\n"
                               "-20,-10,1,-90,6,5.25,swim,80\n20,-9,-1,90,5,0,rest,30\n",
                               stage_place),
                     EXIT_OK);
    const struct fish *fish = &tank.fish[0];
    assert_int_equal(tank.fish_count, 2);
    assert_true(fabsf(fish->position_m.x + 0.2f) < 1e-6f && fabsf(fish->length_m - 0.06f) < 1e-6f);
    assert_true(fabsf(fish->angles.yaw_rad + 90.0f * F_DEG) < 1e-6f);
    assert_int_equal(fish->gait, GAIT_SWIM);
    assert_true(fabsf(fish->stamina - 0.8f) < 1e-6f);
    /* A yaw of -90 degrees points the fish towards +x. */
    assert_true(fabsf(fish->velocity_m_s.x - 0.0525f) < 1e-6f);
    assert_int_equal(tank.fish[1].gait, GAIT_REST);
}

static void test_a_placed_fish_with_a_speed_and_no_gait_swims(void **state)
{
    (void)state;
    assert_int_equal(
        read_text("x_cm,y_cm,z_cm,yaw_deg,speed_cm_s\n0,-5,0,0,4\n10,-5,0,0,0\n", stage_place),
        EXIT_OK);
    assert_int_equal(tank.fish[0].gait, GAIT_SWIM);
    assert_int_equal(tank.fish[1].gait, GAIT_REST);
    assert_true(tank.fish[0].length_m == 0.05f);
}

#define TRACE_HEAD                                                                                 \
    "tick,fish,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,length_cm,height_cm,width_cm,"            \
    "speed_cm_s,tail_hz,gait,stamina,avoiding\n"

static void test_fish_are_placed_from_the_first_tick_of_a_trace(void **state)
{
    (void)state;
    assert_int_equal(read_text(TRACE_HEAD "12,0,-20,-5,0,-90,0,0,5,2,1,40,9,escape,60,none\n"
                                          "12,1,20,-0.9,0,0,40,0,5,2,1,0.5,2,surface,10,none\n"
                                          "12,2,0,-9,0,0,0,0,5,2,1,0.5,2,surface,90,yaw\n"
                                          "24,0,-19,3,0,-90,0,0,5,2,1,40,9,held,60,none\n"
                                          "24,1,20,-0.9,0,0,40,0,5,2,1,0.5,2,surface,10,none\n",
                               stage_place),
                     EXIT_OK);
    expect_printed(
        "the 3 fish of the first tick, 12, are placed; 2 rows of other ticks are skipped");
    const struct fish *fish = tank.fish;
    assert_int_equal(tank.fish_count, 3);
    assert_int_equal(fish[0].gait, GAIT_BURST);
    assert_true(fabsf(fish[0].velocity_m_s.x - 0.4f) < 1e-6f);
    assert_int_equal(fish[1].gait, GAIT_SURFACE);
    assert_int_equal(fish[1].air, AIR_GULPS);
    assert_int_equal(fish[2].air, AIR_RISES); /* The fish is 9 cm deep, so it must rise to the
                                                 surface before it can gulp air. */
    assert_int_equal(fish[2].gait, GAIT_SWIM);
}

static void test_a_trace_of_one_tick_is_placed_without_a_message(void **state)
{
    (void)state;
    assert_int_equal(
        read_text(TRACE_HEAD "12,0,-20,-5,0,-90,0,0,5,2,1,40,9,swim,60,none\n", stage_place),
        EXIT_OK);
    assert_string_equal(printed, "");
}

/* Section 3.6 of the thesis: a tired fish gulps air at the surface for 3 s, recovers completely,
 * and then dives. */
static void test_a_placed_gulping_fish_gulps_and_dives(void **state)
{
    uint32_t tick = 0;
    (void)state;
    assert_int_equal(read_text("x_cm,y_cm,z_cm,yaw_deg,pitch_deg,gait,stamina\n"
                               "0,-1.6,0,0,40,surface,10\n",
                               stage_place),
                     EXIT_OK);
    assert_int_equal(tank.fish[0].gait, GAIT_SURFACE);
    while (tick < 10u * CORE_TICK_HZ && tank.fish[0].gait == GAIT_SURFACE) {
        tank_tick(&tank, tick++, NULL, 0);
    }
    assert_in_range(tick, 3u * CORE_TICK_HZ, 6u * CORE_TICK_HZ);
    assert_true(tank.fish[0].stamina > 0.95f);
}

static void test_fish_that_cannot_be_placed_are_reported(void **state)
{
    static const struct {
        const char *text, *where;
    } bad[] = {
        { "x_cm,y_cm,z_cm,yaw_deg\n0,-5,0,0\n0,-5,4.9,0\n", "fish 0 and 1 overlap by 1.0 mm" },
        { "x_cm,y_cm,z_cm,yaw_deg\n66,-5,0,90\n", "fish 0 is not completely in the water" },
        { "x_cm,y_cm,z_cm,yaw_deg\n0,-0.9,0,0\n", "fish 0 is not completely in the water" },
        { "x_cm,y_cm,z_cm,yaw_deg\n0,-19.1,0,0\n", "fish 0 is not completely in the water" },
        { "x_cm,y_cm,z_cm,yaw_deg,gait\n0,-5,0,0,hop\n", "line 2, column 5 (gait)" },
        { "x_cm,y_cm,z_cm,yaw_deg,gait\n0,-5,0,0,held\n",
          "line 2, column 5 (gait): no poi holds this fish" },
        { "x_cm,y_cm,z_cm,yaw_deg,gait\n0,1.4,0,0,surface\n",
          "line 2: fish 0 is not completely in the water" },
        { "x_cm,y_cm,z_cm,yaw_deg,stamina\n0,-5,0,0,101\n", "line 2, column 5 (stamina)" },
        { "x_cm,y_cm,z_cm,yaw_deg,stamnia\n0,-5,0,0,50\n", "line 1, column 5: 'stamnia'" },
        { "x_cm,y_cm,z_cm,yaw_deg\n0,-5,0,0\n9,-5,0,0,7,8\n", "line 3, column 5: '7'" },
        { "x_cm,y_cm,z_cm,yaw_deg\n0,5,0,0\n", "line 2: fish 0 is not completely in the water" },
        { "x_cm,y_cm,z_cm,yaw_deg\n0,101,0,0\n", "line 2, column 2 (y_cm)" },
        { "tick,x_cm,y_cm,z_cm,yaw_deg\n5,0,-5,0,0\n6,nan,-5,0,0\n", "line 3, column 2 (x_cm)" },
    };
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(read_text(bad[i].text, stage_place), EXIT_BAD_DATA);
        expect_printed(bad[i].where);
    }
}

int main(void)
{
    snprintf(file_name, sizeof file_name, "/tmp/kingyo-test-path.%d", (int)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_path_is_interpolated_between_rows_and_constant_after_the_last),
        cmocka_unit_test(test_columns_are_accepted_in_any_order_after_a_byte_order_mark),
        cmocka_unit_test(test_a_path_error_is_reported_with_line_and_column),
        cmocka_unit_test(test_placed_fish_have_the_given_positions),
        cmocka_unit_test(test_a_placed_fish_with_a_speed_and_no_gait_swims),
        cmocka_unit_test(test_fish_are_placed_from_the_first_tick_of_a_trace),
        cmocka_unit_test(test_a_trace_of_one_tick_is_placed_without_a_message),
        cmocka_unit_test(test_a_placed_gulping_fish_gulps_and_dives),
        cmocka_unit_test(test_fish_that_cannot_be_placed_are_reported),
        cmocka_unit_test(test_a_missing_file_is_not_a_data_error),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    unlink(file_name);
    return failed;
}
