/* test_carried_separation.c -- checks that several fish on the same paper move apart. */
#include "core/poi/catch/carried_fish.h"
#include "tests/unit/support/poi_fixture.h"

static struct poi_fixture fixture;

/* Returns the overlap of two carried fish in the plane of the paper, in metres; 0 or less means
 * that they do not overlap. Each fish is modelled as a capsule. The axis of the capsule is 0.60
 * body lengths long. Its radius is 0.36 of the height of a fish that lies on its side, and 0.36 of
 * the width of an upright fish. The distance is measured at 41 points of the axis. */
static float overlap_m(const struct carried_fish *a, const struct carried_fish *b)
{
    const struct fish *fish_a = &fixture.tank.fish[a->fish], *fish_b = &fixture.tank.fish[b->fish];
    const vec3 on_a = v3(f_sin(a->heading_rad), 0.0f, f_cos(a->heading_rad));
    const vec3 on_b = v3(f_sin(b->heading_rad), 0.0f, f_cos(b->heading_rad));
    const vec3 between = v3(a->x_m - b->x_m, 0.0f, a->z_m - b->z_m);
    float least_m = 1.0f;
    for (int i = -20; i <= 20; i++) {
        const vec3 way = v3_muladd(between, on_a, 0.015f * (float)i * fish_a->length_m);
        const float half_m = 0.30f * fish_b->length_m;
        const float along = f_clamp(v3_dot(way, on_b), -half_m, half_m);
        least_m = f_min(least_m, v3_length(v3_muladd(way, on_b, -along)));
    }
    return 0.36f * (f_lerp(fish_a->width_m, fish_a->height_m, a->lie) +
                    f_lerp(fish_b->width_m, fish_b->height_m, b->lie)) -
           least_m;
}

/* Returns the deepest overlap of any two carried fish in metres. */
static float worst_m(void)
{
    const struct poi *poi = &fixture.poi;
    float worst = -1.0f;
    for (uint32_t i = 1; i < poi->carried_count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            const struct carried_fish *a = &poi->carried_fish[i], *b = &poi->carried_fish[k];
            worst = f_max(worst, overlap_m(a, b));
        }
    }
    return worst;
}

static void lay_a_heap(uint32_t count, float length_m)
{
    fixture_init(&fixture, 4, 1);
    for (uint32_t i = 0; i < count; i++) {
        fixture_place_fish(&fixture, length_m, 0.001f * (float)i, 0.0005f * (float)(i * i % 7u),
                           0.4f * (float)i);
    }
}

static void test_overlapping_carried_fish_soon_lie_side_by_side(void **state)
{
    (void)state;
    for (uint32_t count = 2; count <= 4; count++) {
        lay_a_heap(count, 0.045f);
        assert_true(worst_m() > 0.005f);
        fixture_wait(&fixture, 0.4f);
        /* Up to four of these fish fit on the paper, so none of them may be pushed off. */
        assert_int_equal(fixture.poi.carried_count, count);
        assert_true(worst_m() < 0.0015f);
    }
}

static void test_two_carried_fish_in_the_same_place_separate(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_place_fish(&fixture, 0.045f, 0.0f, 0.0f, 0.3f);
    fixture_place_fish(&fixture, 0.045f, 0.0f, 0.0f, 0.3f);
    fixture_wait(&fixture, 0.4f);
    assert_true(worst_m() < 0.0015f);
    assert_int_equal(fixture.poi.carried_count, 2);
}

static void test_the_lighter_carried_fish_moves_farther(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_place_fish(&fixture, 0.06f, -0.001f, 0.0f, 0.0f);
    fixture_place_fish(&fixture, 0.035f, 0.001f, 0.0f, 0.0f);
    fixture_wait(&fixture, 0.3f);
    assert_true(fixture.poi.carried_fish[1].x_m > 0.004f);
    assert_true(-fixture.poi.carried_fish[0].x_m < 0.4f * fixture.poi.carried_fish[1].x_m);
}

static void test_the_ring_stops_a_carried_fish_that_is_pushed_against_it(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_place_fish(&fixture, 0.045f, 0.033f, 0.0f, 0.0f);
    fixture_place_fish(&fixture, 0.045f, 0.027f, 0.0f, 0.0f);
    fixture_wait(&fixture, 0.5f);
    assert_int_equal(fixture.poi.carried_count, 2);
    assert_true(fixture.poi.carried_fish[0].x_m <= 0.0365f);
    assert_true(worst_m() < 0.0015f);
}

static void test_carried_fish_without_room_are_pushed_over_the_ring(void **state)
{
    (void)state;
    /* 16 fish of 6 cm would need twice the area of the paper, so some must fall off. */
    lay_a_heap(16, 0.06f);
    fixture_wait(&fixture, 2.0f);
    print_message("of 16 fish of 6 cm %u stay\n", fixture.poi.carried_count);
    assert_in_range(fixture.poi.carried_count, 4, 13);
    for (uint32_t i = 0; i < 16; i++) {
        const struct fish *fish = &fixture.tank.fish[i];
        const int rides = fish->gait == GAIT_HELD && fish->holder == 0;
        assert_true(rides ? fish->position_m.y > 0.04f : fish->position_m.y < 0.0f);
    }
}

static void test_a_falling_fish_pushes_no_other_fish(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_place_fish(&fixture, 0.045f, 0.0f, 0.0f, 0.0f);
    fixture_place_fish(&fixture, 0.045f, 0.001f, 0.0f, 0.0f)->state = CARRIED_FALLING;
    carried_separation_tick(&fixture.poi, fixture.tank.fish);
    assert_float_equal(fixture.poi.carried_fish[0].x_m, 0.0f, 0.0f);
    assert_float_equal(fixture.poi.carried_fish[1].x_m, 0.001f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlapping_carried_fish_soon_lie_side_by_side),
        cmocka_unit_test(test_two_carried_fish_in_the_same_place_separate),
        cmocka_unit_test(test_the_lighter_carried_fish_moves_farther),
        cmocka_unit_test(test_the_ring_stops_a_carried_fish_that_is_pushed_against_it),
        cmocka_unit_test(test_carried_fish_without_room_are_pushed_over_the_ring),
        cmocka_unit_test(test_a_falling_fish_pushes_no_other_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
