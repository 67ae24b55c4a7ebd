/* self_test.c -- runs the checks of the self-test page, and evaluates their results. */
#include "core/game/menu/menu_pages.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"

/* ---- Items of the self-test page ------------------------------------------------------------ */

uint16_t menu_self_enabled(const struct menu *menu)
{
    const struct self_test *self = &menu->self;
    const bool open = self->sound_answer == SELF_UNANSWERED || self->lamp_answer == SELF_UNANSWERED;
    return (uint16_t)((open ? MENU_TAG(SELF_YES) | MENU_TAG(SELF_NO) : 0) | MENU_TAG(SELF_AGAIN) |
                      MENU_TAG(SELF_BACK));
}

void menu_self_open(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)settings;
    menu->self = (struct self_test){ .begin_tick = game->tick };
    menu->tag[MENU_SELF_TEST] = SELF_YES;
    menu->test_coins = 0;
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        menu->pressed_count[i] = 0;
    }
}

/* Restarts the self-test, or stores YES or NO as the answer to the first open question. The
 * question about the sound comes before the question about the lamp and the coin slot. */
void menu_self_activate(const struct menu_scope *scope, uint32_t tag)
{
    struct self_test *self = &scope->menu->self;
    const uint8_t answer = tag == SELF_YES ? SELF_ANSWER_YES : SELF_ANSWER_NO;
    CORE_ASSERT(tag < SELF_BACK);
    if (tag == SELF_AGAIN) {
        menu_self_open(scope->menu, scope->game, &scope->config->persistent.settings);
    } else if (self->sound_answer == SELF_UNANSWERED) {
        self->sound_answer = answer;
    } else if (self->lamp_answer == SELF_UNANSWERED) {
        self->lamp_answer = answer;
    }
}

/* ---- Checks of the self-test in each tick ---------------------------------------------------- */

static bool self_test_is_open(const struct game *game)
{
    return game->phase == PHASE_MENU && game->menu.page == MENU_SELF_TEST;
}

/* Runs the checks of the self-test. In its second tick, the self-test logs the unchanged volume
 * setting as a test entry, so that programs that read the ledger see no changed setting. */
void self_test_tick(const struct menu_scope *scope, const struct input *input)
{
    const struct game *game = scope->game;
    struct self_test *self = &scope->menu->self;
    const uint32_t age = game->tick - self->begin_tick;
    if (!self_test_is_open(game)) {
        return;
    }
    if (age == 1u) {
        const struct ledger_entry entry = {
            .kind = LEDGER_SETTING,
            .detail = SET_VOLUME,
            .value = scope->settings_edit->logged.value[SET_VOLUME],
        };
        self->entry_id = ledger_write(scope->accounts, game->tick, &entry, scope->output);
    }
    if (age % CORE_TICK_HZ == 1u && self->sound_answer == SELF_UNANSWERED) {
        output_sound(scope->output, SOUND_CALL, 1.0f, 0.0f);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct poi_input *poi = &input->poi[i];
        const uint8_t bit = (uint8_t)(1u << i);
        if (poi->link != POI_SOURCE_LIVE || !input_pose_is_finite(&poi->target)) {
            continue;
        }
        self->present |= bit;
        if (!(self->has_first_m & bit)) {
            self->has_first_m |= bit;
            self->first_m[i] = poi->target.position_m;
        }
        const vec3 way_m = v3_sub(poi->target.position_m, self->first_m[i]);
        self->ways[i] |= (uint8_t)((f_abs(way_m.x) >= SELF_TEST_WAY_M ? 1u : 0u) |
                                   (f_abs(way_m.y) >= SELF_TEST_WAY_M ? 2u : 0u) |
                                   (f_abs(way_m.z) >= SELF_TEST_WAY_M ? 4u : 0u));
        if (age > CORE_TICK_HZ && poi->age_ticks > self->worst_age[i]) {
            self->worst_age[i] = (uint8_t)(poi->age_ticks < 255u ? poi->age_ticks : 255u);
        }
    }
}

bool self_test_shows(const struct game *game)
{
    const struct self_test *self = &game->menu.self;
    return self_test_is_open(game) && self->sound_answer != SELF_UNANSWERED &&
           self->lamp_answer == SELF_UNANSWERED && game->tick % CORE_TICK_HZ < CORE_TICK_HZ / 2u;
}

/* ---- Results of the self-test ---------------------------------------------------------------- */

void self_test_show(const struct game *game, const struct core_config *config,
                    struct scene_self_test *out)
{
    const struct self_test *self = &game->menu.self;
    const struct ledger *ledger = &game->accounts.ledger;
    const uint32_t age = game->tick - self->begin_tick;
    const bool is_late = age > SELF_TEST_STORE_TICKS;
    const uint32_t left = age < SELF_TEST_TICKS ? SELF_TEST_TICKS - age : 0u;
    const bool is_saved = self->entry_id != 0 && ledger_is_saved(ledger, self->entry_id);
    *out = (struct scene_self_test){
        .sound_answer = self->sound_answer,
        .lamp_answer = self->lamp_answer,
        .present = self->present,
        .players = config->players > 0 ? config->players : 1u,
        .store = (uint8_t)(is_saved && ledger->is_healthy ? SELF_GOOD
                           : is_late                      ? SELF_BAD
                                                          : SELF_WAITS),
        .clock = (uint8_t)(ledger->day != 0 ? SELF_GOOD : SELF_WARN),
        .seconds_left = (uint8_t)((left + CORE_TICK_HZ - 1u) / CORE_TICK_HZ),
        .day = ledger->day,
        .minute = ledger->minute,
    };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        out->ways[i] = self->ways[i];
        out->worst_age[i] = self->worst_age[i];
    }
}

static uint8_t state_from_answer(uint8_t answer)
{
    return answer == SELF_ANSWER_YES ? SELF_GOOD : answer == SELF_ANSWER_NO ? SELF_BAD : SELF_QUERY;
}

/* Buttons that the operator must test. TILT and DOOR are not buttons, and no cabinet has a language
 * button. */
#define TRIED_BUTTONS                                                                              \
    ((uint32_t)(INPUT_START | INPUT_LEFT | INPUT_RIGHT | INPUT_OK | INPUT_TEST | INPUT_SERVICE))

/* Evaluates the self-test's checks of the machine. A check without data waits for its data, and is
 * bad after the timeout. */
static void evaluate_machine(const struct scene_machine *machine, uint8_t state[SELF_CHECKS])
{
    const bool is_fresh = machine->has_backup && machine->backup_min < SELF_BACKUP_OLD_MIN;
    const bool is_kept = machine->keeps == KEEPS_PROVEN || machine->keeps == KEEPS_FOLDER;
    state[SELF_WATCHDOG] = machine->watch == WATCH_OK     ? SELF_GOOD
                           : machine->watch == WATCH_FAIL ? SELF_BAD
                                                          : SELF_WARN;
    state[SELF_BACKUP] = state[SELF_DATA] = state[SELF_ROOM] = state[SELF_HEAT] = SELF_WAITS;
    if (machine->is_checked) {
        state[SELF_BACKUP] = is_fresh ? SELF_GOOD : SELF_WARN;
        state[SELF_DATA] = machine->keeps == KEEPS_UNKNOWN ? SELF_WAITS
                           : is_kept                       ? SELF_GOOD
                                                           : SELF_BAD;
        state[SELF_ROOM] = machine->room_mib >= SELF_ROOM_LOW_MIB   ? SELF_GOOD
                           : machine->room_mib >= SELF_ROOM_BAD_MIB ? SELF_WARN
                                                                    : SELF_BAD;
        state[SELF_HEAT] = !machine->has_heat || machine->heat_margin_c >= SELF_HEAT_NEAR_C
                               ? SELF_GOOD
                           : machine->heat_margin_c > 0 ? SELF_WARN
                                                        : SELF_BAD;
    }
}

/* Evaluates the self-test's checks of the parts that a player uses. The check of the pois is bad if
 * a slot in play has no controller or has late reports. A kiosk without input lines has neither a
 * lamp nor a coin slot. The check of the lamp is then good, unless the operator answers No.
 * In free play coins are returned, so the check of the coins requires no coin. */
static void evaluate_parts(const struct scene *scene, uint8_t state[SELF_CHECKS])
{
    const struct scene_self_test *self = &scene->menu.self;
    const uint32_t frames = scene->devices.frames_a_second;
    const bool is_wired = scene->devices.lines[0] != '\0';
    const bool is_sold = scene->menu.settings.value[SET_PLAY] == PLAY_PAID;
    state[SELF_DISPLAY] = frames == 0                      ? SELF_WAITS
                          : frames >= SELF_TEST_FRAMES_MIN ? SELF_GOOD
                                                           : SELF_BAD;
    state[SELF_SOUND] = state_from_answer(self->sound_answer);
    state[SELF_LAMP] =
        !self->lamp_answer && !is_wired ? (uint8_t)SELF_GOOD : state_from_answer(self->lamp_answer);
    state[SELF_COINS] = scene->menu.test_coins > 0 || !is_sold ? SELF_GOOD : SELF_QUERY;
    state[SELF_BUTTONS] = state[SELF_POIS] = SELF_GOOD;
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        const bool counts = (TRIED_BUTTONS & ~scene->devices.buttons_missing) >> i & 1u;
        if (counts && scene->menu.pressed_count[i] == 0) {
            state[SELF_BUTTONS] = SELF_QUERY;
        }
    }
    for (uint32_t i = 0; i < self->players && i < POI_MAX; i++) {
        if (!(self->present >> i & 1u) || self->worst_age[i] > SELF_TEST_LATE_TICKS) {
            state[SELF_POIS] = SELF_BAD;
        } else if (self->ways[i] != 7u && state[SELF_POIS] == SELF_GOOD) {
            state[SELF_POIS] = SELF_QUERY;
        }
    }
}

uint32_t self_test_result(const struct scene *scene, uint8_t state[SELF_CHECKS])
{
    static const uint8_t order[] = { SELF_QUERY, SELF_BAD, SELF_WARN, SELF_WAITS };
    const struct scene_self_test *self = &scene->menu.self;
    const struct scene_machine *machine = &scene->devices.machine;
    evaluate_machine(machine, state);
    evaluate_parts(scene, state);
    state[SELF_STORE] =
        self->store == SELF_GOOD && machine->quarantined > 0 ? SELF_WARN : self->store;
    state[SELF_CLOCK] = machine->is_clock_back ? SELF_WARN : self->clock;
    state[SELF_FILES] = scene->devices.files_refused == 0 ? SELF_GOOD : SELF_BAD;
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        state[i] = state[i] == SELF_WAITS && self->seconds_left == 0 ? (uint8_t)SELF_BAD : state[i];
        CORE_ASSERT(state[i] < SELF_STATES);
    }
    for (uint32_t i = 0; i < sizeof order * SELF_CHECKS; i++) {
        if (state[i % SELF_CHECKS] == order[i / SELF_CHECKS]) {
            return i % SELF_CHECKS;
        }
    }
    return SELF_CHECKS;
}

uint32_t self_test_left(const uint8_t state[SELF_CHECKS])
{
    uint32_t left = 0;
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        left += state[i] != SELF_GOOD;
    }
    return left;
}
