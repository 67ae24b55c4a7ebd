/* scene_menu.h -- the scene's part for the operator's menu, and the status of the devices on its
 * pages. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/settings.h"

/* Capacity for the counters of core/game/accounting/audits.h, with room for more counters. */
#define SCENE_AUDIT_MAX 96u

/* State of the self-test page, on which the operator tests whether the kiosk is ready for opening
 * (core/game/menu/menu.h). */
struct scene_self_test {
    /* `sound_answer` is the operator's answer about the sound, `lamp_answer` the answer about the
     * lamp and the coin slot. */
    uint8_t sound_answer, lamp_answer;
    /* Bit masks of the slots with a controller and of the slots in play. */
    uint8_t present, players;
    /* States of the checks of the store and of the clock (enum self_state). */
    uint8_t store, clock;
    /* Seconds until a self-test check without a result counts as bad; 0 means that the test is
     * over. */
    uint8_t seconds_left;
    uint16_t day, minute; /* Date and time of the clock, as in struct input. */
    uint8_t ways[POI_MAX], worst_age[POI_MAX];
};

/* State of the operator's menu (core/game/menu/menu.h) while the phase is PHASE_MENU. */
struct scene_menu {
    uint8_t page;  /* enum menu_page */
    uint8_t tag;   /* Highlighted item of the page. */
    uint16_t tags; /* Bit mask of the page's items that can be selected. */
    uint8_t row;   /* Row of the selected controller. */
    uint8_t score; /* Selected row of the leaderboard. */
    /* Index of the first row that the file page shows, < controllers.file_count; 0 if the list is
     * empty. */
    uint8_t file_first;
    uint8_t upright, has_pointer, presses;
    uint8_t rules; /* Format whose rules the menu follows, as in struct core_config. */
    float x, y;    /* Pointer position on the canvas (core/game/pointer_mapping.h). */
    struct controller_status controllers;
    /* Bit mask of the buttons that are held down (enum input_button). */
    uint32_t held;
    /* Presses of each button since the menu was opened. */
    uint16_t pressed_count[INPUT_BUTTON_COUNT];
    uint32_t test_coins; /* Coins since the menu was opened, for the page of the input lines. */
    float coin_s;        /* Seconds since the last test coin. */
    uint8_t chosen;      /* Row of the setting that was changed last. */
    /* 1 if the selection of a setting lowers its value; 0 if the selection raises its value. */
    uint8_t turns_down;
    uint8_t is_saved;   /* 1 if every change of a setting is on disk, otherwise 0. */
    uint8_t has_turned; /* 1 if a setting was changed a moment ago, otherwise 0. */
    uint32_t fish_max;  /* Capacity of the tank in fish. */
    struct settings settings;
    struct scene_self_test self;
    uint8_t slot; /* Slot whose controller is calibrated. */
    /* Bit mask of the slots with a stored calibration, damaged ones included. */
    uint8_t calibrated;
    uint8_t calibrate_step;  /* enum calibrate_step of the calibration. */
    uint8_t calibrate_fault; /* enum calibration_fault of the last attempt. */
    /* Progress of holding the poi still during calibration, [0, 1]. */
    float menu_calibrate_progress;
    vec3 calibrated_m; /* Position of the poi after the correction by the calibration. */
    /* Page of statistics from which the operator opened the page that confirms a reset. */
    uint8_t from;
    uint8_t pin_count; /* Number of PIN digits typed. */
    /* PIN digits typed, as a number; displayed only while a new PIN is chosen. */
    uint16_t pin;
    float pin_wait_s; /* Seconds until a PIN can be typed again. */
    /* `boot` is the number of kiosk starts, including the current start. `last_id` is the id of the
     * newest ledger entry, and `saved_id` the id of the newest ledger entry on disk. */
    uint32_t boot, last_id, saved_id;
    uint32_t audit[SCENE_AUDIT_MAX]; /* Counters of the statistics, indexed by enum audit_id. */
};

/* ---- Computer ---------------------------------------------------------------------------------
 *
 * The state of the computer for the operator's pages. The shell fills in struct scene_machine
 * (platform/system_health.h). The core's state does not contain it. */

/* Result of the check whether data written to the data folder survives a power cut. */
enum scene_keeps {
    KEEPS_UNKNOWN = 0, /* The data folder was not checked yet. */
    /* The script board/kiosk/check-data has read test data back after a power cut. */
    KEEPS_PROVEN,
    /* The data folder is on a disk of this machine, but no power cut was tested. */
    KEEPS_FOLDER,
    KEEPS_MEMORY, /* The data folder is in RAM, so data does not survive. */
    /* The script board/kiosk/check-data found that data does not survive a power cut. */
    KEEPS_NOT,
    KEEPS_NOWHERE, /* No data folder exists. */
};

/* State of the watchdog, which restarts the kiosk when frames stop. */
enum scene_watch {
    WATCH_NONE = 0,
    WATCH_NO_LIMIT, /* A service manager is connected, but has no watchdog timeout. */
    WATCH_OK,
    WATCH_FAIL, /* The service manager did not accept the last keep-alive message. */
};

/* State of the computer. All fields are 0 if the machine was not checked yet. */
struct scene_machine {
    uint8_t is_checked;
    uint8_t keeps; /* Result of the data check (enum scene_keeps). */
    uint8_t watch; /* State of the watchdog (enum scene_watch); valid even if `is_checked` is 0. */
    uint8_t has_backup, has_heat;
    /* 1 if the clock is behind a time stamp written before this start, otherwise 0. */
    uint8_t is_clock_back;
    uint32_t backup_min; /* Minutes since the last good backup; valid if `has_backup` is 1. */
    uint32_t room_mib;   /* Space available to Kingyo in the data folder, in MiB. */
    /* Degrees Celsius below the throttling temperature; valid if `has_heat` is 1. */
    int32_t heat_margin_c;
    /* Number of quarantined databases that the operator has not acknowledged. */
    uint32_t quarantined;
    /* Number of times that the program ended by a panic since the panic count was reset. */
    uint32_t panics;
    /* Data that the kiosk does not load because of panics since power-on: 0 none, 1 settings, 2
     * settings and replays, 3 settings, replays and names. */
    uint8_t left_out;
    /* Number of ranked rounds since the start whose replay could not be saved. A round is not
     * counted if its recording was ended on purpose, because a PIN was typed. */
    uint32_t missed;
};

/* ---- Update by USB stick ---------------------------------------------------------------------
 *
 * The state of the update page (board/image/UPDATE.md). The shell fills in struct scene_update
 * (platform/update_link.h) while the page is open. */

enum scene_update_step {
    UPDATE_STEP_WAIT = 0, /* The service that reads the stick has not answered yet. */
    UPDATE_STEP_NO_STICK,
    UPDATE_STEP_FOUND, /* A verified update waits for the operator. */
    UPDATE_STEP_CHECKING,
    UPDATE_STEP_WRITING,
    UPDATE_STEP_DONE,
    UPDATE_STEP_FAILED,
    UPDATE_STEP_COUNT,
};

/* Reasons why an update failed, and the note UPDATE_FAULT_FELL_BACK: the last update did not start,
 * so the version before it runs. */
enum scene_update_fault {
    UPDATE_FAULT_NONE = 0,
    UPDATE_FAULT_FELL_BACK,
    UPDATE_FAULT_NO_FILESYSTEM,
    UPDATE_FAULT_NO_FOLDER,
    UPDATE_FAULT_UNSIGNED,
    UPDATE_FAULT_WRONG_KEY,
    UPDATE_FAULT_WRONG_BOARD,
    UPDATE_FAULT_OLDER,
    UPDATE_FAULT_SAME_VERSION,
    UPDATE_FAULT_TOO_LARGE,
    UPDATE_FAULT_DAMAGED,
    UPDATE_FAULT_PULLED,
    UPDATE_FAULT_CANCELED,
    UPDATE_FAULT_CARD,
    UPDATE_FAULT_ON_TRIAL,
    UPDATE_FAULT_COUNT,
};

#define SCENE_UPDATE_NAME_SIZE 64u

struct scene_update {
    uint8_t step;                      /* Step of the update (enum scene_update_step). */
    uint8_t percent;                   /* Progress of the step, 0 .. 100. */
    uint8_t fault;                     /* Fault or note (enum scene_update_fault). */
    char name[SCENE_UPDATE_NAME_SIZE]; /* Name of the new version, UTF-8. */
};

/* ---- Devices --------------------------------------------------------------------------------- */

#define SCENE_NAME_SIZE 48u
#define SCENE_LINE_SIZE 160u
#define SCENE_FILE_MAX 8u /* Number of rows of the file page on a portrait screen. */
#define SCENE_FILE_SIZE 64u

enum scene_file_state {
    FILE_UNKNOWN = 0,
    FILE_USED,
    FILE_REFUSED,
    /* The file is a damaged database in quarantine that the operator has not acknowledged. */
    FILE_ASIDE,
    /* The file is a damaged database in quarantine that the operator has acknowledged. */
    FILE_SEEN,
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
    /* Status of the controller search, or the reason why it does not work. */
    char controllers[SCENE_LINE_SIZE];
    /* Status text of the cabinet's input lines: the driver, the number of working lines, and the
     * lines that are missing or faulty. */
    char lines[SCENE_LINE_SIZE];
    /* Name of each component, or its fault (indexed by enum scene_about). */
    char about[ABOUT_COUNT][SCENE_LINE_SIZE];
    /* Newest report of each slot's controller, before calibration and validation. */
    struct scene_axes {
        uint8_t link; /* Source of the slot's pose (enum poi_source). */
        vec3 position_m;
        struct angles angles;
        uint32_t report_count; /* Number of reports in the last full second. */
        float gap_ms;          /* Longest time between two successive reports, in milliseconds. */
    } axes[POI_MAX];
    /* Frames per second, measured on the latest frames; 0 means unknown. */
    uint32_t frames_a_second;
    /* Number of configuration files and lines that were rejected at startup. */
    uint32_t files_refused;
    struct scene_machine machine;
    struct scene_update update;
    /* Bit mask of the line levels before debouncing. Each line has the same bit as in
     * `buttons_missing`. */
    uint32_t line_raw;
    /* Counters of each input line since the start. The index is the line's bit number in
     * `buttons_missing`. */
    struct scene_line {
        uint32_t edges; /* Number of level changes, including contact bounces. */
        uint32_t faults;
    } line[INPUT_BUTTON_COUNT + COIN_LINE_COUNT];
    /* Number of pulses of each coin line that counted as coins, since the start. */
    uint32_t coins[COIN_LINE_COUNT];
    uint32_t button_faults; /* Number of faults of button lines since the start. */
    /* Bit mask of the input lines that do not exist: bits of enum input_button, followed by one bit
     * for each coin line. */
    uint32_t buttons_missing;
    /* Rows of the file page, starting with row `file_first` of struct scene_menu. */
    struct scene_file {
        uint8_t state; /* State of the file (enum scene_file_state). */
        char name[SCENE_FILE_SIZE];
        /* Content of the file, or the reason why the file was rejected. */
        char words[SCENE_LINE_SIZE];
    } file[SCENE_FILE_MAX];
};
