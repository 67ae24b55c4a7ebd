/* scene_menu.h -- the operator's menu, and what the devices say of themselves on its pages. */
#ifndef KINGYO_CORE_SCENE_MENU_H
#define KINGYO_CORE_SCENE_MENU_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene_machine.h"
#include "core/settings.h"

#define SCENE_AUDIT_MAX 96u /* As many as core/game/audits.h counts, and room for more. */

/* Of the page "ready for opening" (core/game/self_test.h). */
struct scene_self_test {
    uint8_t heard, moved;       /* What the operator said. */
    uint8_t present, players;   /* Seats with a controller, a bit each; seats that play. */
    uint8_t store, clock;       /* enum self_state */
    uint8_t seconds_left;       /* Until what has not answered is bad; 0: the test is over. */
    uint16_t day, minute;       /* What the clock says, as struct input's. */
    uint8_t ways[POI_MAX], worst_age[POI_MAX];
};

/* The operator's menu (core/game/menu.h), while the phase is PHASE_MENU. */
struct scene_menu {
    uint8_t page;            /* enum menu_page */
    uint8_t tag;             /* That is pointed at. */
    uint16_t tags;           /* Of the page's, those that are offered; a bit each. */
    uint8_t row;             /* Of the controller that is dealt with. */
    uint8_t score;           /* The row of the ranking that is dealt with. */
    uint8_t file_first;      /* The first row shown of desk.file_count; 0 when there is none. */
    uint8_t upright, has_hand, presses;
    float x, y;              /* The hand, on the canvas (core/game/overlay.h). */
    struct desk_input desk;
    uint32_t held;           /* enum input_button */
    uint16_t pressed_count[INPUT_BUTTON_COUNT]; /* Since the menu was opened; */
    uint32_t test_coins;     /* coins too, of the lines' page. */
    float coin_s;            /* Since the last of them fell. */
    uint8_t chosen;          /* The row of settings that was turned last. */
    uint8_t turns_down;      /* A take turns its value down, not up. */
    uint8_t is_saved;        /* All that was turned is on disk. */
    uint8_t has_turned;      /* Something was, a moment ago. */
    uint32_t fish_max;       /* As many as the stall's tank has room for. */
    struct settings settings;
    struct scene_self_test self;
    uint8_t seat;            /* Whose poi is calibrated, ... */
    uint8_t calibrated;      /* ... which have one, even a torn one, a bit each, */
    uint8_t calibrate_step;  /* ... enum calibrate_step, ... */
    uint8_t calibrate_fault; /* ... enum calibration_fault, ... */
    float calibrate_progress; /* ... [0, 1] of being still, ... */
    vec3 calibrated_m;       /* ... and where that poi is, set right. */
    uint8_t from;            /* The page of the books that asks whether to reset. */
    uint8_t pin_count;       /* Digits typed, ... */
    uint16_t pin;            /* ... which are shown where a new one is chosen. */
    float pin_wait_s;        /* Until one may be typed again. */
    uint32_t boot, last_id, saved_id; /* Of the ledger. */
    uint32_t audit[SCENE_AUDIT_MAX];  /* enum audit_id */
};

#define SCENE_NAME_SIZE 48u
#define SCENE_LINE_SIZE 160u
#define SCENE_FILE_MAX 8u   /* Rows of the files' page on a screen that stands. */
#define SCENE_FILE_SIZE 64u

enum scene_file_state {
    FILE_UNKNOWN = 0,
    FILE_USED,
    FILE_REFUSED,
    FILE_ASIDE, /* A database that was damaged and set aside; nobody has acknowledged that yet. */
    FILE_SEEN,  /* The same, and somebody has. */
    FILE_STATE_COUNT,
};

/* What tells of itself on the page about this machine. */
enum scene_about {
    ABOUT_DISPLAY = 0,
    ABOUT_SOUND,
    ABOUT_STORE,
    ABOUT_CONTROLLERS,
    ABOUT_BUTTONS,
    ABOUT_SWITCHES,
    ABOUT_WATCHDOG,
    ABOUT_COUNT,
};

/* What devices are called, which is no concern of the core: the shell fills it while the operator's
 * menu is shown, and core_scene() leaves it as it is. UTF-8, each "" where there is nothing. */
struct scene_devices {
    char controller[CONTROLLER_MAX][SCENE_NAME_SIZE];
    char controllers[SCENE_LINE_SIZE]; /* What looks for them, or what is missing for that. */
    char lines[SCENE_LINE_SIZE];       /* The cabinet's lines, and which of them are missing. */
    char about[ABOUT_COUNT][SCENE_LINE_SIZE]; /* What each says that it is, or lacks. */
    struct scene_axes {                /* What a seat's controller says, as it says it. */
        uint8_t link;                  /* enum poi_link */
        vec3 position_m;
        struct angles angles;
        uint32_t report_count;         /* In the last whole second; */
        float gap_ms;                  /* the longest time between two of them. */
    } axes[POI_MAX];
    uint32_t frames_a_second;          /* As the last of them came; 0: not known yet. */
    uint32_t files_refused;            /* Files and lines of the configuration, at the start. */
    struct scene_machine machine;
    uint32_t line_raw;                 /* Levels before they count: bits as buttons_missing's. */
    struct scene_line {                /* By those bits, since the start: */
        uint32_t edges;                /* changes of its level, bounces too, */
        uint32_t faults;
    } line[INPUT_BUTTON_COUNT + COIN_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT];   /* Pulses that were coins, since the start. */
    uint32_t button_faults;            /* Since the start. */
    uint32_t buttons_missing;          /* Whose line is not there: enum input_button, then COIN. */
    struct scene_file {                /* From menu.file_first on. */
        uint8_t state;                 /* enum scene_file_state */
        char name[SCENE_FILE_SIZE];
        char words[SCENE_LINE_SIZE];   /* What is in it, or why it was refused. */
    } file[SCENE_FILE_MAX];
};

#endif
