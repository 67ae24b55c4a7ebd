/* test_poi_touch.c -- tests how fingers on a touch panel control the ring. The first finger moves
 * the ring, and two or three fingers have other functions. Also tests faulty touch events. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/game/control/input_pose.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "tests/unit/support/pointer.h"

/* ---- Fingers -------------------------------------------------------------------------------- */

static struct touch_fingers fingers;

static int finger(enum touch_kind kind, int64_t id, float x, float y)
{
    const struct touch_event event = { .kind = (uint8_t)kind, .id = id, .x = x, .y = y };
    return touch_fingers_take(&fingers, &event);
}

static int clean_glass(void **state)
{
    (void)state;
    fingers = (struct touch_fingers){ 0 };
    return 0;
}

static void test_the_first_finger_moves_and_a_second_dips(void **state)
{
    (void)state;
    assert_true(finger(TOUCH_DOWN, 7, 0.25f, 0.5f));
    assert_true(fingers.x == 0.25f && fingers.y == 0.5f);
    assert_false(fingers.dips);
    finger(TOUCH_DOWN, 8, 0.9f, 0.9f);
    assert_true(fingers.dips);
    assert_true(fingers.x == 0.25f && fingers.y == 0.5f);
    /* Only the first finger moves the ring. */
    assert_false(finger(TOUCH_MOVE, 8, 0.8f, 0.8f));
    assert_true(finger(TOUCH_MOVE, 7, 0.3f, 0.5f));
    assert_true(fingers.x == 0.3f);
    finger(TOUCH_UP, 8, 0.8f, 0.8f);
    assert_false(fingers.dips);
}

/* After the first finger is lifted, the ring must not jump to the second finger, which holds the
 * dip. */
static void test_the_ring_stays_when_the_first_finger_lifts(void **state)
{
    (void)state;
    finger(TOUCH_DOWN, 1, 0.2f, 0.2f);
    finger(TOUCH_DOWN, 2, 0.9f, 0.9f);
    finger(TOUCH_UP, 1, 0.2f, 0.2f);
    finger(TOUCH_MOVE, 2, 0.7f, 0.7f);
    finger(TOUCH_DOWN, 3, 0.6f, 0.6f);
    assert_true(fingers.x == 0.2f && fingers.y == 0.2f);
    assert_true(fingers.dips);
    finger(TOUCH_UP, 2, 0.7f, 0.7f);
    finger(TOUCH_UP, 3, 0.6f, 0.6f);
    assert_false(fingers.dips);
    finger(TOUCH_DOWN, 4, 0.5f, 0.6f);
    assert_true(fingers.x == 0.5f && fingers.y == 0.6f);
}

static void test_three_fingers_press_start_once(void **state)
{
    (void)state;
    finger(TOUCH_DOWN, 1, 0.2f, 0.2f);
    finger(TOUCH_DOWN, 2, 0.3f, 0.2f);
    assert_false(touch_fingers_start(&fingers));
    finger(TOUCH_DOWN, 3, 0.4f, 0.2f);
    finger(TOUCH_DOWN, 4, 0.5f, 0.2f);
    assert_true(touch_fingers_start(&fingers));
    assert_false(touch_fingers_start(&fingers));
    finger(TOUCH_UP, 4, 0.5f, 0.2f);
    finger(TOUCH_UP, 3, 0.4f, 0.2f);
    finger(TOUCH_DOWN, 5, 0.4f, 0.2f);
    assert_true(touch_fingers_start(&fingers));
}

/* A touch panel may omit or repeat the end of a touch, or report a finger that never touched. */
static void test_inconsistent_events_move_nothing(void **state)
{
    (void)state;
    assert_false(finger(TOUCH_UP, 9, 0.1f, 0.1f));
    assert_false(finger(TOUCH_MOVE, 9, 0.1f, 0.1f));
    assert_false(finger(TOUCH_DOWN, 9, 0.0f / 0.0f, 0.1f));
    assert_int_equal(fingers.count, 0);
    finger(TOUCH_DOWN, 1, -5.0f, 1e30f);
    assert_true(fingers.x == 0.0f && fingers.y == 1.0f);
    finger(TOUCH_DOWN, 1, 0.5f, 0.5f);
    assert_int_equal(fingers.count, 1);
    for (int64_t id = 2; id < 30; id++) {
        finger(TOUCH_DOWN, id, 0.5f, 0.5f);
    }
    assert_int_equal(fingers.count, TOUCH_FINGER_MAX);
    for (int64_t id = 1; id < 30; id++) {
        finger(TOUCH_UP, id, 0.5f, 0.5f);
    }
    assert_int_equal(fingers.count, 0);
    assert_false(fingers.dips);
}

static void test_random_events_give_a_position_on_the_panel(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 100000; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ 6, i, 0, RNG_TEST });
        const uint32_t any = rng_u32((struct rng_key){ 6, i, 1, RNG_TEST });
        float x;
        memcpy(&x, &any, sizeof x);
        finger((enum touch_kind)(bits % 3u), (int64_t)((bits >> 8) % 14u), x,
               (float)(bits >> 16) / 65536.0f);
        assert_true(fingers.count <= TOUCH_FINGER_MAX);
        assert_true(fingers.x >= 0.0f && fingers.x <= 1.0f);
        assert_true(fingers.y >= 0.0f && fingers.y <= 1.0f);
        assert_int_equal(fingers.dips, fingers.count >= TOUCH_DIP_FINGERS);
    }
}

/* ---- The simulated panel -------------------------------------------------------------------- */

#define SCRIPT 1000u
static struct touch_event script[SCRIPT];
static struct clock_sim twin_clock;
static struct pointer_sim sim;
static struct hal_poi twin;

/* Prepares a script of touch events in which one finger moves around. Every 0.48 s a second finger
 * is put down or lifted. This interval is long enough for a complete dip or lift. */
static int begin_sim(void **state)
{
    (void)state;
    twin_clock = (struct clock_sim){ .now_ns = 1000 * MS };
    pointer_sim_init_touch(&sim, sim_clock_device(&twin_clock), festival_view(), WIDTH, HEIGHT);
    for (uint32_t i = 0; i < SCRIPT; i++) {
        const int second = i > 0 && i % 60 == 0;
        script[i] = (struct touch_event){
            .time_ns = (1000 + 8 * (uint64_t)i) * MS,
            .kind = (uint8_t)(i == 0              ? TOUCH_DOWN
                              : second && i % 120 ? TOUCH_DOWN
                              : second            ? TOUCH_UP
                                                  : TOUCH_MOVE),
            .id = second ? 2 : 1,
            .x = 0.5f + 0.3f * f_sin((float)i * 0.02f),
            .y = 0.5f + 0.2f * f_cos((float)i * 0.03f),
        };
    }
    sim.events = script;
    sim.feed.count = SCRIPT;
    twin = pointer_sim_devices(&sim).poi;
    return twin.ops->open(twin.self);
}

/* Plays the rest of the script. Checks that every sample is finite and that the times of the
 * samples never decrease. Returns the last poll result. */
static int play_out(void)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct poi_sample last = { 0 };
    int result = 0;
    for (uint32_t i = 0; i < 560 && result >= 0; i++) {
        twin_clock.now_ns += 16 * MS;
        result = twin.ops->poll(twin.self, samples, HAL_POI_SAMPLES_MAX);
        for (int k = 0; k < result; k++) {
            assert_true(input_pose_is_finite(&samples[k].target));
            assert_true(samples[k].time_ns >= last.time_ns);
            last = samples[k];
        }
    }
    return result;
}

static void test_a_script_of_touches_moves_and_dips_the_ring(void **state)
{
    (void)state;
    uint32_t dips = 0;
    float before_m = DIP_HOVER_M;
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    for (uint32_t i = 0; i < 500; i++) {
        twin_clock.now_ns += 16 * MS;
        const int count = twin.ops->poll(twin.self, samples, HAL_POI_SAMPLES_MAX);
        const float height_m = samples[count - 1].target.position_m.y;
        dips += before_m >= 0.0f && height_m < 0.0f;
        before_m = height_m;
    }
    /* The second finger is put down 8 times and lifted 8 times, which gives 8 dips. */
    assert_int_equal(dips, 8);
}

/* Duplicate, jumping, invalid and delayed events must still give finite samples in the order of
 * time. After every finger is lifted, no finger may count as touching. */
static void test_a_faulty_panel_gives_finite_samples_in_order(void **state)
{
    (void)state;
    sim.feed.double_every = 3;
    sim.mute_every = 4;
    sim.feed.jump_at = 77;
    sim.feed.random_from = 200;
    sim.feed.random_to = 800;
    sim.feed.silent_from_ns = 3000 * MS;
    sim.feed.silent_to_ns = 4000 * MS;
    play_out();
    assert_int_equal(sim.feed.next, SCRIPT);
    for (int64_t id = 0; id < 16; id++) {
        const struct touch_event up = { .kind = TOUCH_UP, .id = id };
        touch_fingers_take(&sim.fingers, &up);
        const struct touch_event other = { .kind = TOUCH_UP, .id = -id };
        touch_fingers_take(&sim.fingers, &other);
    }
    assert_int_equal(sim.fingers.count, 0);
    assert_false(sim.fingers.dips);
}

static void test_the_panel_can_be_unplugged_at_any_event(void **state)
{
    (void)state;
    struct poi_sample sample;
    for (uint32_t at = 0; at < SCRIPT; at++) {
        begin_sim(state);
        sim.feed.unplug_at = at;
        sim.feed.replug_ns = UINT64_MAX;
        assert_int_equal(play_out(), HAL_ERR_GONE);
        assert_int_equal(sim.feed.next, at);
        assert_int_equal(twin.ops->open(twin.self), HAL_ERR_GONE);
        sim.feed.replug_ns = twin_clock.now_ns;
        assert_int_equal(twin.ops->open(twin.self), HAL_OK);
        assert_int_equal(twin.ops->poll(twin.self, &sample, 1), 1);
        assert_false(sim.fingers.dips);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_first_finger_moves_and_a_second_dips, clean_glass),
        cmocka_unit_test_setup(test_the_ring_stays_when_the_first_finger_lifts, clean_glass),
        cmocka_unit_test_setup(test_three_fingers_press_start_once, clean_glass),
        cmocka_unit_test_setup(test_inconsistent_events_move_nothing, clean_glass),
        cmocka_unit_test_setup(test_random_events_give_a_position_on_the_panel, clean_glass),
        cmocka_unit_test_setup(test_a_script_of_touches_moves_and_dips_the_ring, begin_sim),
        cmocka_unit_test_setup(test_a_faulty_panel_gives_finite_samples_in_order, begin_sim),
        cmocka_unit_test_setup(test_the_panel_can_be_unplugged_at_any_event, begin_sim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
