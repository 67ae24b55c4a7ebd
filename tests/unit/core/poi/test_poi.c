/* test_poi.c -- the ring between hand, water and walls. */
#include "tests/unit/support/poi_stand.h"

#include "core/base/rng.h"
#include "core/tank/water.h"

#define SCREEN_PX 1280.0f
#define VIEW_M 0.95f /* What the screen's width shows of the tank. */

static struct stand stand; /* Too large for some stacks. */

static void test_in_air_the_poi_lags_a_moving_hand_by_a_frame_and_a_half(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand.hand.position_m = stand.poi.position_m = v3(-0.3f, 0.06f, 0.0f);
    stand_move(&stand, v3(0.3f, 0.06f, 0.0f), 0.5f);
    const float lag_s = (stand.hand.position_m.x - stand.poi.position_m.x) / 0.5f;
    assert_true(lag_s > 0.015f);
    assert_true(lag_s < 0.026f);
}

static void test_a_leap_of_the_hand_is_followed_without_overshoot(void **state)
{
    (void)state;
    const float heights_m[] = { 0.06f, -0.07f };
    for (uint32_t i = 0; i < 2; i++) {
        stand_init(&stand, 4, 1);
        stand.hand.position_m = stand.poi.position_m = v3(-0.2f, heights_m[i], 0.0f);
        stand_wait(&stand, 0.2f);
        stand.hand.position_m.x = 0.2f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            stand_tick(&stand);
            assert_true(stand.poi.position_m.x < 0.205f);
        }
        assert_float_equal(stand.poi.position_m.x, 0.2f, 0.001f);
    }
}

static void test_a_hand_that_shakes_wildly_cannot_blow_the_poi_up(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    for (uint32_t tick = 0; tick < 1200; tick++) {
        stand.hand.position_m = tick % 2u ? v3(40.0f, -30.0f, 7.0f) : v3(-40.0f, 30.0f, -7.0f);
        stand.hand.angles.pitch_rad = tick % 3u ? 3.0f : -3.0f;
        stand_tick(&stand);
        assert_true(v3_length(stand.poi.velocity_m_s) < 20.0f);
        assert_in_range((int)(1000.0f * stand.poi.position_m.y) + 150, 0, 450);
    }
}

/* Holds the poi broadside to a steady stream, made by moving it at that speed. */
static float steady_broadside_n(float speed_m_s)
{
    stand_init(&stand, 4, 1);
    stand.tank.size_m = v3(4.0f, 0.5f, 1.0f);
    stand.hand.position_m = stand.poi.position_m = v3(-1.0f, -0.2f, 0.0f);
    stand.hand.angles.roll_rad = 0.5f * F_PI;
    stand_wait(&stand, 0.5f);
    stand_move(&stand, v3(-0.4f, -0.2f, 0.0f), speed_m_s);
    return stand.force.force_n.x;
}

static void test_the_hand_feels_a_quarter_newton_broadside_at_0_3_m_s(void **state)
{
    (void)state;
    assert_float_equal(steady_broadside_n(0.3f), -0.25f, 0.025f);
}

static void test_edge_on_it_feels_almost_nothing(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.hand.position_m = stand.poi.position_m = v3(-0.3f, -0.07f, 0.0f);
    stand_wait(&stand, 0.5f);
    stand_move(&stand, v3(0.3f, -0.07f, 0.0f), 0.3f);
    assert_true(stand.force.force_n.x < 0.0f);
    assert_true(stand.force.force_n.x > -0.010f);
}

/* How far a wrist that rolls at 4 rad/s, or turns the handle about the paper's own normal, is ahead
 * of its ring, s. */
static float turn_lag_s(float height_m, int about_normal)
{
    stand_init(&stand, 4, 1);
    stand.has_wrist = 1;
    stand.hand.position_m = stand.poi.position_m = v3(0.0f, height_m, 0.0f);
    stand_wait(&stand, 0.5f);
    float *hand = about_normal ? &stand.hand.angles.yaw_rad : &stand.hand.angles.roll_rad;
    const float *ring = about_normal ? &stand.poi.angles.yaw_rad : &stand.poi.angles.roll_rad;
    for (uint32_t tick = 0; tick < 36; tick++) {
        *hand += 4.0f * CORE_TICK_S;
        stand_tick(&stand);
    }
    return (*hand - *ring) / 4.0f;
}

static void test_water_slows_a_ring_that_turns_broadside_and_not_one_that_spins(void **state)
{
    (void)state;
    const float air_s = turn_lag_s(0.10f, 0), water_s = turn_lag_s(-0.075f, 0);
    assert_true(water_s > 1.1f * air_s);
    assert_true(water_s < 1.4f * air_s); /* A wrist turns it all the same. */
    assert_float_equal(turn_lag_s(-0.075f, 1), air_s, 1e-4f);
}

static void test_a_poi_that_hangs_in_air_weighs_what_it_weighs(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand_wait(&stand, 1.0f);
    assert_float_equal(stand.force.force_n.y, -POI_MASS_KG * GRAVITY_M_S2, 0.002f);
    stand_dip(&stand);
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.2f);
    stand_wait(&stand, 0.1f);
    assert_true(stand.force.force_n.y < -(POI_MASS_KG + 0.003f) * GRAVITY_M_S2); /* Wet paper. */
}

/* 13 cm out from the hand; what lies to the right of the handle also rolls it. */
static void test_the_hand_feels_the_burdens_moment_about_the_grip(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_wait(&stand, 1.0f);
    const float weight_n = POI_MASS_KG * GRAVITY_M_S2;
    assert_float_equal(stand.force.torque_n_m.x, -0.130f * weight_n, 0.001f);
    assert_float_equal(stand.force.torque_n_m.z, 0.0f, 1e-5f);
    stand.poi.carried_kg = 0.003f; /* What catch_tick would have gathered. */
    stand.poi.loads[0] = (struct sheet_load){ 0.03f, 0.0f, 0.02f, -0.003f * GRAVITY_M_S2 };
    stand.poi.load_count = 1;
    const struct poi_grip grip = { stand.hand, 1 };
    poi_tick(&stand.poi, &grip, &stand.tank, &stand.bowl);
    poi_haptics(&stand.poi, &stand.force);
    assert_float_equal(stand.force.torque_n_m.x, -0.130f * (weight_n + 0.0294f), 0.001f);
    assert_float_equal(stand.force.torque_n_m.z, -0.03f * 0.0294f, 1e-5f);
}

static void test_the_ring_yields_to_floor_walls_and_the_reach_of_an_arm(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.hand.position_m = v3(2.0f, -2.0f, -2.0f);
    stand_wait(&stand, 3.0f);
    assert_true(stand.poi.position_m.y > -0.15f);
    assert_true(stand.poi.position_m.y < -0.14f);
    stand_init(&stand, 4, 1);
    stand_move(&stand, v3(0.0f, -0.07f, 0.0f), 0.2f);
    stand.hand.position_m = v3(2.0f, -0.07f, -2.0f);
    stand_wait(&stand, 3.0f);
    assert_float_equal(stand.poi.position_m.x, 0.45f - POI_OUTER_RADIUS_M, 0.002f);
    assert_float_equal(stand.poi.position_m.z, -0.275f + POI_OUTER_RADIUS_M, 0.002f);
    stand.hand.position_m = v3(2.0f, 2.0f, -2.0f);
    stand_wait(&stand, 3.0f);
    assert_float_equal(stand.poi.position_m.y, 0.30f, 0.002f);
    assert_true(stand.poi.position_m.x > 0.45f);
}

static void
test_a_ring_outside_the_tank_comes_down_on_the_rim_and_not_through_the_wall(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_move(&stand, v3(0.0f, 0.20f, 0.0f), 0.5f);
    stand_move(&stand, v3(0.50f, 0.20f, 0.0f), 0.5f);
    stand_move(&stand, v3(0.50f, -0.10f, 0.0f), 0.5f);
    stand_wait(&stand, 1.0f);
    assert_true(stand.poi.position_m.x > 0.45f);
    assert_true(stand.poi.position_m.y > 0.05f); /* The rim stands 5 cm over the water. */
}

/* 20 N against the damping of a hand give 3.5 m/s, 29 mm a tick; the rest is what a turn of the
 * wrist pushes it off floor, rim and walls. */
static void tick_without_leap(void)
{
    const vec3 before_m = stand.poi.position_m;
    stand_tick(&stand);
    assert_true(v3_length(v3_sub(stand.poi.position_m, before_m)) < 0.040f);
}

static void test_a_ring_that_turns_on_the_rim_stays_on_the_rim(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 16; i++) {
        const int endwise = i % 2u == 1u;
        stand_init(&stand, 4, i);
        const vec3 over = endwise ? v3(0.0f, 0.20f, 0.425f) : v3(0.575f, 0.20f, 0.0f);
        stand_move(&stand, v3(0.0f, 0.20f, 0.0f), 0.5f);
        stand_move(&stand, over, 0.5f);
        stand_move(&stand, v3(over.x, 0.0315f, over.z), 0.5f);
        stand.hand.angles.roll_rad = i & 2u ? 0.6f : -1.2f;
        stand.hand.angles.pitch_rad = i & 4u ? 0.35f : -1.2f;
        stand.hand.angles.pitch_rad *= i & 8u ? 0.0f : 1.0f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            tick_without_leap();
            assert_true(f_abs(stand.poi.position_m.x) > 0.45f ||
                        f_abs(stand.poi.position_m.z) > 0.275f);
        }
    }
}

static void test_a_ring_that_turns_level_beside_a_wall_is_pushed_off_it_and_stays_in(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.hand.angles.roll_rad = stand.poi.angles.roll_rad = 0.5f * F_PI;
    stand_move(&stand, v3(0.0f, -0.05f, 0.0f), 0.3f);
    stand_move(&stand, v3(0.50f, -0.05f, 0.0f), 0.3f);
    stand.hand.angles.roll_rad = 0.0f;
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tick_without_leap();
    }
    assert_float_equal(stand.poi.position_m.x, 0.45f - POI_OUTER_RADIUS_M, 0.002f);
}

static float drawn(uint32_t step, uint32_t which, float low, float high)
{
    const struct rng_key key = { stand.tank.seed, step, which, RNG_BOT_CHOICE };
    return rng_range(key, low, high);
}

static void test_however_the_hand_wanders_the_ring_never_leaps(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 12; seed++) {
        stand_init(&stand, 4, seed);
        for (uint32_t step = 0; step < 400; step++) {
            stand.hand.position_m = v3(drawn(step, 0, -0.60f, 0.60f), drawn(step, 1, -0.20f, 0.15f),
                                       drawn(step, 2, -0.42f, 0.42f));
            stand.hand.angles =
                (struct angles){ drawn(step, 3, -3.0f, 3.0f), drawn(step, 4, -1.5f, 1.5f),
                                 drawn(step, 5, -1.5f, 1.5f) };
            for (uint32_t tick = 0; tick < 12; tick++) {
                tick_without_leap();
            }
        }
    }
}

static void test_a_still_pose_tears_nothing_wet_or_dry(void **state)
{
    (void)state;
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        stand_init(&stand, grade, grade);
        stand_wait(&stand, 5.0f);
        stand_dip(&stand);
        stand_wait(&stand, 10.0f);
        stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.15f);
        stand_wait(&stand, 20.0f);
        assert_float_equal(sheet_left(&stand.poi.sheet), 1.0f, 0.0f);
    }
}

static void test_what_dips_gets_wet_and_only_there(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand.hand.angles.roll_rad = stand.poi.angles.roll_rad = 0.5f * F_PI; /* Right edge down. */
    stand_move(&stand, v3(0.0f, 0.0f, 0.0f), 0.2f);
    stand_wait(&stand, 3.0f);
    const uint32_t row = SHEET_SIDE / 2u * SHEET_SIDE;
    assert_true(stand.poi.sheet.wetness[row + SHEET_SIDE - 4u] > 0.9f);
    assert_true(stand.poi.sheet.wetness[row + 3u] < 0.1f);
    assert_float_equal(stand.poi.immersed, 0.5f, 0.03f);
}

static int lift_survives(uint8_t grade, uint32_t seed, float speed_m_s)
{
    stand_init(&stand, grade, seed);
    stand_dip(&stand);
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), speed_m_s);
    return sheet_left(&stand.poi.sheet) > 0.9f;
}

static void
test_a_broadside_lift_at_1_m_s_tears_wet_grade_6_at_once_and_a_slow_one_does_not(void **state)
{
    (void)state;
    uint32_t fast = 0, slow = 0;
    for (uint32_t seed = 0; seed < 40; seed++) {
        fast += (uint32_t)lift_survives(6, seed, 1.0f);
        slow += (uint32_t)lift_survives(6, seed, 0.2f);
    }
    assert_in_range(fast, 0, 2);
    assert_int_equal(slow, 40);
}

/* Sweeps half a metre with the paper at `roll_rad` to the way. */
static float left_after_sweep(float roll_rad, float speed_m_s, uint32_t seed)
{
    stand_init(&stand, 6, seed);
    stand_move(&stand, v3(-0.30f, 0.06f, 0.0f), 0.5f);
    stand_dip(&stand);
    stand_move(&stand, v3(-0.30f, -0.09f, 0.0f), 0.2f);
    stand_turn(&stand, 0.0f, roll_rad, 0.5f);
    stand_move(&stand, v3(0.25f, -0.09f, 0.0f), speed_m_s);
    return sheet_left(&stand.poi.sheet);
}

static void
test_sweeping_fast_and_flat_under_water_tears_and_gliding_along_the_plane_does_not(void **state)
{
    (void)state;
    uint32_t torn = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        torn += left_after_sweep(70.0f * F_DEG, 0.8f, seed) < 0.95f;
        assert_float_equal(left_after_sweep(0.0f, 0.8f, seed), 1.0f, 0.0f);
        assert_float_equal(left_after_sweep(70.0f * F_DEG, 0.2f, seed), 1.0f, 0.0f);
    }
    assert_in_range(torn, 18, 20);
}

/* ---- Held up by fish ------------------------------------------------------------------------ */

/* A tick in which fish let the ring go nowhere. */
static void tick_held(void)
{
    const struct poi_grip grip = { stand.hand, 1 };
    poi_tick(&stand.poi, &grip, &stand.tank, &stand.bowl);
    struct obstacle ring = poi_obstacle(&stand.poi);
    ring.centre_m = v3_sub(ring.centre_m, ring.step_m);
    ring.step_m = ring.velocity_m_s = v3(0.0f, 0.0f, 0.0f);
    ring.reaction = REACTION_POSITION;
    poi_apply_reaction(&stand.poi, &ring);
}

/* The hand goes on for 0.8 s while the ring is held, and then for 0.5 s more. */
static void test_a_ring_that_comes_free_follows_the_hand_and_does_not_shoot_off(void **state)
{
    (void)state;
    const float hands_m_s[] = { 0.05f, 0.22f, 0.44f };
    for (uint32_t i = 0; i < 6; i++) {
        const float hand_m_s = hands_m_s[i / 2u];
        stand_init(&stand, 5, 1);
        stand.has_wrist = 1;
        if (i % 2u == 1u) { /* A torn poi is a ring: next to no water holds it back. */
            memset(stand.poi.sheet.state, CELL_HOLE, sizeof stand.poi.sheet.state);
            stand.poi.sheet.paper_cells = 0;
        }
        stand.hand.position_m = stand.poi.position_m = v3(-0.35f, -0.07f, 0.0f);
        stand.hand.angles.roll_rad = stand.poi.angles.roll_rad = 0.5f * F_PI;
        stand_wait(&stand, 0.5f);
        for (uint32_t tick = 0; tick < 156; tick++) {
            stand.hand.position_m.x += hand_m_s * CORE_TICK_S;
            if (tick < 96) {
                tick_held();
                assert_float_equal(stand.poi.position_m.x, -0.35f, 0.001f);
                continue;
            }
            const float behind_m = stand.hand.position_m.x - stand.poi.position_m.x;
            const float most_m_s = hand_m_s + f_min(4.0f * behind_m, 1.0f) + 0.01f;
            const vec3 before_m = stand.poi.position_m;
            stand_tick(&stand);
            const vec3 step_m = v3_sub(stand.poi.position_m, before_m);
            assert_true(v3_length(step_m) < most_m_s * CORE_TICK_S);
        }
        stand_wait(&stand, 1.0f);
        assert_float_equal(stand.poi.position_m.x, stand.hand.position_m.x, 0.002f);
    }
}

static void test_a_pull_at_a_ring_that_cannot_move_is_none_at_its_paper(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 10; seed++) {
        stand_init(&stand, 5, seed);
        stand_dip(&stand);
        for (uint32_t tick = 0; tick < 30; tick++) {
            stand.hand.position_m.y += 0.22f * CORE_TICK_S;
            tick_held();
        }
        assert_true(f_abs(stand.poi.pressure_pa) < 1.0f);
        assert_float_equal(sheet_left(&stand.poi.sheet), 1.0f, 0.0f);
        stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.22f); /* It comes free and goes after it. */
        stand_wait(&stand, 0.2f);
        assert_true(stand.poi.position_m.y > 0.01f);
        assert_true(sheet_left(&stand.poi.sheet) > 0.9f);
    }
}

/* Broadside, half a metre a second under water: free it pushes water, held it pushes none. */
static void test_a_ring_that_is_held_moves_no_water_however_the_hand_pulls(void **state)
{
    (void)state;
    stand_init(&stand, 5, 1);
    stand.has_wrist = 1;
    stand.hand.position_m = stand.poi.position_m = v3(-0.2f, -0.07f, 0.0f);
    stand.hand.angles.roll_rad = stand.poi.angles.roll_rad = 0.5f * F_PI;
    stand_wait(&stand, 0.5f);
    for (uint32_t tick = 0; tick < 48; tick++) {
        stand.hand.position_m.x += 0.3f * CORE_TICK_S;
        if (tick < 24) {
            stand_tick(&stand);
        } else {
            tick_held();
        }
        const struct poi_grip grip = { stand.hand, 1 };
        struct poi next = stand.poi;
        poi_tick(&next, &grip, &stand.tank, &stand.bowl);
        const struct obstacle ring = poi_obstacle(&next);
        const vec3 ahead_m = v3(next.position_m.x + 0.02f, -0.07f, 0.0f);
        const float flow_m_s = v3_length(water_flow_m_s(&ring, ahead_m));
        if (tick == 23) {
            assert_true(flow_m_s > 0.1f);
        } else if (tick > 24) {
            assert_true(v3_length(ring.velocity_m_s) > 0.1f); /* It wants to. */
            assert_float_equal(flow_m_s, 0.0f, 0.001f);
        }
    }
}

/* What moves freely knows no catching up: 0.5 m back and forth at up to 2 m/s, and a dead stop. */
static void test_a_quick_hand_keeps_its_lag(void **state)
{
    (void)state;
    const float heights_m[] = { 0.08f, -0.07f };
    for (uint32_t i = 0; i < 2; i++) {
        stand_init(&stand, 4, 1);
        stand.has_wrist = 1;
        stand.hand.position_m = stand.poi.position_m = v3(0.0f, heights_m[i], 0.0f);
        stand_wait(&stand, 0.5f);
        for (uint32_t tick = 1; tick < 3u * CORE_TICK_HZ / 2u; tick++) {
            stand.hand.position_m.x = 0.25f * f_sin(8.0f * (float)tick * CORE_TICK_S);
            stand_tick(&stand);
            const float behind_m = v3_length(v3_sub(stand.hand.position_m, stand.poi.position_m));
            assert_true(v3_length(stand.poi.velocity_m_s) <
                        0.999f * (stand.poi.pace_m_s + 4.0f * behind_m));
        }
        stand.hand.position_m = stand.poi.position_m = v3(-0.25f, heights_m[i], 0.0f);
        stand_wait(&stand, 0.5f);
        stand_move(&stand, v3(0.15f, heights_m[i], 0.0f), 2.0f);
        const float lag_m = stand.hand.position_m.x - stand.poi.position_m.x;
        assert_true(lag_m > 0.030f && lag_m < 0.058f);
        stand_wait(&stand, 0.1f);
        assert_float_equal(stand.poi.position_m.x, 0.15f, 0.002f);
    }
}

/* ---- The mouse ------------------------------------------------------------------------------ */

static float whole_pixel(float at_m)
{
    const float pixel_m = VIEW_M / SCREEN_PX;
    return pixel_m * f_floor(at_m / pixel_m + 0.5f);
}

/* A glide over 0.4 m; reports at 60 Hz, poses linearly between two reports at 120 Hz. */
static void glide(float speed_m_s, float course_rad, float roll_rad, int by_mouse)
{
    stand_init(&stand, 4, 3);
    stand.hand.angles.roll_rad = roll_rad;
    const vec3 way = v3(f_cos(course_rad), 0.0f, f_sin(course_rad));
    const vec3 start = v3(-0.2f * way.x, -0.075f, -0.2f * way.z);
    stand.hand.position_m = stand.poi.position_m = start;
    stand_wait(&stand, 2.0f);
    vec3 reports[2] = { start, start };
    const uint32_t ticks = (uint32_t)(0.4f / speed_m_s * (float)CORE_TICK_HZ);
    for (uint32_t tick = 0; tick < ticks; tick++) {
        const float at_m = speed_m_s * (float)(tick + 1u) * CORE_TICK_S;
        const vec3 smooth = v3_muladd(start, way, at_m);
        if (tick % 2u == 0) {
            const vec3 next = v3_muladd(smooth, way, speed_m_s * CORE_TICK_S);
            reports[0] = reports[1];
            reports[1] = v3(whole_pixel(next.x), next.y, whole_pixel(next.z));
        }
        stand.hand.position_m = smooth;
        if (by_mouse) {
            stand.hand.position_m =
                tick % 2u == 0 ? v3_lerp(reports[0], reports[1], 0.5f) : reports[1];
        }
        stand_tick(&stand);
        if (tick == ticks / 3u) { /* The start is the hand's, not the grid's. */
            stand.tension_max_n_m = stand.tension_sum_n_m = 0.0f;
        }
    }
}

/* Returns how much more than the smooth path the mouse's strains the paper at most. */
static float grain(float speed_m_s, float course_rad, float roll_rad)
{
    glide(speed_m_s, course_rad, roll_rad, 0);
    const float smooth_max = stand.tension_max_n_m, smooth_sum = stand.tension_sum_n_m;
    glide(speed_m_s, course_rad, roll_rad, 1);
    assert_float_equal(stand.tension_sum_n_m / smooth_sum, 1.0f, 0.01f);
    return stand.tension_max_n_m / smooth_max - 1.0f;
}

static const float rolls_rad[] = { 90.0f * F_DEG, 45.0f * F_DEG, 20.0f * F_DEG };

static const float courses_rad[] = { 0.0f, 0.20f, 0.35f, 0.80f, 1.20f, -0.80f };

static void assert_grain(float speed_m_s, float most)
{
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < sizeof courses_rad / sizeof courses_rad[0]; k++) {
            assert_float_equal(grain(speed_m_s, courses_rad[k], rolls_rad[i]), 0.0f, most);
        }
    }
}

static void test_a_whole_pixel_mouse_glide_loads_the_paper_like_the_smooth_path(void **state)
{
    (void)state;
    assert_grain(0.20f, 0.10f);
    assert_grain(0.30f, 0.05f);
}

/* The slower the hand, the coarser a pixel: three pixels a frame are now three, now four. What is
 * left then is drag, the square of the ring's true speed, and less of it would be a later ring. */
static void test_a_slower_mouse_does_so_on_most_courses_and_stays_within_an_eighth(void **state)
{
    (void)state;
    assert_grain(0.15f, 0.13f);
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < 4; k++) {
            assert_float_equal(grain(0.15f, courses_rad[k], rolls_rad[i]), 0.0f, 0.10f);
        }
    }
}

/* ---- The wrist ------------------------------------------------------------------------------ */

static void test_over_the_bowl_the_poi_turns_toward_it_by_55_degrees_and_back(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand.laden = 1;
    stand_move(&stand, v3(0.18f, 0.05f, 0.15f), 0.5f);
    stand_wait(&stand, 0.2f);
    assert_true(vec_basis_from_angles(stand.poi.angles).up.y > 0.999f);
    stand_move(&stand, v3(0.27f, 0.05f, 0.15f), 0.3f);
    stand_wait(&stand, 1.0f);
    const struct basis over = vec_basis_from_angles(stand.poi.angles);
    assert_float_equal(f_acos(over.up.y), 55.0f * F_DEG, 0.02f);
    assert_true(over.up.x > 0.8f); /* It lowers its right edge: the bowl is to the right. */
    const float low_m = stand.poi.position_m.y - POI_OUTER_RADIUS_M * f_sin(55.0f * F_DEG);
    assert_true(low_m > stand.bowl.position_m.y);
    stand_move(&stand, v3(0.10f, 0.05f, 0.0f), 0.5f);
    stand_wait(&stand, 1.0f);
    assert_true(vec_basis_from_angles(stand.poi.angles).up.y > 0.999f);
}

static float tilt_rad(void)
{
    return f_acos(vec_basis_from_angles(stand.poi.angles).up.y);
}

static void test_with_nothing_on_it_the_poi_does_not_turn_over_the_bowl(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand_move(&stand, v3(0.27f, 0.05f, 0.15f), 0.3f);
    stand_wait(&stand, 1.0f);
    assert_true(tilt_rad() < 2.0f * F_DEG);
    stand.laden = 1;
    stand_wait(&stand, 1.0f);
    assert_float_equal(tilt_rad(), 55.0f * F_DEG, 0.02f);
    stand.laden = 0;
    stand.poi.laden_ticks = 0; /* It is empty: its paper can be looked at again. */
    stand_wait(&stand, 0.6f);
    assert_true(tilt_rad() < 2.0f * F_DEG);
}

static void test_the_wrist_never_lowers_the_handle_into_the_bowl(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 16; i++) {
        const float angle = F_TAU * (float)i / 16.0f;
        stand_init(&stand, 6, 1);
        stand.laden = 1;
        bowl_init(&stand.bowl, v3(0.15f * f_cos(angle), 0.02f, 0.15f * f_sin(angle)));
        stand_move(&stand, v3(stand.bowl.position_m.x, 0.035f, stand.bowl.position_m.z), 0.3f);
        float steepest = 1.0f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            stand_tick(&stand);
            const struct basis axes = vec_basis_from_angles(stand.poi.angles);
            assert_true(axes.back.y > -0.01f); /* The handle is level or rises to the hand. */
            steepest = f_min(steepest, axes.up.y);
        }
        assert_float_equal(steepest, f_cos(55.0f * F_DEG), 0.02f); /* It tips all the same. */
    }
}

static void test_a_hand_with_a_wrist_turns_by_itself(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand.has_wrist = 1;
    stand.laden = 1;
    stand_move(&stand, v3(0.30f, 0.05f, 0.15f), 0.5f);
    stand_wait(&stand, 1.0f);
    assert_true(vec_basis_from_angles(stand.poi.angles).up.y > 0.999f);
}

/* Whether the ring's centre line is off the bowl's hull all round. */
static int clear_of_bowl(void)
{
    const struct basis axes = vec_basis_from_angles(stand.poi.angles);
    for (uint32_t i = 0; i < 32; i++) {
        const float a = F_TAU * (float)i / 32.0f;
        const vec3 rim = v3_scale(v3(f_cos(a), 0.0f, f_sin(a)), 0.043f);
        const vec3 at = v3_sub(v3_add(stand.poi.position_m, vec_basis_to_world(&axes, rim)),
                               stand.bowl.position_m);
        const float wide = (at.x * at.x + at.z * at.z) / (BOWL_RADIUS_M * BOWL_RADIUS_M);
        if (at.y < 0.0f && wide + at.y * at.y / (BOWL_DEPTH_M * BOWL_DEPTH_M) < 0.9f) {
            return 0;
        }
    }
    return 1;
}

static void test_the_ring_does_not_pass_through_the_bowl(void **state)
{
    (void)state;
    const vec3 bowl = v3(0.30f, 0.0f, 0.15f);
    stand_init(&stand, 4, 1); /* Down onto it, then aside under water, then up under it. */
    stand_move(&stand, v3(bowl.x, 0.10f, bowl.z), 0.5f);
    stand.hand.position_m.y = -0.10f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        stand_tick(&stand);
        assert_true(clear_of_bowl());
    }
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand.hand.position_m = v3(bowl.x, -0.02f, bowl.z);
    for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
        stand_tick(&stand);
        assert_true(clear_of_bowl());
    }
    stand_init(&stand, 4, 1);
    stand_move(&stand, v3(0.0f, -0.12f, 0.0f), 0.2f);
    stand_move(&stand, v3(bowl.x, -0.12f, bowl.z), 0.3f);
    stand.hand.position_m = v3(bowl.x, 0.08f, bowl.z);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        stand_tick(&stand);
        assert_true(clear_of_bowl());
    }
}

/* ---- Bookkeeping ---------------------------------------------------------------------------- */

static void test_each_dip_counts_once(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    for (uint32_t i = 0; i < 3; i++) {
        stand_move(&stand, v3(0.0f, -0.06f, 0.0f), 0.2f);
        stand_wait(&stand, 0.3f);
        stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.2f);
        stand_wait(&stand, 0.3f);
    }
    assert_int_equal(stand.poi.dips, 3);
}

static void test_a_level_poi_keeps_what_its_belly_holds_and_a_tilted_one_spills_it(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.3f);
    const float carried = stand.poi.water_kg; /* The lift's drag made the belly deep. */
    stand_wait(&stand, 1.0f);
    const float level = stand.poi.water_kg, pool = stand.poi.pool_kg;
    stand_turn(&stand, 0.8f, 0.0f, 0.2f);
    stand_wait(&stand, 0.5f);
    assert_true(carried > 0.005f);
    assert_true(level > 0.004f);
    assert_true(pool > 0.0015f);
    assert_true(stand.poi.pool_kg < 0.12f * pool);
    assert_true(stand.poi.water_kg < 0.0025f);
}

static uint64_t played(uint32_t seed)
{
    stand_init(&stand, 6, seed);
    stand_dip(&stand);
    stand_move(&stand, v3(0.2f, 0.06f, 0.1f), 0.6f);
    return poi_hash(HASH_START, &stand.poi);
}

static void test_the_same_hand_gives_the_same_poi_bit_for_bit(void **state)
{
    (void)state;
    const uint64_t first = played(5);
    assert_true(first == played(5));
    assert_true(first != played(6));
}

static void test_a_target_that_is_no_number_is_a_bug(void **state)
{
    (void)state;
    stand_init(&stand, 6, 1);
    stand.hand.position_m.x = __builtin_nanf("");
    expect_assert_failure(stand_tick(&stand));
    stand_init(&stand, 6, 1);
    stand.hand.angles.roll_rad = __builtin_inff();
    expect_assert_failure(stand_tick(&stand));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_in_air_the_poi_lags_a_moving_hand_by_a_frame_and_a_half),
        cmocka_unit_test(test_a_leap_of_the_hand_is_followed_without_overshoot),
        cmocka_unit_test(test_a_hand_that_shakes_wildly_cannot_blow_the_poi_up),
        cmocka_unit_test(test_the_hand_feels_a_quarter_newton_broadside_at_0_3_m_s),
        cmocka_unit_test(test_edge_on_it_feels_almost_nothing),
        cmocka_unit_test(test_water_slows_a_ring_that_turns_broadside_and_not_one_that_spins),
        cmocka_unit_test(test_a_poi_that_hangs_in_air_weighs_what_it_weighs),
        cmocka_unit_test(test_the_ring_yields_to_floor_walls_and_the_reach_of_an_arm),
        cmocka_unit_test(
            test_a_ring_outside_the_tank_comes_down_on_the_rim_and_not_through_the_wall),
        cmocka_unit_test(test_a_ring_that_turns_on_the_rim_stays_on_the_rim),
        cmocka_unit_test(test_a_ring_that_turns_level_beside_a_wall_is_pushed_off_it_and_stays_in),
        cmocka_unit_test(test_however_the_hand_wanders_the_ring_never_leaps),
        cmocka_unit_test(test_the_hand_feels_the_burdens_moment_about_the_grip),
        cmocka_unit_test(test_a_still_pose_tears_nothing_wet_or_dry),
        cmocka_unit_test(test_what_dips_gets_wet_and_only_there),
        cmocka_unit_test(
            test_a_broadside_lift_at_1_m_s_tears_wet_grade_6_at_once_and_a_slow_one_does_not),
        cmocka_unit_test(
            test_sweeping_fast_and_flat_under_water_tears_and_gliding_along_the_plane_does_not),
        cmocka_unit_test(test_a_ring_that_comes_free_follows_the_hand_and_does_not_shoot_off),
        cmocka_unit_test(test_a_pull_at_a_ring_that_cannot_move_is_none_at_its_paper),
        cmocka_unit_test(test_a_ring_that_is_held_moves_no_water_however_the_hand_pulls),
        cmocka_unit_test(test_a_quick_hand_keeps_its_lag),
        cmocka_unit_test(test_a_whole_pixel_mouse_glide_loads_the_paper_like_the_smooth_path),
        cmocka_unit_test(test_a_slower_mouse_does_so_on_most_courses_and_stays_within_an_eighth),
        cmocka_unit_test(test_over_the_bowl_the_poi_turns_toward_it_by_55_degrees_and_back),
        cmocka_unit_test(test_with_nothing_on_it_the_poi_does_not_turn_over_the_bowl),
        cmocka_unit_test(test_the_wrist_never_lowers_the_handle_into_the_bowl),
        cmocka_unit_test(test_a_hand_with_a_wrist_turns_by_itself),
        cmocka_unit_test(test_the_ring_does_not_pass_through_the_bowl),
        cmocka_unit_test(test_each_dip_counts_once),
        cmocka_unit_test(test_a_level_poi_keeps_what_its_belly_holds_and_a_tilted_one_spills_it),
        cmocka_unit_test(test_the_same_hand_gives_the_same_poi_bit_for_bit),
        cmocka_unit_test(test_a_target_that_is_no_number_is_a_bug),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
