/* test_menu_update.c -- checks the update page of the operator's menu. The page must exist only on
 * a machine that can be updated, and must start an update only when a verified one is there. */
#include "tests/unit/support/menu_fixture.h"

static void open_upkeep(uint8_t update)
{
    input.controllers.update = update;
    step();
    go_to(MENU_UPKEEP);
}

static void test_a_machine_without_updates_offers_no_update_page(void **state)
{
    (void)state;
    open_upkeep(UPDATE_NONE);
    const uint32_t count = menu_tag_count(MENU_UPKEEP, 0);
    for (uint32_t i = 0; i < count; i++) {
        assert_int_not_equal(menu_page_at(MENU_UPKEEP, 0, pointed()), MENU_UPDATE);
        push(INPUT_SERVICE);
    }
    assert_int_equal(menu_enabled(menu()),
                     ((1u << count) - 1u) & ~(1u << menu_tag_of(MENU_UPDATE)));
}

/* In a recording of an older program the page does not exist. The other tags must have the places
 * that they had without the page, so that the recorded pointer selects the same tags. */
static void test_without_the_page_the_other_tags_keep_their_places(void **state)
{
    (void)state;
    const uint32_t update = menu_tag_of(MENU_UPDATE), count = menu_tag_count(MENU_UPKEEP, 0);
    open_upkeep(UPDATE_NONE);
    const uint16_t offered = menu_enabled(menu());
    assert_int_equal(update, count - 2u);
    for (uint32_t upright = 0; upright < 2u; upright++) {
        const struct layout_box none = menu_box(upright, MENU_UPKEEP, 0, offered, update);
        assert_true(none.width == 0.0f && none.height == 0.0f);
        /* Five large tags: as before the update page existed, in rows of four or two. */
        const struct layout_box first = menu_box(upright, MENU_UPKEEP, 0, offered, 0);
        const struct layout_box last = menu_box(upright, MENU_UPKEEP, 0, offered, update - 1u);
        assert_true(last.y > first.y);
        assert_true(last.x + 0.5f * last.width == (upright ? 427.0f : 640.0f));
    }
}

static void test_the_update_starts_once_and_only_when_one_is_found(void **state)
{
    (void)state;
    open_upkeep(UPDATE_IDLE);
    go_to(MENU_UPDATE);
    const uint32_t commands = output.command_count;
    assert_int_equal(pointed(), UPDATE_BACK);
    push(INPUT_SERVICE);
    assert_int_equal(pointed(), UPDATE_BACK);
    input.controllers.update = UPDATE_READY;
    step();
    assert_int_equal(pointed(), UPDATE_BACK); /* The operator selects the start on purpose. */
    push(INPUT_SERVICE);
    assert_int_equal(pointed(), UPDATE_START);
    push(INPUT_TEST);
    expect_order(commands + 1u, COMMAND_UPDATE, 0);
    assert_int_equal(menu()->page, MENU_UPDATE);
    input.controllers.update = UPDATE_BUSY;
    step();
    assert_int_equal(pointed(), UPDATE_BACK);
    assert_int_equal(output.command_count, commands + 1u);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_UPKEEP);
}

static void test_the_menu_stays_open_while_an_update_is_written(void **state)
{
    (void)state;
    open_upkeep(UPDATE_IDLE);
    go_to(MENU_UPDATE);
    input.controllers.update = UPDATE_BUSY;
    steps(2u * MENU_IDLE_TICKS);
    assert_int_equal(core.game.phase, PHASE_MENU);
    input.controllers.update = UPDATE_IDLE;
    steps(MENU_IDLE_TICKS - 1u);
    assert_int_equal(core.game.phase, PHASE_MENU);
    steps(2);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_an_update_state_out_of_range_fails_an_assertion(void **state)
{
    (void)state;
    input.controllers.update = UPDATE_STATE_COUNT;
    expect_assert_failure(step());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_MENU(test_a_machine_without_updates_offers_no_update_page),
        IN_MENU(test_without_the_page_the_other_tags_keep_their_places),
        IN_MENU(test_the_update_starts_once_and_only_when_one_is_found),
        IN_MENU(test_the_menu_stays_open_while_an_update_is_written),
        IN_MENU(test_an_update_state_out_of_range_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
