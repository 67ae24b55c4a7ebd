/* scene_menu.h -- the scene's part for the operator's menu, and the status of the devices on its
 * pages. */
#ifndef KINGYO_CORE_SCENE_MENU_H
#define KINGYO_CORE_SCENE_MENU_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene_machine.h"
#include "core/settings.h"

/* Capacity for the counters of core/game/accounting/audits.h, with room for more counters. */
#define SCENE_AUDIT_MAX 96u

/* State of the page "ready for opening" (core/game/menu/menu.h). */
struct scene_self_test {
    uint8_t heard, moved;     /* Confirmations of the operator for sound and picture. */
    uint8_t present, players; /* Bit masks of the slots with a controller and of the slots in
                                 play. */
    uint8_t store, clock;     /* States of the checks of the store and of the clock (enum
                                 self_state). */
    uint8_t seconds_left;     /* Seconds until a check without a result counts as bad; 0 means that
                                 the test is over. */
    uint16_t day, minute;     /* Date and time of the clock, as in struct input. */
    uint8_t ways[POI_MAX], worst_age[POI_MAX];
};

/* State of the operator's menu (core/game/menu/menu.h) while the phase is PHASE_MENU. */
struct scene_menu {
    uint8_t page;       /* enum menu_page */
    uint8_t tag;        /* Highlighted item of the page. */
    uint16_t tags;      /* Bit mask of the page's items that can be selected. */
    uint8_t row;        /* Row of the selected controller. */
    uint8_t score;      /* Selected row of the leaderboard. */
    uint8_t file_first; /* First row shown on the file page, of controllers.file_count rows; 0 if
                           the list is empty. */
    uint8_t upright, has_hand, presses;
    float x, y; /* Pointer position on the canvas (core/game/pointer_mapping.h). */
    struct controller_status controllers;
    uint32_t held;                              /* Bit mask of the buttons that are held down (enum
                                                   input_button). */
    uint16_t pressed_count[INPUT_BUTTON_COUNT]; /* Presses of each button since the menu was
                                                   opened. */
    uint32_t test_coins; /* Coins since the menu was opened, for the page of the input lines. */
    float coin_s;        /* Seconds since the last test coin. */
    uint8_t chosen;      /* Row of the setting that was changed last. */
    uint8_t turns_down;  /* 1 if selecting an item lowers its value, 0 if selecting raises the
                            value. */
    uint8_t is_saved;    /* 1 if every change of a setting is on disk, otherwise 0. */
    uint8_t has_turned;  /* 1 if a setting was changed a moment ago, otherwise 0. */
    uint32_t fish_max;   /* Capacity of the tank in fish. */
    struct settings settings;
    struct scene_self_test self;
    uint8_t seat;                  /* Slot whose controller is calibrated. */
    uint8_t calibrated;            /* Bit mask of the slots with a stored calibration, damaged
                                      ones included. */
    uint8_t calibrate_step;        /* enum calibrate_step of the calibration. */
    uint8_t calibrate_fault;       /* enum calibration_fault of the last attempt. */
    float menu_calibrate_progress; /* Progress of holding the poi still during calibration, [0,
                                      1]. */
    vec3 calibrated_m;             /* Calibrated position of the poi. */
    uint8_t from;      /* Page of the statistics that requests confirmation of a reset. */
    uint8_t pin_count; /* Number of PIN digits typed. */
    uint16_t pin;      /* PIN digits typed, as a number; displayed only while a new PIN is
                          chosen. */
    float pin_wait_s;  /* Seconds until a PIN can be typed again. */
    uint32_t boot, last_id, saved_id; /* Number of the current kiosk start, id of the newest ledger
                                         entry, and id of the newest ledger entry on disk. */
    uint32_t audit[SCENE_AUDIT_MAX];  /* Counters of the statistics, indexed by enum audit_id. */
};

#define SCENE_NAME_SIZE 48u
#define SCENE_LINE_SIZE 160u
#define SCENE_FILE_MAX 8u /* Number of rows of the file page on a portrait screen. */
#define SCENE_FILE_SIZE 64u

enum scene_file_state {
    FILE_UNKNOWN = 0,
    FILE_USED,
    FILE_REFUSED,
    FILE_ASIDE, /* The file is a damaged database in quarantine that the operator has not
                   acknowledged. */
    FILE_SEEN,  /* The file is a damaged database in quarantine that the operator has
                   acknowledged. */
    FILE_STATE_COUNT,
};

/* Components that report their status on the page about this machine. */
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

/* Names and status texts of the devices. The shell fills the struct while the operator's menu is
 * shown. core_scene() does not change the struct. Each string is UTF-8, and "" if there is no
 * text. */
struct scene_devices {
    char controller[CONTROLLER_MAX][SCENE_NAME_SIZE];
    char controllers[SCENE_LINE_SIZE]; /* Status of the controller search, or the reason why it does
                                          not work. */
    char lines[SCENE_LINE_SIZE];       /* Names of the cabinet's input lines, and of the missing
                                          lines. */
    char about[ABOUT_COUNT][SCENE_LINE_SIZE]; /* Name of each component, or its fault (indexed by
                                                 enum scene_about). */
    struct scene_axes {                       /* Newest report of each slot's controller, before
                                                 calibration and validation. */
        uint8_t link;                         /* Source of the slot's pose (enum poi_source). */
        vec3 position_m;
        struct angles angles;
        uint32_t report_count; /* Number of reports in the last full second. */
        float gap_ms;          /* Longest time between two successive reports, in milliseconds. */
    } axes[POI_MAX];
    uint32_t frames_a_second; /* Frames per second, measured on the latest frames; 0 means
                                 unknown. */
    uint32_t files_refused;   /* Number of configuration files and lines that were rejected at
                                 startup. */
    struct scene_machine machine;
    uint32_t line_raw;  /* Bit mask of the line levels before debouncing. Each line has the same bit
                           as in `buttons_missing`. */
    struct scene_line { /* Counters of each input line since the start. The index is the line's bit
                           number in `buttons_missing`. */
        uint32_t edges; /* Number of level changes, including contact bounces. */
        uint32_t faults;
    } line[INPUT_BUTTON_COUNT + COIN_LINE_COUNT];
    uint32_t coins[COIN_LINE_COUNT]; /* Pulses that counted as coins, since the start. */
    uint32_t button_faults;          /* Number of faults of button lines since the start. */
    uint32_t buttons_missing;        /* Bit mask of the input lines that do not exist: bits of enum
                                        input_button, followed by one bit for each coin line. */
    struct scene_file {              /* Rows of the file page, starting with row `file_first` of
                                        struct scene_menu. */
        uint8_t state;               /* State of the file (enum scene_file_state). */
        char name[SCENE_FILE_SIZE];
        char words[SCENE_LINE_SIZE]; /* Content of the file, or the reason why the file was
                                        rejected. */
    } file[SCENE_FILE_MAX];
};

#endif
