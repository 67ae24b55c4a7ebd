/* menu.h -- the operator's menu: pages of items drawn as wooden tags. One item is highlighted.
 *
 * TEST opens the menu. In the menu, SERVICE, LEFT and RIGHT move the highlight. TEST, START and OK
 * select the highlighted item. The two buttons inside the cabinet (TEST and SERVICE) are therefore
 * sufficient. A poi over the water also moves the highlight, and a dip selects. The poi of any slot
 * can be used; the poi that moved last controls the highlight. The last item of each page leads
 * back.
 *
 * While the menu is open no game is played and coins are returned, except on the page that tests
 * the input lines. On that page the meter counts a coin as a test, without a credit. TEST during a
 * round only requests confirmation, because the button is easy to press by accident and the player
 * has paid. A second press ends the round and refunds its credit. A refunded round is neither a
 * score nor a record.
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
#define MENU_ASK_TICKS (5u * CORE_TICK_HZ) /* Time in which a second TEST press ends the round. */
/* Time after a selection in which a second selection is ignored. */
#define MENU_TAKE_TICKS (CORE_TICK_HZ / 10u)
/* Time without activity after which an open menu closes. */
#define MENU_IDLE_TICKS (300u * CORE_TICK_HZ)
/* Time without activity after which the menu closes on the PIN page. */
#define MENU_PIN_IDLE_TICKS (20u * CORE_TICK_HZ)
/* Number of timeouts without a press, a selection or a coin after which the menu also closes.
 * Motion that lasts longer without any press comes from a poi that swings on its cord. */
#define MENU_SWING_SPANS 3u
#define MENU_PIN_DIGITS 4u
/* Upper limit of each counter on the page of the input lines. */
#define MENU_COUNT_MAX 9999u

/* Pages of the menu. Pages with the same parent are listed in the order of the enum. */
enum menu_page {
    MENU_TOP = 0,
    MENU_DEVICES,     /* List of the pages about devices and wiring. */
    MENU_CONTROLLERS, /* Page of all plugged-in controllers. */
    MENU_CONTROLLER,  /* Page of one controller. */
    MENU_LEARN,       /* Page of the learn wizard of a controller. */
    MENU_LINES,       /* Test of the buttons and the coin lines. */
    MENU_AXES,        /* Reported pose and report rate of each poi. */
    MENU_CALIBRATION, /* Calibration: corners of the tank, water level and tilt of each slot. */
    MENU_MONEY,       /* First of the settings pages, one for each group of settings. */
    MENU_GAME,
    MENU_MODES, /* Selection of the modes that players can choose. */
    MENU_SOUND,
    MENU_PICTURE,
    MENU_CARD,  /* Test picture that covers the whole screen. */
    MENU_BOOKS, /* List of the pages with statistics. */
    MENU_EARNINGS,
    MENU_PLAYS,
    MENU_HOURS,
    MENU_MACHINE,
    MENU_RESET,     /* Confirmation of a reset of a group of statistics. */
    MENU_RANKING,   /* Leaderboard of a mode: today, this week, or all time. */
    MENU_SCORE,     /* One score, with its replay and the removal of its name. */
    MENU_SELF_TEST, /* Self-test before the kiosk opens. */
    MENU_UPKEEP,    /* List of rarely needed pages. */
    MENU_FILES,     /* List of the files found in the data folder, and of the rejected files. */
    MENU_ABOUT,     /* Versions of the software and names of the devices. */
    MENU_NEW_PIN,
    MENU_RESTART,
    MENU_FACTORY, /* Factory reset. */
    MENU_PIN,     /* PIN entry before all other pages, if a PIN is set. */
    MENU_PAGE_COUNT,
};

/* Items of the pages that have code of their own. On the page of all
 * controllers, the items of the first enum follow one item for each controller. */
enum { ROWS_BACK = CONTROLLER_MAX, ROWS_TAGS };
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
}; /* On the leaderboard page, these items follow one item for each row. */
enum { SCORE_REPLAY = 0, SCORE_UNNAME, SCORE_CONFIRM, SCORE_BACK, SCORE_TAGS };
enum { FILES_MORE = 0, FILES_SEEN, FILES_BACK, FILES_TAGS };
enum { BOOK_RESET = 0, BOOK_BACK, BOOK_TAGS };
enum {
    CONFIRM_YES = 0,
    CONFIRM_BACK,
    CONFIRM_TAGS
}; /* Items of a page that requests confirmation. The second item is highlighted first. */
enum {
    PIN_ERASE = 10,
    PIN_BACK,
    PIN_TAGS
}; /* On the PIN page, these items follow the digit keys 1, 2 .. 9, 0. */

/* Items at the foot of a settings page. The items follow one item for each setting and each
 * subpage. */
enum { SETTINGS_DIRECTION = 0, SETTINGS_STANDARD, SETTINGS_BACK, SETTINGS_FEET };

struct menu {
    uint8_t page;       /* Open page (enum menu_page). */
    uint8_t chosen;     /* On a settings page: the row that was changed last; MENU_TAG_MAX means
                           none. */
    uint8_t turns_down; /* 1 if selecting an item on a settings page lowers its value, 0 if
                           selecting raises the value. */
    uint8_t turning;    /* 1 while the button or poi that selected a setting is still pressed, so
                           the value keeps changing; otherwise 0. */
    uint8_t from;       /* Page that requested confirmation of a reset. */
    uint8_t pin_count;  /* Number of PIN digits typed so far. */
    uint16_t pin;       /* PIN digits typed so far, as a number. */
    uint8_t turn_count; /* Number of automatic repeats of the current change, up to 255. */
    uint32_t turn_tick; /* Tick of the last change of a value. */
    uint8_t row;        /* Row of the selected controller on the controller page. */
    uint8_t upright;    /* 1 if the last input reported a portrait screen, otherwise 0. */
    uint8_t file_first; /* First row that the file page shows. */
    uint8_t board;      /* Selected leaderboard: the mode's number * RANK_PERIOD_COUNT + the
                           period's number. */
    uint8_t score;      /* Selected row of the leaderboard. */
    uint8_t score_is_named, score_asks; /* score_is_named is 1 if the selected row has a name.
                                           score_asks is 1 while the removal of the name waits for
                                           confirmation. */
    uint16_t scores;                    /* Bit mask of the leaderboard rows that have a score. */
    uint8_t has_hand, hand, presses;
    uint8_t points;                             /* Item under the pointer, from 1; 0 means none. */
    uint8_t tag[MENU_PAGE_COUNT];               /* Highlighted item of each page. */
    struct controller_status controllers;       /* State of the controllers, from the last input. */
    uint16_t pressed_count[INPUT_BUTTON_COUNT]; /* Presses of each button since the menu was
                                                   opened. */
    uint32_t held;
    uint32_t test_coins, coin_tick; /* Number of test coins, and tick of the last one. */
    uint32_t command_count;
    uint32_t ask_tick;  /* Tick of a TEST press during a round; 0 means none. */
    uint32_t take_tick; /* Tick of the last selection. */
    uint32_t act_tick;  /* Tick of the last activity. */
    uint32_t use_tick;  /* Tick of the last activity other than pointer motion. */
    float x, y;         /* Pointer position on the canvas. */
    struct calibrate calibrate;
    struct self_test self;
    struct layout_point rest[POI_MAX]; /* Pointer position of each slot at its last motion. */
};

struct game;
struct settings_edit;
struct world;
struct core_config;

/* Returns 1 if TEST opens the menu in this tick, otherwise 0. During a round the first press only
 * requests confirmation. */
int menu_opens(struct game *game, struct world *world, const struct core_config *config,
               const struct input *input, struct output *output);
void menu_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output);

/* Returns 1 if a second TEST press would end the round in this tick, otherwise 0. */
int menu_is_asking(const struct game *game);

/* Returns 1 while the input lines are tested, otherwise 0. During the test the coin slot is open,
 * and a coin counts as a test. */
int menu_tries_lines(const struct game *game);

/* Returns 1 if the menu lights the START lamp, otherwise 0. The lamp is lit while
 * self_test_shows() returns 1, and while START is held during the test of the input lines. */
int menu_lights_start(const struct game *game);

/* Returns the ticks until a PIN can be typed; 0 means immediately. A wrong PIN locks the entry for
 * 5 s. Each further wrong PIN doubles the time, up to 160 s. */
uint32_t menu_pin_wait_ticks(const struct settings_edit *settings_edit, uint32_t tick);

/* Returns the number of rows that the file page shows with their full text. `upright` is 1 on a
 * portrait screen. */
uint32_t menu_files_shown(int upright);

/* Fills `out` with the visible state of the menu. */
void menu_show(const struct game *game, const struct core_config *config, struct scene_menu *out);

uint64_t menu_hash(uint64_t hash, const struct menu *menu);

#endif
