/* test_stale_water.c -- checks the oxygen of the water and the pump that restores it. Without
 * players the oxygen falls until fish rise to the surface, and then the pump starts. A round always
 * starts in refreshed water. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/game/phases.h"

static struct core core;
static struct scene scene;
static struct input input;
static struct output output;

static int open_fixture(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 300, .round_s = 60 };
    memset(&input, 0, sizeof input);
    return core_init(&core, &config);
}

static void run(uint32_t seconds)
{
    for (uint32_t i = 0; i < seconds * CORE_TICK_HZ; i++) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        input.pressed = 0;
    }
}

static void test_the_pump_pauses_periodically_and_during_a_round(void **state)
{
    (void)state;
    struct game game = { .phase = PHASE_ATTRACT, .phase_tick = 1000 };
    assert_false(game_pumps(&game, 1000));
    assert_false(game_pumps(&game, 1000 + GAME_STALE_TICKS - 1u));
    assert_true(game_pumps(&game, 1000 + GAME_STALE_TICKS));
    assert_true(game_pumps(&game, 1000 + GAME_STALE_TICKS + GAME_AIR_TICKS - 1u));
    assert_false(game_pumps(&game, 1000 + GAME_STALE_TICKS + GAME_AIR_TICKS));
    game.phase = PHASE_READY;
    assert_true(game_pumps(&game, 1000));
    game.phase = PHASE_ROUND;
    assert_false(game_pumps(&game, 1000 + GAME_STALE_TICKS));
    game.phase = PHASE_RESULT;
    assert_true(game_pumps(&game, 1000));
}

/* Returns the number of fish that breathe at the surface. */
static uint32_t surfacing_count(const struct tank *water)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < water->fish_count; i++) {
        count += water->fish[i].gait == GAIT_SURFACE;
    }
    return count;
}

static void test_fish_rise_for_air_and_dive_again_in_attract(void **state)
{
    (void)state;
    uint32_t most = 0, least_after = 300;
    for (uint32_t second = 0; second < 155; second += 5) {
        run(5);
        const uint32_t count = surfacing_count(&core.world.tank);
        if (second < 80) {
            /* While the water still has 4 mg/L of oxygen, a fish chooses to rise in only one of
             * 4,000 choices of a gait. At most one fish may therefore be at the surface. */
            assert_true(count <= 1);
        }
        most = count > most ? count : most;
        least_after = second >= 135 && count < least_after ? count : least_after;
    }
    print_message("at most %u of 300 gulped before the pump came on, %u after; %.2f mg/L\n", most,
                  least_after, (double)core.world.tank.oxygen.dissolved_mg_l);
    assert_in_range(most, 15, 200);
    assert_true(least_after <= 3);
    assert_true(core.world.tank.oxygen.dissolved_mg_l > 6.0f);
}

static void test_a_round_that_starts_in_stale_water_ends_with_gulping_fish(void **state)
{
    (void)state;
    core.world.tank.oxygen.dissolved_mg_l = 2.0f;
    run(5);
    const float stale_mg_l = core.world.tank.oxygen.dissolved_mg_l;
    /* Holds the poi over a corner of the tank for the whole round, so that the paper lasts and no
     * fish is caught. */
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(-0.35f, 0.15f, 0.2f);
    input.pressed = INPUT_START;
    run(4);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(core.world.tank.oxygen.dissolved_mg_l > stale_mg_l + 0.5f);
    run(54);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    print_message("%.2f mg/L, after the call %.2f, %u at the surface near the end\n",
                  (double)stale_mg_l, (double)core.world.tank.oxygen.dissolved_mg_l,
                  surfacing_count(&core.world.tank));
    assert_true(surfacing_count(&core.world.tank) >= 5);
}

static void test_a_pump_runs_only_in_a_preset_with_a_pump(void **state)
{
    (void)state;
    const struct core_config config = { .preset = TANK_PRESET_OFFICIAL, .fish_count = 20 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    core.game.tick = GAME_STALE_TICKS + 5u;
    run(1);
    assert_false(core.world.tank.oxygen.pump);
    core_scene(&core, &scene);
    assert_false(scene.pump.present);
    open_fixture(state);
    core.game.tick = GAME_STALE_TICKS + 5u;
    run(1);
    assert_true(core.world.tank.oxygen.pump);
    core_scene(&core, &scene);
    assert_true(scene.pump.present && scene.pump.runs);
    assert_float_equal(scene.pump.stone_m.y, -core.world.tank.size_m.y, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_pump_pauses_periodically_and_during_a_round),
        cmocka_unit_test_setup(test_fish_rise_for_air_and_dive_again_in_attract, open_fixture),
        cmocka_unit_test_setup(test_a_round_that_starts_in_stale_water_ends_with_gulping_fish,
                               open_fixture),
        cmocka_unit_test_setup(test_a_pump_runs_only_in_a_preset_with_a_pump, open_fixture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
