/* menu_state.h -- the state of the operator's menu, of its calibration page and of its self-test
 * page. The functions are in menu.h. */
#pragma once

#include <stdint.h>

#include "core/game/control/input_pose.h"
#include "core/game/pointer_mapping.h"
#include "core/input.h"
#include "core/scene.h"

#define CALIBRATE_STILL_TICKS (CORE_TICK_HZ + CORE_TICK_HZ / 2u)
/* Largest distance in metres and largest rotation (input_turn()) by which a poi may move while it
 * counts as held still. An arm that rests on the tank's rim moves less. */
#define CALIBRATE_STILL_M 0.008f
#define CALIBRATE_STILL_TURN 0.15f
/* Distance that the poi must move away from the last accepted pose before the next pose can be
 * accepted. */
#define CALIBRATE_MOVE_M 0.03f

enum calibrate_step {
    CALIBRATE_IDLE = 0,
    /* First of four calibration steps, one for each corner of the tank. The next step is
     * CALIBRATE_WATER. */
    CALIBRATE_CORNER,
    CALIBRATE_WATER = CALIBRATE_CORNER + (int)CALIBRATE_CORNERS,
    CALIBRATE_DONE,
    CALIBRATE_REFUSED, /* The calibration was rejected and is unchanged. `fault` is the reason. */
    CALIBRATE_STEPS,
};

struct calibrate {
    uint8_t slot;
    uint8_t step;    /* Current calibration step (enum calibrate_step). */
    uint8_t fault;   /* Reason for the rejection (enum calibration_fault). */
    uint8_t present; /* Bit mask of the slots with a controller. */
    /* Bit mask of the slots with a stored calibration, including incomplete calibrations. */
    uint8_t is_set;
    uint8_t has_before; /* Bit mask of the slots whose previous calibration is in `before`. */
    int32_t before[POI_MAX][CALIBRATION_VALUES];
    uint8_t has_anchor, must_move;
    uint16_t still_ticks;
    /* Pose at which the poi was first held still. Deviations are measured from this pose. */
    struct poi_target anchor;
    /* Sum of the deviations from `anchor` over the ticks in which the poi was still. */
    struct poi_target sum;
    struct calibration_sample sample;
};

/* Time after which a check of the self-test that still has no result counts as bad. */
#define SELF_TEST_TICKS (20u * CORE_TICK_HZ)
/* Longest time in which the self-test's ledger entry must reach the disk. If the SD card is slower,
 * the check SELF_STORE fails. */
#define SELF_TEST_STORE_TICKS (10u * CORE_TICK_HZ)
/* Distance by which a poi must move along an axis, so that the check SELF_POIS accepts the
 * axis. */
#define SELF_TEST_WAY_M 0.03f
/* Age in ticks from which a controller's report counts as late, which means fewer than 30 reports
 * per second. */
#define SELF_TEST_LATE_TICKS 4u
/* Lowest frame rate, in frames per second, at which the check SELF_DISPLAY passes. */
#define SELF_TEST_FRAMES_MIN 25u

/* Age of a backup, in minutes, from which the backup is too old. A backup is made at startup and
 * every hour. */
#define SELF_BACKUP_OLD_MIN 180u
/* Free disk space in MiB below which the check SELF_ROOM needs attention. The value is twice the
 * size of the database, plus the size of a replay of each ranked round. */
#define SELF_ROOM_LOW_MIB 64u
/* Free disk space in MiB below which the check SELF_ROOM is bad. Less space is too little for the
 * entries of one evening and their backup. */
#define SELF_ROOM_BAD_MIB 8u
/* Margin in degrees Celsius below the temperature at which the processor throttles. The check
 * SELF_HEAT needs attention if the temperature is within this margin, because a hot afternoon can
 * raise the temperature by as much. */
#define SELF_HEAT_NEAR_C 10

/* Checks of the self-test: first the checks of the machine, then the checks of the parts that a
 * player uses. */
enum self_check {
    /* Passes if the store confirmed a ledger entry on disk, and no database is in quarantine. */
    SELF_STORE = 0,
    SELF_BACKUP,
    SELF_DATA, /* Passes if data in the data folder survives a power cut. */
    SELF_ROOM,
    SELF_FILES, /* Passes if no file in the data folder was rejected at startup. */
    SELF_CLOCK,
    SELF_HEAT,
    SELF_WATCHDOG,
    SELF_DISPLAY,
    SELF_SOUND,
    SELF_LAMP,
    SELF_BUTTONS,
    SELF_COINS,
    SELF_POIS,
    SELF_CHECKS,
};

enum self_state {
    SELF_WAITS = 0,
    SELF_GOOD,
    SELF_WARN, /* The kiosk can open, but the part needs attention today. */
    SELF_BAD,
    SELF_QUERY,
    SELF_STATES,
};

enum { SELF_UNANSWERED = 0, SELF_ANSWER_YES, SELF_ANSWER_NO };

struct self_test {
    /* Answers of the operator to the question about the sound and to the question about the lamp
     * and the coin slot. */
    uint8_t sound_answer, lamp_answer;
    uint8_t present; /* Bit mask of the slots with a controller. */
    /* Directions in which each poi moved, as a bit mask. x, y and z have one bit each. */
    uint8_t ways[POI_MAX];
    uint8_t worst_age[POI_MAX]; /* Largest age of a report of each slot, in ticks. */
    vec3 first_m[POI_MAX];      /* Position at which each poi was first seen. */
    uint8_t has_first_m;        /* Bit mask of the slots with a valid `first_m`. */
    uint32_t begin_tick;
    /* Id of the ledger entry that the self-test wrote; 0 means that the ledger had no room. */
    uint32_t entry_id;
};

/* Largest number of items on a page: twelve in its body and four at its foot. */
#define MENU_TAG_MAX 16u
/* Time limit for the second TEST press that ends a round, counted from the first press. */
#define MENU_CONFIRM_TICKS (5u * CORE_TICK_HZ)
/* Time after a selection during which further selections are ignored. */
#define MENU_TAKE_TICKS (CORE_TICK_HZ / 10u)
/* Time without activity after which an open menu closes. */
#define MENU_IDLE_TICKS (300u * CORE_TICK_HZ)
/* Time without activity after which the menu closes if the PIN page is open. */
#define MENU_PIN_IDLE_TICKS (20u * CORE_TICK_HZ)
/* Number of idle timeouts after which the menu closes although a poi moves, if no press, selection
 * or coin occurred. Such long motion comes from a poi that swings on its cord. */
#define MENU_SWING_SPANS 3u
#define MENU_PIN_DIGITS 4u
/* Largest value that each counter on the page of the input lines can show. */
#define MENU_COUNT_MAX 9999u

/* Pages of the menu. The menu lists pages with the same parent in the order of this enum. */
enum menu_page {
    MENU_TOP = 0,
    MENU_DEVICES,     /* Page that lists the pages about devices and wiring. */
    MENU_CONTROLLERS, /* Page that lists all plugged-in controllers. */
    /* Page of one controller, on which the operator selects or releases the controller. */
    MENU_CONTROLLER,
    MENU_LEARN, /* Page of the learn wizard of a controller. */
    MENU_LINES, /* Page that tests the buttons and the coin lines. */
    MENU_AXES,  /* Page that shows the reported pose and the report rate of each poi. */
    /* Calibration page: corners of the tank, water level and tilt of each slot. */
    MENU_CALIBRATION,
    /* First of the settings pages: settings about money. Each group of settings has one page. */
    MENU_MONEY,
    MENU_GAME,
    MENU_MODES, /* Page on which the operator chooses the modes that players can select. */
    MENU_SOUND,
    MENU_PICTURE,
    MENU_CARD,  /* Page with a test picture that covers the whole screen. */
    MENU_BOOKS, /* Page that lists the pages with statistics. */
    MENU_EARNINGS,
    MENU_PLAYS,
    MENU_HOURS,
    MENU_MACHINE,
    MENU_RESET, /* Page that requests confirmation before a group of statistics is reset. */
    /* Page with the leaderboard of one mode for today, for this week or for all time. */
    MENU_RANKING,
    MENU_SCORE,     /* Page of one score, which plays its replay or removes its name. */
    MENU_SELF_TEST, /* Page of the self-test before the kiosk opens. */
    /* Page that lists the pages for files, versions, a new PIN, a restart and the factory reset. */
    MENU_UPKEEP,
    /* Page that lists the files found in the data folder, and the rejected files. */
    MENU_FILES,
    MENU_ABOUT, /* Page with the versions of the software and the names of the devices. */
    MENU_NEW_PIN,
    MENU_RESTART,
    MENU_FACTORY, /* Page of the factory reset. */
    /* Page for the PIN entry. If a PIN is set, this page opens before all other pages. */
    MENU_PIN,
    /* Page of the update by USB stick. Hashes of recordings depend on the numbers of the pages
     * before. */
    MENU_UPDATE,
    MENU_PAGE_COUNT,
};

/* Items of the menu pages. Each of the following enums lists the items of one page, or of several
 * pages of the same kind. The last constant of an enum is the number of its last item plus 1.
 *
 * The enum ROWS_* belongs to the page of all controllers, where these items follow one item for
 * each controller. */
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
/* The enum RANKING_* belongs to the leaderboard page, where these items follow one item for each
 * row of the leaderboard. */
enum { RANKING_NEXT = SCENE_LEADERBOARD_ROWS, RANKING_BACK, RANKING_TAGS };
enum { SCORE_REPLAY = 0, SCORE_UNNAME, SCORE_CONFIRM, SCORE_BACK, SCORE_TAGS };
enum { FILES_MORE = 0, FILES_SEEN, FILES_BACK, FILES_TAGS };
enum { UPDATE_START = 0, UPDATE_BACK, UPDATE_TAGS };
enum { BOOK_RESET = 0, BOOK_BACK, BOOK_TAGS };
/* Items of a page that requests confirmation. The second item is highlighted first. */
enum { CONFIRM_YES = 0, CONFIRM_BACK, CONFIRM_TAGS };
/* The enum PIN_* belongs to the PIN page, where these items follow the digit keys 1, 2 .. 9, 0. */
enum { PIN_ERASE = 10, PIN_BACK, PIN_TAGS };

/* Items at the foot of a settings page. The items follow one item for each setting and each
 * subpage. */
enum { SETTINGS_DIRECTION = 0, SETTINGS_STANDARD, SETTINGS_BACK, SETTINGS_FEET };

struct menu {
    uint8_t page; /* Open page (enum menu_page). */
    /* On a settings page: the row that was changed last; MENU_TAG_MAX means none. */
    uint8_t chosen;
    /* Direction in which the value of a setting changes when the operator selects the setting: 1
     * means down, 0 means up. */
    uint8_t turns_down;
    /* 1 while the button or poi that selected a setting is still pressed, so the value keeps
     * changing; otherwise 0. */
    uint8_t turning;
    /* Page of statistics from which the operator opened the page that confirms a reset. */
    uint8_t from;
    uint8_t pin_count; /* Number of PIN digits typed so far. */
    uint16_t pin;      /* PIN digits typed so far, as a number. */
    /* Number of automatic repetitions of the current change of a value while a button or a dipped
     * poi is held, up to 255. */
    uint8_t turn_count;
    uint32_t turn_tick; /* Tick at which a value on a settings page last changed. */
    uint8_t row;        /* Row of the selected controller in the list of controllers. */
    uint8_t upright;    /* 1 if the last input reported a portrait screen, otherwise 0. */
    uint8_t rules;      /* Format whose rules the menu follows, as in struct core_config. */
    uint8_t file_first; /* Index of the first file that the file page shows. */
    /* Selected leaderboard: the number of the board (ranking_board()) * RANK_PERIOD_COUNT + the
     * period's number. */
    uint8_t board;
    uint8_t score; /* Selected row of the leaderboard. */
    /* `score_is_named` is 1 if the selected row has a name. `is_unnaming` is 1 while the removal of
     * the name waits for confirmation. */
    uint8_t score_is_named, is_unnaming;
    uint16_t scores; /* Bit mask of the leaderboard rows that have a score. */
    uint8_t has_pointer, pointer_player, presses;
    /* Item under the pointer, counted from 1. 0 means no item. */
    uint8_t points;
    uint8_t tag[MENU_PAGE_COUNT];         /* Index of the highlighted item of each page. */
    struct controller_status controllers; /* State of the controllers, from the last input. */
    /* Presses of each button since the menu was opened. */
    uint16_t pressed_count[INPUT_BUTTON_COUNT];
    uint32_t held;
    /* `test_coins` is the number of test coins. `coin_tick` is the tick of the last test coin. */
    uint32_t test_coins, coin_tick;
    uint32_t command_count;
    /* Tick of a TEST press during a round; 0 means that no press waits for confirmation. */
    uint32_t confirm_tick;
    uint32_t take_tick; /* Tick at which a menu item was last selected. */
    uint32_t act_tick;  /* Tick of the last activity in the menu, including pointer motion. */
    uint32_t use_tick;  /* Tick of the last activity in the menu other than pointer motion. */
    float x, y;         /* Pointer position on the canvas. */
    struct calibrate calibrate;
    struct self_test self;
    /* Position of each slot's pointer when the pointer last moved. */
    struct layout_point rest[POI_MAX];
};
