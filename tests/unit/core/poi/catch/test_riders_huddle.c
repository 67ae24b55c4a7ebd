/* test_riders_huddle.c -- several fish on one paper. */
#include "core/poi/catch/carried_fish.h"
#include "tests/unit/support/poi_stand.h"

static struct stand stand;

/* The deepest that two riders lie in one another. */
static float worst_m(void)
{
    const struct poi *poi = &stand.poi;
    float worst = -1.0f;
    for (uint32_t i = 1; i < poi->carried_count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            const struct carried_fish *a = &poi->carried_fish[i], *b = &poi->carried_fish[k];
            worst = f_max(worst, carried_separation_overlap_m(a, &stand.tank.fish[a->fish], b,
                                                              &stand.tank.fish[b->fish]));
        }
    }
    return worst;
}

static void lay_a_heap(uint32_t count, float length_m)
{
    stand_init(&stand, 4, 1);
    for (uint32_t i = 0; i < count; i++) {
        stand_lay(&stand, length_m, 0.001f * (float)i, 0.0005f * (float)(i * i % 7u),
                  0.4f * (float)i);
    }
}

static void test_fish_that_came_up_in_one_another_soon_lie_side_by_side(void **state)
{
    (void)state;
    for (uint32_t count = 2; count <= 4; count++) {
        lay_a_heap(count, 0.045f);
        assert_true(worst_m() > 0.005f);
        stand_wait(&stand, 0.4f);
        assert_int_equal(stand.poi.carried_count, count); /* There is room for them. */
        assert_true(worst_m() < 0.0015f);
    }
}

static void test_two_in_the_same_place_part_too(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_lay(&stand, 0.045f, 0.0f, 0.0f, 0.3f);
    stand_lay(&stand, 0.045f, 0.0f, 0.0f, 0.3f);
    stand_wait(&stand, 0.4f);
    assert_true(worst_m() < 0.0015f);
    assert_int_equal(stand.poi.carried_count, 2);
}

static void test_the_lighter_gives_way_the_more(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_lay(&stand, 0.06f, -0.001f, 0.0f, 0.0f);
    stand_lay(&stand, 0.035f, 0.001f, 0.0f, 0.0f);
    stand_wait(&stand, 0.3f);
    assert_true(stand.poi.carried_fish[1].x_m > 0.004f);
    assert_true(-stand.poi.carried_fish[0].x_m < 0.4f * stand.poi.carried_fish[1].x_m);
}

static void test_the_ring_holds_who_is_pushed_against_it(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_lay(&stand, 0.045f, 0.033f, 0.0f, 0.0f);
    stand_lay(&stand, 0.045f, 0.027f, 0.0f, 0.0f);
    stand_wait(&stand, 0.5f);
    assert_int_equal(stand.poi.carried_count, 2);
    assert_true(stand.poi.carried_fish[0].x_m <= 0.0365f);
    assert_true(worst_m() < 0.0015f);
}

static void test_where_there_is_no_room_left_they_are_squeezed_over_the_ring(void **state)
{
    (void)state;
    lay_a_heap(16, 0.06f); /* Twice the paper. */
    stand_wait(&stand, 2.0f);
    print_message("of 16 fish of 6 cm %u stay\n", stand.poi.carried_count);
    assert_in_range(stand.poi.carried_count, 4, 13);
    for (uint32_t i = 0; i < 16; i++) {
        const struct fish *fish = &stand.tank.fish[i];
        const int rides = fish->gait == GAIT_HELD && fish->holder == 0;
        assert_true(rides ? fish->position_m.y > 0.04f : fish->position_m.y < 0.0f);
    }
}

static void test_who_falls_pushes_nobody(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_lay(&stand, 0.045f, 0.0f, 0.0f, 0.0f);
    stand_lay(&stand, 0.045f, 0.001f, 0.0f, 0.0f)->state = CARRIED_FALLING;
    carried_separation_tick(&stand.poi, stand.tank.fish);
    assert_float_equal(stand.poi.carried_fish[0].x_m, 0.0f, 0.0f);
    assert_float_equal(stand.poi.carried_fish[1].x_m, 0.001f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_that_came_up_in_one_another_soon_lie_side_by_side),
        cmocka_unit_test(test_two_in_the_same_place_part_too),
        cmocka_unit_test(test_the_lighter_gives_way_the_more),
        cmocka_unit_test(test_the_ring_holds_who_is_pushed_against_it),
        cmocka_unit_test(test_where_there_is_no_room_left_they_are_squeezed_over_the_ring),
        cmocka_unit_test(test_who_falls_pushes_nobody),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
