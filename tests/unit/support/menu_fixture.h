/* menu_fixture.h -- test fixture of the operator's menu, with functions that open its pages. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_MENU_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_MENU_FIXTURE_H

#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"
#include "tests/unit/support/menu_tag.h"

/* Returns the state of the menu. */
static inline const struct menu *menu(void)
{
    return &core.game.menu;
}

/* Returns the index of the selected tag (menu item) of the open page. */
static inline uint8_t pointed(void)
{
    return menu()->tag[menu()->page];
}

/* Presses a button as a person does, with at least 0.1 s between two presses. */
static inline void push(uint32_t button)
{
    press(button);
    steps(MENU_TAKE_TICKS);
}

/* Returns the index of the tag (menu item) of the top page that closes the menu. */
static inline uint32_t leave(void)
{
    return menu_tag_count(MENU_TOP, false) - 1u;
}

/* Opens the menu of a kiosk with controllers in the rows 0 and 3; a cmocka setup function. */
static inline int setup_open(void **state)
{
    setup(state);
    input.controllers.state[0] = CONTROLLER_ACTIVE;
    input.controllers.state[3] = CONTROLLER_FREE;
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    return 0;
}

/* Presses SERVICE until the tag (menu item) that leads to `page` is selected, and opens the page
 * with TEST. */
static inline void go_to(uint8_t page)
{
    for (uint32_t i = 0; pointed() != menu_tag_of(page) && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    assert_int_equal(menu()->page, page);
}

/* Opens the list of controllers from the top page. */
static inline void go_to_controllers(void)
{
    go_to(MENU_DEVICES);
    go_to(MENU_CONTROLLERS);
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
}

/* Opens the menu page of the controller in row 3, which is assigned to no player. */
static inline void go_to_a_controller(void)
{
    go_to_controllers();
    push(INPUT_SERVICE);
    assert_int_equal(pointed(), 3);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_CONTROLLER);
    assert_int_equal(menu()->row, 3);
}

/* Opens the page of the input lines from the top page. */
static inline void go_to_lines(void)
{
    go_to(MENU_DEVICES);
    go_to(MENU_LINES);
}

/* Asserts that the newest command to the controllers has the id `id`, the kind `kind` and the row
 * `row`. */
static inline void expect_order(uint32_t id, enum controller_command_kind kind, uint8_t row)
{
    const struct controller_command *order = &output.commands[(id - 1u) % CONTROLLER_COMMAND_MAX];
    assert_int_equal(output.command_count, id);
    assert_int_equal(order->kind, kind);
    assert_int_equal(order->row, row);
}

#define IN_MENU(test) cmocka_unit_test_setup(test, setup_open)

#endif
