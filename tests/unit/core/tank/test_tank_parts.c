/* test_tank_parts.c -- checks data that the contact solver keeps. Its copies of positions and its
 * predicted gaps must agree with the true positions of the bodies. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/input.h"
#include "core/tank/tank_fields.h"
#include "tests/unit/support/open_tank.h"

#define POI_RADIUS 0.0465f
#define ROUNDING_M 0.00002f

static struct tank tank, twin;

static void open_official(uint32_t fish_count)
{
    open_tank(&tank, TANK_PRESET_OFFICIAL, fish_count, 7);
}

static int swims(const struct tank *t, uint32_t index)
{
    return fish_swims(&t->fish[index]);
}

/* ---- Fish scooped between two updates ------------------------------------------------------- */

/* Removes a fish from the water, as a poi does when it lifts a fish. */
static void scoop(struct tank *t, uint32_t index)
{
    t->fish[index].gait = GAIT_HELD;
    t->fish[index].holder = 0;
}

/* Moves the copy of a removed fish, which the broad phase still has, to the place `place_m`. */
static void ghost_at(struct tank *t, uint32_t index, vec3 place_m)
{
    t->broad_phase.body[index].centre_m = place_m;
}

static void test_a_fish_scooped_between_updates_leaves_no_stale_body(void **state)
{
    (void)state;
    uint32_t staged = 0;
    open_official(1000);
    for (uint32_t tick = 0; tick < 60u; tick++) {
        tank_tick(&tank, tick, NULL, 0);
        if (tick % BROAD_PHASE_UPDATE_TICKS != 0 || tank.broad_phase.contact_count == 0) {
            continue;
        }
        const struct contact contact =
            tank.broad_phase.contact[staged % tank.broad_phase.contact_count];
        if (!swims(&tank, contact.a) || !swims(&tank, contact.b)) {
            continue;
        }
        scoop(&tank, contact.a);
        const struct fish held = tank.fish[contact.a];
        memcpy(&twin, &tank, sizeof twin);
        ghost_at(&tank, contact.a, tank.fish[contact.b].position_m);
        ghost_at(&twin, contact.a, v3(0.0f, 1.0f, 0.0f));
        for (uint32_t k = 1; k < BROAD_PHASE_UPDATE_TICKS; k++) {
            tank_tick(&tank, ++tick, NULL, 0);
            tank_tick(&twin, tick, NULL, 0);
        }
        const struct fish *after = &tank.fish[contact.a];
        assert_memory_equal(&after->position_m, &held.position_m, sizeof held.position_m);
        assert_memory_equal(&after->angles, &held.angles, sizeof held.angles);
        assert_true(field_hash(HASH_START, &tank_quick_fields, &tank) ==
                    field_hash(HASH_START, &tank_quick_fields, &twin));
        staged++;
    }
    assert_true(staged >= 10);
}

/* ---- Predicted gaps ------------------------------------------------------------------------- */

static vec3 nearest_in(const struct box *box, vec3 point_m)
{
    const vec3 p = vec_basis_to_body(&box->axes, v3_sub(point_m, box->centre_m)), h = box->half_m;
    const vec3 q = v3(f_clamp(p.x, -h.x, h.x), f_clamp(p.y, -h.y, h.y), f_clamp(p.z, -h.z, h.z));
    return v3_add(box->centre_m, vec_basis_to_world(&box->axes, q));
}

/* Returns the true distance of two boxes. A point is projected alternately onto both boxes until it
 * converges to the nearest points. The largest gap along a separating axis cannot be used, because
 * it is too small if the boxes are nearest at two corners. */
static float apart_m(const struct box *a, const struct box *b)
{
    vec3 in_a = a->centre_m, in_b = b->centre_m;
    for (int k = 0; k < 100; k++) {
        in_a = nearest_in(a, in_b);
        in_b = nearest_in(b, in_a);
    }
    return v3_length(v3_sub(in_a, in_b));
}

/* Returns the largest distance by which a pair of fish is nearer than its predicted gap. Only pairs
 * with a positive predicted gap count. */
static float worst_violation_m(const struct broad_phase *broad_phase)
{
    float worst_m = 0.0f;
    for (uint32_t c = 0; c < broad_phase->near_count; c++) {
        const struct contact *contact = &broad_phase->contact[c];
        const float reported_m =
            contact->gap_m - (broad_phase->way_m[contact->a] + broad_phase->way_m[contact->b]);
        if (reported_m > 0.0f && swims(&tank, contact->a) && swims(&tank, contact->b)) {
            const struct box a = fish_box(&tank.fish[contact->a]),
                             b = fish_box(&tank.fish[contact->b]);
            if (box_gap(&a, 0.0f, &b, 0.0f).body_m < reported_m) {
                worst_m = f_max(worst_m, reported_m - apart_m(&a, &b));
            }
        }
    }
    return worst_m;
}

/* Returns a ring that moves from side to side through the fish. */
static struct obstacle swept(uint32_t tick, float speed_m_s)
{
    const float reach_m = 0.5f * tank.size_m.x - 0.06f;
    const float laps = (float)tick * CORE_TICK_S * speed_m_s / (4.0f * reach_m);
    const float share = laps - (float)(uint32_t)laps;
    const float way = share < 0.5f ? 1.0f : -1.0f;
    const float x = share < 0.5f ? 4.0f * share - 1.0f : 3.0f - 4.0f * share;
    struct obstacle ring = { .kind = OBSTACLE_DISC,
                             .centre_m = { x * reach_m, -0.5f * tank.size_m.y, 0.02f },
                             .radius_m = POI_RADIUS,
                             .axes = vec_basis_from_angles((struct angles){ 0.0f, 0.4f, 0.9f }) };
    ring.axes_before = ring.axes;
    ring.normal = ring.axes.up;
    ring.velocity_m_s = v3(way * speed_m_s, 0.0f, 0.0f);
    ring.step_m = v3_scale(ring.velocity_m_s, CORE_TICK_S);
    return ring;
}

static void test_the_true_distance_of_a_pair_is_at_least_its_predicted_gap(void **state)
{
    (void)state;
    const float speeds_m_s[] = { 0.3f, 0.8f, 1.5f, 3.0f };
    open_official(1000);
    for (uint32_t s = 0; s < 4; s++) {
        float worst_m = 0.0f;
        uint32_t reverted_count = 0;
        for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
            struct obstacle ring = swept(tick, speeds_m_s[s]);
            tank_tick(&tank, s * 1000u + tick, &ring, 1);
            reverted_count += tank.solver.reverted_count;
            worst_m = f_max(worst_m, worst_violation_m(&tank.broad_phase));
        }
        print_message("%.1f m/s: %.4f mm nearer at worst, %u put back\n", (double)speeds_m_s[s],
                      (double)(1000.0f * worst_m), reverted_count);
        assert_true(worst_m < ROUNDING_M);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_scooped_between_updates_leaves_no_stale_body),
        cmocka_unit_test(test_the_true_distance_of_a_pair_is_at_least_its_predicted_gap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
