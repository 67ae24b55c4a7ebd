/* test_fouls.c -- how a fish was scooped is seen in the motion: along the wall it is a foul and the
 * fish does not count; the third foul ends the round. */
#include "stall_stand.h"

#define READY_TICKS (5u * CORE_TICK_HZ)

static const vec3 aside_m = { 0.0f, STAND_ABOVE_M, 0.45f }; /* Beyond the tank's near wall. */

static void begin(uint8_t mode, uint32_t fish_count)
{
    const struct core_config config = {
        .seed = 3,
        .preset = TANK_PRESET_OFFICIAL,
        .fish_count = fish_count,
        .modes = (uint8_t)(1u << mode),
    };
    open_stall(&config);
    hold(0, aside_m);
    tick();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

#define WALL_Z_M 0.325f
#define SLANT_RAD 0.5f

static void lead_tilted(vec3 to_m, float pitch_rad, float roll_rad)
{
    const struct angles from = input.poi[0].target.angles;
    const vec3 way_m = v3_sub(to_m, input.poi[0].target.position_m);
    const uint32_t count = 60u + (uint32_t)(v3_length(way_m) / (0.2f * CORE_TICK_S));
    for (uint32_t i = 1; i <= count; i++) {
        struct poi_target *target = &input.poi[0].target;
        const float share = (float)i / (float)count;
        target->position_m = v3_mad(target->position_m, way_m, 1.0f / (float)count);
        target->angles.pitch_rad = f_lerp(from.pitch_rad, pitch_rad, share);
        target->angles.roll_rad = f_lerp(from.roll_rad, roll_rad, share);
        tick();
    }
}

/* Six fish rest side by side about a place, in three layers. */
static void lay_fish(float x_m, float z_m)
{
    struct tank_stage stages[6];
    for (uint32_t i = 0; i < 6; i++) {
        stages[i] = (struct tank_stage){
            .position_m = v3(x_m + (i % 2u ? 0.03f : -0.03f), -0.02f * (float)(1u + i / 2u), z_m),
            .angles = { 0.5f * F_PI, 0.0f, 0.0f },
            .length_m = 0.04f,
            .stamina = 0.5f,
            .gait = GAIT_REST,
        };
    }
    tank_stage_all(&core.tank, stages, 6);
}

static void bring_home(void)
{
    const vec3 bowl_m = core.bowl[0].position_m;
    lead_tilted(v3(bowl_m.x, 0.07f, bowl_m.z), 0.0f, 0.0f);
    lead_tilted(v3(bowl_m.x, 0.09f, bowl_m.z), 0.0f, -1.2f);
    ticks(120);
    lead_tilted(v3(bowl_m.x - 0.15f, 0.09f, bowl_m.z), 0.0f, 0.0f);
}

/* A slanted poi comes from the inside, meets the wall, is pressed `press_m` on and lifted along. */
static void scoop_along_the_wall(float press_m)
{
    const float ring_z_m = WALL_Z_M - POI_OUTER_RADIUS_M * f_cos(SLANT_RAD) + press_m;
    lead_tilted(v3(0.30f, 0.06f, 0.0f), 0.0f, 0.0f);
    lead_tilted(v3(0.30f, -0.06f, WALL_Z_M - 0.12f), SLANT_RAD, 0.0f);
    lay_fish(0.30f, WALL_Z_M - 0.010f);
    lead_tilted(v3(0.30f, -0.06f, ring_z_m), SLANT_RAD, 0.0f);
    lead_tilted(v3(0.30f, 0.03f, ring_z_m), SLANT_RAD, 0.0f);
    lead_tilted(v3(0.30f, 0.07f, ring_z_m - 0.02f), 0.0f, 0.0f);
    bring_home();
}

/* The same far from every wall: from under them, straight up. */
static void scoop_in_the_open(void)
{
    lead_tilted(v3(0.30f, 0.06f, 0.0f), 0.0f, 0.0f);
    lead_tilted(v3(0.30f, -0.085f, 0.0f), 0.1f, 0.0f);
    lay_fish(0.30f, 0.0f);
    lead_tilted(v3(0.30f, 0.07f, 0.0f), 0.1f, 0.0f);
    bring_home();
}

static void play(uint8_t mode)
{
    begin(mode, 6);
    wait_for_phase(PHASE_ROUND, READY_TICKS + 10u);
}

static void test_fish_pressed_against_the_wall_are_a_foul_and_do_not_count(void **state)
{
    (void)state;
    uint32_t fouls = 0;
    for (uint32_t i = 0; i < 3; i++) {
        play(MODE_CHAMPIONSHIP);
        scoop_along_the_wall(0.01f + 0.015f * (float)i);
        const uint32_t in_bowl = core.bowl[0].fish_count;
        assert_true(in_bowl > 0);
        fouls += look()->player[0].fouls;
        assert_true(scene.player[0].fouls <= 1); /* One scoop is one incident. */
        if (scene.player[0].fouls > 0) {
            assert_int_equal(scene.player[0].foul, FOUL_WALL);
            assert_true(scene.caught[0] < in_bowl);
        } else {
            assert_int_equal(scene.caught[0], in_bowl);
        }
    }
    assert_true(fouls >= 2);
}

static void test_fish_from_open_water_count_without_a_foul(void **state)
{
    (void)state;
    play(MODE_CHAMPIONSHIP);
    scoop_in_the_open();
    assert_int_equal(look()->player[0].fouls, 0);
    assert_int_equal(scene.caught[0], core.bowl[0].fish_count);
    assert_true(scene.caught[0] > 0);
}

/* Two scoops along the wall are two fouls; with one before the start they are three. */
static void test_the_third_foul_ends_the_players_round(void **state)
{
    (void)state;
    begin(MODE_CHAMPIONSHIP, 6);
    input.shade[0] = (struct shade_input){ .present = 1, .radius_m = 0.3f };
    ticks(220);
    input.shade[0].present = 0;
    assert_int_equal(look()->player[0].fouls, 1);
    wait_for_phase(PHASE_ROUND, READY_TICKS);
    for (uint32_t i = 0; i < 8 && !look()->player[0].out; i++) {
        scoop_along_the_wall(0.01f);
    }
    assert_int_equal(scene.player[0].fouls, FOUL_MAX);
    assert_true(scene.player[0].out);
    wait_for_phase(PHASE_RESULT, GAME_GONE_TICKS + 1u); /* Nobody is left who plays. */
    assert_int_equal(output.record.player[0].fouls, FOUL_MAX);
}

static void test_at_a_stall_a_fish_from_the_wall_counts(void **state)
{
    (void)state;
    uint32_t caught = 0;
    for (uint32_t i = 0; i < 3; i++) {
        play(MODE_FESTIVAL);
        scoop_along_the_wall(0.01f + 0.015f * (float)i);
        assert_int_equal(look()->player[0].fouls, 0);
        assert_int_equal(scene.caught[0], core.bowl[0].fish_count);
        caught += scene.caught[0];
    }
    assert_true(caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_pressed_against_the_wall_are_a_foul_and_do_not_count),
        cmocka_unit_test(test_fish_from_open_water_count_without_a_foul),
        cmocka_unit_test(test_the_third_foul_ends_the_players_round),
        cmocka_unit_test(test_at_a_stall_a_fish_from_the_wall_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
