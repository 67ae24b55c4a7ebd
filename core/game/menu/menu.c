/* menu.c -- runs one tick of the operator's menu: buttons, pointer, and selection. */
#include "core/game/menu/menu_pages.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/game/menu/menu.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"
#include "core/poi/world.h"

struct menu_scope menu_scope_of(struct game *game, struct core_config *config,
                                struct output *output)
{
    return (struct menu_scope){
        .game = game,
        .menu = &game->menu,
        .settings_edit = &game->settings_edit,
        .accounts = &game->accounts,
        .language = &game->language,
        .config = config,
        .output = output,
    };
}

/* Asserts that every value of the controller state is in range. The state comes from the shell, the
 * program around the core. */
static void check_controllers(const struct controller_status *controllers)
{
    CORE_ASSERT(controllers->learn_step < LEARN_STEP_COUNT);
    CORE_ASSERT(controllers->learn_row < CONTROLLER_MAX);
    CORE_ASSERT(controllers->update < UPDATE_STATE_COUNT);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        CORE_ASSERT(controllers->state[i] < CONTROLLER_STATE_COUNT);
    }
}

/* ---- Opening of the menu -------------------------------------------------------------------- */

static bool is_played(const struct game *game)
{
    return game->phase == PHASE_READY || game->phase == PHASE_ROUND;
}

bool menu_is_confirming(const struct game *game)
{
    const uint32_t confirm_tick = game->menu.confirm_tick;
    return is_played(game) && confirm_tick != 0 && game->tick - confirm_tick < MENU_CONFIRM_TICKS;
}

/* Opens the menu. The round ends, and its credit is refunded if it is refundable. The pointers'
 * positions are recorded, so that a pointer at rest highlights nothing. */
static void open_menu(struct game *game, struct world *world, const struct core_config *config,
                      const struct input *input, struct output *output)
{
    CORE_ASSERT(game->phase != PHASE_MENU);
    struct menu *menu = &game->menu;
    *menu = (struct menu){
        .controllers = input->controllers,
        .upright = input->upright != 0,
        .rules = config->rules,
        /* Treat each poi as already dipped, so that a poi that is under water when the menu opens
         * selects no item. */
        .presses = 1,
        .command_count = menu->command_count,
        .take_tick = game->tick,
        .act_tick = game->tick,
        .use_tick = game->tick,
    };
    check_controllers(&input->controllers);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        menu->rest[i] = pointer_of_player(world, input, menu->upright, i).at;
    }
    if (game->phase == PHASE_ROUND && round_standing_is_spent(game, config)) {
        round_result_skip(game, world, config, output);
    } else {
        credit_refund(&game->accounts, game, config, REFUND_OPERATOR, output);
    }
    /* Log uptime and faults, so that the statistics in the menu are up to date. */
    health_log_write(&game->accounts, &game->health_log, game->tick, input, output);
    game->paused = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        world->poi[i].carried_count = 0; /* Return the fish on the paper to the water. */
    }
    table_setup_empty_bowls(world);
    game_enter_phase(game, PHASE_MENU);
    menu_turn(menu, game, &config->persistent.settings,
              config->persistent.settings.value[SET_PIN] != 0 ? MENU_PIN : MENU_TOP);
}

bool menu_opens(struct game *game, struct world *world, const struct core_config *config,
                const struct input *input, struct output *output)
{
    if (!(input->pressed & INPUT_TEST) || game->phase == PHASE_MENU) {
        return false;
    }
    output_sound(output, SOUND_CALL, 0.8f, 0.0f);
    if (is_played(game) && !menu_is_confirming(game)) {
        game->menu.confirm_tick = game->tick;
        return false;
    }
    open_menu(game, world, config, input, output);
    return true;
}

/* ---- Selection of items by buttons ---------------------------------------------------------- */

/* Highlights an available item. The previously highlighted item may have become unavailable, for
 * example after a controller was unplugged. */
static void point_at_something(struct menu *menu)
{
    const uint16_t offered = menu_enabled(menu);
    uint8_t tag = menu->tag[menu->page];
    if (!(offered >> tag & 1u)) {
        tag = 0;
        while (tag < MENU_TAG_MAX && !(offered >> tag & 1u)) {
            tag++;
        }
    }
    CORE_ASSERT(tag < MENU_TAG_MAX);
    menu->tag[menu->page] = tag;
}

void menu_turn(struct menu *menu, const struct game *game, const struct settings *settings,
               enum menu_page page)
{
    CORE_ASSERT(page < MENU_PAGE_COUNT);
    menu->page = (uint8_t)page;
    /* Treat the pointer as if no item were under it, so that a pointer at rest highlights no item
     * of the new page. */
    menu->points = 0;
    if (menu_page_desc_of(menu->page)->open) {
        menu_page_desc_of(menu->page)->open(menu, game, settings);
    }
    point_at_something(menu);
}

void menu_go(const struct menu_scope *scope, enum menu_page page)
{
    menu_turn(scope->menu, scope->game, &scope->config->persistent.settings, page);
}

static void point_at_tag(struct menu *menu, uint32_t tag, struct output *output)
{
    CORE_ASSERT(tag < menu_tag_count(menu->page, menu->rules));
    if (menu->tag[menu->page] != tag) {
        menu->tag[menu->page] = (uint8_t)tag;
        output_sound(output, SOUND_KEY, 0.7f, 0.0f);
    }
}

/* Moves the highlight to the next available item, forward or backward, and wraps around. */
static void point_on(struct menu *menu, bool forward, struct output *output)
{
    CORE_ASSERT(menu->page < MENU_PAGE_COUNT);
    const uint32_t count = menu_tag_count(menu->page, menu->rules);
    const uint16_t offered = menu_enabled(menu);
    uint32_t tag = menu->tag[menu->page];
    do {
        tag = (tag + (forward ? 1u : count - 1u)) % count;
    } while (!(offered >> tag & 1u));
    point_at_tag(menu, tag, output);
}

/* Runs the action of the highlighted item, unless an item was selected less than MENU_TAKE_TICKS
 * ago. Returns true if the action closes the menu. */
static bool activate_pointed_tag(const struct menu_scope *scope)
{
    CORE_ASSERT(scope->game->phase == PHASE_MENU);
    struct menu *menu = scope->menu;
    const uint32_t tick = scope->game->tick;
    if (tick - menu->take_tick < MENU_TAKE_TICKS) {
        return false;
    }
    menu->take_tick = menu->use_tick = tick;
    output_sound(scope->output, SOUND_TICK, 0.7f, 0.0f);
    return menu_activate(scope);
}

static bool is_way_back(const struct input *input)
{
    return (input->pressed & MENU_WAY_BACK) == MENU_WAY_BACK;
}

/* Handles the buttons. LEFT lowers the value of a highlighted setting, and RIGHT raises it. On
 * other items they move the highlight. Returns true if a button closes the menu. */
static bool take_menu_buttons(const struct menu_scope *scope, const struct input *input)
{
    struct menu *menu = scope->menu;
    const uint32_t inside = INPUT_TEST | INPUT_SERVICE;
    if (is_way_back(input)) {
        menu->tag[menu->page] = (uint8_t)(menu_tag_count(menu->page, menu->rules) - 1u);
        CORE_ASSERT(menu_enabled(menu) >> menu->tag[menu->page] & 1u);
        return activate_pointed_tag(scope);
    }
    const uint32_t pressed =
        input->pressed &
        (menu_page_desc_of(menu->page)->shows_presses ? inside : (uint32_t)INPUT_BUTTON_ALL);
    if ((pressed & (INPUT_LEFT | INPUT_RIGHT)) &&
        menu_has_arrows(menu->page, menu->rules, menu->tag[menu->page])) {
        menu->turns_down = (pressed & INPUT_LEFT) != 0;
        return activate_pointed_tag(scope);
    }
    if (pressed & (INPUT_SERVICE | INPUT_RIGHT | INPUT_DOWN)) {
        point_on(menu, 1, scope->output);
    } else if (pressed & (INPUT_LEFT | INPUT_UP)) {
        point_on(menu, 0, scope->output);
    }
    /* The directions up and down report INPUT_OK too, which must not select an item here. */
    return (pressed & (INPUT_TEST | INPUT_START | INPUT_OK)) &&
           !(pressed & (INPUT_UP | INPUT_DOWN)) && activate_pointed_tag(scope);
}

/* ---- Selection of items by a pointer -------------------------------------------------------- */

/* Returns true if the page uses the motion of the controllers for a purpose other than pointing.
 * The pages of the learn wizard, the calibration and the self-test do so. */
static bool uses_motion(const struct menu *menu)
{
    const uint8_t step = menu->controllers.learn_step;
    switch (menu->page) {
    case MENU_CALIBRATION:
        return menu_calibrate_is_running(&menu->calibrate);
    case MENU_SELF_TEST:
        return true;
    case MENU_LEARN:
        return step != LEARN_TRY && step != LEARN_FAILED && step != LEARN_NOT_SAVED;
    default:
        return false;
    }
}

/* Moves the highlight when a pointer enters an item. While the pointer is at rest, even after a
 * page change, the buttons move the highlight. If several controllers are connected, the pointer of
 * the controller that moved last counts. The slot of this controller may have no bowl, because the
 * operator may test a controller that was never used in a game. Returns true if the pointer closes
 * the menu. */
static bool point_at_tag_by_hand(const struct menu_scope *scope, const struct world *world,
                                 const struct input *input)
{
    struct menu *menu = scope->menu;
    struct pointer_state pointer =
        pointer_of_player(world, input, menu->upright, menu->pointer_player);
    bool stirs = false;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct pointer_state other = pointer_of_player(world, input, menu->upright, i);
        const float x = other.at.x - menu->rest[i].x, y = other.at.y - menu->rest[i].y;
        if (other.present && x * x + y * y > POINTER_MOVE_MIN * POINTER_MOVE_MIN) {
            menu->rest[i] = other.at;
            menu->act_tick = scope->game->tick;
            pointer = other;
            stirs = true;
        }
    }
    if (!pointer.present || uses_motion(menu)) {
        menu->has_pointer = menu->points = 0;
        /* No pointer is present. A pointer that appears later selects nothing until its pose has
         * been above the water. */
        menu->presses = 1;
        return false;
    }
    const bool was_down = menu->presses || pointer.player != menu->pointer_player;
    menu->has_pointer = 1;
    menu->pointer_player = pointer.player;
    menu->x = pointer.at.x;
    menu->y = pointer.at.y;
    const uint16_t offered = menu_enabled(menu);
    uint8_t points = 0; /* Item under the pointer, counted from 1. 0 means no item. */
    for (uint32_t tag = 0; tag < menu_tag_count(menu->page, menu->rules) && points == 0; tag++) {
        const struct layout_box box =
            menu_box(menu->upright, menu->page, menu->rules, offered, tag);
        points = pointer_is_inside(box, 0.0f, pointer.at) ? (uint8_t)(tag + 1u) : 0u;
    }
    if (stirs && points != menu->points && points > 0) {
        point_at_tag(menu, points - 1u, scope->output);
    }
    menu->points = stirs ? points : menu->points;
    menu->presses = pointer.height_m < (was_down ? POINTER_RELEASE_Y_M : POINTER_PRESS_Y_M);
    if (menu->presses && !was_down && points > 0) {
        menu->points = points;
        /* A dip of the poi selects the item under the pointer, even if a button has moved the
         * highlight. */
        point_at_tag(menu, points - 1u, scope->output);
        menu_aim_at_arrow(menu, pointer.at);
        return activate_pointed_tag(scope);
    }
    return false;
}

/* ---- Tick of the operator's menu ------------------------------------------------------------- */

/* Counts the presses of each button and the test coins, on every page. */
static void count_inputs(struct menu *menu, uint32_t tick, const struct input *input,
                         struct output *output)
{
    const uint32_t pressed = is_way_back(input) ? 0u : input->pressed;
    const uint32_t coins = input_coin_pulses(input);
    CORE_ASSERT(menu->test_coins <= MENU_COUNT_MAX);
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        const bool counts = (pressed >> i & 1u) && menu->pressed_count[i] < MENU_COUNT_MAX;
        menu->pressed_count[i] = (uint16_t)(menu->pressed_count[i] + counts);
    }
    if (coins > 0) {
        const uint32_t room = MENU_COUNT_MAX - menu->test_coins;
        menu->test_coins += coins < room ? coins : room;
        menu->coin_tick = tick;
        output_sound(output, SOUND_COIN, 0.5f, 0.0f);
    }
}

/* Copies the state of the controllers and of the buttons from `input` to the menu, which displays
 * this state. */
static void watch_input_test(struct menu *menu, const struct game *game,
                             const struct settings *settings, const struct input *input,
                             struct output *output)
{
    check_controllers(&input->controllers);
    const bool is_unkept = input->controllers.learn_step == LEARN_NOT_SAVED &&
                           menu->controllers.learn_step != LEARN_NOT_SAVED;
    const bool has_changed =
        memcmp(&menu->controllers, &input->controllers, sizeof menu->controllers) != 0;
    menu->controllers = input->controllers;
    menu->upright = input->upright != 0;
    menu->held = input->held;
    count_inputs(menu, game->tick, input, output);
    const bool is_used = input->pressed != 0 || input_coin_pulses(input) > 0;
    /* The menu stays open while an update is written, which may take longer than the timeout. */
    const bool is_busy = input->controllers.update == UPDATE_BUSY;
    menu->use_tick = is_used || is_busy ? game->tick : menu->use_tick;
    menu->act_tick = is_used || is_busy || has_changed ? game->tick : menu->act_tick;
    /* The store could not save the learned mapping of a controller, so the menu opens the page of
     * the learn wizard. */
    if (is_unkept && menu->page != MENU_PIN) {
        menu->row = input->controllers.learn_row;
        menu_turn(menu, game, settings, MENU_LEARN);
    }
    point_at_something(menu);
}

/* Runs one tick of the menu. On a settings page, a change repeats while the selecting button is
 * held or the selecting poi is still under water over the item. The menu closes after an idle
 * timeout (MENU_IDLE_TICKS, or MENU_PIN_IDLE_TICKS on the PIN page) without activity. If a poi
 * moves but nothing is pressed or selected, the menu closes after MENU_SWING_SPANS timeouts. */
void menu_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output)
{
    struct menu *menu = &game->menu;
    CORE_ASSERT(game->phase == PHASE_MENU && menu->page < MENU_PAGE_COUNT);
    const struct menu_scope scope = menu_scope_of(game, config, output);
    watch_input_test(menu, game, &config->persistent.settings, input, output);
    bool closes = take_menu_buttons(&scope, input) || point_at_tag_by_hand(&scope, world, input);
    if (!closes) {
        const uint32_t directions = menu_has_arrows(menu->page, menu->rules, menu->tag[menu->page])
                                        ? (uint32_t)(INPUT_LEFT | INPUT_RIGHT)
                                        : 0u;
        const bool is_taking =
            (menu->held & (INPUT_TEST | INPUT_START | INPUT_OK | directions)) != 0 ||
            (menu->has_pointer && menu->presses && menu->points == menu->tag[menu->page] + 1u);
        menu_settings_tick(&scope, is_taking);
        const uint32_t span = menu->page == MENU_PIN ? MENU_PIN_IDLE_TICKS : MENU_IDLE_TICKS;
        closes = game->tick - menu->act_tick >= span ||
                 game->tick - menu->use_tick >= MENU_SWING_SPANS * span;
    }
    if (closes) {
        menu_close(game, world, config, output);
    }
}

bool menu_tries_lines(const struct game *game)
{
    const uint8_t page = game->menu.page;
    return game->phase == PHASE_MENU && (page == MENU_LINES || page == MENU_SELF_TEST);
}
