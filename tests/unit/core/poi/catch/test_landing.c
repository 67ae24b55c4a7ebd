/* test_landing.c -- checks how fish land in a bowl, for which player they count, and which fouls
 * are detected. */
#include <stdbool.h>

#include "core/poi/catch/capture.h"
#include "tests/unit/support/poi_fixture.h"

static struct poi_fixture fixture;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return fixture_lift(&fixture, grade, seed, off_x_m, 0.0f);
}

static void test_a_fish_tipped_over_the_bowl_lands_and_counts_once(void **state)
{
    (void)state;
    uint32_t landed = 0;
    for (uint32_t seed = 0; seed < 60; seed++) {
        const uint32_t fish = lifted(4, seed, 0.0f);
        fixture_move(&fixture, v3(0.20f, 0.05f, 0.10f), 0.3f);
        assert_int_equal(fixture.landed, 0);
        /* Holds the ring at 35 mm, as a mouse does. At this height the ring is just above the
         * bowl. */
        fixture_move(&fixture, v3(0.30f, 0.035f, 0.15f), 0.3f);
        fixture_wait(&fixture, 1.5f);
        assert_int_equal(fixture.poured + fixture.walled, 0);
        assert_int_equal(fixture.bowl.fish_count, fixture.landed);
        assert_int_equal(fixture.tank.fish[fish].gait == GAIT_BOWL, fixture.landed == 1);
        landed += fixture.landed;
        fixture_wait(&fixture, 0.5f);
        assert_int_equal(fixture.bowl.fish_count, fixture.landed);
        assert_int_equal(fixture.poi.carried_count, 0);
    }
    /* Up to three of the 60 fish may slip off the paper before they reach the bowl. */
    assert_in_range(landed, 57, 60);
}

static void test_a_fish_lands_in_the_bowl_from_every_side(void **state)
{
    (void)state;
    uint32_t landed = 0;
    for (uint32_t i = 0; i < 16; i++) {
        const float angle = F_TAU * (float)i / 16.0f;
        lifted(4, i, 0.0f);
        bowl_init(&fixture.bowl, v3(0.15f * f_cos(angle), 0.02f, 0.15f * f_sin(angle)));
        fixture_wait(&fixture, 0.5f);
        fixture_move(&fixture, v3(fixture.bowl.position_m.x, 0.05f, fixture.bowl.position_m.z),
                     0.25f);
        fixture_wait(&fixture, 1.5f);
        landed += fixture.landed;
    }
    assert_in_range(landed, 15, 16);
}

/* ---- How a fish counts: landed, poured, or pressed against a wall ---------------------------- */

static struct catch_result counted(uint8_t clear_ticks, uint8_t walled)
{
    const struct carried_fish carried = { .clear_ticks = clear_ticks, .walled = walled };
    struct catch_result results[POI_MAX] = { 0 };
    catch_count(&carried, 0, 0, results);
    return results[0];
}

static void test_a_fish_is_landed_or_poured_or_walled(void **state)
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

static void test_a_landing_requires_the_ring_wholly_above_the_water(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    assert_int_equal(fixture.poi.carried_fish[0].clear_ticks, CARRIED_CLEAR_TICKS);
    fixture.has_wrist = 1;
    /* Tilts the ring, so that its lowest point is 20 mm below its centre. */
    fixture_turn(&fixture, 0.0f, 25.0f * F_DEG, 0.3f);
    fixture_move(&fixture, v3(0.0f, 0.028f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.2f);
    assert_int_equal(fixture.poi.carried_fish[0].clear_ticks, CARRIED_CLEAR_TICKS);
    /* The centre of the ring is at 16 mm, so the lowest point of the ring is 4 mm under water. */
    fixture_move(&fixture, v3(0.0f, 0.016f, 0.0f), 0.2f);
    fixture_wait(&fixture, 0.2f);
    assert_int_equal(fixture.poi.carried_count, 1);
    assert_int_equal(fixture.poi.carried_fish[0].clear_ticks, 0);
    /* Raises the ring until its lowest point is 10 mm above the surface. */
    fixture.hand.position_m.y = 0.030f;
    uint32_t ticks = 0;
    while (fixture.poi.carried_fish[0].clear_ticks < CARRIED_CLEAR_TICKS &&
           ticks++ < CORE_TICK_HZ) {
        fixture_tick(&fixture);
    }
    assert_in_range(ticks, CARRIED_CLEAR_TICKS, CORE_TICK_HZ / 2u);
}

/* The ring is beside the bowl. Its far edge is above the opening of the bowl, but its near edge is
 * still in the water. It is a foul to pour a fish into the bowl from such a ring. */
static void test_a_fish_from_a_ring_in_the_water_is_poured(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture.poi.position_m = v3(0.30f - BOWL_RADIUS_M - 0.030f, 0.026f, 0.15f);
    fixture.poi.angles.roll_rad = -40.0f * F_DEG;
    fixture.hand = (struct poi_target){ fixture.poi.position_m, fixture.poi.angles };
    fixture.has_wrist = 1;
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.03f, 0.035f, 0.0f, 0.0f);
    /* Lets the fish slide up the slope at 0.8 m/s, which is fast enough to fly over the edge into
     * the bowl. */
    carried->slide_x_m_s = 0.8f;
    fixture_wait(&fixture, 0.5f);
    assert_int_equal(fixture.poured, 1);
    assert_int_equal(fixture.landed, 0);
    /* The fish is in the bowl, but it does not count as landed. */
    assert_int_equal(fixture.bowl.fish_count, 1);
}

/* Returns 1 if a fish is walled, which is a foul: the ring presses the fish against a wall. The
 * ring is level and at the distance `gap_m` from the right wall, and the fish is at the distance
 * `fish_gap_m` from this wall. The player's target is nearer to the wall than the ring by
 * `press_m`. */
static bool is_walled(float gap_m, float press_m, float speed_m_s, float fish_gap_m)
{
    fixture_init(&fixture, 4, 1);
    const struct basis level = vec_basis_from_angles(fixture.poi.angles);
    const uint32_t index = fixture_add_fish(&fixture, v3(0.0f, -0.01f, 0.0f), 0.04f);
    struct fish *fish = &fixture.tank.fish[index];
    fixture.poi.position_m = v3(0.45f - gap_m - POI_OUTER_RADIUS_M, -0.02f, 0.0f);
    fixture.poi.hand_m = v3_add(fixture.poi.position_m, v3(press_m, 0.0f, 0.0f));
    fixture.poi.velocity_m_s.x = speed_m_s;
    fish->position_m.x = 0.45f - fish_gap_m - 0.5f * fish->width_m;
    return capture_is_walled(&fixture.poi, &level, &fixture.tank, fish);
}

static void test_a_fish_between_a_wall_and_a_pressing_ring_is_walled(void **state)
{
    (void)state;
    /* The fish is walled (trapped between ring and wall), because the ring is 5 mm from the wall
     * and the player presses it toward the wall. */
    assert_true(is_walled(0.005f, 0.010f, 0.0f, 0.005f));
    /* The fish is walled, because the ring is 12 mm from the wall and moves toward the wall at 0.10
     * m/s. */
    assert_true(is_walled(0.012f, 0.0f, 0.10f, 0.005f));
    /* The fish is not walled, because the player does not press the ring toward the wall. */
    assert_false(is_walled(0.005f, 0.0f, 0.0f, 0.005f));
    assert_false(is_walled(0.005f, -0.02f, -0.1f, 0.005f));
    /* The fish is not walled, because the ring is too far from the wall (25 mm). */
    assert_false(is_walled(0.025f, 0.010f, 0.10f, 0.005f));
    /* The fish is not walled, because it is too far from the wall (30 mm). */
    assert_false(is_walled(0.005f, 0.010f, 0.10f, 0.030f));
}

/* Scoops a fish that is 12 mm from the right wall, and moves to `to_x_m` during the lift. Returns 0
 * if the fish is not caught, 1 if it is caught, and 2 if it is caught while it was trapped between
 * ring and wall. */
static uint32_t scooped(float to_x_m)
{
    fixture_init(&fixture, 4, 3);
    fixture_move(&fixture, v3(0.40f, 0.06f, 0.0f), 0.5f);
    fixture_dip(&fixture);
    fixture_move(&fixture, v3(0.40f, -0.035f, 0.0f), 0.2f);
    fixture_add_fish(&fixture, v3(0.438f, -0.014f, 0.0f), 0.045f);
    fixture_move(&fixture, v3(to_x_m, 0.05f, 0.0f), 0.15f);
    return fixture.poi.carried_count > 0 ? 1u + fixture.poi.carried_fish[0].walled : 0u;
}

static void test_a_scoop_against_a_wall_is_walled_and_a_vertical_scoop_is_not(void **state)
{
    (void)state;
    assert_int_equal(scooped(0.46f), 2);
    assert_int_equal(scooped(0.40f), 1);
}

/* ---- Owner of a landed fish ----------------------------------------------------------------- */

static bool is_in_hull(const struct bowl *bowl, vec3 point_m)
{
    const vec3 at = v3_sub(point_m, bowl->position_m);
    const float radius_m = bowl_hull_radius_m(-at.y);
    return at.y <= 0.0f && at.y > -BOWL_DEPTH_M && at.x * at.x + at.z * at.z < radius_m * radius_m;
}

/* Lets a fish fall from the poi of player 0 at the position `from_m`. Two bowls float in the tank,
 * one for each player. Returns the gait of the fish after the fall. */
static uint8_t fell_at(vec3 from_m, struct catch_result results[POI_MAX], struct bowl bowls[2])
{
    fixture_init(&fixture, 4, 1);
    bowl_init(&bowls[0], v3(-0.2f, 0.012f, 0.0f));
    bowl_init(&bowls[1], v3(0.2f, 0.012f, 0.0f));
    const struct stall stall = { &fixture.tank, bowls, 2, false };
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.04f, 0.0f, 0.0f, 0.0f);
    struct fish *fish = &fixture.tank.fish[carried->fish];
    carried->state = CARRIED_FALLING;
    carried->clear_ticks = CARRIED_CLEAR_TICKS;
    fish->position_m = from_m;
    memset(results, 0, POI_MAX * sizeof *results);
    for (uint32_t tick = 0; tick < 60 && fixture.poi.carried_count > 0; tick++) {
        catch_tick(&fixture.poi, 0, &stall, tick, &fixture.output, results);
        for (uint32_t i = 0; i < 2 && fish->gait != GAIT_BOWL; i++) {
            assert_false(is_in_hull(&bowls[i], fish->position_m));
        }
    }
    assert_int_equal(fixture.poi.carried_count, 0);
    return fish->gait;
}

static void test_a_fish_belongs_to_the_bowl_it_lies_in(void **state)
{
    (void)state;
    struct catch_result results[POI_MAX];
    struct bowl bowls[2];
    assert_int_equal(fell_at(v3(0.2f, 0.06f, 0.02f), results, bowls), GAIT_BOWL);
    /* The fish has fallen into the bowl of player 1, so it counts for player 1. */
    assert_int_equal(results[1].landed, 1);
    assert_int_equal(results[0].landed + results[0].poured + results[0].walled, 0);
    assert_int_equal(bowls[1].fish_count, 1);
    assert_int_equal(fixture.tank.fish[0].holder, 1);
    assert_int_equal(fell_at(v3(-0.2f, 0.06f, 0.02f), results, bowls), GAIT_BOWL);
    assert_int_equal(results[0].landed, 1);
    assert_int_equal(fixture.tank.fish[0].holder, 0);
}

static void test_a_foul_counts_for_the_player_who_caused_it(void **state)
{
    (void)state;
    const struct carried_fish carried = { .clear_ticks = 0 };
    struct catch_result results[POI_MAX] = { 0 };
    catch_count(&carried, 2, 3, results);
    assert_int_equal(results[2].poured, 1);
    assert_int_equal(results[3].poured + results[3].landed, 0);
    /* The fish is in bowl 3 and counts as content of bowl 3. The foul, however, belongs to player
     * 2. */
    assert_int_equal(results[3].bowled, 1);
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
        assert_int_equal(results[0].slipped, 1);
        assert_int_equal(fixture.tank.fish[0].holder, FISH_HOLDER_WATER);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_tipped_over_the_bowl_lands_and_counts_once),
        cmocka_unit_test(test_a_fish_lands_in_the_bowl_from_every_side),
        cmocka_unit_test(test_a_fish_is_landed_or_poured_or_walled),
        cmocka_unit_test(test_a_landing_requires_the_ring_wholly_above_the_water),
        cmocka_unit_test(test_a_fish_from_a_ring_in_the_water_is_poured),
        cmocka_unit_test(test_a_fish_between_a_wall_and_a_pressing_ring_is_walled),
        cmocka_unit_test(test_a_scoop_against_a_wall_is_walled_and_a_vertical_scoop_is_not),
        cmocka_unit_test(test_a_fish_belongs_to_the_bowl_it_lies_in),
        cmocka_unit_test(test_a_foul_counts_for_the_player_who_caused_it),
        cmocka_unit_test(test_a_fish_that_misses_the_mouth_slides_off_the_hull_into_the_water),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
