/* test_tank.c -- checks whole tanks: minutes with 300 fish, a poi that is dragged through the fish,
 * and repeatability. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/core.h"
#include "core/tank/tank_fields.h"
#include "tests/unit/support/open_tank.h"

#define MINUTE (60u * CORE_TICK_HZ)

static struct tank tank, twin;

static void run(struct tank *t, uint32_t from, uint32_t ticks, struct obstacle *obstacles,
                uint32_t count)
{
    for (uint32_t tick = from; tick < from + ticks; tick++) {
        if (tick % 2u == 0) {
            water_step(&t->water, t->size_m);
        }
        tank_tick(t, tick, obstacles, count);
    }
}

static float deepest_overlap_m(const struct tank *t, uint32_t *over_half_mm)
{
    float deepest = 0.0f;
    for (uint32_t i = 0; i < t->fish_count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const vec3 d = v3_sub(t->fish[i].position_m, t->fish[j].position_m);
            const float reach = 0.56f * (t->fish[i].length_m + t->fish[j].length_m);
            if (v3_dot(d, d) < reach * reach) {
                const struct box a = fish_box(&t->fish[i]), b = fish_box(&t->fish[j]);
                const float depth = box_depth_m(&a, &b);
                deepest = f_max(deepest, depth);
                *over_half_mm += depth > 0.0005f;
            }
        }
    }
    return deepest;
}

static void test_a_fresh_tank_holds_fish_that_do_not_overlap(void **state)
{
    (void)state;
    const uint32_t counts[] = { 1, 300, tank_preset_fish_max(tank_preset(0), 1.0f) };
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t over = 0;
        open_tank(&tank, TANK_PRESET_FESTIVAL, counts[i], 40u + i);
        assert_true(deepest_overlap_m(&tank, &over) < 1e-5f);
    }
}

static void test_a_tank_accepts_exactly_the_maximum_fish_count(void **state)
{
    (void)state;
    static struct core core;
    struct core_config config = { .seed = 3 };
    config.fish_count = tank_preset_fish_max(tank_preset(0), 1.0f) + 1u;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
    /* core_init() has failed, so no tank was opened. */
    assert_int_equal(core.world.tank.fish_count, 0);
    expect_assert_failure(open_tank(&tank, 0, config.fish_count, 3));
    config.fish_count--;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core.world.tank.fish_count, config.fish_count);
}

/* Returns the greatest jump of a fish in the last tick. A jump is the part of the displacement that
 * exceeds the fish's own speed (at least 1.5 lengths per second) plus 3 cm/s. */
static float jump_m(const struct tank *t)
{
    float farthest_m = 0.0f;
    for (uint32_t i = 0; i < t->fish_count; i++) {
        const vec3 step = v3_sub(t->fish[i].position_m, t->solver.began_m[i]);
        const float own_m =
            (f_max(t->fish[i].speed_m_s, 1.5f * t->fish[i].length_m) + 0.03f) * CORE_TICK_S;
        farthest_m = f_max(farthest_m, v3_length(step) - own_m);
    }
    return farthest_m;
}

static void test_a_tank_that_is_full_keeps_its_fish_apart(void **state)
{
    (void)state;
    uint32_t over = 0;
    float deepest = 0.0f, jump = 0.0f;
    open_tank(&tank, TANK_PRESET_FESTIVAL, tank_preset_fish_max(tank_preset(0), 1.0f), 5);
    for (uint32_t tick = 0; tick < 4u * CORE_TICK_HZ; tick++) {
        run(&tank, tick, 1, 0, 0);
        jump = f_max(jump, jump_m(&tank));
        if (tick % 8u == 0) {
            deepest = f_max(deepest, deepest_overlap_m(&tank, &over));
        }
    }
    print_message("%u fish: deepest overlap %.2f mm, %u pairs in 60 ticks over 0.5 mm, shoved by "
                  "%.2f mm\n",
                  tank.fish_count, (double)(1000.0f * deepest), over, (double)(1000.0f * jump));
    assert_true(deepest < 0.004f);
    assert_true(over < 20u);
    assert_true(jump < 0.004f);
}

static void check_inside(const struct fish *fish, vec3 size_m)
{
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box), p = fish->position_m;
    assert_true(v3_is_finite(p));
    assert_true(f_abs(p.x) + extent.x < 0.5f * size_m.x + 1e-4f);
    assert_true(f_abs(p.z) + extent.z < 0.5f * size_m.z + 1e-4f);
    assert_true(p.y + extent.y < 1e-4f);
    assert_true(p.y - extent.y > -size_m.y - 1e-4f);
}

#define LONG_TICKS (3u * MINUTE / 2u)

static void test_every_fish_stays_valid_separate_and_inside_for_minutes(void **state)
{
    (void)state;
    uint32_t over = 0, near_wall = 0, samples = 0, jolts = 0;
    uint32_t gaits[GAIT_COUNT] = { 0 };
    float deepest = 0.0f, swim_lengths = 0.0f;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 300, 7);
    for (uint32_t tick = 0; tick < LONG_TICKS; tick++) {
        run(&tank, tick, 1, 0, 0);
        if (tick % 40u != 0) {
            continue;
        }
        deepest = f_max(deepest, deepest_overlap_m(&tank, &over));
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            check_inside(fish, tank.size_m);
            assert_true(f_abs(fish->angles.pitch_rad) < 26.0f * F_DEG);
            /* Only an escaping fish may turn faster than 540 degrees per second. */
            assert_true(f_abs(fish->yaw_rate_rad_s) < 540.0f * F_DEG);
            assert_true(fish->tail_phase_rad >= 0.0f && fish->tail_phase_rad < F_TAU);
            const float gap =
                f_min(0.425f - f_abs(fish->position_m.x), 0.275f - f_abs(fish->position_m.z));
            near_wall += gap < 0.05f;
            jolts += f_abs(v3_length(fish->velocity_m_s) - fish->speed_m_s) > 0.10f;
            swim_lengths +=
                fish->gait == GAIT_SWIM ? v3_length(fish->velocity_m_s) / fish->length_m : 0.0f;
            gaits[fish->gait]++;
            samples++;
        }
    }
    const float all = (float)samples;
    print_message("deepest overlap %.2f mm, %u of %u pair samples over 0.5 mm\n",
                  (double)(1000.0f * deepest), over, LONG_TICKS / 40u);
    print_message(
        "burst %.4f swim %.3f rest %.3f, swimming %.2f lengths/s, near a wall %.3f, jolts %.5f\n",
        (double)((float)gaits[GAIT_BURST] / all), (double)((float)gaits[GAIT_SWIM] / all),
        (double)((float)gaits[GAIT_REST] / all), (double)(swim_lengths / (float)gaits[GAIT_SWIM]),
        (double)((float)near_wall / all), (double)((float)jolts / all));
    assert_true(deepest < 0.004f);
    assert_true(over < 6u);
    /* A single fish swims at 1.05 lengths per second. A mean below half of this would mean that the
     * fish block each other. */
    assert_true(swim_lengths / (float)gaits[GAIT_SWIM] > 0.5f);
    /* 28 % of the tank's area is within 5 cm of a wall. The share of the fish that are there must
     * be similar, because fish must not crowd at the walls. */
    assert_float_equal((float)near_wall / all, 0.28f, 0.12f);
    assert_float_equal((float)gaits[GAIT_REST] / all, 0.65f, 0.08f);
    assert_true((float)jolts / all < 0.001f);
}

static void test_the_same_seed_repeats_the_motion_and_another_does_not(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 120, 99);
    open_tank(&twin, TANK_PRESET_FESTIVAL, 120, 99);
    run(&tank, 0, 20u * CORE_TICK_HZ, 0, 0);
    run(&twin, 0, 20u * CORE_TICK_HZ, 0, 0);
    assert_true(field_hash(HASH_START, &tank_fields, &tank) ==
                field_hash(HASH_START, &tank_fields, &twin));
    assert_true(field_hash(HASH_START, &tank_quick_fields, &tank) ==
                field_hash(HASH_START, &tank_quick_fields, &twin));
    open_tank(&twin, TANK_PRESET_FESTIVAL, 120, 98);
    run(&twin, 0, 20u * CORE_TICK_HZ, 0, 0);
    assert_true(field_hash(HASH_START, &tank_quick_fields, &tank) !=
                field_hash(HASH_START, &tank_quick_fields, &twin));
}

static void test_a_copy_of_a_tank_continues_identically(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 80, 3);
    run(&tank, 0, 500, 0, 0);
    twin = tank;
    /* Overwrites the broad phase. This must have no effect, because the broad phase is computed
     * anew in tick 500. */
    memset(&twin.broad_phase, 0x5a, sizeof twin.broad_phase);
    run(&tank, 500, 500, 0, 0);
    run(&twin, 500, 500, 0, 0);
    assert_true(field_hash(HASH_START, &tank_fields, &tank) ==
                field_hash(HASH_START, &tank_fields, &twin));
}

static struct obstacle disc_at(vec3 centre, vec3 velocity)
{
    return (struct obstacle){ .kind = OBSTACLE_DISC,
                              .centre_m = centre,
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .velocity_m_s = velocity,
                              .radius_m = 0.0465f };
}

/* Measurements of a disc that is dragged through the fish. */
struct dragged {
    uint32_t escapes, near_samples, over;
    /* Deepest overlap of two fish, deepest overlap of a fish with the ring, and largest jump of a
     * fish, all in m. */
    float body_m, ring_m, jump_m;
    float lag_m; /* Largest distance in m by which fish held the disc back. */
};

/* Returns the distance between a point and a disc, which stands for the ring and its paper. */
static float disc_distance_m(const struct obstacle *disc, vec3 point_m)
{
    const vec3 d = v3_sub(point_m, disc->centre_m);
    const float above_m = v3_dot(d, disc->normal);
    const float out_m = v3_length(v3_muladd(d, disc->normal, -above_m)) - disc->radius_m;
    return out_m <= 0.0f ? f_abs(above_m) : f_sqrt(above_m * above_m + out_m * out_m);
}

static void look_at_the_ring(struct dragged *dragged, const struct obstacle *disc)
{
    dragged->body_m = f_max(dragged->body_m, deepest_overlap_m(&tank, &dragged->over));
    dragged->jump_m = f_max(dragged->jump_m, jump_m(&tank));
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        const struct box box = fish_box(&tank.fish[i]);
        dragged->ring_m = f_max(dragged->ring_m, v3_length(obstacle_clear(disc, &box)));
    }
}

/* Drags a disc along the tank at half the depth. Fish may stop the disc, and each tick begins where
 * the fish stopped it. */
static struct dragged drag(float speed_m_s, vec3 normal)
{
    struct dragged dragged = { 0 };
    open_tank(&tank, TANK_PRESET_FESTIVAL, 300, 17);
    run(&tank, 0, 5u * CORE_TICK_HZ, 0, 0);
    const uint32_t ticks = (uint32_t)(0.6f / speed_m_s * (float)CORE_TICK_HZ);
    vec3 left_m = { -0.3f, -0.06f, 0.0f };
    for (uint32_t tick = 0; tick < ticks; tick++) {
        const float x = -0.3f + 0.6f * (float)tick / (float)ticks;
        struct obstacle disc = disc_at(v3(x, -0.06f, 0.0f), v3(speed_m_s, 0.0f, 0.0f));
        disc.normal = normal;
        disc.step_m = v3_sub(disc.centre_m, left_m);
        uint8_t was[300];
        for (uint32_t i = 0; i < 300; i++) {
            was[i] = tank.fish[i].gait;
        }
        run(&tank, 600u + tick, 1, &disc, 1);
        left_m = disc.centre_m;
        dragged.lag_m = f_max(dragged.lag_m, v3_length(v3_sub(v3(x, -0.06f, 0.0f), left_m)));
        for (uint32_t i = 0; i < 300; i++) {
            dragged.escapes += tank.fish[i].gait == GAIT_ESCAPE && was[i] != GAIT_ESCAPE;
            dragged.near_samples += disc_distance_m(&disc, tank.fish[i].position_m) < 0.02f;
        }
        /* Does not measure the first 0.1 s, because the disc appears in the middle of fish. */
        if (tick > CORE_TICK_HZ / 10u) {
            look_at_the_ring(&dragged, &disc);
        }
    }
    dragged.near_samples /= ticks / 10u;
    print_message("drag at %.2f m/s: %u escapes, %.1f fish within 2 cm; deepest in each other "
                  "%.2f mm, in the ring %.2f mm; %u pairs over 0.5 mm; shoved by %.2f mm; held up "
                  "by %.2f mm\n",
                  (double)speed_m_s, dragged.escapes, 0.1 * (double)dragged.near_samples,
                  (double)(1000.0f * dragged.body_m), (double)(1000.0f * dragged.ring_m),
                  dragged.over, (double)(1000.0f * dragged.jump_m),
                  (double)(1000.0f * dragged.lag_m));
    return dragged;
}

static void test_the_fullest_tank_of_each_preset_starts_without_an_overlap(void **state)
{
    (void)state;
    static const float scales[] = { TANK_AREA_SCALE_MIN, 0.3f, 1.0f };
    for (uint32_t k = 0; k < 3u * TANK_PRESET_COUNT; k++) {
        struct tank_config config = tank_config_of((uint8_t)(k / 3u));
        config.area_scale = scales[k % 3u];
        config.fish_count = tank_preset_fish_max(tank_preset(config.preset), config.area_scale);
        uint32_t over = 0;
        assert_int_equal(tank_open(&tank, &config), 1);
        assert_true(deepest_overlap_m(&tank, &over) <= SOLVER_FREE_M);
    }
}

/* In the smallest tank, one of a hundred seeds gives initial positions at which a few fish push
 * each other without end. tank_open() must then choose other positions. */
static void test_the_smallest_tank_has_room_for_its_fish_with_every_seed(void **state)
{
    (void)state;
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.area_scale = TANK_AREA_SCALE_MIN;
    config.fish_count = tank_preset_fish_max(tank_preset(config.preset), config.area_scale);
    for (config.seed = 1; config.seed <= 300; config.seed++) {
        uint32_t over = 0;
        assert_int_equal(tank_open(&tank, &config), 1);
        assert_true(deepest_overlap_m(&tank, &over) <= SOLVER_FREE_M);
    }
}

/* The tank measures 6.7 x 6.7 cm and gets two fish of up to 8 cm. With some seeds there is no room
 * for them, so tank_open() must return an error. */
static void test_a_tank_without_room_is_rejected(void **state)
{
    (void)state;
    uint32_t refused = 0;
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.area_scale = TANK_AREA_SCALE_MIN;
    config.size_m = v3(TANK_SIDE_MIN_M, TANK_DEPTH_MIN_M, TANK_SIDE_MIN_M);
    config.fish_count = tank_config_fish_max(&config);
    for (config.seed = 1; config.seed <= 200; config.seed++) {
        uint32_t over = 0;
        if (tank_open(&tank, &config)) {
            assert_true(deepest_overlap_m(&tank, &over) <= SOLVER_FREE_M);
        } else {
            refused++;
        }
    }
    print_message("%u of 200 refused\n", refused);
    assert_in_range(refused, 1, 20);
}

/* A fish that tank_stage_all() places in a given state (stage) must have the speed and the heading
 * of this state in the first tick. The next update of the fish itself may be three ticks later. */
static void test_a_staged_fish_has_its_staged_motion_from_the_first_tick(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 40; seed++) {
        const struct tank_stage stage = {
            .position_m = { 0.0f, -0.06f, 0.0f },
            .length_m = 0.06f,
            .speed_m_s = 0.05f,
            .stamina = 1.0f,
            .gait = seed % 2u ? GAIT_BURST : GAIT_REST,
        };
        open_tank(&tank, TANK_PRESET_THESIS, 1, seed);
        tank_stage_all(&tank, &stage, 1);
        const float burst_m_s = 3.0f * 0.06f, drift_m_s = 0.1f * 0.06f;
        for (uint32_t tick = 0; tick < 4; tick++) {
            const float before_m_s = tank.fish[0].speed_m_s;
            tank_tick(&tank, tick, NULL, 0);
            const float now_m_s = tank.fish[0].speed_m_s;
            const float goal_m_s = tank.fish[0].speed_goal_m_s;
            assert_true(stage.gait == GAIT_BURST ? now_m_s > before_m_s : now_m_s < before_m_s);
            assert_true(f_abs(now_m_s - before_m_s) < 0.2f * f_abs(before_m_s - goal_m_s));
            assert_true(stage.gait == GAIT_BURST ? f_abs(goal_m_s - burst_m_s) < 1e-4f
                                                 : goal_m_s <= drift_m_s);
        }
    }
}

static void test_a_fast_disc_scatters_fish_and_a_slow_one_does_not(void **state)
{
    (void)state;
    const struct dragged slow = drag(0.10f, v3(0.0f, 1.0f, 0.0f));
    const vec3 slant_30_deg = v3(0.5f, 0.8660254f, 0.0f);
    const struct dragged fast = drag(0.40f, slant_30_deg);
    assert_int_equal(slow.escapes, 0);
    assert_true(fast.escapes >= 10);
    /* No fish may overlap another fish or the ring by 0.5 mm or more. The slow ring may move no
     * fish by 4 mm or more in a tick. */
    assert_true(slow.body_m < 0.0005f && slow.ring_m < 0.0005f && slow.jump_m < 0.004f);
    assert_true(fast.body_m < 0.0005f && fast.ring_m < 0.0005f && fast.over == 0);
    assert_true(slow.lag_m < 0.005f && fast.lag_m < 0.01f);
    assert_true(fast.jump_m < 2.0f * 0.40f * CORE_TICK_S + 0.003f);
}

static void test_an_escape_costs_stamina_and_ends_within_a_second(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 1, 5);
    struct fish *fish = &tank.fish[0];
    fish->position_m = v3(0.0f, -0.06f, 0.0f);
    fish->stamina = 0.8f;
    float top_m_s = 0.0f;
    uint32_t tick = 0, fled = 0;
    for (; tick < 2u * CORE_TICK_HZ; tick++) {
        struct obstacle disc =
            disc_at(v3(-0.06f, -0.06f, 0.0f), v3(tick < 30 ? 0.5f : 0.0f, 0.0f, 0.0f));
        disc.normal = v3(1.0f, 0.0f, 0.0f);
        run(&tank, tick, 1, &disc, 1);
        fled += fish->gait == GAIT_ESCAPE;
        top_m_s = f_max(top_m_s, v3_length(fish->velocity_m_s));
    }
    assert_in_range(fled, CORE_TICK_HZ / 2u, CORE_TICK_HZ);
    assert_true(top_m_s > 7.0f * fish->length_m && top_m_s < 11.0f * fish->length_m);
    assert_true(fish->stamina < 0.79f);
}

static void test_held_and_bowl_fish_are_not_changed(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 60, 8);
    tank.fish[3].gait = GAIT_HELD;
    tank.fish[4].gait = GAIT_BOWL;
    /* Places the held fish at the position of a swimming fish. Neither of the two may push the
     * other. */
    tank.fish[3].position_m = tank.fish[5].position_m;
    const uint64_t held = field_hash(HASH_START, &fish_fields, &tank.fish[3]),
                   bowl = field_hash(HASH_START, &fish_fields, &tank.fish[4]);
    run(&tank, 0, 600, 0, 0);
    assert_true(field_hash(HASH_START, &fish_fields, &tank.fish[3]) == held);
    assert_true(field_hash(HASH_START, &fish_fields, &tank.fish[4]) == bowl);
}

/* Drops a resting fish from 8 cm above the water. */
static struct fish *drop(vec3 place_m)
{
    struct fish *fish = &tank.fish[0];
    fish->gait = GAIT_ESCAPE;
    fish->position_m = v3(place_m.x, 0.08f, place_m.z);
    fish->velocity_m_s = v3(0.0f, 0.0f, 0.0f);
    return fish;
}

static void test_a_fish_that_a_poi_releases_falls_in_and_flees(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 1, 8);
    const struct fish *fish = drop(v3(0.1f, 0.0f, 0.0f));
    run(&tank, 0, 10, 0, 0);
    /* After 10 ticks the fish must still be falling, because it must not jump into the water. */
    assert_true(fish->position_m.y < 0.08f && fish->position_m.y > 0.0f);
    run(&tank, 10, 40, 0, 0);
    assert_int_equal(fish->gait, GAIT_ESCAPE);
    run(&tank, 50, 2u * CORE_TICK_HZ, 0, 0);
    check_inside(fish, tank.size_m);
}

static void test_a_fish_that_falls_on_others_finds_a_place_between_them(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 12; seed++) {
        open_tank(&tank, TANK_PRESET_FESTIVAL, 40, seed);
        struct fish *under = &tank.fish[20];
        under->position_m.y = -0.5f * under->height_m - 0.002f;
        const struct fish *fish = drop(under->position_m);
        run(&tank, 0, 50 + 2u * CORE_TICK_HZ, 0, 0);
        assert_true(fish_swims(fish));
        check_inside(fish, tank.size_m);
    }
}

static void test_no_fish_swims_into_the_bowl(void **state)
{
    (void)state;
    struct obstacle bowl = { .kind = OBSTACLE_BOWL,
                             .centre_m = tank_preset(0)->bowl_m[0],
                             .normal = { 0.0f, 1.0f, 0.0f },
                             .radius_m = 0.075f,
                             .depth_m = 0.055f };
    float deepest = 0.0f;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 300, 12);
    for (uint32_t tick = 0; tick < MINUTE / 2u; tick++) {
        run(&tank, tick, 1, &bowl, 1);
        for (uint32_t i = 0; i < tank.fish_count && tick > CORE_TICK_HZ; i++) {
            const struct box box = fish_box(&tank.fish[i]);
            deepest = f_max(deepest, v3_length(obstacle_clear(&bowl, &box)));
        }
    }
    print_message("deepest in the hull %.2f mm\n", (double)(1000.0f * deepest));
    assert_true(deepest < 0.0005f);
}

static void test_the_surface_is_never_completely_still(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 1, 2);
    run(&tank, 0, 4u * CORE_TICK_HZ, 0, 0);
    uint32_t moved = 0;
    for (uint32_t column = 0; column < RIPPLE_X; column++) {
        moved += f_abs(tank.water.height_m[tank.water.newest][RIPPLE_Z / 2][column]) > 1e-7f;
    }
    assert_true(moved > RIPPLE_X / 4u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fresh_tank_holds_fish_that_do_not_overlap),
        cmocka_unit_test(test_a_tank_accepts_exactly_the_maximum_fish_count),
        cmocka_unit_test(test_a_tank_that_is_full_keeps_its_fish_apart),
        cmocka_unit_test(test_every_fish_stays_valid_separate_and_inside_for_minutes),
        cmocka_unit_test(test_the_same_seed_repeats_the_motion_and_another_does_not),
        cmocka_unit_test(test_a_copy_of_a_tank_continues_identically),
        cmocka_unit_test(test_the_fullest_tank_of_each_preset_starts_without_an_overlap),
        cmocka_unit_test(test_the_smallest_tank_has_room_for_its_fish_with_every_seed),
        cmocka_unit_test(test_a_tank_without_room_is_rejected),
        cmocka_unit_test(test_a_staged_fish_has_its_staged_motion_from_the_first_tick),
        cmocka_unit_test(test_a_fast_disc_scatters_fish_and_a_slow_one_does_not),
        cmocka_unit_test(test_an_escape_costs_stamina_and_ends_within_a_second),
        cmocka_unit_test(test_held_and_bowl_fish_are_not_changed),
        cmocka_unit_test(test_a_fish_that_a_poi_releases_falls_in_and_flees),
        cmocka_unit_test(test_a_fish_that_falls_on_others_finds_a_place_between_them),
        cmocka_unit_test(test_no_fish_swims_into_the_bowl),
        cmocka_unit_test(test_the_surface_is_never_completely_still),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
