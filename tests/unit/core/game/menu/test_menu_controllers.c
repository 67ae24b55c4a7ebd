/* test_menu_controllers.c -- tests the menu pages for controllers and files. Each command must be
 * sent once, and the operator must be able to reach every row of the file list. */
#include "tests/unit/support/menu_fixture.h"

static void test_the_actions_of_a_controller_depend_on_its_state(void **state)
{
    (void)state;
    static const struct {
        uint8_t state;
        uint16_t tags;
    } offers[] = {
        { CONTROLLER_NONE, 0 },
        { CONTROLLER_FREE, 1u << ROW_CHOOSE | 1u << ROW_LEARN },
        { CONTROLLER_ACTIVE, 1u << ROW_RELEASE | 1u << ROW_LEARN },
        { CONTROLLER_LOST, 1u << ROW_RELEASE },
        { CONTROLLER_UNSUPPORTED, 0 },
        { CONTROLLER_DENIED, 1u << ROW_CHOOSE | 1u << ROW_RELEASE },
    };
    static struct scene scene;
    go_to_a_controller();
    for (size_t i = 0; i < sizeof offers / sizeof offers[0]; i++) {
        input.controllers.state[3] = offers[i].state;
        step();
        core_scene(&core, &scene);
        assert_int_equal(scene.menu.tags, offers[i].tags | 1u << ROW_BACK);
        /* The new state may have disabled the selected menu entry. In this case, the menu must have
         * selected another entry. */
        assert_true(scene.menu.tags >> scene.menu.tag & 1u);
    }
}

static void test_each_command_is_sent_once_with_its_row(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_TEST);
    expect_order(1, COMMAND_CHOOSE, 3);
    steps(CORE_TICK_HZ);
    expect_order(1, COMMAND_CHOOSE, 3);
    input.controllers.state[3] = CONTROLLER_ACTIVE;
    step();
    /* The menu entry ROW_CHOOSE has been disabled, so the menu selects ROW_RELEASE. */
    assert_int_equal(pointed(), ROW_RELEASE);
    push(INPUT_TEST);
    expect_order(2, COMMAND_RELEASE, 3);
}

static void test_command_numbers_continue_after_the_menu_is_reopened(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_TEST);
    core.game.phase = PHASE_ATTRACT;
    push(INPUT_TEST);
    go_to_a_controller();
    push(INPUT_TEST);
    expect_order(2, COMMAND_CHOOSE, 3);
}

static void test_a_controller_mapping_is_learned_step_by_step_and_stored(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    expect_order(1, COMMAND_LEARN, 3);
    /* The controller manager has not begun to learn the controller yet, so LEARNS_NEXT is
     * disabled. */
    assert_int_equal(pointed(), LEARNS_END);
    uint32_t id = 1;
    for (uint8_t learn = LEARN_REST; learn <= LEARN_DIP; learn++) {
        input.controllers.learn_step = learn;
        input.controllers.learn_row = 3;
        step();
        /* Moves the selection away from LEARNS_NEXT. The operator must then be able to select it
         * again in every step of the learning. */
        push(INPUT_LEFT);
        while (pointed() != LEARNS_NEXT) {
            push(INPUT_SERVICE);
        }
        push(INPUT_TEST);
        expect_order(++id, COMMAND_LEARN_NEXT, 3);
    }
    input.controllers.learn_step = LEARN_TRY;
    step();
    assert_int_equal(pointed(), LEARNS_KEEP);
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    /* The selected menu entry, LEARNS_AGAIN, has started the learning again, so COMMAND_LEARN was
     * sent with a new number. */
    expect_order(++id, COMMAND_LEARN, 3);
    while (pointed() != LEARNS_KEEP) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    expect_order(++id, COMMAND_LEARN_KEEP, 3);
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
}

static void test_a_failed_write_of_a_mapping_is_reported_on_every_page(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    input.controllers.learn_step = LEARN_TRY;
    input.controllers.learn_row = 3;
    step();
    while (pointed() != LEARNS_KEEP) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    expect_order(2, COMMAND_LEARN_KEEP, 3);
    push(INPUT_SERVICE);
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
    input.controllers.learn_step = LEARN_NOT_SAVED;
    step();
    assert_int_equal(menu()->page, MENU_LEARN);
    assert_int_equal(pointed(), LEARNS_KEEP);
    push(INPUT_TEST);
    expect_order(3, COMMAND_LEARN_KEEP, 3);
    steps(10);
    /* The input still reports LEARN_NOT_SAVED, but the menu opens the page of the failure only
     * once. */
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
}

static void test_a_failed_command_can_be_retried_or_left(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    input.controllers.learn_step = LEARN_FAILED;
    step();
    push(INPUT_LEFT);
    push(INPUT_SERVICE);
    while (pointed() != LEARNS_END) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    expect_order(2, COMMAND_LEARN_END, 3);
    assert_int_equal(menu()->page, MENU_CONTROLLER);
}

static void test_an_idle_menu_cancels_learning(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    input.controllers.learn_step = LEARN_LEFT;
    steps(MENU_IDLE_TICKS + MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    expect_order(2, COMMAND_LEARN_END, 3);
}

static void go_to_files(uint8_t file_count)
{
    input.controllers.file_count = file_count;
    go_to(MENU_UPKEEP);
    go_to(MENU_FILES);
}

static void test_the_more_tag_is_enabled_when_the_rows_exceed_a_page(void **state)
{
    (void)state;
    static struct scene scene;
    go_to_files(0);
    for (uint32_t upright = 0; upright < 2u; upright++) {
        const uint32_t shown = menu_files_shown((int)upright);
        input.upright = (uint8_t)upright;
        for (uint32_t count = 0; count <= UINT8_MAX; count++) {
            input.controllers.file_count = (uint8_t)count;
            step();
            core_scene(&core, &scene);
            assert_int_equal(scene.menu.tags, 1u << FILES_BACK | 1u << FILES_SEEN |
                                                  (count > shown ? 1u << FILES_MORE : 0u));
            assert_int_equal(scene.menu.controllers.file_count, count);
        }
    }
}

/* With any number of rows and in both screen orientations, MORE must show every row and then the
 * first row again. */
static void test_the_more_tag_pages_through_every_row_and_back_to_the_first(void **state)
{
    static struct scene scene;
    for (uint32_t k = 0; k < 2u * UINT8_MAX; k++) {
        setup_open(state);
        input.upright = (uint8_t)(k % 2u);
        go_to_files((uint8_t)(1u + k / 2u));
        const uint32_t shown = menu_files_shown(input.upright);
        for (uint32_t seen = 0; seen < input.controllers.file_count; seen += shown) {
            core_scene(&core, &scene);
            assert_int_equal(scene.menu.file_first, seen);
            push(INPUT_LEFT);
            while (input.controllers.file_count > shown && pointed() != FILES_MORE) {
                push(INPUT_SERVICE);
            }
            if (pointed() == FILES_MORE) {
                push(INPUT_TEST);
            }
        }
        core_scene(&core, &scene);
        assert_int_equal(scene.menu.file_first, 0);
    }
}

static void test_the_files_page_always_opens_at_the_first_row(void **state)
{
    (void)state;
    go_to_files(20);
    push(INPUT_TEST);
    assert_int_equal(menu()->file_first, menu_files_shown(0));
    push(INPUT_SERVICE);
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_UPKEEP);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_FILES);
    assert_int_equal(menu()->file_first, 0);
}

/* If files are quarantined, the tag that leads back is preselected. The operator must therefore
 * select the acknowledgement deliberately. */
static void test_quarantined_files_are_acknowledged_by_a_separate_tag(void **state)
{
    (void)state;
    go_to_files(2);
    assert_int_equal(pointed(), FILES_BACK);
    const uint32_t commands = output.command_count;
    push(INPUT_SERVICE);
    assert_int_equal(pointed(), FILES_SEEN);
    push(INPUT_TEST);
    assert_int_equal(output.command_count, commands + 1u);
    assert_int_equal(output.commands[commands % CONTROLLER_COMMAND_MAX].kind, COMMAND_SEEN);
    assert_int_equal(menu()->page, MENU_FILES);
    assert_int_equal(menu()->file_first, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_MENU(test_the_more_tag_is_enabled_when_the_rows_exceed_a_page),
        IN_MENU(test_the_more_tag_pages_through_every_row_and_back_to_the_first),
        IN_MENU(test_the_files_page_always_opens_at_the_first_row),
        IN_MENU(test_quarantined_files_are_acknowledged_by_a_separate_tag),
        IN_MENU(test_the_actions_of_a_controller_depend_on_its_state),
        IN_MENU(test_each_command_is_sent_once_with_its_row),
        IN_MENU(test_command_numbers_continue_after_the_menu_is_reopened),
        IN_MENU(test_a_controller_mapping_is_learned_step_by_step_and_stored),
        IN_MENU(test_a_failed_write_of_a_mapping_is_reported_on_every_page),
        IN_MENU(test_a_failed_command_can_be_retried_or_left),
        IN_MENU(test_an_idle_menu_cancels_learning),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
