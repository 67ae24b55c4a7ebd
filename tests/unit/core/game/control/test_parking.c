/* test_parking.c -- checks that the poi of a player who is out is parked on the tank's rim. Every
 * unused poi must have its own visible parking place. */
#include "tests/unit/support/core_fixture.h"

#include "core/game/control/controller.h"
#include "core/game/rules.h"

#define HANDLE_END_M 0.152f
#define SIGHTS 17u

static void open_for(uint8_t preset, uint32_t players)
{
    const struct core_config config = { .seed = 4, .preset = preset, .players = (uint8_t)players };
    open_core(&config);
}

static void hold_all(uint32_t players)
{
    for (uint32_t i = 0; i < players; i++) {
        hold(i, v3(i % 2u ? -0.1f : 0.1f, ABOVE_M, i < 2u ? 0.1f : -0.1f));
    }
}

static void play(uint32_t players)
{
    open_for(TANK_PRESET_FESTIVAL, players);
    hold_all(players);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, GAME_READY_TICKS + 10u);
    ticks(10);
}

/* Projects a point of the world to screen coordinates from -1 to 1. */
static void project(vec3 at_m, float *x, float *y)
{
    const struct view *view = &tank_preset(core.world.tank.preset)->view;
    const struct basis axes = view_basis(view);
    const vec3 seen = vec_basis_to_body(&axes, v3_sub(at_m, view->eye_m));
    const float tan_y = view_half_height_tan(view, view->aspect_min);
    *x = seen.x / (-seen.z * tan_y * view->aspect_min);
    *y = seen.y / (-seen.z * tan_y);
}

/* Returns point number `nth` of a poi whose ring is at `ring_m`. The last of the SIGHTS points is
 * the end of the handle, and the other points are on the outer edge of the ring. */
static vec3 sight_of(vec3 ring_m, uint32_t nth)
{
    const float angle = F_TAU * (float)nth / (float)(SIGHTS - 1u);
    return nth == SIGHTS - 1u ? v3_add(ring_m, v3(0.0f, 0.0f, HANDLE_END_M))
                              : v3_add(ring_m, v3(POI_OUTER_RADIUS_M * f_cos(angle), 0.0f,
                                                  POI_OUTER_RADIUS_M * f_sin(angle)));
}

static void expect_in_the_picture(vec3 ring_m)
{
    for (uint32_t i = 0; i < SIGHTS; i++) {
        float x = 0.0f, y = 0.0f;
        project(sight_of(ring_m, i), &x, &y);
        assert_true(f_abs(x) < 0.995f);
        /* The poi must be above the lowest part of the screen (y < -0.8), because text covers this
         * part. */
        assert_true(y > -0.8f);
        /* The poi must be below the highest part of the screen (y > 0.78), because name plates
         * cover this part. */
        assert_true(y < 0.78f);
    }
}

static float apart_m(vec3 a_m, vec3 b_m)
{
    return v3_length(v3(a_m.x - b_m.x, 0.0f, a_m.z - b_m.z));
}

static void expect_own_place(uint32_t index, uint32_t players)
{
    const vec3 *moored = tank_preset(core.world.tank.preset)->bowl_m;
    const vec3 at_m = core.world.poi[index].position_m;
    expect_in_the_picture(at_m);
    for (uint32_t i = 0; i < players; i++) {
        const float bowl_m = apart_m(at_m, moored[i]);
        assert_true(bowl_m > BOWL_RADIUS_M + POI_OUTER_RADIUS_M - 0.001f);
        if (i != index) {
            assert_true(bowl_m > apart_m(at_m, moored[index]));
            assert_true(apart_m(at_m, core.world.poi[i].position_m) > 2.0f * POI_OUTER_RADIUS_M);
        }
    }
}

static void test_every_poi_has_its_own_visible_parking_place(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        for (uint32_t players = 1; players <= POI_MAX; players++) {
            open_for(preset, players);
            for (uint32_t i = 0; i < players; i++) {
                expect_own_place(i, players);
            }
        }
    }
}

static void bots(uint32_t players)
{
    for (uint32_t i = 0; i < players; i++) {
        input.poi[i].link = POI_SOURCE_BOT;
    }
}

static void test_pois_are_parked_before_the_start_and_after_the_end(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 4, .players = 4, .round_s = 10 };
    open_core(&config);
    /* In attract mode, a bot plays with the first poi. */
    ticks(700);
    bots(4);
    press(INPUT_START);
    ticks(GAME_READY_TICKS - 10u);
    assert_int_equal(core.game.phase, PHASE_READY);
    for (uint32_t i = 0; i < 4; i++) {
        expect_own_place(i, 4);
    }
    wait_for_phase(PHASE_RESULT, 16u * CORE_TICK_HZ);
    ticks(300);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    for (uint32_t i = 0; i < 4; i++) {
        expect_own_place(i, 4);
    }
}

/* ---- Pois of players who are out ------------------------------------------------------------ */

static void expect_parked(uint32_t index, uint32_t players)
{
    const struct shade_cast *cast = &core.world.tank.shade[SHADE_MAX + index].cast;
    assert_true(look()->player[index].out);
    assert_false(cast->present);
    assert_false(parking_collides(&core.game, &core.world, index));
    expect_own_place(index, players);
}

static void test_a_poi_without_paper_is_parked_and_the_others_play(void **state)
{
    (void)state;
    play(2);
    lead(0, v3(0.1f, BELOW_M, 0.1f));
    tear_all(0);
    /* After its paper is torn, a poi stays in place for half a second (60 ticks), so that the
     * player sees the hole. */
    ticks(60);
    assert_true(apart_m(core.world.poi[0].position_m, v3(0.1f, 0.0f, 0.1f)) < 0.03f);
    ticks(3u * CORE_TICK_HZ);
    expect_parked(0, 2);
    assert_false(look()->player[1].out);
    assert_true(apart_m(core.world.poi[1].position_m, v3(-0.1f, 0.0f, 0.1f)) < 0.01f);
    /* The parked poi must ignore its player's input. */
    input.poi[0].target.position_m = v3(-0.1f, BELOW_M, -0.1f);
    ticks(200);
    expect_parked(0, 2);
}

/* Starts a game with two players. The poi of the first player then lifts a fish. */
static void lift_fish(void)
{
    play(2);
    lead(0, v3(0.1f, BELOW_M, 0.1f));
    ticks(60);
    const struct tank_stage stage = {
        .position_m = v3(0.1f, -0.038f, 0.1f), .length_m = 0.04f, .stamina = 0.5f, .gait = GAIT_REST
    };
    tank_stage_all(&core.world.tank, &stage, 1);
    /* Lifts the poi slowly, at 0.1 m/s. */
    for (uint32_t i = 0; i < 132u; i++) {
        input.poi[0].target.position_m.y += 0.1f * CORE_TICK_S;
        tick();
    }
    ticks(30);
    assert_int_equal(core.world.poi[0].carried_count, 1);
}

static void test_carried_fish_are_released_after_the_third_foul(void **state)
{
    (void)state;
    lift_fish();
    /* The game sets `out` when a player commits the third foul. The test sets `out` directly. */
    core.game.player[0].out = 1;
    ticks(4u * CORE_TICK_HZ);
    expect_parked(0, 2);
    assert_int_equal(core.world.poi[0].carried_count, 0);
    assert_int_not_equal(core.world.tank.fish[0].gait, GAIT_HELD);
}

static void test_a_slap_ends_when_its_fish_is_released(void **state)
{
    (void)state;
    lift_fish();
    core.game.player[0].out = 1;
    bool slapped = false;
    for (uint32_t i = 0; i < 4u * CORE_TICK_HZ; i++) {
        struct carried_fish *carried = &core.world.poi[0].carried_fish[0];
        if (core.world.poi[0].carried_count > 0 && carried->state == CARRIED_LYING) {
            /* Makes the fish slap in every tick until it is released. */
            carried->slap_s = 0.02f;
            carried->slap_n = 0.02f;
        }
        /* If a released fish slapped, an assertion would fail in this tick. */
        tick();
        slapped = slapped || core.world.poi[0].slap_count > 0;
    }
    assert_true(slapped);
    assert_int_equal(core.world.poi[0].slap_count, 0);
    expect_parked(0, 2);
}

static void test_a_poi_lost_for_too_long_is_parked(void **state)
{
    (void)state;
    play(2);
    input.poi[0].link = POI_SOURCE_LOST;
    for (uint32_t i = 0; i < 2u * GAME_LOST_TICKS_OTHERS && !core.game.player[0].out; i++) {
        tick();
    }
    ticks(5u * CORE_TICK_HZ);
    expect_parked(0, 2);
    assert_false(core.game.paused);
}

static void test_a_poi_parks_and_returns_without_a_jump(void **state)
{
    (void)state;
    play(2);
    tear_all(0);
    vec3 last_m = core.world.poi[0].position_m;
    for (uint32_t i = 0; i < 600u; i++) {
        tick();
        /* A poi that is being parked moves at up to 1.2 m/s, which is 10 mm per tick. */
        assert_true(v3_length(v3_sub(core.world.poi[0].position_m, last_m)) < 0.010f);
        last_m = core.world.poi[0].position_m;
    }
    expect_parked(0, 2);
    tear_all(1);
    wait_for_phase(PHASE_RESULT, 600u);
    ticks(GAME_AGAIN_TICKS + 10u);
    expect_own_place(0, 2);
    last_m = core.world.poi[0].position_m;
    press(INPUT_START);
    for (uint32_t i = 0; i < 300u; i++) {
        tick();
        assert_true(v3_length(v3_sub(core.world.poi[0].position_m, last_m)) < 0.015f);
        last_m = core.world.poi[0].position_m;
    }
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_true(apart_m(last_m, input.poi[0].target.position_m) < 0.01f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_poi_has_its_own_visible_parking_place),
        cmocka_unit_test(test_pois_are_parked_before_the_start_and_after_the_end),
        cmocka_unit_test(test_a_poi_without_paper_is_parked_and_the_others_play),
        cmocka_unit_test(test_carried_fish_are_released_after_the_third_foul),
        cmocka_unit_test(test_a_slap_ends_when_its_fish_is_released),
        cmocka_unit_test(test_a_poi_lost_for_too_long_is_parked),
        cmocka_unit_test(test_a_poi_parks_and_returns_without_a_jump),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
