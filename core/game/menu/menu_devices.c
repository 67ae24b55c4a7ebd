/* menu_devices.c -- the pages about devices: selects controllers, runs the learn wizard for an
 * unknown controller, and calibrates a slot's poi. */
#include "core/game/menu/menu_pages.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/game.h"
#include "core/poi/world.h"

/* ---- Page of all controllers ---------------------------------------------------------------- */

uint16_t menu_rows_enabled(const struct menu *menu)
{
    uint16_t offers = MENU_TAG(ROWS_BACK);
    for (uint32_t row = 0; row < CONTROLLER_MAX; row++) {
        offers |= menu->controllers.state[row] != CONTROLLER_NONE ? MENU_TAG(row) : 0;
    }
    return offers;
}

void menu_rows_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag < CONTROLLER_MAX);
    scope->menu->row = (uint8_t)tag;
    menu_go(scope, MENU_CONTROLLER);
}

/* ---- Page of one controller ----------------------------------------------------------------- */

/* Highlights the first item of the open page. Called when the page shows a different controller. */
void menu_reopen(struct menu *menu, const struct game *game, const struct settings *settings)
{
    (void)game;
    (void)settings;
    menu->tag[menu->page] = 0;
}

uint16_t menu_row_enabled(const struct menu *menu)
{
    CORE_ASSERT(menu->row < CONTROLLER_MAX);
    static const uint16_t by_state[CONTROLLER_STATE_COUNT] = {
        [CONTROLLER_FREE] = MENU_TAG(ROW_CHOOSE) | MENU_TAG(ROW_LEARN),
        [CONTROLLER_ACTIVE] = MENU_TAG(ROW_RELEASE) | MENU_TAG(ROW_LEARN),
        [CONTROLLER_LOST] = MENU_TAG(ROW_RELEASE), /* A lost controller has no item for the learn
                                                      wizard, because the wizard needs a
                                                      connected controller. */
        /* A controller that could not be opened can be chosen again, because the operating system's
         * permission may have been granted after the first attempt. */
        [CONTROLLER_DENIED] = MENU_TAG(ROW_CHOOSE) | MENU_TAG(ROW_RELEASE),
    };
    return by_state[menu->controllers.state[menu->row]] | MENU_TAG(ROW_BACK);
}

void menu_row_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag < ROW_BACK);
    if (tag == ROW_LEARN) {
        menu_command(scope->menu, scope->output, COMMAND_LEARN);
        menu_go(scope, MENU_LEARN);
        return;
    }
    menu_command(scope->menu, scope->output, tag == ROW_CHOOSE ? COMMAND_CHOOSE : COMMAND_RELEASE);
}

/* ---- Page of the learn wizard --------------------------------------------------------------- */

uint16_t menu_learn_enabled(const struct menu *menu)
{
    CORE_ASSERT(menu->controllers.learn_step < LEARN_STEP_COUNT);
    switch (menu->controllers.learn_step) {
    case LEARN_NONE:
        /* The wizard has not started, or the controller is disconnected, so the wizard can only be
         * ended. */
        return MENU_TAG(LEARNS_END);
    case LEARN_TRY:
    case LEARN_NOT_SAVED: /* The mapping could not be saved. The operator may try again, for
                             example after an SD card was inserted. */
        return MENU_TAG(LEARNS_KEEP) | MENU_TAG(LEARNS_AGAIN) | MENU_TAG(LEARNS_END);
    case LEARN_FAILED:
        return MENU_TAG(LEARNS_AGAIN) | MENU_TAG(LEARNS_END);
    default:
        return MENU_TAG(LEARNS_NEXT) | MENU_TAG(LEARNS_END);
    }
}

void menu_learn_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag < LEARNS_END);
    switch (tag) {
    case LEARNS_NEXT:
        menu_command(scope->menu, scope->output, COMMAND_LEARN_NEXT);
        break;
    case LEARNS_KEEP:
        menu_command(scope->menu, scope->output, COMMAND_LEARN_KEEP);
        menu_go(scope, MENU_CONTROLLERS);
        break;
    default:
        menu_command(scope->menu, scope->output, COMMAND_LEARN);
        break;
    }
}

void menu_learn_close(struct menu *menu, struct output *output)
{
    menu_command(menu, output, COMMAND_LEARN_END);
}

/* ---- Calibration: items of the page --------------------------------------------------------- */

uint16_t menu_calibrate_enabled(const struct menu *menu)
{
    CORE_ASSERT(menu->calibrate.slot < POI_MAX);
    const struct calibrate *calibrate = &menu->calibrate;
    const uint32_t slot = 1u << calibrate->slot;
    return (uint16_t)(((calibrate->present & ~slot) != 0 ? MENU_TAG(CALIBRATE_NEXT) : 0u) |
                      (calibrate->present & slot ? MENU_TAG(CALIBRATE_BEGIN) : 0u) |
                      (calibrate->has_before & slot ? MENU_TAG(CALIBRATE_UNDO) : 0u) |
                      (calibrate->is_set & slot ? MENU_TAG(CALIBRATE_NONE) : 0u) |
                      MENU_TAG(CALIBRATE_BACK));
}

static void begin_anew(struct calibrate *calibrate)
{
    calibrate->step = CALIBRATE_IDLE;
    calibrate->has_anchor = 0;
    calibrate->still_ticks = 0;
}

static void next_slot(struct calibrate *calibrate)
{
    CORE_ASSERT(calibrate->present != 0);
    do {
        calibrate->slot = (uint8_t)((calibrate->slot + 1u) % POI_MAX);
    } while (!(calibrate->present >> calibrate->slot & 1u));
}

void menu_calibrate_open(struct menu *menu, const struct game *game,
                         const struct settings *settings)
{
    CORE_ASSERT(menu->page == MENU_CALIBRATION);
    (void)game;
    (void)settings;
    struct calibrate *calibrate = &menu->calibrate;
    begin_anew(calibrate);
    if (calibrate->present != 0 && !(calibrate->present >> calibrate->slot & 1u)) {
        next_slot(calibrate);
    }
}

/* Stores `value` as the slot's calibration. A complete previous calibration is kept, so that the
 * operator can restore it. */
static void swap_with(const struct menu_scope *scope, int32_t value[CALIBRATION_VALUES])
{
    struct calibrate *calibrate = &scope->menu->calibrate;
    CORE_ASSERT(calibrate->slot < POI_MAX);
    const uint32_t first = input_calibration_setting(calibrate->slot);
    const struct settings *settings = &scope->config->persistent.settings;
    int32_t before[CALIBRATION_VALUES] = { 0 };
    if (input_calibration_is_set(settings, calibrate->slot)) {
        memcpy(before, &settings->value[first], sizeof before);
    }
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        settings_edit_set(scope, first + i, value[i]);
    }
    settings_edit_set(scope, input_calibration_check_setting(calibrate->slot),
                      input_calibration_check(value));
    memcpy(calibrate->before[calibrate->slot], before, sizeof before);
    calibrate->has_before |= (uint8_t)(1u << calibrate->slot);
}

void menu_calibrate_activate(const struct menu_scope *scope, uint32_t tag)
{
    CORE_ASSERT(tag < CALIBRATE_BACK);
    struct calibrate *calibrate = &scope->menu->calibrate;
    int32_t value[CALIBRATION_VALUES] = { 0 };
    begin_anew(calibrate);
    if (tag == CALIBRATE_NEXT) {
        next_slot(calibrate);
    } else if (tag == CALIBRATE_BEGIN) {
        calibrate->step = CALIBRATE_CORNER;
        /* The poi may still be in its holder, and must move before the first pose counts. */
        calibrate->must_move = 1;
    } else if (tag == CALIBRATE_UNDO) {
        memcpy(value, calibrate->before[calibrate->slot], sizeof value);
        swap_with(scope, value);
    } else {
        swap_with(scope, value);
    }
}

/* ---- Calibration: detection of a poi that is held still ------------------------------------- */

bool menu_calibrate_is_running(const struct calibrate *calibrate)
{
    return calibrate->step >= CALIBRATE_CORNER && calibrate->step <= CALIBRATE_WATER;
}

float menu_calibrate_progress(const struct calibrate *calibrate)
{
    return (float)calibrate->still_ticks / (float)CALIBRATE_STILL_TICKS;
}

static void rest_at(struct calibrate *calibrate, const struct poi_target *at)
{
    calibrate->has_anchor = 1;
    calibrate->anchor = *at;
    calibrate->sum = (struct poi_target){ { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f } };
    calibrate->still_ticks = 0;
}

/* Adds the deviation of the poi's pose from `anchor` to `sum` while the poi is held still. A sum of
 * positions would lose precision far from the origin. Returns true if the poi has been still for
 * CALIBRATE_STILL_TICKS. */
static bool watch_still(struct calibrate *calibrate, const struct poi_input *poi)
{
    const struct poi_target *at = &poi->target, *anchor = &calibrate->anchor;
    struct poi_target *sum = &calibrate->sum;
    if (!calibrate->has_anchor) {
        rest_at(calibrate, at);
        return false;
    }
    const float way_m = v3_length(v3_sub(at->position_m, anchor->position_m));
    if (calibrate->must_move && way_m <= CALIBRATE_MOVE_M) {
        return false;
    }
    const float turn = poi->has_wrist ? input_turn(anchor->angles, at->angles) : 0.0f;
    if (calibrate->must_move || way_m > CALIBRATE_STILL_M || turn > CALIBRATE_STILL_TURN) {
        calibrate->must_move = 0;
        rest_at(calibrate, at);
        return false;
    }
    sum->position_m = v3_add(sum->position_m, v3_sub(at->position_m, anchor->position_m));
    sum->angles.pitch_rad += f_wrap_angle(at->angles.pitch_rad - anchor->angles.pitch_rad);
    sum->angles.roll_rad += f_wrap_angle(at->angles.roll_rad - anchor->angles.roll_rad);
    calibrate->still_ticks++;
    CORE_ASSERT(calibrate->still_ticks <= CALIBRATE_STILL_TICKS);
    return calibrate->still_ticks == CALIBRATE_STILL_TICKS;
}

/* ---- Calibration: steps --------------------------------------------------------------------- */

/* Stores the mean of the still poses for the current calibration step. After the last calibration
 * step, computes the calibration. */
static void take_pose(const struct menu_scope *scope, const struct world *world,
                      const struct poi_input *poi)
{
    struct calibrate *calibrate = &scope->menu->calibrate;
    const float share = 1.0f / (float)CALIBRATE_STILL_TICKS;
    struct poi_target at = calibrate->anchor;
    int32_t value[CALIBRATION_VALUES];
    CORE_ASSERT(menu_calibrate_is_running(calibrate));
    at.position_m = v3_muladd(at.position_m, calibrate->sum.position_m, share);
    at.angles.pitch_rad += share * calibrate->sum.angles.pitch_rad;
    at.angles.roll_rad += share * calibrate->sum.angles.roll_rad;
    rest_at(calibrate, &poi->target);
    calibrate->must_move = 1;
    scope->menu->act_tick = scope->game->tick;
    if (calibrate->step != CALIBRATE_WATER) {
        calibrate->sample.corner_m[calibrate->step - CALIBRATE_CORNER] = at.position_m;
        calibrate->step++;
        output_sound(scope->output, SOUND_CATCH, 0.7f, 0.0f);
        return;
    }
    calibrate->sample.water = at;
    calibrate->sample.has_wrist = poi->has_wrist != 0;
    calibrate->fault =
        (uint8_t)input_calibration_solve(&calibrate->sample, world->tank.size_m, value);
    const bool is_good = calibrate->fault == CALIBRATION_GOOD;
    if (is_good) {
        swap_with(scope, value);
    }
    calibrate->step = is_good ? CALIBRATE_DONE : CALIBRATE_REFUSED;
    output_sound(scope->output, is_good ? SOUND_RESULT : SOUND_FOUL, 0.7f, 0.0f);
}

void menu_calibrate_tick(const struct menu_scope *scope, const struct world *world,
                         const struct input *raw)
{
    const struct settings *settings = &scope->config->persistent.settings;
    struct calibrate *calibrate = &scope->menu->calibrate;
    if (scope->game->phase != PHASE_MENU) {
        return;
    }
    calibrate->present = calibrate->is_set = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const bool is_there = raw->poi[i].link == POI_SOURCE_LIVE;
        const bool is_set =
            input_calibration_is_set(settings, i) || input_calibration_is_torn(settings, i);
        calibrate->present |= (uint8_t)((uint32_t)is_there << i);
        calibrate->is_set |= (uint8_t)((uint32_t)is_set << i);
    }
    CORE_ASSERT(calibrate->slot < POI_MAX && calibrate->step < CALIBRATE_STEPS);
    const struct poi_input *poi = &raw->poi[calibrate->slot];
    if (scope->menu->page != MENU_CALIBRATION || !menu_calibrate_is_running(calibrate)) {
        return;
    }
    if (poi->link != POI_SOURCE_LIVE || !input_pose_is_finite(&poi->target)) {
        calibrate->has_anchor = 0;
        calibrate->still_ticks = 0;
    } else if (watch_still(calibrate, poi)) {
        take_pose(scope, world, poi);
    }
}
