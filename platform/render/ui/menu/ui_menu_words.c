/* ui_menu_words.c -- tables with the texts of the operator's pages and settings. Each page and each
 * setting has one row. */
#include "platform/render/ui/menu/ui_menu.h"

#define BACK TEXT_MENU_BACK
#define RESETS { TEXT_FOOT_RESET, BACK }
#define SURE { TEXT_FOOT_SURE, BACK }
#define KEYS { TEXT_FOOT_ERASE, BACK }
#define TURNS { TEXT_FOOT_UP, TEXT_FOOT_STANDARD, BACK }

static const struct menu_words pages[MENU_PAGE_COUNT] = {
    [MENU_TOP] = { .title = TEXT_MENU, .foot = { TEXT_MENU_LEAVE } },
    [MENU_DEVICES] = { .title = TEXT_PAGE_DEVICES, .about = TEXT_ABOUT_DEVICES, .foot = { BACK } },
    [MENU_CONTROLLERS] = { .title = TEXT_PAGE_CONTROLLERS, .about = TEXT_ABOUT_CONTROLLERS,
                           .foot = { BACK }, .draw = menu_rows },
    [MENU_CONTROLLER] = {
        .title = TEXT_PAGE_CONTROLLERS,
        .names = { [ROW_CHOOSE] = TEXT_ROW_CHOOSE, [ROW_RELEASE] = TEXT_ROW_RELEASE,
                   [ROW_LEARN] = TEXT_ROW_LEARN },
        .lines = { [ROW_CHOOSE] = TEXT_ROW_CHOOSE_WORDS, [ROW_RELEASE] = TEXT_ROW_RELEASE_WORDS,
                   [ROW_LEARN] = TEXT_ROW_LEARN_WORDS },
        .foot = { BACK },
        .draw = menu_one_controller,
    },
    [MENU_LEARN] = { .title = TEXT_ROW_LEARN,
                     .foot = { TEXT_LEARNS_NEXT, TEXT_LEARNS_KEEP, TEXT_LEARNS_AGAIN,
                               TEXT_LEARNS_END },
                     .draw = menu_learning },
    [MENU_LINES] = { .title = TEXT_PAGE_LINES, .about = TEXT_ABOUT_LINES, .foot = { BACK },
                     .draw = menu_lines },
    [MENU_MONEY] = { .title = TEXT_PAGE_MONEY, .about = TEXT_ABOUT_MONEY, .foot = TURNS },
    [MENU_GAME] = { .title = TEXT_PAGE_GAME, .about = TEXT_ABOUT_GAME, .foot = TURNS },
    [MENU_MODES] = { .title = TEXT_PAGE_MODES, .about = TEXT_ABOUT_MODES, .foot = { BACK } },
    [MENU_SOUND] = { .title = TEXT_PAGE_SOUND, .about = TEXT_ABOUT_SOUND, .foot = TURNS },
    [MENU_PICTURE] = { .title = TEXT_PAGE_PICTURE, .about = TEXT_ABOUT_PICTURE, .foot = TURNS },
    [MENU_CARD] = { .title = TEXT_PAGE_CARD, .about = TEXT_ABOUT_CARD, .foot = { BACK },
                    .draw = menu_card, .is_whole = true },
    [MENU_AXES] = { .title = TEXT_PAGE_AXES, .about = TEXT_ABOUT_AXES, .foot = { BACK },
                    .draw = menu_axes },
    [MENU_CALIBRATION] = {
        .title = TEXT_PAGE_CALIBRATION, .about = TEXT_ABOUT_CALIBRATION,
        .foot = { TEXT_CALIBRATE_NEXT, TEXT_CALIBRATE_BEGIN, TEXT_CALIBRATE_UNDO,
                  TEXT_CALIBRATE_NONE, BACK },
        .draw = menu_calibration,
    },
    [MENU_BOOKS] = { .title = TEXT_PAGE_BOOKS, .about = TEXT_ABOUT_BOOKS, .foot = { BACK } },
    [MENU_EARNINGS] = { .title = TEXT_PAGE_EARNINGS, .about = TEXT_ABOUT_EARNINGS, .foot = RESETS,
                        .draw = menu_earnings },
    [MENU_PLAYS] = { .title = TEXT_PAGE_PLAYS, .about = TEXT_ABOUT_PLAYS, .foot = RESETS,
                     .draw = menu_plays },
    [MENU_HOURS] = { .title = TEXT_PAGE_HOURS, .about = TEXT_ABOUT_HOURS, .foot = RESETS,
                     .draw = menu_hours },
    [MENU_MACHINE] = { .title = TEXT_PAGE_MACHINE, .about = TEXT_ABOUT_MACHINE, .foot = RESETS,
                       .draw = menu_machine },
    [MENU_RESET] = { .title = TEXT_PAGE_RESET, .foot = SURE, .draw = menu_confirm },
    [MENU_RANKING] = { .title = TEXT_PAGE_RANKING, .about = TEXT_ABOUT_RANKING,
                       .foot = { TEXT_RANKING_NEXT, BACK }, .draw = menu_ranking },
    [MENU_SCORE] = {
        .title = TEXT_PAGE_RANKING,
        .names = { [SCORE_REPLAY] = TEXT_SCORE_REPLAY, [SCORE_UNNAME] = TEXT_SCORE_UNNAME,
                   [SCORE_CONFIRM] = TEXT_SCORE_SURE },
        .lines = { [SCORE_REPLAY] = TEXT_SCORE_REPLAY_WORDS,
                   [SCORE_UNNAME] = TEXT_SCORE_UNNAME_WORDS,
                   [SCORE_CONFIRM] = TEXT_SCORE_SURE_WORDS },
        .foot = { BACK },
        .draw = menu_score,
    },
    [MENU_SELF_TEST] = { .title = TEXT_PAGE_SELF_TEST, .about = TEXT_ABOUT_SELF_TEST,
                         .foot = { TEXT_SELF_YES, TEXT_SELF_NO, TEXT_SELF_AGAIN, BACK },
                         .draw = menu_self_test },
    [MENU_UPKEEP] = { .title = TEXT_PAGE_UPKEEP, .about = TEXT_ABOUT_UPKEEP, .foot = { BACK } },
    [MENU_FILES] = { .title = TEXT_PAGE_FILES, .about = TEXT_ABOUT_FILES,
                     .foot = { TEXT_FILES_MORE, TEXT_FILES_SEEN, BACK }, .draw = menu_files },
    [MENU_ABOUT] = { .title = TEXT_PAGE_ABOUT, .about = TEXT_ABOUT_ABOUT, .foot = { BACK },
                     .draw = menu_about },
    [MENU_NEW_PIN] = { .title = TEXT_PAGE_PIN, .about = TEXT_ABOUT_PIN, .foot = KEYS,
                       .draw = menu_pin },
    [MENU_RESTART] = { .title = TEXT_PAGE_RESTART, .about = TEXT_ABOUT_RESTART, .foot = SURE,
                       .draw = menu_confirm },
    [MENU_FACTORY] = { .title = TEXT_PAGE_FACTORY, .about = TEXT_ABOUT_FACTORY, .foot = SURE,
                       .draw = menu_confirm },
    [MENU_UPDATE] = { .title = TEXT_PAGE_UPDATE, .about = TEXT_ABOUT_UPDATE,
                      .foot = { TEXT_FOOT_UPDATE, BACK }, .draw = menu_update },
    [MENU_PIN] = { .title = TEXT_PAGE_PIN, .foot = { TEXT_FOOT_ERASE, TEXT_MENU_LEAVE },
                   .draw = menu_pin },
};

static const struct setting_words settings[SETTING_COUNT] = {
    [SET_PLAY] = { TEXT_SET_PLAY, TEXT_HELP_PLAY,
                   .choices = { TEXT_OPT_FREE, TEXT_OPT_PAID, TEXT_OPT_EVENT } },
    [SET_PRICE] = { TEXT_SET_PRICE, TEXT_HELP_PRICE, .unit = TEXT_VAL_WORTH },
    [SET_COIN_1] = { TEXT_SET_COIN_1, TEXT_HELP_COIN_1, .unit = TEXT_VAL_WORTH },
    [SET_COIN_2] = { TEXT_SET_COIN_2, TEXT_HELP_COIN_2, .unit = TEXT_VAL_WORTH },
    [SET_COIN_3] = { TEXT_SET_COIN_3, TEXT_HELP_COIN_3, .unit = TEXT_VAL_WORTH },
    [SET_BONUS_UNITS] = { TEXT_SET_BONUS_UNITS, TEXT_HELP_BONUS_UNITS, .unit = TEXT_VAL_WORTH,
                          .zero = TEXT_VAL_NONE },
    [SET_BONUS_CREDITS] = { TEXT_SET_BONUS_CREDITS, TEXT_HELP_BONUS_CREDITS,
                            .unit = TEXT_VAL_CREDITS },
    [SET_CREDIT_MAX] = { TEXT_SET_CREDIT_MAX, TEXT_HELP_CREDIT_MAX, .unit = TEXT_VAL_CREDITS },
    [SET_CREDIT_EXPIRY_MIN] = { TEXT_SET_CREDIT_EXPIRY, TEXT_HELP_CREDIT_EXPIRY,
                                .unit = TEXT_VAL_MINUTES, .zero = TEXT_VAL_FOREVER },
    [SET_TICKET_FISH] = { TEXT_SET_TICKET_FISH, TEXT_HELP_TICKET_FISH, .unit = TEXT_VAL_TICKET,
                          .zero = TEXT_VAL_NONE },
    [SET_MODES] = { TEXT_SET_MODES, TEXT_HELP_MODES,
                    .choices = { TEXT_FESTIVAL, TEXT_CHAMPIONSHIP, TEXT_PRACTICE, TEXT_LAB } },
    [SET_GRADE] = { TEXT_SET_GRADE, TEXT_HELP_GRADE, .unit = TEXT_VAL_GRADE,
                    .zero = TEXT_VAL_MODES_OWN },
    [SET_ROUND_S] = { TEXT_SET_ROUND, TEXT_HELP_ROUND, .unit = TEXT_VAL_SECONDS,
                      .zero = TEXT_VAL_MODES_OWN },
    [SET_FISH] = { TEXT_SET_FISH, TEXT_HELP_FISH, .unit = TEXT_VAL_FISH,
                   .zero = TEXT_VAL_TANKS_OWN },
    [SET_PLAYERS] = { TEXT_SET_PLAYERS, TEXT_HELP_PLAYERS, .unit = TEXT_VAL_PLAYERS },
    [SET_LANGUAGE] = { TEXT_SET_LANGUAGE, TEXT_HELP_LANGUAGE,
                       .choices = { TEXT_OPT_JA, TEXT_OPT_EN } },
    [SET_NAMES] = { TEXT_SET_NAMES, TEXT_HELP_NAMES, .choices = { TEXT_OPT_NO, TEXT_OPT_YES } },
    [SET_VOLUME] = { TEXT_SET_VOLUME, TEXT_HELP_VOLUME, .unit = TEXT_VAL_PER_CENT },
    [SET_ATTRACT_SOUND] = { TEXT_SET_ATTRACT_SOUND, TEXT_HELP_ATTRACT_SOUND, .unit = TEXT_VAL_LOOP,
                            .zero = TEXT_VAL_SILENT, .one = TEXT_VAL_EVERY_LOOP },
    [SET_ROTATION] = { TEXT_SET_ROTATION, TEXT_HELP_ROTATION,
                       .choices = { TEXT_OPT_TURN_0, TEXT_OPT_TURN_90, TEXT_OPT_TURN_180,
                                    TEXT_OPT_TURN_270 } },
    [SET_OVERSCAN_X] = { TEXT_SET_OVERSCAN_X, TEXT_HELP_OVERSCAN_X, .unit = TEXT_VAL_PER_MILLE },
    [SET_OVERSCAN_Y] = { TEXT_SET_OVERSCAN_Y, TEXT_HELP_OVERSCAN_Y, .unit = TEXT_VAL_PER_MILLE },
    [SET_BRIGHTNESS] = { TEXT_SET_BRIGHTNESS, TEXT_HELP_BRIGHTNESS, .unit = TEXT_VAL_PER_CENT },
    [SET_DIM] = { TEXT_SET_DIM, TEXT_HELP_DIM, .unit = TEXT_VAL_PER_CENT },
    [SET_DIM_AFTER_MIN] = { TEXT_SET_DIM_AFTER, TEXT_HELP_DIM_AFTER, .unit = TEXT_VAL_MINUTES,
                            .zero = TEXT_VAL_NEVER },
    [SET_NIGHT_FROM_MIN] = { TEXT_SET_NIGHT_FROM, TEXT_HELP_NIGHT_FROM, .choices = { 0 } },
    [SET_NIGHT_TO_MIN] = { TEXT_SET_NIGHT_TO, TEXT_HELP_NIGHT_TO, .choices = { 0 } },
    [SET_LEVEL] = { TEXT_SET_LEVEL, TEXT_HELP_LEVEL,
                    .choices = { TEXT_LEVEL_NORMAL, TEXT_LEVEL_EASY, TEXT_LEVEL_MASTER } },
    [SET_DIP] = { TEXT_SET_DIP, TEXT_HELP_DIP,
                  .choices = { TEXT_OPT_DIP_HOLD, TEXT_OPT_DIP_CLICK } },
    [SET_REACH] = { TEXT_SET_REACH, TEXT_HELP_REACH, .unit = TEXT_VAL_PER_CENT,
                    .zero = TEXT_VAL_WHOLE },
    [SET_SIDE] = { TEXT_SET_SIDE, TEXT_HELP_SIDE,
                   .choices = { TEXT_OPT_SIDE_DIP, TEXT_OPT_SIDE_RIGHT, TEXT_OPT_SIDE_LEFT } },
    [SET_TEXT] = { TEXT_SET_TEXT, TEXT_HELP_TEXT,
                   .choices = { TEXT_OPT_TEXT_NORMAL, TEXT_OPT_TEXT_LARGE,
                                TEXT_OPT_TEXT_LARGEST } },
};

const struct menu_words *menu_words_of(uint8_t page)
{
    return &pages[page < MENU_PAGE_COUNT ? page : (uint8_t)MENU_TOP];
}

/* Returns the texts of a setting. Returns the texts of setting 0 for the calibration settings and
 * the PIN, which have no texts because the menu never shows them as numbers. */
const struct setting_words *menu_setting_words_of(uint32_t id)
{
    return &settings[id < SETTING_COUNT && settings[id].name ? id : 0u];
}
