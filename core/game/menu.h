/* menu.h -- the operator's menu: pages of wooden tags, one of which is pointed at.
 *
 * TEST opens it. Then SERVICE, LEFT and RIGHT point, and TEST, START and OK take what is pointed
 * at: the two buttons inside the cabinet suffice. So does a hand over the water, which points where
 * it is and takes by a dip: that of any seat, and the one that moved last. The last tag of each
 * page leads back.
 *
 * While it is open nothing is played and coins are sent back, but on the page that tries the lines:
 * there a coin is a test, which the meter counts and nobody is given a credit for. TEST in a round
 * only asks: it lies where a cleaner's elbow reaches it, and somebody stands there who has paid.
 * Pressed again it ends the round, without a result, since a round that was cut short is neither a
 * score nor a record; what it cost comes back.
 *
 * To add a page: a name in enum menu_page, a row in menu_pages.c that says which page it belongs to
 * and what its tags do, and a row of words in platform/render/ui_menu_words.c. A page that only
 * shows tags for others, or settings of a group, needs no code at all. */
#ifndef KINGYO_CORE_GAME_MENU_H
#define KINGYO_CORE_GAME_MENU_H

#include <stdint.h>

#include "core/game/menu_calibrate.h"
#include "core/game/overlay.h"
#include "core/game/self_test.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define MENU_TAG_MAX 16u /* Of a page: twelve in its body, and four at its foot. */
#define MENU_ASK_TICKS (5u * CORE_TICK_HZ)    /* So long a second TEST ends the round. */
#define MENU_TAKE_TICKS (CORE_TICK_HZ / 10u)  /* Two takes within it are one hand's. */
#define MENU_IDLE_TICKS (300u * CORE_TICK_HZ) /* Left open and forgotten: the stall opens again. */
#define MENU_PIN_IDLE_TICKS (20u * CORE_TICK_HZ) /* The same of who does not know the PIN. */
#define MENU_SWING_SPANS 3u /* So many of such spans without a press, a take or a coin end it, too:
                               what moves all the while is a poi that swings on its cord. */
#define MENU_PIN_DIGITS 4u
#define MENU_COUNT_MAX 9999u                  /* A counter of the lines' page stops there. */

/* Pages of one parent hang there in this order. */
enum menu_page {
    MENU_TOP = 0,
    MENU_DEVICES,     /* Leads to what is plugged in and wired: */
    MENU_CONTROLLERS, /* all that are plugged in, ... */
    MENU_CONTROLLER,  /* ... one of them, ... */
    MENU_LEARN,       /* ... and what it says when it is moved; */
    MENU_LINES,       /* buttons and coins; */
    MENU_AXES,        /* where each poi says that it is, and how often. */
    MENU_CALIBRATION, /* What each says is set right: the tank's corners, water level, tilt. */
    MENU_MONEY,       /* Settings, a group each. */
    MENU_GAME,
    MENU_MODES,       /* Which of them are offered. */
    MENU_SOUND,
    MENU_PICTURE,
    MENU_CARD,        /* A test card over all of the picture. */
    MENU_BOOKS,       /* Leads to the audits: */
    MENU_EARNINGS,
    MENU_PLAYS,
    MENU_HOURS,
    MENU_MACHINE,
    MENU_RESET,       /* a group of them is set to zero. */
    MENU_RANKING,     /* The best of a mode, today, this week or ever, ... */
    MENU_SCORE,       /* ... and one of them: its replay, and a name that must go. */
    MENU_SELF_TEST,   /* Ready for opening? */
    MENU_UPKEEP,      /* Leads to what is seldom needed: */
    MENU_FILES,       /* what was found in the data folder, and what was not fit for use; */
    MENU_ABOUT,       /* versions and devices; */
    MENU_NEW_PIN,
    MENU_RESTART,
    MENU_FACTORY,     /* everything as on the first day. */
    MENU_PIN,         /* Asked for before all others, where one is set. */
    MENU_PAGE_COUNT,
};

/* The tags of pages that have code of their own. */
enum { ROWS_BACK = CONTROLLER_MAX, ROWS_TAGS }; /* Behind one for each controller. */
enum { ROW_CHOOSE = 0, ROW_RELEASE, ROW_LEARN, ROW_BACK, ROW_TAGS };
enum { LEARNS_NEXT = 0, LEARNS_KEEP, LEARNS_AGAIN, LEARNS_END, LEARNS_TAGS };
enum { LINES_BACK = 0, LINES_TAGS };
enum { CALIBRATE_NEXT = 0, CALIBRATE_BEGIN, CALIBRATE_UNDO, CALIBRATE_NONE, CALIBRATE_BACK,
       CALIBRATE_TAGS };
enum { SELF_YES = 0, SELF_NO, SELF_AGAIN, SELF_BACK, SELF_TAGS };
enum { RANKING_NEXT = SCENE_BOARD_ROWS, RANKING_BACK, RANKING_TAGS }; /* Behind one a row. */
enum { SCORE_REPLAY = 0, SCORE_UNNAME, SCORE_SURE, SCORE_BACK, SCORE_TAGS };
enum { FILES_MORE = 0, FILES_SEEN, FILES_BACK, FILES_TAGS };
enum { BOOK_RESET = 0, BOOK_BACK, BOOK_TAGS };
enum { SURE_YES = 0, SURE_BACK, SURE_TAGS }; /* Of what is asked twice; it points at the second. */
enum { PIN_ERASE = 10, PIN_BACK, PIN_TAGS }; /* Behind a key for each digit: 1, 2 .. 9, 0. */

/* The feet of pages of settings, behind one for each setting and for each page of theirs. */
enum { SETTINGS_DIRECTION = 0, SETTINGS_STANDARD, SETTINGS_BACK, SETTINGS_FEET };

struct menu {
    uint8_t page;    /* enum menu_page */
    uint8_t chosen;  /* On a page of settings: the row that was turned last; MENU_TAG_MAX: none. */
    uint8_t turns_down; /* There a take turns a value down, not up. */
    uint8_t turning; /* Since it was taken TEST, or the poi, has not come up: it turns on. */
    uint8_t from;    /* The page that asked whether to reset. */
    uint8_t pin_count; /* Digits of a PIN that were typed so far, ... */
    uint16_t pin;    /* ... and those digits. */
    uint8_t turn_count; /* How often it turned on, .. 255, and ... */
    uint32_t turn_tick; /* ... when it was turned last. */
    uint8_t row;     /* Of the controller that is dealt with. */
    uint8_t upright; /* As the last input said. */
    uint8_t file_first; /* The first row that the files' page shows. */
    uint8_t board;   /* Of the ranking: its mode * RANK_PERIOD_COUNT + its period; ... */
    uint8_t score;   /* ... the row that is dealt with, ... */
    uint8_t score_is_named, score_asks; /* ... whether it has a name, and that is to go; ... */
    uint16_t scores; /* ... and those that somebody is in, a bit each. */
    uint8_t has_hand, hand, presses;
    uint8_t points;  /* The tag under the hand, from 1; 0: none. */
    uint8_t tag[MENU_PAGE_COUNT]; /* Which is pointed at on each page. */
    struct desk_input desk;       /* As the last input said. */
    uint16_t pressed_count[INPUT_BUTTON_COUNT]; /* Since it was opened. */
    uint32_t held;
    uint32_t test_coins, coin_tick; /* Those that fell on the lines' page. */
    uint32_t order_count;
    uint32_t ask_tick;  /* When TEST was pressed in a round; 0: it was not. */
    uint32_t take_tick; /* When a tag was taken last, ... */
    uint32_t act_tick;  /* ... when anybody last did anything, ... */
    uint32_t use_tick;  /* ... and when it was more than to move a hand. */
    float x, y;         /* The hand, on the canvas; ... */
    struct calibrate calibrate;
    struct self_test self;
    struct overlay_point rest[POI_MAX]; /* ... and where each last moved on from. */
};

struct core;

/* Whether TEST opens the menu in this very tick; in a round, it asks first. */
int menu_opens(struct core *core, const struct input *input, struct output *output);
void menu_tick(struct core *core, const struct input *input, struct output *output);

/* Whether a second TEST would end the round now. */
int menu_is_asking(const struct core *core);

/* Whether the lines are looked at: the slot is open, and a coin is a test of it. */
int menu_tries_lines(const struct core *core);

/* While the lines are looked at, the start button's lamp is lit by its button. */
int menu_lights_start(const struct core *core);

/* After a wrong PIN none is taken for so long: 5 s, and twice as long after each further one, up to
 * 160 s. 0: one is. */
uint32_t menu_pin_wait_ticks(const struct core *core);

/* Rows of the files' page that are seen at once, with the words of each in full. */
uint32_t menu_files_shown(int upright);

/* What there is to see of it. */
void menu_show(const struct core *core, struct scene_menu *out);

uint64_t menu_hash(uint64_t hash, const struct menu *menu);

#endif
