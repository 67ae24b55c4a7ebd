/* test_menu.c -- the operator's menu: two buttons or a hand lead everywhere, no round runs behind
 * it, no coin in it is money, and each order is told once. */
#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_stand.h"

static const struct menu *menu(void)
{
    return &core.game.menu;
}

static uint8_t pointed(void)
{
    return menu()->tag[menu()->page];
}

/* A press as a hand makes it: nobody presses twice within a tenth of a second. */
static void push(uint32_t button)
{
    press(button);
    steps(MENU_TAKE_TICKS);
}

static uint32_t leave(void)
{
    return menu_tag_count(MENU_TOP) - 1u;
}

static int setup_open(void **state)
{
    setup(state);
    input.controllers.state[0] = CONTROLLER_ACTIVE;
    input.controllers.state[3] = CONTROLLER_FREE;
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    return 0;
}

/* SERVICE points until the page's tag is pointed at, and TEST takes it. */
static void go_to(uint8_t page)
{
    for (uint32_t i = 0; pointed() != menu_tag_of(page) && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    assert_int_equal(menu()->page, page);
}

static void go_to_controllers(void)
{
    go_to(MENU_DEVICES);
    go_to(MENU_CONTROLLERS);
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
}

/* The page of row 3, which is free. */
static void go_to_a_controller(void)
{
    go_to_controllers();
    push(INPUT_SERVICE);
    assert_int_equal(pointed(), 3);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_CONTROLLER);
    assert_int_equal(menu()->row, 3);
}

static void go_to_lines(void)
{
    go_to(MENU_DEVICES);
    go_to(MENU_LINES);
}

static void expect_order(uint32_t id, enum controller_command_kind kind, uint8_t row)
{
    const struct controller_command *order = &output.commands[(id - 1u) % CONTROLLER_COMMAND_MAX];
    assert_int_equal(output.command_count, id);
    assert_int_equal(order->kind, kind);
    assert_int_equal(order->row, row);
}

/* ---- Opening and leaving -------------------------------------------------------------------- */

static void test_test_opens_it_at_once_where_nothing_is_played(void **state)
{
    (void)state;
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(menu()->page, MENU_TOP); /* The press that opened it took nothing. */
    setup(state);
    play_into_result();
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
}

static void test_in_a_round_test_asks_and_an_elbow_ends_nothing(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(menu_is_asking(&core.game));
    steps(MENU_ASK_TICKS);
    assert_false(menu_is_asking(&core.game));
    press(INPUT_TEST); /* Much later: it asks anew. */
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(menu_is_asking(&core.game));
}

static void test_a_second_test_ends_the_round_without_a_result_and_pays_it_back(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    core.game.accounts.ledger.balance.paid = core.game.accounts.ledger.committed.paid = 2;
    play_into_round();
    core.game.player[0].caught = 7;
    assert_int_equal(purse_credits(&core), 1);
    press(INPUT_TEST);
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(purse_credits(&core), 2);
    assert_int_equal(purse_audit(&core, AUDIT_REFUNDS), 1);
    assert_int_equal(output.record.id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 2);
}

static void test_the_question_of_one_round_is_not_asked_in_the_next(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_TEST);
    core.game.phase = PHASE_RESULT;
    assert_false(menu_is_asking(&core.game));
}

static void test_its_last_tag_opens_the_stall_again(void **state)
{
    (void)state;
    push(INPUT_LEFT); /* Round the other way: the last one. */
    assert_int_equal(pointed(), leave());
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_left_open_and_forgotten_the_stall_opens_again(void **state)
{
    (void)state;
    steps(MENU_IDLE_TICKS / 2u);
    push(INPUT_SERVICE); /* Somebody is there. */
    steps(MENU_IDLE_TICKS - 2u * MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_MENU);
    steps(3u * MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_start_in_the_menu_begins_no_round(void **state)
{
    (void)state;
    push(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(menu()->page, MENU_DEVICES);
    assert_int_equal(core.game.round_count, 0);
}

/* ---- Two buttons ---------------------------------------------------------------------------- */

static void test_service_points_round_and_passes_over_empty_rows(void **state)
{
    (void)state;
    go_to_controllers();
    static const uint8_t way[] = { 0, 3, ROWS_BACK, 0, 3 };
    for (size_t i = 0; i < sizeof way; i++) {
        assert_int_equal(pointed(), way[i]);
        push(INPUT_SERVICE);
    }
}

static void test_service_gives_no_credit_in_the_menu(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    push(INPUT_SERVICE);
    assert_int_equal(purse_credits(&core), 0);
    assert_int_equal(purse_audit(&core, AUDIT_CREDITS_SERVICE), 0);
}

/* Into each page that hangs somewhere, by TEST and SERVICE alone, and back by its last tag. */
static void test_two_buttons_lead_into_every_page_and_back(void **state)
{
    uint32_t seen = 1u << MENU_TOP; /* Those that hang nowhere have tests of their own. */
    for (uint8_t page = 1; page < MENU_PAGE_COUNT; page++) {
        seen |= menu_tag_of(page) == MENU_TAG_MAX ? 1u << page : 0u;
    }
    for (uint8_t page = 1; page < MENU_PAGE_COUNT; page++) {
        uint8_t way[4];
        uint32_t depth = 0;
        setup_open(state);
        for (uint8_t at = page; at != MENU_TOP && at < MENU_PAGE_COUNT;) {
            way[depth++] = at;
            at = menu_page_desc_of(at)->parent;
        }
        for (uint32_t i = depth; i > 0 && menu_tag_of(way[i - 1u]) < MENU_TAG_MAX; i--) {
            go_to(way[i - 1u]);
            seen |= 1u << way[i - 1u];
        }
        for (uint32_t i = 0; i <= depth && core.game.phase == PHASE_MENU; i++) {
            push(INPUT_LEFT); /* The last tag is the one before the first that is offered. */
            while (pointed() != menu_tag_count(menu()->page) - 1u) {
                push(INPUT_SERVICE);
            }
            push(INPUT_TEST);
        }
        assert_int_equal(core.game.phase, PHASE_ATTRACT);
    }
    assert_int_equal(seen, (1u << MENU_PAGE_COUNT) - 1u);
}

static void test_one_push_takes_once_however_it_bounces(void **state)
{
    (void)state;
    go_to_controllers();
    press(INPUT_TEST);
    press(INPUT_TEST);
    press(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_CONTROLLER);
    assert_int_equal(output.command_count, 0);
}

/* ---- Controllers ---------------------------------------------------------------------------- */

static void test_what_may_be_done_to_a_controller_is_what_it_is_good_for(void **state)
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
        assert_true(scene.menu.tags >> scene.menu.tag & 1u); /* It points at one of them. */
    }
}

static void test_each_order_is_told_once_with_its_row(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_TEST);
    expect_order(1, COMMAND_CHOOSE, 3);
    steps(CORE_TICK_HZ);
    expect_order(1, COMMAND_CHOOSE, 3);
    input.controllers.state[3] = CONTROLLER_ACTIVE;
    step();
    assert_int_equal(pointed(), ROW_RELEASE); /* What was pointed at is gone. */
    push(INPUT_TEST);
    expect_order(2, COMMAND_RELEASE, 3);
}

static void test_orders_count_on_when_the_menu_is_opened_again(void **state)
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

static void test_a_controller_is_learned_step_by_step_and_kept(void **state)
{
    (void)state;
    go_to_a_controller();
    push(INPUT_SERVICE);
    push(INPUT_TEST);
    expect_order(1, COMMAND_LEARN, 3);
    assert_int_equal(pointed(), LEARNS_END); /* Until the desk has begun. */
    uint32_t id = 1;
    for (uint8_t learn = LEARN_REST; learn <= LEARN_DIP; learn++) {
        input.controllers.learn_step = learn;
        input.controllers.learn_row = 3;
        step();
        push(INPUT_LEFT); /* Whatever it pointed at: */
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
    expect_order(++id, COMMAND_LEARN, 3); /* Once more. */
    while (pointed() != LEARNS_KEEP) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
    expect_order(++id, COMMAND_LEARN_KEEP, 3);
    assert_int_equal(menu()->page, MENU_CONTROLLERS);
}

static void test_who_kept_what_cannot_be_written_is_told_wherever_he_is(void **state)
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
    assert_int_equal(menu()->page, MENU_CONTROLLERS); /* It is told once. */
}

static void test_what_failed_can_be_tried_again_or_left(void **state)
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

static void test_a_menu_that_is_forgotten_ends_what_was_being_learned(void **state)
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

/* ---- Files ---------------------------------------------------------------------------------- */

static void go_to_files(uint8_t file_count)
{
    input.controllers.file_count = file_count;
    go_to(MENU_UPKEEP);
    go_to(MENU_FILES);
}

static void test_more_is_offered_where_more_is_than_fits(void **state)
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

/* However many there are and however the screen stands: each row is seen, and then the first. */
static void test_more_leads_past_every_row_and_to_the_first_again(void **state)
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

static void test_files_are_shown_from_the_first_whenever_they_are_looked_at(void **state)
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

/* What was set aside is acknowledged by who means to: a short page points at the way back. */
static void test_what_was_set_aside_is_acknowledged_by_a_tag_of_its_own(void **state)
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

/* ---- Buttons and coins ---------------------------------------------------------------------- */

static void drop(uint32_t coins)
{
    input.coin_count[0] = coins;
    step();
    input.coin_count[0] = 0;
}

static void test_a_coin_on_the_lines_page_is_a_test_and_only_metered(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    static struct scene scene;
    go_to_lines();
    assert_int_equal(output.coin_lockout, 0); /* Else none would reach the mechanism. */
    for (uint32_t i = 0; i < 5; i++) {
        drop(1);
    }
    core_scene(&core, &scene);
    assert_int_equal(scene.menu.test_coins, 5);
    assert_int_equal(core.game.accounts.ledger.balance.units + purse_credits(&core), 0);
    assert_int_equal(output.coins_counted, 5); /* They are in the box. */
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_DEVICES);
    assert_int_equal(output.coin_lockout, 1);
}

/* The slot is closed there; one that falls all the same is the operator's, who has the key. */
static void test_on_every_other_page_coins_are_sent_back_and_one_that_falls_is_a_test(void **state)
{
    (void)state;
    core.config.credit_coins = 2;
    for (uint8_t page = 0; page < MENU_PAGE_COUNT; page++) {
        if (page == MENU_LINES || page == MENU_SELF_TEST) {
            continue;
        }
        const uint32_t before = output.coins_counted;
        menu_turn(&core.game, &core.config.persistent.settings, (enum menu_page)page);
        step();
        assert_int_equal(output.coin_lockout, 1);
        drop(1);
        drop(1);
        assert_int_equal(core.game.accounts.ledger.balance.units + purse_credits(&core), 0);
        assert_int_equal(output.coins_counted, before + 2u);
        assert_int_equal(purse_audit(&core, AUDIT_TEST_COINS), output.coins_counted);
    }
}

/* The meter and the books count each coin once, whatever page is turned in its tick. */
static void test_no_test_coin_is_twice_or_never_where_a_page_is_turned(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    for (uint32_t i = 1; i <= 60u; i++) {
        menu_turn(&core.game, &core.config.persistent.settings,
                  i % 20u < 10u ? MENU_DEVICES : MENU_LINES);
        if (i % 10u == 0) { /* From LINES back, and there again. */
            core.game.menu.tag[MENU_DEVICES] = (uint8_t)menu_tag_of(MENU_LINES);
            input.pressed = INPUT_TEST;
        }
        drop(1);
        assert_int_equal(output.coins_counted, i);
        assert_int_equal(menu()->test_coins, i);
        assert_int_equal(purse_audit(&core, AUDIT_TEST_COINS), i);
    }
    assert_int_equal(purse_credits(&core), 0);
}

static void test_lines_are_watched_and_only_test_leads_back(void **state)
{
    (void)state;
    static struct scene scene;
    uint16_t before[INPUT_BUTTON_COUNT];
    go_to_lines();
    memcpy(before, menu()->pressed_count, sizeof before); /* What led here. */
    const uint32_t shown = INPUT_START | INPUT_OK | INPUT_LEFT | INPUT_RIGHT | INPUT_TILT;
    input.held = shown;
    push(shown);
    push(shown);
    core_scene(&core, &scene);
    assert_int_equal(menu()->page, MENU_LINES);
    assert_int_equal(scene.menu.held, shown);
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        assert_int_equal(scene.menu.pressed_count[i], before[i] + (shown >> i & 1u ? 2u : 0u));
    }
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_DEVICES);
}

static void test_the_start_buttons_lamp_follows_it_while_lines_are_watched(void **state)
{
    (void)state;
    go_to_lines();
    step();
    assert_int_equal(output.start_lamp, 0);
    input.held = INPUT_START;
    step();
    assert_int_equal(output.start_lamp, 1);
}

static void test_counters_stop_where_their_digits_end(void **state)
{
    (void)state;
    go_to_lines();
    for (uint32_t i = 0; i < MENU_COUNT_MAX + 10u; i++) {
        press(INPUT_DOOR);
    }
    assert_int_equal(menu()->pressed_count[8], MENU_COUNT_MAX);
    input.coin_count[0] = UINT32_MAX;
    step();
    assert_int_equal(menu()->test_coins, MENU_COUNT_MAX);
    step();
    assert_int_equal(menu()->test_coins, MENU_COUNT_MAX);
}

static void test_a_shake_while_the_operator_works_is_no_shake(void **state)
{
    (void)state;
    push(INPUT_TILT);
    assert_int_equal(core.game.accounts.credit.shakes, 0);
}

/* ---- The hand ------------------------------------------------------------------------------- */

/* A poi with a wrist, whose plan of the tank is the canvas, over the middle of a tag. */
static void hold_over(uint32_t tag, float y_m)
{
    const int upright = input.upright;
    const struct layout_point canvas = pointer_layout_size(upright);
    const struct layout_box box = menu_box(upright, menu()->page, menu_enabled(menu()), tag);
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
    input.poi[0].target.position_m.x += 0.02f; /* From elsewhere, or it points at nothing. */
    step();
    hold_over(tag, ABOVE_M);
    steps(MENU_TAKE_TICKS);
    assert_int_equal(pointed(), tag);
    input.poi[0].target.position_m.y = BELOW_M;
    step();
    input.poi[0].target.position_m.y = ABOVE_M;
    steps(MENU_TAKE_TICKS);
}

static void test_a_poi_alone_leads_everywhere_on_both_screens(void **state)
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
        tap(menu_tag_count(MENU_DEVICES) - 1u);
        tap(leave());
        assert_int_equal(core.game.phase, PHASE_ATTRACT);
    }
}

static void test_a_dip_that_hits_no_tag_takes_none(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(MENU_TAKE_TICKS);
    input.poi[0].target.position_m.z = -0.49f * core.world.tank.size_m.z; /* The title. */
    step();
    input.poi[0].target.position_m.y = BELOW_M;
    steps(MENU_TAKE_TICKS);
    assert_int_equal(menu()->page, MENU_TOP);
}

static void test_who_opens_it_with_a_poi_in_the_water_takes_nothing(void **state)
{
    hold_at(BELOW_M);
    setup_open(state);
    hold_over(leave(), BELOW_M);
    steps(CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(pointed(), leave());
}

static void test_a_controller_that_is_being_learned_points_at_nothing(void **state)
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

static void test_whoever_moves_points_also_without_a_bowl(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(2);
    input.poi[2] = input.poi[0]; /* There is one bowl, and a third controller. */
    steps(2);
    hold_over(1, ABOVE_M);
    steps(2);
    assert_int_equal(pointed(), 1);
    const struct poi_input mine = input.poi[0];
    hold_over(leave(), ABOVE_M);
    input.poi[2] = input.poi[0];
    input.poi[0] = mine;
    steps(2);
    assert_int_equal(menu()->hand, 2);
    assert_int_equal(pointed(), leave());
    input.poi[2].target.position_m.y = BELOW_M;
    steps(MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* The page opens under it: what lies there was not meant. */
static void test_a_hand_that_rests_chooses_nothing_where_a_page_opens(void **state)
{
    (void)state;
    hold_over(0, ABOVE_M);
    steps(2);
    go_to(MENU_DEVICES);
    hold_over(0, ABOVE_M);
    steps(2);
    for (uint32_t i = 0; i < 2u; i++) { /* Also as it comes back from where it was. */
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
    assert_int_equal(pointed(), 0); /* It stirs, and means what lies under it. */
}

static void test_a_hand_that_rests_as_the_menu_opens_chooses_nothing(void **state)
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

/* ---- Places --------------------------------------------------------------------------------- */

static void expect_apart(int upright, uint8_t page, uint16_t offered)
{
    const struct layout_point canvas = pointer_layout_size(upright);
    const uint32_t count = menu_tag_count(page);
    for (uint32_t a = 0; a < count; a++) {
        const struct layout_box box = menu_box(upright, page, offered, a);
        if (!(offered >> a & 1u)) {
            assert_true(box.width <= 0.0f);
            continue;
        }
        assert_true(box.x >= 0.0f && box.y >= 0.0f);
        assert_true(box.x + box.width <= canvas.x && box.y + box.height <= canvas.y);
        for (uint32_t b = 0; b < a; b++) {
            const struct layout_box other = menu_box(upright, page, offered, b);
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
        const uint32_t all = 1u << menu_tag_count(page);
        for (uint32_t offered = 1; offered < all; offered += 1u + all / 512u) {
            expect_apart(0, page, (uint16_t)offered);
            expect_apart(1, page, (uint16_t)offered);
        }
    }
}

static void test_a_desk_that_is_out_of_range_is_a_bug(void **state)
{
    (void)state;
    input.controllers.state[2] = CONTROLLER_STATE_COUNT;
    expect_assert_failure(step());
    input.controllers.state[2] = 0;
    input.controllers.learn_row = CONTROLLER_MAX;
    expect_assert_failure(step());
    input.controllers.learn_row = 0;
    input.controllers.learn_step = LEARN_STEP_COUNT;
    expect_assert_failure(step());
}

#define IN_MENU(test) cmocka_unit_test_setup(test, setup_open)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_test_opens_it_at_once_where_nothing_is_played, setup),
        cmocka_unit_test_setup(test_in_a_round_test_asks_and_an_elbow_ends_nothing, setup),
        cmocka_unit_test_setup(test_a_second_test_ends_the_round_without_a_result_and_pays_it_back,
                               setup),
        cmocka_unit_test_setup(test_the_question_of_one_round_is_not_asked_in_the_next, setup),
        IN_MENU(test_its_last_tag_opens_the_stall_again),
        IN_MENU(test_more_is_offered_where_more_is_than_fits),
        IN_MENU(test_more_leads_past_every_row_and_to_the_first_again),
        IN_MENU(test_files_are_shown_from_the_first_whenever_they_are_looked_at),
        IN_MENU(test_what_was_set_aside_is_acknowledged_by_a_tag_of_its_own),
        IN_MENU(test_left_open_and_forgotten_the_stall_opens_again),
        IN_MENU(test_start_in_the_menu_begins_no_round),
        IN_MENU(test_service_points_round_and_passes_over_empty_rows),
        IN_MENU(test_service_gives_no_credit_in_the_menu),
        cmocka_unit_test(test_two_buttons_lead_into_every_page_and_back),
        IN_MENU(test_one_push_takes_once_however_it_bounces),
        IN_MENU(test_what_may_be_done_to_a_controller_is_what_it_is_good_for),
        IN_MENU(test_each_order_is_told_once_with_its_row),
        IN_MENU(test_orders_count_on_when_the_menu_is_opened_again),
        IN_MENU(test_a_controller_is_learned_step_by_step_and_kept),
        IN_MENU(test_who_kept_what_cannot_be_written_is_told_wherever_he_is),
        IN_MENU(test_what_failed_can_be_tried_again_or_left),
        IN_MENU(test_a_menu_that_is_forgotten_ends_what_was_being_learned),
        IN_MENU(test_a_coin_on_the_lines_page_is_a_test_and_only_metered),
        IN_MENU(test_on_every_other_page_coins_are_sent_back_and_one_that_falls_is_a_test),
        IN_MENU(test_no_test_coin_is_twice_or_never_where_a_page_is_turned),
        IN_MENU(test_lines_are_watched_and_only_test_leads_back),
        IN_MENU(test_the_start_buttons_lamp_follows_it_while_lines_are_watched),
        IN_MENU(test_counters_stop_where_their_digits_end),
        IN_MENU(test_a_shake_while_the_operator_works_is_no_shake),
        cmocka_unit_test(test_a_poi_alone_leads_everywhere_on_both_screens),
        IN_MENU(test_a_dip_that_hits_no_tag_takes_none),
        cmocka_unit_test_setup(test_who_opens_it_with_a_poi_in_the_water_takes_nothing, setup),
        IN_MENU(test_a_controller_that_is_being_learned_points_at_nothing),
        IN_MENU(test_whoever_moves_points_also_without_a_bowl),
        IN_MENU(test_a_hand_that_rests_chooses_nothing_where_a_page_opens),
        IN_MENU(test_a_hand_that_rests_as_the_menu_opens_chooses_nothing),
        cmocka_unit_test(test_no_two_tags_overlap_and_all_are_on_the_canvas),
        IN_MENU(test_a_desk_that_is_out_of_range_is_a_bug),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
