/* test_menu_poi.c -- tests that an operator can use the menu with a poi alone, and that a poi
 * selects no tag (menu entry) by accident. */
#include "tests/unit/support/menu_fixture.h"

/* Holds a poi over the middle of a tag, `y_m` above the water. If the poi measures its orientation,
 * the position is mapped from the tank seen from above to the whole screen. */
static void hold_over(uint32_t tag, float y_m)
{
    const int upright = input.upright;
    const struct layout_point canvas = pointer_layout_size(upright);
    const struct layout_box box = menu_box(upright, menu()->page, false, menu_enabled(menu()), tag);
    assert_true(box.width > 0.0f);
    input.poi[0] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target.position_m = { core.world.tank.size_m.x *
                                   ((box.x + 0.5f * box.width) / canvas.x - 0.5f),
                               y_m,
                               core.world.tank.size_m.z *
                                   ((box.y + 0.5f * box.height) / canvas.y - 0.5f) },
    };
}

static void tap(uint32_t tag)
{
    hold_over(tag, ABOVE_M);
    /* Moves the poi from 2 cm beside the menu entry onto the entry, because only a moving poi
     * selects an entry. */
    input.poi[0].target.position_m.x += 0.02f;
    step();
    hold_over(tag, ABOVE_M);
    steps(MENU_TAKE_TICKS);
    assert_int_equal(pointed(), tag);
    input.poi[0].target.position_m.y = BELOW_M;
    step();
    input.poi[0].target.position_m.y = ABOVE_M;
    steps(MENU_TAKE_TICKS);
}

static void test_a_poi_alone_reaches_every_page_on_both_screens(void **state)
{
    for (uint8_t upright = 0; upright < 2u; upright++) {
        setup_open(state);
        input.upright = upright;
        step();
        tap(menu_tag_of(MENU_DEVICES));
        tap(menu_tag_of(MENU_CONTROLLERS));
        assert_int_equal(menu()->page, MENU_CONTROLLERS);
        tap(3);
        assert_int_equal(menu()->page, MENU_CONTROLLER);
        tap(ROW_CHOOSE);
        expect_order(1, COMMAND_CHOOSE, 3);
        tap(ROW_LEARN);
        assert_int_equal(menu()->page, MENU_LEARN);
        input.controllers.learn_step = LEARN_TRY;
        step();
        tap(LEARNS_KEEP);
        expect_order(3, COMMAND_LEARN_KEEP, 3);
        tap(ROWS_BACK);
        tap(menu_tag_of(MENU_LINES));
        assert_int_equal(menu()->page, MENU_LINES);
        tap(LINES_BACK);
        tap(menu_tag_count(MENU_DEVICES, false) - 1u);
        tap(leave());
        assert_int_equal(core.game.phase, PHASE_ATTRACT);
    }
}

static void test_a_dip_outside_the_tags_activates_none(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(MENU_TAKE_TICKS);
    /* Moves the poi over the title of the page, where no menu entry is. */
    input.poi[0].target.position_m.z = -0.49f * core.world.tank.size_m.z;
    step();
    input.poi[0].target.position_m.y = BELOW_M;
    steps(MENU_TAKE_TICKS);
    assert_int_equal(menu()->page, MENU_TOP);
}

static void test_a_submerged_poi_activates_no_tag_as_the_menu_opens(void **state)
{
    hold_at(BELOW_M);
    setup_open(state);
    hold_over(leave(), BELOW_M);
    steps(CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(pointed(), leave());
}

static void test_a_controller_that_is_being_learned_selects_no_tag(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    input.controllers.learn_step = LEARN_LEFT;
    step();
    const uint8_t before = pointed();
    for (uint32_t tag = 0; tag < 2u; tag++) {
        hold_over(tag == 0 ? LEARNS_NEXT : LEARNS_END, ABOVE_M);
        steps(MENU_TAKE_TICKS);
        input.poi[0].target.position_m.y = BELOW_M;
        steps(MENU_TAKE_TICKS);
        assert_int_equal(pointed(), before);
        assert_int_equal(menu()->page, MENU_LEARN);
    }
    expect_order(1, COMMAND_LEARN, 3);
}

static void test_a_moving_controller_without_a_bowl_selects_tags(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(2);
    /* Places a second poi in slot 2 at rest over the same menu entry. Any connected poi can use the
     * menu, although the kiosk has only one player, in slot 0. The poi that moves selects the
     * entry. */
    input.poi[2] = input.poi[0];
    steps(2);
    hold_over(1, ABOVE_M);
    steps(2);
    assert_int_equal(pointed(), 1);
    const struct poi_input mine = input.poi[0];
    hold_over(leave(), ABOVE_M);
    input.poi[2] = input.poi[0];
    input.poi[0] = mine;
    steps(2);
    assert_int_equal(menu()->pointer_player, 2);
    assert_int_equal(pointed(), leave());
    input.poi[2].target.position_m.y = BELOW_M;
    steps(MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* The page opens while a poi rests over one of its entries. This entry must not be selected,
 * because the player did not point at it. */
static void test_a_resting_poi_selects_no_tag_as_a_page_opens(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(2);
    go_to(MENU_DEVICES);
    hold_over(0, ABOVE_M);
    steps(2);
    /* A page opens under the resting poi, and afterwards the first page is shown again. Neither may
     * change the selected entry. */
    for (uint32_t i = 0; i < 2u; i++) {
        go_to(MENU_AXES);
        const uint8_t left = (uint8_t)menu_tag_of(MENU_AXES);
        push(INPUT_TEST);
        assert_int_equal(menu()->page, MENU_DEVICES);
        steps(MENU_TAKE_TICKS);
        assert_int_equal(pointed(), left);
    }
    hold_over(0, ABOVE_M);
    input.poi[0].target.position_m.x += 0.02f;
    steps(2);
    /* The poi has moved now, so the menu entry under it is selected. */
    assert_int_equal(pointed(), 0);
}

static void test_a_resting_poi_selects_no_tag_as_the_menu_opens(void **state)
{
    hold_over(2, ABOVE_M);
    const struct poi_input rests = input.poi[0];
    setup(state);
    input.poi[0] = rests;
    steps(2);
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(pointed(), 0);
}

static void expect_apart(int upright, uint8_t page, uint16_t offered)
{
    const struct layout_point canvas = pointer_layout_size(upright);
    const uint32_t count = menu_tag_count(page, false);
    for (uint32_t a = 0; a < count; a++) {
        const struct layout_box box = menu_box(upright, page, false, offered, a);
        if (!(offered >> a & 1u)) {
            assert_true(box.width <= 0.0f);
            continue;
        }
        assert_true(box.x >= 0.0f && box.y >= 0.0f);
        assert_true(box.x + box.width <= canvas.x && box.y + box.height <= canvas.y);
        for (uint32_t b = 0; b < a; b++) {
            const struct layout_box other = menu_box(upright, page, false, offered, b);
            const int apart = other.width <= 0.0f || other.x + other.width <= box.x ||
                              box.x + box.width <= other.x || other.y + other.height <= box.y ||
                              box.y + box.height <= other.y;
            if (!apart) {
                fail_msg("page %u: tags %u and %u overlap", page, a, b);
            }
        }
    }
}

static void test_no_two_tags_overlap_and_all_are_on_the_canvas(void **state)
{
    (void)state;
    for (uint8_t page = 0; page < MENU_PAGE_COUNT; page++) {
        const uint32_t all = 1u << menu_tag_count(page, false);
        for (uint32_t offered = 1; offered < all; offered += 1u + all / 512u) {
            expect_apart(0, page, (uint16_t)offered);
            expect_apart(1, page, (uint16_t)offered);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_poi_alone_reaches_every_page_on_both_screens),
        IN_MENU(test_a_dip_outside_the_tags_activates_none),
        cmocka_unit_test_setup(test_a_submerged_poi_activates_no_tag_as_the_menu_opens, setup),
        IN_MENU(test_a_controller_that_is_being_learned_selects_no_tag),
        IN_MENU(test_a_moving_controller_without_a_bowl_selects_tags),
        IN_MENU(test_a_resting_poi_selects_no_tag_as_a_page_opens),
        IN_MENU(test_a_resting_poi_selects_no_tag_as_the_menu_opens),
        cmocka_unit_test(test_no_two_tags_overlap_and_all_are_on_the_canvas),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
