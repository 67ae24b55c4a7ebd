/* test_landing.c -- how fish come into a bowl, whose they are, and what an umpire saw of it. */
#include "core/poi/catch/capture.h"
#include "tests/unit/support/poi_stand.h"

static struct stand stand;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return stand_lift(&stand, grade, seed, off_x_m, 0.0f);
}

static void test_tipped_over_the_bowl_a_fish_lands_and_counts_once(void **state)
{
    (void)state;
    uint32_t landed = 0;
    for (uint32_t seed = 0; seed < 60; seed++) {
        const uint32_t fish = lifted(4, seed, 0.0f);
        stand_move(&stand, v3(0.20f, 0.05f, 0.10f), 0.3f);
        assert_int_equal(stand.landed, 0);
        stand_move(&stand, v3(0.30f, 0.035f, 0.15f),
                   0.3f); /* A pointer's height: low over the mouth. */
        stand_wait(&stand, 1.5f);
        assert_int_equal(stand.poured + stand.walled, 0);
        assert_int_equal(stand.bowl.fish_count, stand.landed);
        assert_int_equal(stand.tank.fish[fish].gait == GAIT_BOWL, stand.landed == 1);
        landed += stand.landed;
        stand_wait(&stand, 0.5f);
        assert_int_equal(stand.bowl.fish_count, stand.landed);
        assert_int_equal(stand.poi.carried_count, 0);
    }
    assert_in_range(landed, 57, 60); /* One that thrashes leaves when it likes. */
}

static void test_from_whichever_side_it_comes_the_fish_lands_in_the_bowl(void **state)
{
    (void)state;
    uint32_t landed = 0;
    for (uint32_t i = 0; i < 16; i++) {
        const float angle = F_TAU * (float)i / 16.0f;
        lifted(4, i, 0.0f);
        bowl_init(&stand.bowl, v3(0.15f * f_cos(angle), 0.02f, 0.15f * f_sin(angle)));
        stand_wait(&stand, 0.5f);
        stand_move(&stand, v3(stand.bowl.position_m.x, 0.05f, stand.bowl.position_m.z), 0.25f);
        stand_wait(&stand, 1.5f);
        landed += stand.landed;
    }
    assert_in_range(landed, 15, 16);
}

/* ---- Landed, poured, walled ----------------------------------------------------------------- */

static struct catch_result counted(uint8_t clear_ticks, uint8_t walled)
{
    const struct carried_fish carried = { .clear_ticks = clear_ticks, .walled = walled };
    struct catch_result results[POI_MAX] = { 0 };
    catch_count(&carried, 0, 0, results);
    return results[0];
}

static void test_each_fish_is_one_of_landed_poured_and_walled(void **state)
{
    (void)state;
    for (uint8_t clear = 0; clear <= CARRIED_CLEAR_TICKS; clear++) {
        for (uint8_t walled = 0; walled <= 1; walled++) {
            const struct catch_result one = counted(clear, walled);
            assert_int_equal(one.landed + one.poured + one.walled, 1);
            assert_int_equal(one.poured, clear < CARRIED_CLEAR_TICKS);
            assert_int_equal(one.walled, clear == CARRIED_CLEAR_TICKS && walled);
        }
    }
}

static void test_the_ring_must_be_wholly_over_the_water_without_a_break(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    assert_int_equal(stand.poi.carried_fish[0].clear_ticks, CARRIED_CLEAR_TICKS);
    stand.has_wrist = 1;
    stand_turn(&stand, 0.0f, 25.0f * F_DEG, 0.3f); /* Its lower edge 20 mm under its middle: */
    stand_move(&stand, v3(0.0f, 0.028f, 0.0f), 0.2f);
    stand_wait(&stand, 0.2f);
    assert_int_equal(stand.poi.carried_fish[0].clear_ticks, CARRIED_CLEAR_TICKS);
    stand_move(&stand, v3(0.0f, 0.016f, 0.0f), 0.2f); /* now in the water, ... */
    stand_wait(&stand, 0.2f);
    assert_int_equal(stand.poi.carried_count, 1);
    assert_int_equal(stand.poi.carried_fish[0].clear_ticks, 0);
    stand.hand.position_m.y = 0.030f; /* ... and out again, for as long as takes to see. */
    uint32_t ticks = 0;
    while (stand.poi.carried_fish[0].clear_ticks < CARRIED_CLEAR_TICKS && ticks++ < CORE_TICK_HZ) {
        stand_tick(&stand);
    }
    assert_in_range(ticks, CARRIED_CLEAR_TICKS, CORE_TICK_HZ / 2u);
}

/* A ring beside the bowl, its far edge over the mouth, its near one in the water. */
static void test_a_fish_that_comes_in_from_a_ring_in_the_water_is_poured(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand.poi.position_m = v3(0.30f - BOWL_RADIUS_M - 0.030f, 0.026f, 0.15f);
    stand.poi.angles.roll_rad = -40.0f * F_DEG;
    stand.hand = (struct poi_target){ stand.poi.position_m, stand.poi.angles };
    stand.has_wrist = 1;
    struct carried_fish *carried = stand_lay(&stand, 0.03f, 0.035f, 0.0f, 0.0f);
    carried->slide_x_m_s = 0.8f; /* It jumps up the slope and over the edge. */
    stand_wait(&stand, 0.5f);
    assert_int_equal(stand.poured, 1);
    assert_int_equal(stand.landed, 0);
    assert_int_equal(stand.bowl.fish_count, 1); /* It lies there all the same. */
}

/* A level ring whose edge is `gap_m` from the right wall, with a hand that is `press_m` beyond it
 * and a fish `fish_gap_m` from that wall. */
static int is_walled(float gap_m, float press_m, float speed_m_s, float fish_gap_m)
{
    stand_init(&stand, 4, 1);
    const struct basis level = vec_basis_from_angles(stand.poi.angles);
    const uint32_t index = stand_fish(&stand, v3(0.0f, -0.01f, 0.0f), 0.04f);
    struct fish *fish = &stand.tank.fish[index];
    stand.poi.position_m = v3(0.45f - gap_m - POI_OUTER_RADIUS_M, -0.02f, 0.0f);
    stand.poi.hand_m = v3_add(stand.poi.position_m, v3(press_m, 0.0f, 0.0f));
    stand.poi.velocity_m_s.x = speed_m_s;
    fish->position_m.x = 0.45f - fish_gap_m - 0.5f * fish->width_m;
    return capture_is_walled(&stand.poi, &level, &stand.tank, fish);
}

static void test_a_fish_between_a_wall_and_a_ring_that_presses_is_walled(void **state)
{
    (void)state;
    assert_true(is_walled(0.005f, 0.010f, 0.0f, 0.005f)); /* Stopped, the hand pushes on. */
    assert_true(is_walled(0.012f, 0.0f, 0.10f, 0.005f));  /* Not there yet. */
    assert_false(is_walled(0.005f, 0.0f, 0.0f, 0.005f));  /* Nobody pushes. */
    assert_false(is_walled(0.005f, -0.02f, -0.1f, 0.005f));
    assert_false(is_walled(0.025f, 0.010f, 0.10f, 0.005f)); /* Far from the wall. */
    assert_false(is_walled(0.005f, 0.010f, 0.10f, 0.030f)); /* The fish is. */
}

/* 0: not taken up; 1: taken up; 2: walled. A fish swims 12 mm from the right wall. */
static uint32_t scooped(float to_x_m)
{
    stand_init(&stand, 4, 3);
    stand_move(&stand, v3(0.40f, 0.06f, 0.0f), 0.5f);
    stand_dip(&stand);
    stand_move(&stand, v3(0.40f, -0.035f, 0.0f), 0.2f);
    stand_fish(&stand, v3(0.438f, -0.014f, 0.0f), 0.045f);
    stand_move(&stand, v3(to_x_m, 0.05f, 0.0f), 0.15f);
    return stand.poi.carried_count > 0 ? 1u + stand.poi.carried_fish[0].walled : 0u;
}

static void test_scooped_against_a_wall_it_is_walled_straight_up_it_is_not(void **state)
{
    (void)state;
    assert_int_equal(scooped(0.46f), 2);
    assert_int_equal(scooped(0.40f), 1);
}

/* ---- Whose ---------------------------------------------------------------------------------- */

static int is_in_hull(const struct bowl *bowl, vec3 point_m)
{
    const vec3 at = v3_sub(point_m, bowl->position_m);
    const float radius_m = bowl_hull_radius_m(-at.y);
    return at.y <= 0.0f && at.y > -BOWL_DEPTH_M && at.x * at.x + at.z * at.z < radius_m * radius_m;
}

/* Player 0's fish falls from 5 cm over a point; bowls of two players float there. Returns its gait
 * once it is off the poi. */
static uint8_t fell_at(vec3 from_m, struct catch_result results[POI_MAX], struct bowl bowls[2])
{
    stand_init(&stand, 4, 1);
    bowl_init(&bowls[0], v3(-0.2f, 0.012f, 0.0f));
    bowl_init(&bowls[1], v3(0.2f, 0.012f, 0.0f));
    const struct stall stall = { &stand.tank, bowls, 2 };
    struct carried_fish *carried = stand_lay(&stand, 0.04f, 0.0f, 0.0f, 0.0f);
    struct fish *fish = &stand.tank.fish[carried->fish];
    carried->state = CARRIED_FALLING;
    carried->clear_ticks = CARRIED_CLEAR_TICKS;
    fish->position_m = from_m;
    memset(results, 0, POI_MAX * sizeof *results);
    for (uint32_t tick = 0; tick < 60 && stand.poi.carried_count > 0; tick++) {
        catch_tick(&stand.poi, 0, &stall, tick, &stand.output, results);
        for (uint32_t i = 0; i < 2 && fish->gait != GAIT_BOWL; i++) {
            assert_false(is_in_hull(&bowls[i], fish->position_m));
        }
    }
    assert_int_equal(stand.poi.carried_count, 0);
    return fish->gait;
}

static void test_a_fish_belongs_to_the_bowl_that_it_lies_in(void **state)
{
    (void)state;
    struct catch_result results[POI_MAX];
    struct bowl bowls[2];
    assert_int_equal(fell_at(v3(0.2f, 0.06f, 0.02f), results, bowls), GAIT_BOWL);
    assert_int_equal(results[1].landed, 1); /* The neighbour's. */
    assert_int_equal(results[0].landed + results[0].poured + results[0].walled, 0);
    assert_int_equal(bowls[1].fish_count, 1);
    assert_int_equal(stand.tank.fish[0].holder, 1);
    assert_int_equal(fell_at(v3(-0.2f, 0.06f, 0.02f), results, bowls), GAIT_BOWL);
    assert_int_equal(results[0].landed, 1);
    assert_int_equal(stand.tank.fish[0].holder, 0);
}

static void test_a_foul_is_the_hands_that_did_it(void **state)
{
    (void)state;
    const struct carried_fish carried = { .clear_ticks = 0 };
    struct catch_result results[POI_MAX] = { 0 };
    catch_count(&carried, 2, 3, results);
    assert_int_equal(results[2].poured, 1);
    assert_int_equal(results[3].poured + results[3].landed, 0);
    assert_int_equal(results[3].bowled, 1); /* There it lies, whoever did it. */
    assert_int_equal(results[2].bowled, 0);
}

static void test_a_fish_that_misses_the_mouth_slides_off_the_hull_into_the_water(void **state)
{
    (void)state;
    struct catch_result results[POI_MAX];
    struct bowl bowls[2];
    for (uint32_t i = 0; i < 24; i++) {
        const float angle = F_TAU * (float)i / 24.0f;
        const float out_m = BOWL_RADIUS_M + 0.001f + 0.0004f * (float)i;
        const vec3 from = v3(0.2f + out_m * f_cos(angle), 0.06f, out_m * f_sin(angle));
        assert_int_not_equal(fell_at(from, results, bowls), GAIT_BOWL);
        assert_int_equal(bowls[0].fish_count + bowls[1].fish_count, 0);
        assert_int_equal(stand.tank.fish[0].holder, FISH_HOLDER_WATER);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tipped_over_the_bowl_a_fish_lands_and_counts_once),
        cmocka_unit_test(test_from_whichever_side_it_comes_the_fish_lands_in_the_bowl),
        cmocka_unit_test(test_each_fish_is_one_of_landed_poured_and_walled),
        cmocka_unit_test(test_the_ring_must_be_wholly_over_the_water_without_a_break),
        cmocka_unit_test(test_a_fish_that_comes_in_from_a_ring_in_the_water_is_poured),
        cmocka_unit_test(test_a_fish_between_a_wall_and_a_ring_that_presses_is_walled),
        cmocka_unit_test(test_scooped_against_a_wall_it_is_walled_straight_up_it_is_not),
        cmocka_unit_test(test_a_fish_belongs_to_the_bowl_that_it_lies_in),
        cmocka_unit_test(test_a_foul_is_the_hands_that_did_it),
        cmocka_unit_test(test_a_fish_that_misses_the_mouth_slides_off_the_hull_into_the_water),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
