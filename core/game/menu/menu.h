/* menu.h -- the operator's menu: pages of items drawn as wooden tags, one of which is highlighted.
 *
 * TEST opens the menu. Then SERVICE, LEFT and RIGHT move the highlight, and TEST, START and OK
 * select the highlighted item, so the two buttons inside the cabinet suffice. A poi over the water
 * also moves the highlight, and a dip selects. The poi of any slot can be used; the one that moved
 * last counts. The last item of each page leads back.
 *
 * While the menu is open no game is played and coins are returned. The exception is the page that
 * tests the input lines: there the meter counts a coin as a test, without a credit. TEST during a
 * round only requests confirmation, because the button is easy to press by accident and the player
 * has paid. A second press ends the round and refunds its credit. Such a round is neither a score
 * nor a record.
 *
 * To add a page, add a name to enum menu_page, a row in menu_pages.c with its parent and actions,
 * and a row of texts in platform/render/ui/menu/ui_menu_words.c. A page that only lists other
 * pages, or a group of settings, needs no code. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_H
#define KINGYO_CORE_GAME_MENU_MENU_H

#include <stdint.h>

#include "core/game/menu/menu_calibrate.h"
#include "core/game/menu/self_test.h"
#include "core/game/pointer_mapping.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

/* Largest number of items on a page: twelve in its body and four at its foot. */
#define MENU_TAG_MAX 16u
#define MENU_ASK_TICKS (5u * CORE_TICK_HZ)   /* Time within which a second TEST ends the round. */
#define MENU_TAKE_TICKS (CORE_TICK_HZ / 10u) /* Two selections within this time count as one. */
/* Time without activity after which an open menu closes. */
#define MENU_IDLE_TICKS (300u * CORE_TICK_HZ)
/* Time without activity after which the menu closes on the PIN page. */
#define MENU_PIN_IDLE_TICKS (20u * CORE_TICK_HZ)
/* Number of timeouts without a press, a selection or a coin after which the menu also closes.
 * Constant motion alone comes from a poi that swings on its cord. */
#define MENU_SWING_SPANS 3u
#define MENU_PIN_DIGITS 4u
/* Upper limit of a counter on the page of the input lines. */
#define MENU_COUNT_MAX 9999u

/* Pages with the same parent are listed in this order. */
enum menu_page {
    MENU_TOP = 0,
    MENU_DEVICES,     /* List of the pages about devices and wiring. */
    MENU_CONTROLLERS, /* All plugged-in controllers. */
    MENU_CONTROLLER,  /* One controller. */
    MENU_LEARN,       /* The learn wizard of a controller. */
    MENU_LINES,       /* Test of buttons and coins. */
    MENU_AXES,        /* Reported pose and report rate of each poi. */
    MENU_CALIBRATION, /* Calibration: corners of the tank, water level and tilt of each slot. */
    MENU_MONEY,       /* Pages of settings, one per group. */
    MENU_GAME,
    MENU_MODES, /* Modes on offer. */
    MENU_SOUND,
    MENU_PICTURE,
    MENU_CARD,  /* Test card over the whole picture. */
    MENU_BOOKS, /* List of the pages with statistics. */
    MENU_EARNINGS,
    MENU_PLAYS,
    MENU_HOURS,
    MENU_MACHINE,
    MENU_RESET,     /* Confirmation of a reset of a group of statistics. */
    MENU_RANKING,   /* Leaderboard of a mode: today, this week, or ever. */
    MENU_SCORE,     /* One score: its replay, and removal of its name. */
    MENU_SELF_TEST, /* Self-test before opening. */
    MENU_UPKEEP,    /* List of rarely needed pages. */
    MENU_FILES,     /* Files found in the data folder, and rejected files. */
    MENU_ABOUT,     /* Versions and devices. */
    MENU_NEW_PIN,
    MENU_RESTART,
    MENU_FACTORY, /* Factory reset. */
    MENU_PIN,     /* PIN entry before all other pages, if a PIN is set. */
    MENU_PAGE_COUNT,
};

/* Items of pages that have code of their own. */
enum {
    ROWS_BACK = CONTROLLER_MAX,
    ROWS_TAGS
}; /* These items follow one item for each controller. */
enum { ROW_CHOOSE = 0, ROW_RELEASE, ROW_LEARN, ROW_BACK, ROW_TAGS };
enum { LEARNS_NEXT = 0, LEARNS_KEEP, LEARNS_AGAIN, LEARNS_END, LEARNS_TAGS };
enum { LINES_BACK = 0, LINES_TAGS };
enum {
    CALIBRATE_NEXT = 0,
    CALIBRATE_BEGIN,
    CALIBRATE_UNDO,
    CALIBRATE_NONE,
    CALIBRATE_BACK,
    CALIBRATE_TAGS
};
enum { SELF_YES = 0, SELF_NO, SELF_AGAIN, SELF_BACK, SELF_TAGS };
enum {
    RANKING_NEXT = SCENE_LEADERBOARD_ROWS,
    RANKING_BACK,
    RANKING_TAGS
}; /* These items follow one item for each row. */
enum { SCORE_REPLAY = 0, SCORE_UNNAME, SCORE_CONFIRM, SCORE_BACK, SCORE_TAGS };
enum { FILES_MORE = 0, FILES_SEEN, FILES_BACK, FILES_TAGS };
enum { BOOK_RESET = 0, BOOK_BACK, BOOK_TAGS };
enum {
    CONFIRM_YES = 0,
    CONFIRM_BACK,
    CONFIRM_TAGS
}; /* Items of a confirmation; the second item is highlighted first. */
enum {
    PIN_ERASE = 10,
    PIN_BACK,
    PIN_TAGS
}; /* These items follow one key for each digit: 1, 2 .. 9, 0. */

/* Foot items of settings pages, after one item for each setting and each subpage. */
enum { SETTINGS_DIRECTION = 0, SETTINGS_STANDARD, SETTINGS_BACK, SETTINGS_FEET };

struct menu {
    uint8_t page;       /* enum menu_page */
    uint8_t chosen;     /* On a settings page: the row that was changed last; MENU_TAG_MAX: none. */
    uint8_t turns_down; /* 1: selecting an item on a settings page lowers its value; 0: raises the
                           value. */
    uint8_t turning; /* 1 while the button or poi that selected a setting is still pressed, so that
                        the value keeps changing. */
    uint8_t from;    /* Page that requested confirmation of a reset. */
    uint8_t pin_count;  /* Number of PIN digits typed so far. */
    uint16_t pin;       /* PIN digits typed so far, as a number. */
    uint8_t turn_count; /* Number of automatic repeats, up to 255. */
    uint32_t turn_tick; /* Tick of the last change of a value. */
    uint8_t row;        /* Row of the selected controller. */
    uint8_t upright;    /* 1: portrait screen, from the last input. */
    uint8_t file_first; /* First row that the file page shows. */
    uint8_t board;      /* Selected leaderboard: its mode * RANK_PERIOD_COUNT + its period. */
    uint8_t score;      /* Selected row of the leaderboard. */
    uint8_t score_is_named, score_asks; /* score_is_named: the row has a name. score_asks: removal
                                           of the name waits for confirmation. */
    uint16_t scores;                    /* Bit mask of the leaderboard rows that have a score. */
    uint8_t has_hand, hand, presses;
    uint8_t points;                             /* Item under the pointer, from 1; 0: none. */
    uint8_t tag[MENU_PAGE_COUNT];               /* Highlighted item of each page. */
    struct controller_status controllers;       /* State of the controllers, from the last input. */
    uint16_t pressed_count[INPUT_BUTTON_COUNT]; /* Presses of each button since the menu was
                                                   opened. */
    uint32_t held;
    uint32_t test_coins, coin_tick; /* Number of test coins, and tick of the last one. */
    uint32_t command_count;
    uint32_t ask_tick;  /* Tick of a TEST press during a round; 0: none. */
    uint32_t take_tick; /* Tick of the last selection. */
    uint32_t act_tick;  /* Tick of the last activity. */
    uint32_t use_tick;  /* Tick of the last activity other than motion. */
    float x, y;         /* Pointer position on the canvas. */
    struct calibrate calibrate;
    struct self_test self;
    struct layout_point rest[POI_MAX]; /* Pointer position of each slot at its last motion. */
};

struct game;
struct settings_edit;
struct world;
struct core_config;

/* Returns 1 if TEST opens the menu in this tick. During a round the first press only requests
 * confirmation. */
int menu_opens(struct game *game, struct world *world, const struct core_config *config,
               const struct input *input, struct output *output);
void menu_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output);

/* Returns 1 if a second TEST would end the round now. */
int menu_is_asking(const struct game *game);

/* Returns 1 if the input lines are tested: the coin slot is open, and a coin counts as a test. */
int menu_tries_lines(const struct game *game);

/* Returns 1 if the START lamp is lit; during the test of the input lines the START button lights
 * it. */
int menu_lights_start(const struct game *game);

/* Returns the ticks until a PIN can be typed; 0: now. A wrong PIN locks the entry for 5 s, and each
 * further one doubles the time, up to 160 s. */
uint32_t menu_pin_wait_ticks(const struct settings_edit *settings_edit, uint32_t tick);

/* Returns the number of rows visible at once on the file page, with the full text of each row. */
uint32_t menu_files_shown(int upright);

/* Fills `out` with the visible state of the menu. */
void menu_show(const struct game *game, const struct core_config *config, struct scene_menu *out);

uint64_t menu_hash(uint64_t hash, const struct menu *menu);

#endif
