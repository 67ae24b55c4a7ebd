/* test_poi_blocked.c -- tests the ring of a poi while fish block it and after they release it. */
#include "tests/unit/support/poi_fixture.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

/* Runs a tick in which fish hold the ring, so that it cannot move. */
static void tick_held(void)
{
    const struct poi_grip grip = { fixture.hand, 1 };
    poi_tick(&fixture.poi, &grip, &fixture.tank, &fixture.bowl);
    struct obstacle ring = poi_obstacle(&fixture.poi);
    ring.centre_m = v3_sub(ring.centre_m, ring.step_m);
    ring.step_m = ring.velocity_m_s = v3(0.0f, 0.0f, 0.0f);
    ring.reaction = REACTION_POSITION;
    poi_apply_reaction(&fixture.poi, &ring);
}

/* The player's target moves for 0.8 s while the ring is blocked, and for 0.5 s more after the ring
 * is released. The ring must catch up with the target at a limited speed. */
static void test_a_released_ring_follows_the_hand_without_overspeed(void **state)
{
    (void)state;
    const float hands_m_s[] = { 0.05f, 0.22f, 0.44f };
    for (uint32_t i = 0; i < 6; i++) {
        const float hand_m_s = hands_m_s[i / 2u];
        fixture_init(&fixture, 5, 1);
        fixture.has_wrist = 1;
        /* In every second pass of this loop the ring has no paper, and therefore almost no drag. */
        if (i % 2u == 1u) {
            memset(fixture.poi.sheet.state, CELL_HOLE, sizeof fixture.poi.sheet.state);
            fixture.poi.sheet.paper_cells = 0;
        }
        fixture.hand.position_m = fixture.poi.position_m = v3(-0.35f, -0.07f, 0.0f);
        fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad = 0.5f * F_PI;
        fixture_wait(&fixture, 0.5f);
        for (uint32_t tick = 0; tick < 156; tick++) {
            fixture.hand.position_m.x += hand_m_s * CORE_TICK_S;
            if (tick < 96) {
                tick_held();
                assert_float_equal(fixture.poi.position_m.x, -0.35f, 0.001f);
                continue;
            }
            const float behind_m = fixture.hand.position_m.x - fixture.poi.position_m.x;
            const float most_m_s = hand_m_s + f_min(4.0f * behind_m, 1.0f) + 0.01f;
            const vec3 before_m = fixture.poi.position_m;
            fixture_tick(&fixture);
            const vec3 step_m = v3_sub(fixture.poi.position_m, before_m);
            assert_true(v3_length(step_m) < most_m_s * CORE_TICK_S);
        }
        fixture_wait(&fixture, 1.0f);
        assert_float_equal(fixture.poi.position_m.x, fixture.hand.position_m.x, 0.002f);
    }
}

static void test_a_pull_at_a_blocked_ring_does_not_load_the_paper(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 10; seed++) {
        fixture_init(&fixture, 5, seed);
        fixture_dip(&fixture);
        for (uint32_t tick = 0; tick < 30; tick++) {
            fixture.hand.position_m.y += 0.22f * CORE_TICK_S;
            tick_held();
        }
        assert_true(f_abs(fixture.poi.pressure_pa) < 1.0f);
        assert_float_equal(sheet_left(&fixture.poi.sheet), 1.0f, 0.0f);
        /* From here on, the ring is no longer blocked. */
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.22f);
        fixture_wait(&fixture, 0.2f);
        assert_true(fixture.poi.position_m.y > 0.01f);
        assert_true(sheet_left(&fixture.poi.sheet) > 0.9f);
    }
}

/* The player moves the ring broadside under water at 0.3 m/s. A ring that can move makes the water
 * flow, but a blocked ring must not. */
static void test_a_blocked_ring_moves_no_water(void **state)
{
    (void)state;
    fixture_init(&fixture, 5, 1);
    fixture.has_wrist = 1;
    fixture.hand.position_m = fixture.poi.position_m = v3(-0.2f, -0.07f, 0.0f);
    fixture.hand.angles.roll_rad = fixture.poi.angles.roll_rad = 0.5f * F_PI;
    fixture_wait(&fixture, 0.5f);
    for (uint32_t tick = 0; tick < 48; tick++) {
        fixture.hand.position_m.x += 0.3f * CORE_TICK_S;
        if (tick < 24) {
            fixture_tick(&fixture);
        } else {
            tick_held();
        }
        const struct poi_grip grip = { fixture.hand, 1 };
        struct poi next = fixture.poi;
        poi_tick(&next, &grip, &fixture.tank, &fixture.bowl);
        const struct obstacle ring = poi_obstacle(&next);
        const vec3 ahead_m = v3(next.position_m.x + 0.02f, -0.07f, 0.0f);
        const float flow_m_s = v3_length(water_flow_m_s(&ring, ahead_m));
        if (tick == 23) {
            assert_true(flow_m_s > 0.1f);
        } else if (tick > 24) {
            /* The obstacle has the velocity that the player requests. The ring is blocked, so the
             * water must not flow. */
            assert_true(v3_length(ring.velocity_m_s) > 0.1f);
            assert_float_equal(flow_m_s, 0.0f, 0.001f);
        }
    }
}

/* After fish have blocked the ring, the ring follows the player's hand at a limited speed. This
 * limit must not apply to a ring that was not blocked. In this test nothing blocks the ring. The
 * player moves it 0.5 m back and forth at up to 2 m/s and stops suddenly. */
static void test_a_fast_free_hand_motion_keeps_the_same_lag(void **state)
{
    (void)state;
    const float heights_m[] = { 0.08f, -0.07f };
    for (uint32_t i = 0; i < 2; i++) {
        fixture_init(&fixture, 4, 1);
        fixture.has_wrist = 1;
        fixture.hand.position_m = fixture.poi.position_m = v3(0.0f, heights_m[i], 0.0f);
        fixture_wait(&fixture, 0.5f);
        for (uint32_t tick = 1; tick < 3u * CORE_TICK_HZ / 2u; tick++) {
            fixture.hand.position_m.x = 0.25f * f_sin(8.0f * (float)tick * CORE_TICK_S);
            fixture_tick(&fixture);
            const float behind_m =
                v3_length(v3_sub(fixture.hand.position_m, fixture.poi.position_m));
            assert_true(v3_length(fixture.poi.velocity_m_s) <
                        0.999f * (fixture.poi.pace_m_s + 4.0f * behind_m));
        }
        fixture.hand.position_m = fixture.poi.position_m = v3(-0.25f, heights_m[i], 0.0f);
        fixture_wait(&fixture, 0.5f);
        fixture_move(&fixture, v3(0.15f, heights_m[i], 0.0f), 2.0f);
        const float lag_m = fixture.hand.position_m.x - fixture.poi.position_m.x;
        assert_true(lag_m > 0.030f && lag_m < 0.058f);
        fixture_wait(&fixture, 0.1f);
        assert_float_equal(fixture.poi.position_m.x, 0.15f, 0.002f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_released_ring_follows_the_hand_without_overspeed),
        cmocka_unit_test(test_a_pull_at_a_blocked_ring_does_not_load_the_paper),
        cmocka_unit_test(test_a_blocked_ring_moves_no_water),
        cmocka_unit_test(test_a_fast_free_hand_motion_keeps_the_same_lag),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
