/* shot_menu.c -- implementation of shot_menu.h: example content of the operator's menu. */
#include "tests/render/shot_menu.h"

#include <stdio.h>
#include <string.h>

#include "core/game/menu/menu_pages.h"

static const struct {
    uint8_t state;
    const char *name;
} found[CONTROLLER_MAX] = {
    { CONTROLLER_ACTIVE, "1209:0001 Kingyo poi, port 1-1.2" },
    { CONTROLLER_FREE, "054c:09cc Wireless Controller, port 1-1.4" },
    { CONTROLLER_LOST, "046d:c626 SpaceNavigator, port 3-2" },
    { CONTROLLER_DENIED, "056a:0302 Wacom Intuos, port 1-1.1.3" },
    { CONTROLLER_NONE, "" },
    { CONTROLLER_UNSUPPORTED, "046d:c31c USB Keyboard, port 2-1" },
};

/* Example files that the menu lists after the files of the store. */
static const struct scene_file files[] = {
    { FILE_REFUSED, "species/bad.kfish", "magic: no packed species begins so" },
    { FILE_REFUSED, "species/tancho.kfish",
      "curve 2: knot 5: its weights sum to 1.250000, and not to 1; kingyoctl morph import says in "
      "which line of the text" },
    { FILE_REFUSED, "graphs/wakin.graph:3", "wakin has 5 keys" },
    { FILE_REFUSED, "usb.txt:4", "expected VVVV:PPPP[:SERIAL] and plays or rests" },
    { FILE_REFUSED, "pois/046d-c626.poi:2", "unknown field 'wobble'" },
    { FILE_REFUSED, "/etc/kingyo/kingyo.conf:7", "grade = 9: wrong value; expected 4 to 7" },
    { FILE_ASIDE, "kingyo.db.damaged-1",
      "damaged, and set aside: what could be read took its place" },
    { FILE_SEEN, "kingyo.db.missing-2", "was missing: what could be read took its place" },
    { FILE_USED, "species/funa.kfish", "funa" },
    { FILE_USED, "graphs/hirame.graph", "hirame" },
};
#define FILE_COUNT (sizeof files / sizeof files[0])

/* clang-format off */
static const char *const names[MENU_PAGE_COUNT] = {
    [MENU_TOP] = "top",         [MENU_DEVICES] = "devices",
    [MENU_CONTROLLERS] = "controllers", [MENU_CONTROLLER] = "controller",
    [MENU_LEARN] = "learn",     [MENU_LINES] = "lines",
    [MENU_MONEY] = "money",     [MENU_GAME] = "game",
    [MENU_MODES] = "modes",     [MENU_SOUND] = "sound",
    [MENU_PICTURE] = "picture", [MENU_CARD] = "card", [MENU_UPKEEP] = "upkeep",
    [MENU_FILES] = "files",     [MENU_AXES] = "axes",
    [MENU_CALIBRATION] = "calibration", [MENU_SELF_TEST] = "selftest",
    [MENU_BOOKS] = "books",     [MENU_EARNINGS] = "earnings",
    [MENU_PLAYS] = "plays",     [MENU_HOURS] = "hours",
    [MENU_MACHINE] = "machine", [MENU_RESET] = "reset",
    [MENU_ABOUT] = "about",     [MENU_NEW_PIN] = "newpin",
    [MENU_RESTART] = "restart", [MENU_FACTORY] = "factory",
    [MENU_PIN] = "pin", [MENU_UPDATE] = "update",
    [MENU_RANKING] = "ranking", [MENU_SCORE] = "score",
};
/* clang-format on */

const char *shot_menu_name_of(uint8_t id)
{
    return id < MENU_PAGE_COUNT ? names[id] : NULL;
}

int shot_menu_exists(const char *page, uint8_t step)
{
    for (uint8_t i = 0; i < MENU_PAGE_COUNT; i++) {
        if (names[i] && strcmp(names[i], page) == 0) {
            return step < (i == MENU_LEARN         ? (uint32_t)LEARN_STEP_COUNT
                           : i == MENU_CALIBRATION ? CALIBRATE_STEPS + CALIBRATION_FAULTS
                                                   : CONTROLLER_MAX);
        }
    }
    return 0;
}

/* Sets a few settings to values other than their defaults. */
static void adjust_some(const struct menu_scope *scope)
{
    settings_edit_set(scope, SET_PLAY, PLAY_PAID);
    settings_edit_set(scope, SET_PRICE, 2);
    settings_edit_set(scope, SET_BONUS_UNITS, 5);
    settings_edit_set(scope, SET_MODES, 1 << MODE_FESTIVAL | 1 << MODE_PRACTICE | 1 << CHOICE_LAB);
    settings_edit_set(scope, SET_ROUND_S, 90);
    settings_edit_set(scope, SET_VOLUME, 65);
    settings_edit_set(scope, SET_NIGHT_FROM_MIN, 22 * 60 + 30);
}

/* Fills the audit counters with values that are typical after a summer. */
static void keep_books(struct core *core)
{
    uint32_t *count = core->game.accounts.audits.count;
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        count[id] = 17u + id * id * 31u % 4999u;
    }
    /* The kiosk is open from 10 to 22 o'clock, with most rounds in the late afternoon. */
    for (uint32_t hour = 0; hour < 24u; hour++) {
        count[AUDIT_HOUR + hour] = hour < 10u || hour > 21u ? 0u : (hour - 9u) * (23u - hour) * 9u;
    }
    count[AUDIT_CAUGHT] = 31877;
    count[AUDIT_PLAYERS] = 8211;
    count[AUDIT_PAPERS_TORN] = 7090;
    count[AUDIT_PAPER_LIFE_S] = 180250;
    count[AUDIT_UP_S] = 3600u * 871u;
    count[AUDIT_UP_S_MAX] = 3600u * 14u;
    count[AUDIT_COINS_1] = 1234567;
}

/* Fills the leaderboard with the scores of a festival evening. */
static void rank_some(struct ranking *ranking)
{
    static const char *const guests[] = { "きんぎょ", "KINGYO", "",      "たろうとはなこ",
                                          "マリー",   "A-1",    "さくら" };
    for (uint32_t i = 0; i < sizeof guests / sizeof guests[0]; i++) {
        struct rank_row *row = &ranking->row[MODE_FESTIVAL][RANK_DAY][i];
        *row = (struct rank_row){ .caught = 19u - 2u * i, .round_id = 100u + i };
        snprintf(row->name, sizeof row->name, "%s", guests[i]);
    }
}

/* Opens the calibration at the step `step`. If `step` is beyond the last step, opens the refusal
 * page instead, with the reason that belongs to the number. */
static void calibrate_some(struct calibrate *calibrate, uint8_t step)
{
    calibrate->step = step < CALIBRATE_STEPS ? step : (uint8_t)CALIBRATE_REFUSED;
    calibrate->fault =
        step < CALIBRATE_STEPS ? (uint8_t)CALIBRATION_UNEVEN : (uint8_t)(step - CALIBRATE_STEPS);
    calibrate->has_before = 1;
}

void shot_menu_open(struct core *core, const char *page, uint8_t step, int upright)
{
    struct output output = { 0 };
    struct input input = { .pressed = INPUT_TEST, .upright = upright != 0 };
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        input.controllers.state[i] = found[i].state;
    }
    input.controllers.file_count = FILE_COUNT + 1u;
    input.controllers.update = UPDATE_BUSY;
    core_tick(core, &input, &output);
    struct menu *menu = &core->game.menu;
    rank_some(&core->game.accounts.ranking);
    for (uint8_t i = 0; i < MENU_PAGE_COUNT; i++) {
        if (names[i] && strcmp(names[i], page) == 0) {
            menu_turn(menu, &core->game, &core->config.persistent.settings, (enum menu_page)i);
        }
    }
    if (menu_page_desc_of(menu->page)->body == MENU_BODY_SETTINGS) {
        menu->tag[menu->page] = (uint8_t)(step % menu_body_count(menu->page, false));
    }
    const struct menu_scope scope = menu_scope_of(&core->game, &core->config, &output);
    adjust_some(&scope);
    keep_books(core);
    if (menu->page == MENU_CALIBRATION) {
        calibrate_some(&menu->calibrate, step);
        settings_edit_set(&scope, input_calibration_setting(0), step > CALIBRATE_WATER ? 1 : 0);
    }
    menu->from = MENU_EARNINGS;
    menu->pin = 407;
    menu->pin_count = menu->page == MENU_PIN || menu->page == MENU_NEW_PIN ? 3 : 0;
    const uint32_t first = step * menu_files_shown(upright);
    menu->file_first = (uint8_t)(first < input.controllers.file_count ? first : 0u);
    menu->row = menu->page == MENU_CONTROLLER && step < CONTROLLER_MAX ? step : 0;
    input.controllers.learn_step = menu->page == MENU_LEARN ? step % LEARN_STEP_COUNT : 0;
    input.controllers.learn_progress = 150;
    input.pressed = menu->page == MENU_LINES ? INPUT_LEFT | INPUT_OK : 0;
    input.held = INPUT_LEFT | INPUT_DOOR;
    input.coin_count[0] = menu->page == MENU_LINES || menu->page == MENU_TOP ? 3 : 0;
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].has_wrist = 1;
    input.poi[0].target.position_m = v3(0.12f, 0.06f, 0.10f);
    core_tick(core, &input, &output);
    input.pressed = input.coin_count[0] = 0;
    for (uint32_t i = 0; i < CORE_TICK_HZ / 4u; i++) {
        core_tick(core, &input, &output);
    }
}

/* clang-format off */
static const char *const about[ABOUT_COUNT] = {
    [ABOUT_DISPLAY] = "OpenGL ES 3.1 V3D 7.1, 1920x1080, scene 1x, floor 0.6x, 4 samples",
    [ABOUT_SOUND] = "sound through SDL alsa",
    [ABOUT_STORE] = "/var/lib/kingyo/kingyo.db",
    [ABOUT_CONTROLLERS] = "libusb: 5 controllers, 1 of them play",
    [ABOUT_BUTTONS] = "keyboard: Space starts, arrows choose, 5 6 7 coins, F2 menu, F3 "
                      "service, L language, F11 full screen, Esc quits; three fingers start",
    [ABOUT_SWITCHES] = "libgpiod 1.6.3: 6 of 8 lines; no start, coin (BTN_START is in use by "
                       "'another')",
    [ABOUT_WATCHDOG] = "watchdog: service manager at /run/systemd/notify",
};
/* clang-format on */

void shot_menu_name(struct scene_devices *devices, uint8_t file_first)
{
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (found[i].state != CONTROLLER_NONE) {
            snprintf(devices->controller[i], SCENE_NAME_SIZE, "%s", found[i].name);
        }
    }
    snprintf(devices->controllers, SCENE_LINE_SIZE, "libusb: 5 controllers, 1 of them play");
    snprintf(devices->lines, SCENE_LINE_SIZE,
             "libgpiod 1.6.3: 6 of 8 lines; no start, coin (BTN_START is in use by 'another')");
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        snprintf(devices->about[i], SCENE_LINE_SIZE, "%s", about[i]);
    }
    devices->axes[0] = (struct scene_axes){
        POI_SOURCE_LIVE, { 0.21f, 0.06f, -0.13f }, { 0.6f, -0.3f, 0.1f }, 1000, 2.4f
    };
    devices->axes[1] = (struct scene_axes){
        POI_SOURCE_LIVE, { -0.55f, 0.11f, 0.22f }, { -2.1f, 0.9f, -0.4f }, 125, 214.0f
    };
    devices->axes[2].link = POI_SOURCE_LOST;
    devices->frames_a_second = 60;
    devices->files_refused = 6;
    devices->machine = (struct scene_machine){
        .is_checked = 1,
        .keeps = KEEPS_PROVEN,
        .watch = WATCH_NO_LIMIT,
        .has_backup = 1,
        .backup_min = 7,
        .room_mib = 40,
        .has_heat = 1,
        .heat_margin_c = 21,
        .quarantined = 1,
        .missed = 2,
    };
    devices->update = (struct scene_update){ .step = UPDATE_STEP_WRITING,
                                             .percent = 42,
                                             .name = "Kingyo 0.2.0 (2026-12-01)" };
    devices->line_raw = INPUT_LEFT | INPUT_DOOR | INPUT_TILT;
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT + COIN_LINE_COUNT; i++) {
        devices->line[i] = (struct scene_line){ 4u + i * i * 41u, i % 4u == 3u ? i : 0u };
    }
    devices->button_faults = 2;
    devices->buttons_missing = INPUT_START | 1u << INPUT_BUTTON_COUNT;
    for (uint32_t i = 0; i < SCENE_FILE_MAX; i++) {
        const uint32_t row = file_first + i;
        devices->file[i] = row == 0
                               ? (struct scene_file){ FILE_USED, "", "/var/lib/kingyo/kingyo.db" }
                           : row <= FILE_COUNT ? files[row - 1u]
                                               : (struct scene_file){ .state = FILE_UNKNOWN };
    }
}
