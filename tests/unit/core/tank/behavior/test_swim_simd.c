/* test_swim_simd.c -- checks that the SIMD code for swimming gives the same result as the scalar
 * code, bit for bit. Checks also the distances that it reports. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/mem.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/swim.h"
#include "tests/unit/support/pond.h"

/* Number of fish. The prime number 67 is not divisible by any number of lanes, so the last block is
 * incomplete. */
#define SHOAL 67u
#define SHOAL_ROUNDS 3000u

static float drawn(uint32_t round, uint32_t fish, uint32_t *use, float low, float high)
{
    return rng_range((struct rng_key){ round, fish, (*use)++, RNG_TEST }, low, high);
}

/* Returns a fish in a random state. The state may be slightly outside the possible range. */
static struct fish any_fish(uint32_t round, uint32_t index)
{
    uint32_t use = 0;
#define DRAWN(low, high) drawn(round, index, &use, low, high)
    struct fish fish = {
        .position_m = { DRAWN(-0.7f, 0.7f), DRAWN(-0.2f, 0.0f), DRAWN(-0.4f, 0.4f) },
        .speed_m_s = DRAWN(0.0f, 0.5f),
        .angles = { DRAWN(-F_PI, F_PI), DRAWN(-1.0f, 1.0f), DRAWN(-1.6f, 1.6f) },
        .yaw_rate_rad_s = DRAWN(-20.0f, 20.0f),
        .push_m_s = { DRAWN(-0.03f, 0.03f), DRAWN(-0.03f, 0.03f), DRAWN(-0.03f, 0.03f) },
        .climb_m_s = DRAWN(-0.03f, 0.03f),
        .heading_rad = DRAWN(-9.0f, 9.0f),
        .drawn_rad = DRAWN(-F_PI, F_PI),
        .brake = DRAWN(0.0f, 1.0f),
        .room = DRAWN(0.2f, 1.0f),
        .speed_goal_m_s = DRAWN(0.0f, 0.5f),
        .speed_up_keep = DRAWN(0.0f, 1.0f),
        .slow_keep = DRAWN(0.0f, 1.0f),
        .turn_rate_max_rad_s = DRAWN(0.5f, 30.0f),
        .haste = DRAWN(0.0f, 1.0f) < 0.8f ? 1.0f : 8.0f,
        .climb_goal_m_s = DRAWN(-0.03f, 0.03f),
        .pitch_goal_rad = DRAWN(-0.5f, 0.5f),
        .beats = DRAWN(0.0f, 1.0f) < 0.5f ? 0.0f : 1.0f,
        .velocity_m_s = { DRAWN(-0.3f, 0.3f), DRAWN(-0.3f, 0.3f), DRAWN(-0.3f, 0.3f) },
        .stamina = DRAWN(0.0f, 1.0f),
        .bend_rad = DRAWN(-1.0f, 1.0f),
        .tail_phase_rad = DRAWN(0.0f, 6.28f),
        .tail_beat_hz = DRAWN(0.5f, 15.0f),
        .tail_amplitude = DRAWN(0.15f, 1.5f),
        .age_days = DRAWN(60.0f, 300.0f),
    };
    fish_grow(&fish, DRAWN(0.03f, 0.09f), pond_params());
    fish.gait = (uint8_t)DRAWN(0.0f, 4.999f);
    /* Makes held fish rare, because a single held fish makes its whole block use the scalar
     * code. */
    if (DRAWN(0.0f, 1.0f) < 0.02f) {
        fish.gait = DRAWN(0.0f, 1.0f) < 0.5f ? GAIT_HELD : GAIT_BOWL;
    }
    fish.falls = DRAWN(0.0f, 1.0f) < 0.01f;
#undef DRAWN
    return fish;
}

/* Returns the greatest distance by which a corner of the body has moved. */
static float corner_way_m(const struct body *from, const struct body *to)
{
    float farthest_m = 0.0f;
    for (int corner = 0; corner < 8; corner++) {
        const float x = corner & 1 ? 1.0f : -1.0f, y = corner & 2 ? 1.0f : -1.0f,
                    z = corner & 4 ? 1.0f : -1.0f;
        const struct box a = body_box(from), b = body_box(to);
        const vec3 half = v3(x * a.half_m.x, y * a.half_m.y, z * a.half_m.z);
        const vec3 at_a = v3_add(a.centre_m, vec_basis_to_world(&a.axes, half));
        const vec3 at_b = v3_add(b.centre_m, vec_basis_to_world(&b.axes, half));
        farthest_m = f_max(farthest_m, v3_length(v3_sub(at_b, at_a)));
    }
    return farthest_m;
}

static void test_no_corner_moves_farther_than_the_reported_distance(void **state)
{
    (void)state;
    float closest = 1.0f;
    for (uint32_t round = 0; round < 20000u; round++) {
        struct fish fish = any_fish(round, 0);
        const struct box before = fish_box(&fish);
        const float way_m = swim_move(&fish, pond_params());
        const struct box after = fish_box(&fish);
        const struct body from = body_of(&before, 0.0f), to = body_of(&after, 0.0f);
        const float corner_m = corner_way_m(&from, &to);
        assert_true(corner_m <= way_m + 1e-6f);
        closest = f_min(closest, way_m > 1e-3f ? 1.0f - corner_m / way_m : 1.0f);
    }
    /* The reported distance is an upper limit. In the best case, it must exceed the true distance
     * by less than 10 %. */
    assert_true(closest < 0.1f);
}

struct school {
    struct fish fish[SHOAL];
    struct body body[SHOAL];
    float way_m[SHOAL];
    vec3 before_m[SHOAL + 1u];
};

static struct shoal shoal_of(struct school *school, uint8_t preset)
{
    return (struct shoal){ school->fish,  school->body,
                           school->way_m, school->before_m,
                           SHOAL,         &tank_preset(preset)->params,
                           0.2f };
}

static void school_make(struct school *school, uint32_t round)
{
    memset(school, 0, sizeof *school);
    for (uint32_t i = 0; i < SHOAL; i++) {
        school->fish[i] = any_fish(round, i);
        school->before_m[i] = school->fish[i].position_m;
    }
}

/* Moves all fish with the scalar code. */
static void school_swim_one_by_one(struct school *school, uint8_t preset, vec3 shove_m)
{
    for (uint32_t i = 0; i < SHOAL; i++) {
        struct fish *fish = &school->fish[i];
        if (!fish_swims(fish)) {
            continue;
        }
        school->way_m[i] +=
            fish->falls ? SWIM_FAR_M : swim_move(fish, &tank_preset(preset)->params);
        const struct box box = fish_box(fish);
        school->body[i] = body_of(&box, 0.2f * fish->length_m);
        school->body[i].centre_m = v3_add(school->body[i].centre_m, shove_m);
        school->way_m[i] += v3_length(v3_sub(school->body[i].centre_m, fish->position_m));
        fish->position_m = school->body[i].centre_m;
        swim_settle(fish, v3_sub(fish->position_m, school->before_m[i]),
                    v3_scale(school->body[i].back, -1.0f));
    }
}

static void school_swim(struct school *school, uint8_t preset, vec3 shove_m, uint32_t lanes)
{
    const struct shoal shoal = shoal_of(school, preset);
    swim_move_all(&shoal, lanes);
    for (uint32_t i = 0; i < SHOAL; i++) {
        if (fish_swims(&school->fish[i])) {
            school->body[i].centre_m = v3_add(school->body[i].centre_m, shove_m);
        }
    }
    swim_settle_all(&shoal, lanes);
}

static void check_lanes(uint32_t lanes)
{
    static struct school one_by_one, by_lanes;
    for (uint32_t round = 0; round < SHOAL_ROUNDS; round++) {
        const uint8_t preset = (uint8_t)(round % TANK_PRESET_COUNT);
        const vec3 shove_m = v3(1e-4f * (float)(round % 5u), -2e-4f, 1e-4f);
        school_make(&one_by_one, round);
        school_make(&by_lanes, round);
        school_swim_one_by_one(&one_by_one, preset, shove_m);
        school_swim(&by_lanes, preset, shove_m, lanes);
        for (uint32_t i = 0; i < SHOAL; i++) {
            assert_memory_equal(&by_lanes.fish[i], &one_by_one.fish[i], sizeof(struct fish));
            assert_memory_equal(&by_lanes.body[i], &one_by_one.body[i], sizeof(struct body));
            assert_memory_equal(&by_lanes.way_m[i], &one_by_one.way_m[i], sizeof(float));
        }
    }
}

static void test_four_lanes_equal_the_scalar_form(void **state)
{
    (void)state;
    check_lanes(0);
    check_lanes(4);
}

static void test_eight_lanes_equal_the_scalar_form(void **state)
{
    (void)state;
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) {
        check_lanes(8);
        return;
    }
#endif
    skip();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_corner_moves_farther_than_the_reported_distance),
        cmocka_unit_test(test_four_lanes_equal_the_scalar_form),
        cmocka_unit_test(test_eight_lanes_equal_the_scalar_form),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
