/* test_ring_contact.c -- checks the contact between a moving poi and a fish within one tick: the
 * motion, the reaction, and the side of the paper on which the fish stays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/collision/obstacle.h"
#include "tests/unit/support/pond.h"

#define CASES 400u

static uint8_t paper[OBSTACLE_PAPER_SIDE * OBSTACLE_PAPER_SIDE];

static float draw(uint32_t who, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 8, which, who, RNG_TEST }, low, high);
}

static struct angles any_angles(uint32_t who, uint32_t which)
{
    return (struct angles){ draw(who, which, -F_PI, F_PI), draw(who, which + 1u, -0.8f, 0.8f),
                            draw(who, which + 2u, -0.8f, 0.8f) };
}

/* Returns a disc at a random place that has moved at up to 3 m/s in this tick. If `who` is odd, the
 * disc has also turned. */
static struct obstacle disc_of(uint32_t who)
{
    struct obstacle disc = {
        .kind = OBSTACLE_DISC,
        .centre_m = v3(draw(who, 1, -0.1f, 0.1f), draw(who, 2, -0.1f, 0.0f), 0.0f),
        .radius_m = 0.0465f,
        .axes = vec_basis_from_angles(any_angles(who, 3)),
        .turned = who % 2u,
        .paper = paper,
        .paper_radius_m = 0.0418f,
    };
    const vec3 way =
        v3(draw(who, 6, -1.0f, 1.0f), draw(who, 7, -1.0f, 1.0f), draw(who, 8, -1.0f, 1.0f));
    struct angles before = any_angles(who, 3);
    before.yaw_rad += disc.turned ? draw(who, 10, -0.3f, 0.3f) : 0.0f;
    disc.axes_before = vec_basis_from_angles(before);
    disc.normal = disc.axes.up;
    disc.velocity_m_s = v3_scale(v3_normalize_or(way, disc.normal), draw(who, 9, 0.05f, 3.0f));
    disc.step_m = v3_scale(disc.velocity_m_s, CORE_TICK_S);
    return disc;
}

static struct body body_at(vec3 place_m, struct angles angles)
{
    const struct fish fish = { .position_m = place_m, .angles = angles, WAKIN(0.045f) };
    const struct box box = fish_box(&fish);
    return body_of(&box, 0.0f);
}

static int has_paper(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sizeof paper; i++) {
        paper[i] = OBSTACLE_PAPER_HOLDS;
    }
    return 0;
}

static void test_a_fish_moved_with_the_disc_keeps_its_relative_position(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < CASES; i++) {
        const struct obstacle disc = disc_of(i), before = obstacle_before(&disc);
        const vec3 was_m = v3(draw(i, 11, -0.2f, 0.2f), draw(i, 12, -0.2f, 0.0f), 0.05f);
        const vec3 is_m = obstacle_carry_m(&disc, was_m);
        const vec3 was_seen = vec_basis_to_body(&before.axes, v3_sub(was_m, before.centre_m));
        const vec3 is_seen = vec_basis_to_body(&disc.axes, v3_sub(is_m, disc.centre_m));
        assert_true(v3_length(v3_sub(was_seen, is_seen)) < 1e-6f);
    }
}

/* Fish push a disc back along its step. The disc must never move back by more than its step. If a
 * fish did not touch the disc before the step, it must not touch the disc at the end. */
static void test_a_blocked_disc_moves_back_by_at_most_its_step(void **state)
{
    (void)state;
    uint32_t met = 0, stood = 0;
    for (uint32_t i = 0; i < CASES; i++) {
        struct obstacle disc = disc_of(i);
        const struct obstacle start = obstacle_before(&disc);
        const float round_rad = draw(i, 13, -F_PI, F_PI);
        const vec3 on_ring = v3(0.045f * f_cos(round_rad), 0.0f, 0.045f * f_sin(round_rad));
        const struct body body = body_at(
            v3_add(disc.centre_m, vec_basis_to_world(&disc.axes, on_ring)), any_angles(i, 14));
        vec3 out;
        if (obstacle_excess_m(&start, &body, &body, 0.0003f, &out) > 0.0f) {
            continue;
        }
        uint32_t calls = 0;
        float excess_m = obstacle_excess_m(&disc, &body, &body, 0.0003f, &out);
        met += excess_m > 1e-6f;
        while (excess_m > 1e-6f) {
            const float step_m = v3_length(disc.step_m);
            assert_true(obstacle_apply_reaction(&disc, out, excess_m));
            assert_true(v3_length(disc.step_m) <= step_m + 1e-7f);
            assert_true(disc.reaction != 0 && ++calls <= 10u);
            excess_m = obstacle_excess_m(&disc, &body, &body, 0.0003f, &out);
        }
        const vec3 from_m = v3_sub(disc.centre_m, disc.step_m);
        assert_true(v3_length(v3_sub(from_m, start.centre_m)) < 1e-6f);
        stood += calls > 0 && v3_length(disc.step_m) == 0.0f;
    }
    print_message("%u of %u met a fish, %u had to stand still\n", met, CASES, stood);
    assert_true(met > CASES / 8u && stood < met);
}

static void test_a_disc_at_rest_does_not_move_back(void **state)
{
    (void)state;
    struct obstacle disc = disc_of(2);
    disc.step_m = v3(0.0f, 0.0f, 0.0f);
    disc.turned = 0;
    const vec3 centre_m = disc.centre_m;
    assert_false(obstacle_apply_reaction(&disc, v3(0.0f, 1.0f, 0.0f), 0.001f));
    assert_true(v3_length(v3_sub(disc.centre_m, centre_m)) == 0.0f && disc.reaction == 0);
}

/* At 3 m/s, the paper moves by 25 mm in a tick, which is more than the height of a fish. The fish
 * must nevertheless stay on its side of the paper. */
static void test_paper_keeps_a_fish_on_its_side_at_any_speed(void **state)
{
    (void)state;
    uint32_t pushed = 0;
    for (uint32_t i = 0; i < CASES; i++) {
        const struct obstacle disc = disc_of(i), before = obstacle_before(&disc);
        const float side = i % 4u < 2u ? 1.0f : -1.0f;
        const vec3 seen = v3(draw(i, 20, -0.015f, 0.015f), side * draw(i, 21, 0.009f, 0.03f),
                             draw(i, 22, -0.015f, 0.015f));
        const vec3 was_m = v3_add(before.centre_m, vec_basis_to_world(&before.axes, seen));
        struct body body = body_at(was_m, any_angles(i, 23));
        for (uint32_t round = 0; round < 40u; round++) {
            const vec3 push = obstacle_paper_push(&disc, &body, was_m);
            pushed += round == 0 && v3_dot(push, push) > 0.0f;
            body.centre_m = v3_add(body.centre_m, push);
        }
        const vec3 now = vec_basis_to_body(&disc.axes, v3_sub(body.centre_m, disc.centre_m));
        if (now.x * now.x + now.z * now.z < 0.04f * 0.04f) {
            assert_true(side * now.y > 0.0f);
        }
    }
    assert_true(pushed > CASES / 8u);
}

static void test_torn_paper_stops_no_fish(void **state)
{
    (void)state;
    struct obstacle disc = disc_of(0);
    disc.turned = 0;
    const struct obstacle before = obstacle_before(&disc);
    const vec3 was_m = v3_muladd(before.centre_m, before.axes.up, 0.004f);
    const struct body body = body_at(was_m, (struct angles){ 0 });
    const vec3 held = obstacle_paper_push(&disc, &body, was_m);
    for (uint32_t i = 0; i < sizeof paper; i++) {
        paper[i] = 0;
    }
    const vec3 freed = obstacle_paper_push(&disc, &body, was_m);
    has_paper(state);
    assert_true(v3_dot(held, held) > 0.0f);
    assert_true(v3_dot(freed, freed) == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_moved_with_the_disc_keeps_its_relative_position),
        cmocka_unit_test(test_a_blocked_disc_moves_back_by_at_most_its_step),
        cmocka_unit_test(test_a_disc_at_rest_does_not_move_back),
        cmocka_unit_test(test_paper_keeps_a_fish_on_its_side_at_any_speed),
        cmocka_unit_test(test_torn_paper_stops_no_fish),
    };
    return cmocka_run_group_tests(tests, has_paper, NULL);
}
