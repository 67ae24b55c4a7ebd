/* test_gulp_scoop.c -- checks that a fish that gulps air at the surface is easier to catch than a
 * fish at mid depth.
 *
 * Players at real stalls prefer slow or gulping fish near the surface. The 2013 thesis (section
 * 2.3) explains that a shallow scoop loads the paper less. The test makes the same scoop at a
 * single fish in both states. The poi enters the water beside the fish at a slant, moves level
 * under the fish, and rises. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/poi/catch/catch.h"
#include "core/tank/behavior/surface_breathing.h"

#define TRIALS 60u
/* Height of the fish's lowest point above the paper. */
#define UNDER_M 0.022f
#define BESIDE_M 0.085f /* Distance from the fish at which the poi enters the water. */
/* Speed of the player's motion. At this speed, most fish at mid depth flee. */
#define HAND_M_S 0.30f
#define FISH_M 0.05f

static struct tank tank;
static struct poi poi;
static struct bowl bowl;
static struct output output;
static uint32_t now;

struct outcome {
    uint32_t caught, fled;
    /* Integral of the tension of the paper over time. */
    float strain_n_s_m;
};

static void step(struct poi_target hand, struct outcome *sum)
{
    const struct poi_grip grip = { hand, 1 };
    output.sound_count = 0;
    poi_tick(&poi, &grip, &tank, &bowl);
    struct obstacle ring = poi_obstacle(&poi);
    tank_tick(&tank, now, &ring, 1);
    poi_apply_reaction(&poi, &ring);
    const struct stall stall = { &tank, &bowl, 1, false };
    struct catch_result caught[POI_MAX] = { 0 };
    catch_tick(&poi, 0, &stall, now, &output, caught);
    sum->strain_n_s_m += poi.strain.tension_max_n_m * CORE_TICK_S;
    now++;
}

/* Moves the poi at the speed `m_s` until it is at the height `at_m.y`, at the distances `at_m.x`
 * and `at_m.z` from the fish. The fish may swim meanwhile. */
static void follow(const struct fish *fish, vec3 at_m, float pitch_rad, float m_s,
                   struct poi_target *hand, struct outcome *sum)
{
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ && fish->gait != GAIT_HELD; tick++) {
        const vec3 goal = v3(fish->position_m.x + at_m.x, at_m.y, fish->position_m.z + at_m.z);
        const vec3 way = v3_sub(goal, hand->position_m);
        if (v3_length(way) < 0.002f) {
            return;
        }
        hand->position_m = v3_add(hand->position_m, v3_limit(way, m_s * CORE_TICK_S));
        hand->angles.pitch_rad += f_clamp(pitch_rad - hand->angles.pitch_rad, -0.03f, 0.03f);
        step(*hand, sum);
        sum->fled += fish->gait == GAIT_ESCAPE;
    }
}

static void scoop(const struct fish *fish, struct outcome *sum)
{
    struct poi_target hand = { .position_m = { fish->position_m.x, 0.05f,
                                               fish->position_m.z + BESIDE_M } };
    const struct box box = fish_box(fish);
    const float deep_m = fish->position_m.y - box_extent_m(&box).y - UNDER_M;
    struct outcome one = { 0 };
    poi_init(&poi, 6, hand.position_m, now);
    poi.link = POI_SOURCE_LIVE;
    follow(fish, v3(0.0f, deep_m, BESIDE_M), 0.6f, HAND_M_S, &hand, &one);
    follow(fish, v3(0.0f, deep_m, 0.0f), 0.0f, HAND_M_S, &hand, &one);
    const vec3 top = v3(hand.position_m.x, 0.05f, hand.position_m.z);
    while (hand.position_m.y < top.y) {
        hand.position_m.y += HAND_M_S * CORE_TICK_S;
        step(hand, &one);
        one.fled += fish->gait == GAIT_ESCAPE;
    }
    for (uint32_t i = 0; i < CORE_TICK_HZ / 2u; i++) {
        step(hand, &one);
    }
    sum->caught += fish->gait == GAIT_HELD;
    sum->fled += one.fled > 0;
    sum->strain_n_s_m += one.strain_n_s_m;
}

/* Waits until the only fish of the tank is in the required state: gulping if `gulps` is set,
 * otherwise calm at mid depth. The fish is 5 cm long and the water 12 cm deep. */
static const struct fish *wait_for_fish(uint32_t seed, int gulps)
{
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.fish_count = 1;
    config.seed = seed;
    config.oxygen_mg_l = gulps ? 0.5f : TANK_OXYGEN_SATURATED;
    config.time_compression = 0.0f;
    assert_true(tank_open(&tank, &config));
    struct fish *fish = &tank.fish[0];
    fish_grow(fish, FISH_M, tank_behavior_params(&tank));
    /* With this stamina, the fish swims at mid depth when it does not gulp. */
    fish->stamina = 0.6f;
    now = 0;
    for (; now < 120u * CORE_TICK_HZ; now++) {
        tank_tick(&tank, now, NULL, 0);
        const int inside = f_abs(fish->position_m.x) < 0.30f && f_abs(fish->position_m.z) < 0.14f;
        const int there = gulps ? surface_breathes(fish)
                                : f_abs(fish->position_m.y + 0.06f) < 0.015f &&
                                      fish->gait == GAIT_REST && fish->speed_m_s < 0.02f;
        if (inside && there && now > 4u * CORE_TICK_HZ) {
            return fish;
        }
    }
    return NULL;
}

static struct outcome trials(int gulps)
{
    struct outcome sum = { 0 };
    bowl_init(&bowl, v3(0.335f, 0.012f, 0.185f));
    for (uint32_t i = 0, seed = 1; i < TRIALS; seed++) {
        const struct fish *fish = wait_for_fish(seed, gulps);
        assert_true(seed < 10u * TRIALS);
        if (fish) {
            scoop(fish, &sum);
            i++;
        }
    }
    print_message("%s: %u of %u caught, %u fled; the paper bore %.1f N s/m a scoop\n",
                  gulps ? "gulping" : "at mid depth", sum.caught, TRIALS, sum.fled,
                  (double)(sum.strain_n_s_m / (float)TRIALS));
    return sum;
}

static void test_the_same_scoop_catches_more_gulping_fish_with_less_strain(void **state)
{
    (void)state;
    const struct outcome below = trials(0), above = trials(1);
    assert_true(above.caught > below.caught);
    assert_true(2u * above.fled < below.fled);
    assert_true(above.strain_n_s_m < 0.85f * below.strain_n_s_m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_same_scoop_catches_more_gulping_fish_with_less_strain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
