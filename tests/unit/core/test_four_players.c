/* test_four_players.c -- checks that no fish is lost, duplicated or in two places while four
 * players move at random. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/core.h"

#define FISH 150u

static struct core core;
static struct input input;
static struct output output;
static uint32_t most_ridden, most_bowled, bowls_filled;

static float draw(uint32_t tick, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 5, tick, which, RNG_TEST }, low, high);
}

/* Gives the player a new random target every half second: in the water, above it, or over the bowl.
 * The poi moves to the target as fast as an arm can, at any angle. */
static void lead(uint32_t player, uint32_t tick)
{
    struct poi_input *poi = &input.poi[player];
    static vec3 goal_m[POI_MAX];
    static struct angles goal[POI_MAX];
    const uint32_t turn = tick / 60u * POI_MAX + player;
    if (tick % 60u == 0) {
        const float half_x = 0.5f * core.world.tank.size_m.x,
                    half_z = 0.5f * core.world.tank.size_m.z;
        const int home = draw(turn, 0, 0.0f, 1.0f) < 0.35f;
        const vec3 anywhere = v3(draw(turn, 1, -half_x, half_x), draw(turn, 2, -0.09f, 0.09f),
                                 draw(turn, 3, -half_z, half_z));
        goal_m[player] =
            home ? v3_add(core.world.bowl[player].position_m, v3(0.0f, 0.05f, 0.0f)) : anywhere;
        goal[player] = (struct angles){ draw(turn, 4, -0.5f, 0.5f), draw(turn, 5, -0.4f, 0.4f),
                                        home ? 0.9f : draw(turn, 6, -0.4f, 0.4f) };
    }
    poi->link = POI_SOURCE_LIVE;
    poi->has_wrist = 1;
    poi->target.position_m = v3_lerp(poi->target.position_m, goal_m[player], 0.05f);
    poi->target.angles.yaw_rad = f_lerp(poi->target.angles.yaw_rad, goal[player].yaw_rad, 0.05f);
    poi->target.angles.pitch_rad =
        f_lerp(poi->target.angles.pitch_rad, goal[player].pitch_rad, 0.05f);
    poi->target.angles.roll_rad = f_lerp(poi->target.angles.roll_rad, goal[player].roll_rad, 0.05f);
}

/* Checks that every fish either swims, is carried by exactly one poi, or lies in exactly one bowl.
 * Checks also that the fish count of each bowl is correct. */
static void count_all(void)
{
    uint32_t ridden[FISH] = { 0 }, bowled[POI_MAX] = { 0 };
    uint32_t swim = 0, ride = 0, kept = 0, loose = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct poi *poi = &core.world.poi[i];
        for (uint32_t k = 0; k < poi->carried_count; k++) {
            ridden[poi->carried_fish[k].fish]++;
            assert_int_equal(core.world.tank.fish[poi->carried_fish[k].fish].gait, GAIT_HELD);
            assert_int_equal(core.world.tank.fish[poi->carried_fish[k].fish].holder, i);
        }
        ride += poi->carried_count;
    }
    for (uint32_t i = 0; i < FISH; i++) {
        const struct fish *fish = &core.world.tank.fish[i];
        const int held = fish->gait == GAIT_HELD && fish->holder != FISH_HOLDER_WATER;
        assert_int_equal(ridden[i], held);
        assert_true(v3_is_finite(fish->position_m));
        swim += (uint32_t)fish_swims(fish);
        loose += fish->gait == GAIT_HELD && fish->holder == FISH_HOLDER_WATER;
        if (fish->gait == GAIT_BOWL) {
            assert_true(fish->holder < POI_MAX);
            bowled[fish->holder]++;
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        assert_int_equal(bowled[i], core.world.bowl[i].fish_count);
        kept += bowled[i];
        bowls_filled |= bowled[i] > 0 ? 1u << i : 0u;
    }
    assert_int_equal(swim + loose + ride + kept, FISH);
    most_ridden = ride > most_ridden ? ride : most_ridden;
    most_bowled = kept > most_bowled ? kept : most_bowled;
}

static void test_a_minute_of_four_random_pois_creates_and_loses_no_fish(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 7,
                                        .fish_count = FISH,
                                        .players = POI_MAX,
                                        .grade = 4,
                                        .round_s = 60,
                                        /* Uses practice mode, because torn paper is replaced in
                                         * this mode. */
                                        .modes = 1u << MODE_PRACTICE };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    for (uint32_t tick = 0; tick < 64u * CORE_TICK_HZ; tick++) {
        for (uint32_t i = 0; i < POI_MAX; i++) {
            lead(i, tick);
        }
        input.pressed = tick == 10 ? INPUT_START : 0;
        core_tick(&core, &input, &output);
        assert_int_equal(output.tick, core.game.tick);
        assert_int_equal(output.phase, core.game.phase);
        assert_int_equal(output.round_tick, core.game.round_tick);
        assert_int_equal(output.is_idle, core.game.phase == PHASE_ATTRACT);
        output.sound_count = 0;
        count_all();
    }
    print_message("at most %u fish rode and %u were in bowls at once\n", most_ridden, most_bowled);
    assert_true(most_ridden >= 2);
    assert_true(most_bowled >= 2);
}

static void test_each_player_has_a_bowl_at_its_own_place(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        for (uint8_t players = 0; players <= POI_MAX; players++) {
            const struct core_config config = { .seed = 1, .preset = preset, .players = players };
            assert_int_equal(core_init(&core, &config), CORE_OK);
            for (uint32_t i = 0; i < POI_MAX; i++) {
                assert_int_equal(core.world.bowl[i].present, i < (players ? players : 1u));
                if (core.world.bowl[i].present) {
                    const vec3 off_m =
                        v3_sub(core.world.bowl[i].position_m, tank_preset(preset)->bowl_m[i]);
                    assert_float_equal(v3_length(off_m), 0.0f, 0.0f);
                }
            }
        }
    }
}

/* At the start, fewer than 1 % of the fish may be more than 5 mm deep in the hull of a bowl. */
static void test_fish_start_clear_of_every_bowl(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        const struct core_config config = { .seed = 3, .preset = preset, .players = POI_MAX };
        uint32_t inside = 0;
        assert_int_equal(core_init(&core, &config), CORE_OK);
        for (uint32_t i = 0; i < core.world.tank.fish_count; i++) {
            const struct box box = fish_box(&core.world.tank.fish[i]);
            for (uint32_t k = 0; k < POI_MAX; k++) {
                const struct obstacle hull = bowl_obstacle(&core.world.bowl[k]);
                inside += obstacle_touch(&hull, &box).gap_m < -0.005f;
            }
        }
        print_message("%s: %u fish of %u start in a hull\n", tank_preset(preset)->name, inside,
                      core.world.tank.fish_count);
        assert_true(inside * 100u < core.world.tank.fish_count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_minute_of_four_random_pois_creates_and_loses_no_fish),
        cmocka_unit_test(test_each_player_has_a_bowl_at_its_own_place),
        cmocka_unit_test(test_fish_start_clear_of_every_bowl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
