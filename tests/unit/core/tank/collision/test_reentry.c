/* test_reentry.c -- checks fish that are dropped into the water among other fish. A dropped fish
 * may swim only after it is clear of all other fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/capture.h"
#include "tests/unit/support/open_tank.h"

#define LOOSE_MAX_S 0.5f
#define POI_RADIUS 0.0465f

static struct tank tank;
static struct bowl bowl;

static float draw(uint32_t who, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 5, which, who, RNG_TEST }, low, high);
}

static bool is_loose(uint32_t index)
{
    return tank.fish[index].gait == GAIT_HELD && tank.fish[index].holder == FISH_HOLDER_WATER;
}

static uint32_t count_loose(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        count += (uint32_t)is_loose(i);
    }
    return count;
}

static float deepest_m(void)
{
    float deepest = 0.0f;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const struct fish *a = &tank.fish[i], *b = &tank.fish[j];
            const vec3 d = v3_sub(a->position_m, b->position_m);
            const float reach_m = 0.56f * (a->length_m + b->length_m);
            if (fish_swims(a) && fish_swims(b) && v3_dot(d, d) < reach_m * reach_m) {
                const struct box box_a = fish_box(a), box_b = fish_box(b);
                deepest = f_max(deepest, box_depth_m(&box_a, &box_b));
            }
        }
    }
    return deepest;
}

/* Returns the number of ticks after which all dropped fish swim. In each of these ticks, no
 * swimming fish may overlap another. */
static uint32_t run_until_all_swim(uint32_t tick, struct obstacle *obstacles, uint32_t count)
{
    for (uint32_t ticks = 0; ticks < 10u * CORE_TICK_HZ; ticks++) {
        if (count_loose() == 0) {
            return ticks;
        }
        assert_true(tank.reentry_count >= count_loose());
        tank_tick(&tank, tick + ticks, obstacles, count);
        assert_true(deepest_m() <= SOLVER_FREE_M + 1e-6f);
    }
    return UINT32_MAX;
}

static void expect_all_swim_soon(const char *what, uint32_t worst_ticks)
{
    const float worst_s = (float)worst_ticks * CORE_TICK_S;
    print_message("%s: reentry took %.2f s at most\n", what, (double)worst_s);
    assert_true(worst_s < LOOSE_MAX_S);
}

static uint32_t max_of(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static void settle(uint32_t *tick, uint32_t ticks)
{
    for (uint32_t k = 0; k < ticks; k++) {
        tank_tick(&tank, (*tick)++, NULL, 0);
    }
}

/* Drops 20 fish at the same time, each onto another fish. All of them must swim within half a
 * second. */
static void test_fish_dropped_into_a_full_tank_swim_within_half_a_second(void **state)
{
    (void)state;
    uint32_t tick = 0, worst = 0;
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 3);
    for (uint32_t drop = 0; drop < 12; drop++) {
        settle(&tick, 30);
        for (uint32_t k = 0; k < 20; k++) {
            const uint32_t who = drop * 40u + k;
            tank.fish[who].position_m = tank.fish[999u - who].position_m;
            tank.fish[who].angles.yaw_rad = draw(who, 1, -F_PI, F_PI);
            catch_set_free(&tank, &tank.fish[who], v3(0.0f, -0.8f, 0.0f));
        }
        assert_int_equal(count_loose(), 20);
        worst = max_of(worst, run_until_all_swim(tick, NULL, 0));
        tick += CORE_TICK_HZ;
    }
    expect_all_swim_soon("dropped", worst);
}

static void test_fish_poured_into_a_full_tank_swim_within_half_a_second(void **state)
{
    (void)state;
    uint32_t tick = 0, worst = 0;
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 4);
    for (uint32_t pour = 0; pour < 8; pour++) {
        bowl_init(&bowl, v3(draw(pour, 2, -0.4f, 0.4f), 0.012f, draw(pour, 3, -0.2f, 0.2f)));
        settle(&tick, 30);
        for (uint32_t k = 0; k < 40; k++) {
            tank.fish[pour * 40u + k].gait = GAIT_BOWL;
            tank.fish[pour * 40u + k].holder = 0;
        }
        bowl.fish_count = 40;
        bowl_empty(&bowl, 0, &tank);
        assert_int_equal(count_loose(), 40);
        struct obstacle hull = bowl_obstacle(&bowl);
        worst = max_of(worst, run_until_all_swim(tick, &hull, 1));
        tick += CORE_TICK_HZ;
    }
    expect_all_swim_soon("poured", worst);
}

static void test_fish_dropped_on_each_other_separate(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 12, 6);
    for (uint32_t i = 0; i < 12; i++) {
        tank.fish[i].position_m = v3(0.1f, -0.06f, 0.05f);
        tank.fish[i].angles = (struct angles){ 0.3f, 0.0f, 0.0f };
        catch_set_free(&tank, &tank.fish[i], v3(0.0f, 0.0f, 0.0f));
    }
    expect_all_swim_soon("twelve in one place", run_until_all_swim(0, NULL, 0));
}

/* Drops two equal fish at the same place in open water. The first fish may swim at once. The second
 * fish may swim as soon as it is clear of the first. */
static void test_two_dropped_fish_in_one_place_swim_without_an_overlap(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_FESTIVAL, 2, 6);
    for (uint32_t i = 0; i < 2; i++) {
        tank.fish[i].position_m = v3(0.0f, -0.06f, 0.0f);
        reentry_begin(&tank, &tank.fish[i], v3(0.0f, 0.0f, 0.0f));
    }
    tank_tick(&tank, 0, NULL, 0);
    assert_int_equal(count_loose(), 1);
    assert_int_equal(tank.reentry_count, 1);
    expect_all_swim_soon("two in one place", run_until_all_swim(1, NULL, 0));
    assert_int_equal(tank.reentry_count, 0);
}

/* The smallest allowed tank is filled with the maximum number of fish, and one of them is
 * dropped. */
static void test_there_is_a_gap_even_in_the_smallest_tank(void **state)
{
    (void)state;
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.size_m = v3(0.30f, 0.05f, 0.30f);
    config.fish_count = tank_config_fish_max(&config);
    assert_int_equal(tank_open(&tank, &config), 1);
    reentry_begin(&tank, &tank.fish[0], v3(0.0f, 0.0f, 0.0f));
    tank.fish[0].position_m = tank.fish[1].position_m;
    expect_all_swim_soon("in a small tank", run_until_all_swim(0, NULL, 0));
}

/* The dropped fish lie just above the paper, below two layers of other fish. They must find free
 * places above the paper, and must not pass through the paper. */
static void test_a_dropped_fish_takes_no_gap_through_paper(void **state)
{
    (void)state;
    static uint8_t paper[OBSTACLE_PAPER_SIDE * OBSTACLE_PAPER_SIDE];
    for (uint32_t i = 0; i < sizeof paper; i++) {
        paper[i] = OBSTACLE_PAPER_HOLDS;
    }
    struct obstacle ring = { .kind = OBSTACLE_DISC,
                             .centre_m = { 0.0f, -0.06f, 0.0f },
                             .normal = { 0.0f, 1.0f, 0.0f },
                             .radius_m = POI_RADIUS,
                             .axes = vec_basis_from_angles((struct angles){ 0 }),
                             .axes_before = vec_basis_from_angles((struct angles){ 0 }),
                             .paper = paper,
                             .paper_radius_m = 0.9f * POI_RADIUS };
    /* 36 fish swim in three layers of twelve. Twelve more fish are dropped onto the lowest
     * layer. */
    open_tank(&tank, TANK_PRESET_FESTIVAL, 48, 6);
    for (uint32_t i = 0; i < 48; i++) {
        const uint32_t layer = i / 12u % 3u;
        struct fish *fish = &tank.fish[i];
        fish_grow(fish, 0.03f, tank_behavior_params(&tank));
        fish->position_m =
            v3(0.0065f * (float)(i % 6u) - 0.01625f, -0.0545f + 0.0112f * (float)layer,
               i / 6u % 2u == 0 ? -0.0155f : 0.0155f);
        fish->angles = (struct angles){ 0.0f, 0.0f, 0.0f };
        fish->speed_m_s = 0.0f;
        if (i >= 36u) {
            reentry_begin(&tank, fish, v3(0.0f, -0.3f, 0.0f));
        }
    }
    for (uint32_t tick = 0; tick < CORE_TICK_HZ && count_loose() > 0; tick++) {
        tank_tick(&tank, tick, &ring, 1);
        for (uint32_t i = 36; i < 48; i++) {
            const vec3 p = tank.fish[i].position_m;
            if (p.x * p.x + p.z * p.z < 0.036f * 0.036f) {
                assert_true(p.y > -0.06f);
            }
        }
    }
    assert_int_equal(count_loose(), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_dropped_into_a_full_tank_swim_within_half_a_second),
        cmocka_unit_test(test_fish_poured_into_a_full_tank_swim_within_half_a_second),
        cmocka_unit_test(test_fish_dropped_on_each_other_separate),
        cmocka_unit_test(test_two_dropped_fish_in_one_place_swim_without_an_overlap),
        cmocka_unit_test(test_there_is_a_gap_even_in_the_smallest_tank),
        cmocka_unit_test(test_a_dropped_fish_takes_no_gap_through_paper),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
