/* test_carried_falls.c -- checks how fish leave a poi. They slide off tilted paper, flop over the
 * ring, or swim off. */
#include "tests/unit/support/poi_fixture.h"

static struct poi_fixture fixture;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return fixture_lift(&fixture, grade, seed, off_x_m, 0.0f);
}

/* Tips a fish off the poi at (x_m, y_m) to the right, and counts the sounds of each kind. Asserts
 * that the sound of a fall into the water (SOUND_PLOP) or into the bowl (SOUND_CATCH) comes from
 * the side on which the fish is, and returns the gain of this sound. */
static float tipped_at(float x_m, float y_m, uint32_t heard[SOUND_COUNT])
{
    const uint32_t fish = lifted(4, 3, 0.0f);
    float gain = 0.0f;
    fixture_move(&fixture, v3(x_m, y_m, 0.15f), 0.2f);
    memset(heard, 0, SOUND_COUNT * sizeof *heard);
    for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
        fixture.hand.angles.roll_rad = f_min((float)i / 36.0f, 1.0f) * 55.0f * F_DEG;
        fixture_tick(&fixture);
        for (uint32_t k = 0; k < fixture.output.sound_count; k++) {
            const struct sound_event *const event = &fixture.output.sounds[k];
            heard[event->sound]++;
            if (event->sound == SOUND_PLOP || event->sound == SOUND_CATCH) {
                assert_true(event->pan * fixture.tank.fish[fish].position_m.x > 0.0f);
                gain = event->gain;
            }
        }
    }
    return gain;
}

static void test_a_fall_into_the_water_plops_once_and_louder_from_higher(void **state)
{
    (void)state;
    uint32_t low[SOUND_COUNT], high[SOUND_COUNT];
    const float low_gain = tipped_at(0.08f, 0.05f, low);
    const float high_gain = tipped_at(0.08f, 0.14f, high);
    assert_int_equal(low[SOUND_PLOP], 1);
    assert_int_equal(high[SOUND_PLOP], 1);
    assert_int_equal(low[SOUND_CATCH] + high[SOUND_CATCH], 0);
    assert_true(high_gain > low_gain + 0.1f);
}

static void test_a_fall_into_the_bowl_is_a_catch_and_no_plop(void **state)
{
    (void)state;
    uint32_t heard[SOUND_COUNT];
    tipped_at(0.27f, 0.10f, heard);
    assert_int_equal(fixture.landed + fixture.poured, 1);
    assert_int_equal(heard[SOUND_CATCH], 1);
    assert_int_equal(heard[SOUND_PLOP], 0);
}

static void test_a_fish_tipped_over_the_tank_slides_off_and_swims(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 3, 0.0f);
    fixture_turn(&fixture, 0.0f, 55.0f * F_DEG, 0.3f);
    fixture_wait(&fixture, 1.0f);
    assert_int_equal(fixture.poi.carried_count, 0);
    assert_int_equal(fixture.landed, 0);
    assert_true(fixture.tank.fish[fish].position_m.y < 0.0f);
    /* The right side of the paper is lower, so the fish must slide off to the right (x > 0). */
    assert_true(fixture.tank.fish[fish].position_m.x > 0.0f);
}

static void test_a_slight_tilt_keeps_the_fish_behind_the_ring(void **state)
{
    (void)state;
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        lifted(4, seed, 0.0f);
        fixture_turn(&fixture, 0.0f, 24.0f * F_DEG, 0.5f);
        fixture_wait(&fixture, 1.0f);
        kept += fixture.poi.carried_count;
    }
    assert_in_range(kept, 17, 20);
}

static void test_a_fish_near_the_ring_flops_out_more_often_than_one_in_the_middle(void **state)
{
    (void)state;
    uint32_t rim = 0, middle = 0;
    for (uint32_t seed = 0; seed < 40; seed++) {
        fixture_lift(&fixture, 4, seed, 0.0f, -0.5f * F_PI);
        fixture_wait(&fixture, 2.0f);
        middle += fixture.poi.carried_count;
        /* The fish lies near the ring, and its head points outward. */
        fixture_lift(&fixture, 4, seed, 0.034f, -0.5f * F_PI);
        fixture_wait(&fixture, 2.0f);
        rim += fixture.poi.carried_count;
    }
    assert_true(middle >= 38);
    assert_in_range(rim, 20, middle - 1u);
}

/* Tilts a poi by `tilt_rad` over the bowl for one second, 20 times with one fish each. Returns how
 * many of the 20 fish stay on the paper. */
static uint32_t kept_at(float tilt_rad)
{
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 20; seed++) {
        fixture_init(&fixture, 4, seed);
        fixture_dip(&fixture);
        /* The fish rests in the water before the lift, so it is still calm when it is lifted. */
        fixture_add_fish(&fixture, v3(0.0f, -0.045f, 0.005f), 0.045f);
        fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.18f);
        fixture.has_wrist = 1;
        fixture_move(&fixture, v3(0.26f, 0.08f, 0.15f), 0.3f);
        fixture_turn(&fixture, 0.0f, tilt_rad, 0.3f);
        fixture_wait(&fixture, 1.0f);
        kept += fixture.poi.carried_count;
    }
    return kept;
}

static void test_a_poi_with_controller_orientation_tips_fish_only_at_a_steep_angle(void **state)
{
    (void)state;
    const uint32_t level = kept_at(0.0f), slight = kept_at(30.0f * F_DEG);
    const uint32_t steep = kept_at(48.0f * F_DEG);
    print_message("over the bowl for a second: level %u of 20 stay, at 30 degrees %u, at 48 %u\n",
                  level, slight, steep);
    assert_int_equal(level, 20);
    assert_true(slight >= 17);
    assert_true(steep <= 1);
    /* In the last of the 20 repetitions, the fish fell into the bowl. */
    assert_true(fixture.landed == 1);
}

/* Lifts a poi with one fish out of the water at `lift_m_s`, 24 times. Returns how many of the 24
 * fish stay on the paper. */
static uint32_t lifted_of_24(int is_wild, float lift_m_s)
{
    uint32_t kept = 0;
    for (uint32_t seed = 0; seed < 24; seed++) {
        fixture_init(&fixture, 5, seed);
        fixture_dip(&fixture);
        const uint32_t index = fixture_add_fish(&fixture, v3(0.0f, -0.045f, 0.0f), 0.045f);
        struct fish *fish = &fixture.tank.fish[index];
        fish->angles.yaw_rad = (float)seed;
        fish->alarm = is_wild ? 1.0f : 0.0f;
        fish->stamina = is_wild ? 1.0f : 0.5f;
        fixture_move(&fixture, v3(0.0f, -0.03f, 0.0f), 0.1f);
        fixture_move(&fixture, v3(0.0f, 0.05f, 0.0f), lift_m_s);
        fixture_wait(&fixture, 0.2f);
        kept += fixture.poi.carried_count;
    }
    return kept;
}

static void test_a_slow_lift_loses_wild_fish_over_the_edge_and_keeps_calm_ones(void **state)
{
    (void)state;
    const uint32_t wild = lifted_of_24(1, 0.025f), calm = lifted_of_24(0, 0.025f);
    const uint32_t brisk = lifted_of_24(1, 0.12f);
    print_message("at 25 mm/s %u of 24 wild and %u calm ones come up, at 120 mm/s %u wild ones\n",
                  wild, calm, brisk);
    assert_true(wild <= 4);
    assert_true(calm >= 20);
    assert_true(brisk >= 22);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_tipped_over_the_tank_slides_off_and_swims),
        cmocka_unit_test(test_a_fall_into_the_water_plops_once_and_louder_from_higher),
        cmocka_unit_test(test_a_fall_into_the_bowl_is_a_catch_and_no_plop),
        cmocka_unit_test(test_a_slight_tilt_keeps_the_fish_behind_the_ring),
        cmocka_unit_test(test_a_fish_near_the_ring_flops_out_more_often_than_one_in_the_middle),
        cmocka_unit_test(test_a_poi_with_controller_orientation_tips_fish_only_at_a_steep_angle),
        cmocka_unit_test(test_a_slow_lift_loses_wild_fish_over_the_edge_and_keeps_calm_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
