/* test_fouls.c -- checks the fouls of a championship. A fish that is scooped along a wall, or that
 * is swept from the water into the bowl, does not count and is a foul. The third foul ends the
 * player's round. */
#include "tests/unit/support/core_fixture.h"
#include "tests/unit/support/newest_record.h"

#define READY_TICKS (5u * CORE_TICK_HZ)

/* Position for the poi outside the tank, in front of the near wall. */
static const vec3 aside_m = { 0.0f, ABOVE_M, 0.45f };

static void begin(uint8_t mode, uint32_t fish_count)
{
    const struct core_config config = {
        .seed = 3,
        .preset = TANK_PRESET_OFFICIAL,
        .fish_count = fish_count,
        .grade = 5,
        .modes = (uint8_t)(1u << mode),
    };
    open_core(&config);
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
        target->position_m = v3_muladd(target->position_m, way_m, 1.0f / (float)count);
        target->angles.pitch_rad = f_lerp(from.pitch_rad, pitch_rad, share);
        target->angles.roll_rad = f_lerp(from.roll_rad, roll_rad, share);
        tick();
    }
}

/* Places six resting fish side by side in three layers around the point x_m, z_m. */
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
    tank_stage_all(&core.world.tank, stages, 6);
}

/* Places six fish side by side above the dipped poi, near the right edge of its ring. */
static void lay_fish_over_the_poi(float x_m, float z_m)
{
    struct tank_stage stages[6];
    for (uint32_t i = 0; i < 6; i++) {
        stages[i] = (struct tank_stage){
            .position_m = v3(x_m + (i % 2u ? 0.018f : 0.038f), -0.018f,
                             z_m + 0.025f * ((float)(i / 2u) - 1.0f)),
            .length_m = 0.04f,
            .stamina = 0.9f,
            .gait = GAIT_REST,
        };
    }
    tank_stage_all(&core.world.tank, stages, 6);
}

static void bring_home(void)
{
    const vec3 bowl_m = core.world.bowl[0].position_m;
    lead_tilted(v3(bowl_m.x, 0.07f, bowl_m.z), 0.0f, 0.0f);
    lead_tilted(v3(bowl_m.x, 0.09f, bowl_m.z), 0.0f, -1.2f);
    ticks(120);
    lead_tilted(v3(bowl_m.x - 0.15f, 0.09f, bowl_m.z), 0.0f, 0.0f);
}

/* Makes a scoop that is a foul: moves a tilted poi to the wall, presses it `press_m` deep into the
 * wall, and lifts it along the wall. */
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

/* Makes a scoop that is not a foul: far from every wall, lifts the poi straight up from below the
 * fish. */
static void scoop_in_the_open(void)
{
    lead_tilted(v3(0.30f, 0.06f, 0.0f), 0.0f, 0.0f);
    lead_tilted(v3(0.30f, -0.085f, 0.0f), 0.1f, 0.0f);
    lay_fish(0.30f, 0.0f);
    lead_tilted(v3(0.30f, 0.07f, 0.0f), 0.1f, 0.0f);
    bring_home();
}

/* Sweeps fish along the water surface into a bowl, which is a foul. The bowl floats as deep as a
 * bowl with a hundred fish, so its rim is only 3 mm above the water. The poi accelerates to 1.7
 * m/s, rises to `end_m` above the water and stops at the bowl. The fish slide on into the bowl. */
static void sweep_into_the_bowl(uint32_t wait_ticks, float end_m)
{
    const vec3 bowl_m = core.world.bowl[0].position_m;
    const float from_m = bowl_m.x - 0.40f;
    const float way_m = bowl_m.x - BOWL_RADIUS_M - POI_OUTER_RADIUS_M - from_m;
    const uint32_t count = (uint32_t)(2.0f * way_m / (1.7f * CORE_TICK_S));
    bowl_init(&core.world.bowl[0], v3(bowl_m.x, 0.003f, bowl_m.z));
    lead_tilted(v3(from_m, 0.06f, bowl_m.z), 0.0f, 0.0f);
    lead_tilted(v3(from_m, -0.035f, bowl_m.z), 0.0f, 0.0f);
    ticks(wait_ticks);
    lay_fish_over_the_poi(from_m, bowl_m.z);
    lead_tilted(v3(from_m, -0.003f, bowl_m.z), 0.0f, 0.0f);
    for (uint32_t i = 1; i <= count; i++) {
        const float share = (float)i / (float)count;
        const float square = share * share;
        const float late = square * square * square * square;
        input.poi[0].target.position_m.x = from_m + way_m * square;
        input.poi[0].target.position_m.y = f_lerp(-0.003f, end_m, late);
        input.poi[0].target.angles.roll_rad = -0.04f * share;
        tick();
    }
    ticks(60);
}

/* Starts a round and runs it until tick READY_TICKS + 20. All modes therefore continue from the
 * same tick. */
static void play(uint8_t mode)
{
    begin(mode, 6);
    wait_for_phase(PHASE_ROUND, READY_TICKS + 10u);
    ticks(READY_TICKS + 20u - core.game.tick);
}

static void test_fish_pressed_against_the_wall_are_a_foul_and_do_not_count(void **state)
{
    (void)state;
    uint32_t fouls = 0;
    for (uint32_t i = 0; i < 3; i++) {
        play(MODE_CHAMPIONSHIP);
        scoop_along_the_wall(0.01f + 0.015f * (float)i);
        const uint32_t in_bowl = core.world.bowl[0].fish_count;
        assert_true(in_bowl > 0);
        fouls += look()->player[0].fouls;
        /* The scoop touches the wall in several ticks, but must count as only one foul. */
        assert_true(scene.player[0].fouls <= 1);
        if (scene.player[0].fouls > 0) {
            assert_int_equal(scene.player[0].foul, FOUL_WALL);
            assert_true(scene.caught[0] < in_bowl);
        } else {
            assert_int_equal(scene.caught[0], in_bowl);
        }
    }
    assert_true(fouls >= 2);
}

struct sweeps {
    uint32_t caught, in_bowl, fouls, poured;
};

/* Repeats the sweep 40 times, and waits a few ticks longer each time. A single sweep may fail,
 * because the fish swim at random. */
static struct sweeps sweep_often(uint8_t mode, float end_m)
{
    struct sweeps sum = { 0 };
    for (uint32_t i = 0; i < 40; i++) {
        play(mode);
        sweep_into_the_bowl(7u * i, end_m);
        look();
        const uint32_t poured = core.game.player[0].offence_tick[FOUL_POURED] != 0;
        assert_true(scene.player[0].fouls == 0 || scene.player[0].foul == FOUL_POURED);
        assert_int_equal(scene.player[0].fouls, rules_of(mode)->counts_fouls ? poured : 0u);
        sum.caught += scene.caught[0];
        sum.in_bowl += scene.bowl[0].fish_count;
        sum.fouls += scene.player[0].fouls;
        sum.poured += poured;
    }
    return sum;
}

static void test_fish_swept_in_from_the_water_are_a_foul_and_do_not_count(void **state)
{
    (void)state;
    const struct sweeps sum = sweep_often(MODE_CHAMPIONSHIP, 0.004f);
    assert_true(sum.fouls > 0);
    assert_true(sum.caught + sum.fouls <= sum.in_bowl);
}

static void test_fish_swept_in_count_in_a_festival(void **state)
{
    (void)state;
    const struct sweeps sum = sweep_often(MODE_FESTIVAL, 0.004f);
    /* Some fish were swept into the bowl (`poured`). In a festival this is not a foul, so all fish
     * in the bowl count. */
    assert_true(sum.poured > 0);
    assert_int_equal(sum.caught, sum.in_bowl);
}

/* The ring makes the same sweep, but rises above the water before it reaches the bowl. */
static void test_a_ring_lifted_above_the_water_first_commits_no_foul(void **state)
{
    (void)state;
    const struct sweeps sum = sweep_often(MODE_CHAMPIONSHIP, 0.030f);
    assert_true(sum.caught > 0);
    assert_int_equal(sum.caught, sum.in_bowl);
    assert_int_equal(sum.fouls, 0);
}

static void test_fish_from_open_water_count_without_a_foul(void **state)
{
    (void)state;
    play(MODE_CHAMPIONSHIP);
    scoop_in_the_open();
    assert_int_equal(look()->player[0].fouls, 0);
    assert_int_equal(scene.caught[0], core.world.bowl[0].fish_count);
    assert_true(scene.caught[0] > 0);
}

/* Drops one fish into the empty bowl from the paper of a ring that has been above the water for
 * `clear_ticks` ticks. */
static void drop_a_fish(uint8_t clear_ticks)
{
    core.world.tank.fish[0].gait = GAIT_HELD;
    core.world.tank.fish[0].holder = 0;
    core.world.tank.fish[0].position_m =
        v3_add(core.world.bowl[0].position_m, v3(0.0f, 0.02f, 0.0f));
    core.world.poi[0].carried_fish[0] =
        (struct carried_fish){ .fish = 0, .state = CARRIED_FALLING, .clear_ticks = clear_ticks };
    core.world.poi[0].carried_count = 1;
    ticks(40);
    assert_int_equal(core.world.bowl[0].fish_count, 1);
}

static void test_a_fish_that_falls_off_a_lost_poi_is_no_foul(void **state)
{
    (void)state;
    static const uint8_t links[] = { POI_SOURCE_ABSENT, POI_SOURCE_LOST };
    for (size_t i = 0; i < sizeof links; i++) {
        play(MODE_CHAMPIONSHIP);
        input.poi[0].link = links[i];
        drop_a_fish(0);
        assert_int_equal(look()->player[0].fouls, 0);
        assert_int_equal(scene.caught[0], 0);
        /* A fish that was wholly above the water counts, although the controller is lost. */
        play(MODE_CHAMPIONSHIP);
        input.poi[0].link = links[i];
        drop_a_fish(CARRIED_CLEAR_TICKS);
        assert_int_equal(look()->player[0].fouls, 0);
        assert_int_equal(scene.caught[0], 1);
    }
    play(MODE_CHAMPIONSHIP);
    drop_a_fish(0);
    /* The player controls this poi, so the drop of the fish is a foul. */
    assert_int_equal(look()->player[0].fouls, 1);
    assert_int_equal(scene.caught[0], 0);
}

static void test_no_fish_counts_after_the_third_foul(void **state)
{
    (void)state;
    for (uint8_t before = 0; before <= FOUL_MAX; before++) {
        play(MODE_CHAMPIONSHIP);
        core.game.player[0].fouls = before;
        drop_a_fish(CARRIED_CLEAR_TICKS);
        assert_int_equal(look()->caught[0], before < FOUL_MAX);
    }
}

/* The player commits one foul before the start, and two more fouls by scoops along the wall. */
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
    /* The only player is out of the round, so the round ends. */
    wait_for_phase(PHASE_RESULT, GAME_GONE_TICKS + 1u);
    assert_int_equal(newest_record(&output)->player[0].fouls, FOUL_MAX);
}

static void test_a_fish_from_the_wall_counts_in_a_festival(void **state)
{
    (void)state;
    uint32_t caught = 0;
    for (uint32_t i = 0; i < 3; i++) {
        play(MODE_FESTIVAL);
        scoop_along_the_wall(0.01f + 0.015f * (float)i);
        assert_int_equal(look()->player[0].fouls, 0);
        assert_int_equal(scene.caught[0], core.world.bowl[0].fish_count);
        caught += scene.caught[0];
    }
    assert_true(caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_pressed_against_the_wall_are_a_foul_and_do_not_count),
        cmocka_unit_test(test_fish_swept_in_from_the_water_are_a_foul_and_do_not_count),
        cmocka_unit_test(test_fish_swept_in_count_in_a_festival),
        cmocka_unit_test(test_a_ring_lifted_above_the_water_first_commits_no_foul),
        cmocka_unit_test(test_fish_from_open_water_count_without_a_foul),
        cmocka_unit_test(test_a_fish_that_falls_off_a_lost_poi_is_no_foul),
        cmocka_unit_test(test_no_fish_counts_after_the_third_foul),
        cmocka_unit_test(test_the_third_foul_ends_the_players_round),
        cmocka_unit_test(test_a_fish_from_the_wall_counts_in_a_festival),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
