/* scene.h -- what there is to see, rebuilt from the state once per frame.
 *
 * Plain data with no pointers, so a scene can be kept, compared or drawn on another thread. */
#ifndef KINGYO_CORE_SCENE_H
#define KINGYO_CORE_SCENE_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/morph/species.h"
#include "core/settings.h"
#include "core/view.h"
#include "core/base/vec.h"

#define SCENE_FISH_MAX 2048u /* As TANK_FISH_MAX. */
#define SHEET_SIDE 32u       /* Cells along each side of the paper's square: 2.5 mm at 80 mm. */
#define RIPPLE_X 128u        /* Cells of the water surface, left to right ... */
#define RIPPLE_Z 80u         /* ... and back to front; about 7 mm in the festival tank. */

enum scene_place {
    SCENE_IN_TANK = 0,
    SCENE_ON_POI = 1,
    SCENE_IN_BOWL = 2,
};

struct scene_fish {
    vec3 position_m;         /* Centre of the body box. */
    struct angles angles;
    float length_m;          /* Total length, snout to tail tip. */
    float age_days;          /* Since it hatched; shape and colour are of that age. */
    float tail_phase_rad;    /* Of the travelling body wave; [0, 2 pi). */
    float tail_amplitude;    /* 1 is a fifth of the length from tip to tip; 0 is still. */
    float bend_rad;          /* Whole-body bend of a turn; positive bends the tail to its right. */
    float gape;              /* [0, 1] how far its mouth is open: it gulps at the surface. */
    float gulp;              /* (0, 1] from one opening to the next; 0: it does not gulp. */
    float progress;          /* [0, 1] from the species' first key shape to its last. */
    float maturity;          /* [0, 1] along the colour keys. */
    uint32_t look;           /* Random bits that choose the individual's pattern and colours. */
    uint8_t place;           /* enum scene_place */
};

struct scene_poi {
    uint8_t present;
    uint8_t owner;           /* Player index, chooses the ring's colour. */
    vec3 position_m;         /* Ring centre. */
    struct angles angles;
    float ring_radius_m;     /* Inner: the paper's edge. */
    float sag_m;             /* Depth of the paper's belly, along -up; negative bulges upward. */
    float paper_left;        /* [0, 1] area that is still there. */
    float shade_dark;        /* [0, 1] of the light that it takes from below; 0 once it dips. */
    float water_m;           /* Mean depth of the water that lies on it, or hangs in it. */
    uint8_t shows_stress;    /* Practice: the paper is coloured by `stress`. */
    uint8_t wetness[SHEET_SIDE * SHEET_SIDE];   /* 0 dry .. 255 wet; row 0 is the far edge (-z). */
    uint8_t integrity[SHEET_SIDE * SHEET_SIDE]; /* 255 whole .. 1 nearly torn, 0 hole. */
    uint8_t stress[SHEET_SIDE * SHEET_SIDE]; /* Load over strength, raised where it gathers; 255: it
                                                tears at once. 0 where there is no paper. */
};

struct scene_bowl {
    uint8_t present;
    uint8_t owner;
    vec3 position_m;         /* Centre of the mouth: it floats, and the poi may push it about. */
    struct angles angles;    /* How it heels. */
    float radius_m;          /* Of the mouth. */
    float depth_m;
    float water_below_m;     /* So far under its mouth its own water stands. */
    uint32_t fish_count;
};

/* The air stone of a tank that has a pump. */
struct scene_pump {
    uint8_t present;
    uint8_t runs;
    vec3 stone_m; /* On the floor. */
};

/* A fan that someone holds over the water, and with it its shadow. */
struct scene_fan {
    uint8_t present;
    uint8_t owner;           /* Player index, chooses its picture. */
    uint8_t unseen;          /* Only its shadow shows: for who wants to see what is below. */
    float x_m, z_m;          /* Middle of the shadow on the water, straight below the light. */
    float radius_m;
    float dark;              /* [0, 1] of the light that it takes. */
    float still_s;           /* How long it has been held still. */
};

enum scene_phase {
    PHASE_ATTRACT = 0,
    PHASE_READY = 1,  /* A few seconds to take the poi. */
    PHASE_ROUND = 2,
    PHASE_RESULT = 3,
    PHASE_WORDLESS = 4, /* No phase of a game: a picture of the tank alone. */
    PHASE_CHOOSE = 5,   /* Which mode? */
    PHASE_LAB = 6,      /* The growth lab. */
    PHASE_ALBUM = 7,    /* What was caught grows up. */
    PHASE_MENU = 8,     /* The operator's menu. */
    PHASE_NAME = 9,     /* Who is ranked writes a name. */
    PHASE_BOARD = 10,   /* The ranking, with that name. */
};

enum game_mode {
    MODE_FESTIVAL = 0,     /* Until the paper cannot hold a fish, or the time is over. */
    MODE_CHAMPIONSHIP = 1, /* The federation's: three minutes, one No. 5 poi, fouls. */
    MODE_PRACTICE = 2,     /* The paper shows its stress; fresh paper for torn; no score. */
    MODE_COUNT = 3,
};

/* What a stall offers beside its modes: nothing that is scored. As a bit among `modes`. */
#define CHOICE_LAB ((uint8_t)MODE_COUNT)
#define CHOICE_COUNT (MODE_COUNT + 1u)

/* Found in what was done, never declared. The third ends a player's round. */
enum foul {
    FOUL_NONE = 0,
    FOUL_POURED = 1, /* Into the bowl from a ring that was not wholly above the water. */
    FOUL_WALL = 2,   /* A fish pressed against the tank's wall and scooped there. */
    FOUL_SHADE = 3,  /* A shadow held over the water before the start. */
    FOUL_COUNT = 4,
};
#define FOUL_MAX 3u

/* What the keeper calls out; each is shown and heard once. */
enum time_call {
    CALL_NONE = 0,
    CALL_ONE_MINUTE = 1,  /* One minute has passed ... */
    CALL_TWO_MINUTES = 2, /* ... two ... */
    CALL_TEN_SECONDS = 3, /* ... ten seconds are left, ... */
    CALL_COUNTDOWN = 4,   /* ... and the last five, one by one: see seconds_left. */
    CALL_TIME = 5,        /* Time is up. */
};

/* What the stall calls to the player. The words are the renderer's, in the scene's language. */
enum scene_hint {
    HINT_NONE = 0,
    HINT_START,       /* Press to play. */
    HINT_MOVE,        /* Move the poi over a fish. */
    HINT_DIP,         /* Hold the button to dip. */
    HINT_LIFT,        /* Let go to lift. */
    HINT_BOWL,        /* Carry it to the bowl. */
    HINT_TILT,        /* The wheel tilts the poi. */
    HINT_SLOWLY,      /* Haste tears paper. */
    HINT_GLIDE,       /* Dip beside a fish, slide under it, lift softly. */
    HINT_TORN,        /* The paper is gone. */
    HINT_LOST_POI,    /* The controller is away; the round waits. */
    HINT_WET_ALL,     /* Wet all of the paper: it tears between wet and dry. */
    HINT_NO_SHADE,    /* Keep your shadow off the water before the start. */
    HINT_CLEAR_RIM,   /* Lift the whole ring out of the water before the bowl. */
    HINT_CHOOSE,      /* LEFT and RIGHT choose, START begins. */
    HINT_COIN,        /* Nothing is paid yet. */
    HINT_PAID_BACK,   /* The round ended for want of a poi: its credit came back. */
    HINT_COUNT,
};

enum language {
    LANGUAGE_JA = 0,
    LANGUAGE_EN = 1,
    LANGUAGE_COUNT,
};

enum scene_keeping { LAB_NOT_SAVED = 0, LAB_SAVING, LAB_SAVED, LAB_UNSAVED /* It could not. */ };

/* The growth lab, while the phase is PHASE_LAB. Places are of core/game/lab_layout.h's canvas. */
struct scene_lab {
    uint8_t species, species_count; /* The built-in ones, then the makers'. */
    uint8_t refused;         /* Makers' files that could not be used. */
    uint8_t template;        /* enum graph_template that the graph began as. */
    uint8_t layer;           /* Which key's curve is in hand; from MORPH_KEY_MAX on, the scale. */
    uint8_t playing, compare, path;
    uint8_t points;          /* enum lab_part under the hand. */
    uint8_t presses, has_hand, upright;
    uint8_t holds;           /* enum lab_hold */
    uint8_t held_knot;       /* Of the graph or the scale, or 255. */
    uint8_t keeping;         /* enum scene_keeping of the last time SAVE was pressed. */
    uint8_t is_own, is_kept; /* What is shown is the species' own; is what the stall keeps. */
    uint8_t scale_knot_count;
    float x, y;              /* The hand. */
    float progress, age_days, length_m;
    float weight[MORPH_KEY_MAX]; /* As the graph has them at `progress`; >= 0, sum 1. */
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
    struct species_card card; /* With its curves and scale as edited. */
};

#define ALBUM_FISH_MAX 6u /* As many pictures as a page has room for. */

/* The catch of the round, each fish from hatching to old age, while it is PHASE_ALBUM. */
struct scene_album {
    uint32_t fish_count;     /* <= ALBUM_FISH_MAX; the first caught come first. */
    uint32_t caught;         /* How many there were in all. */
    struct scene_grown {
        uint8_t owner;       /* Player index. */
        uint8_t is_caught;   /* It is older by now than when it was caught. */
        uint32_t look;
        float caught_age_days, caught_length_m;
        float age_days, length_m, progress;
        float maturity;      /* As struct scene_fish has it. */
    } fish[ALBUM_FISH_MAX];
};

#define SCENE_NAME_LETTERS 8u /* As NAME_LETTERS_MAX. */

/* Somebody writes a name (core/game/name.h), while it is PHASE_NAME; `waits` always. */
struct scene_name {
    uint8_t waits;           /* Who is to be asked for one, a bit a seat. */
    uint8_t seat;
    uint8_t alphabet;        /* enum name_alphabet */
    uint8_t key;             /* That is pointed at: a cell, or enum name_key. */
    uint8_t upright, has_hand, presses;
    uint8_t was_refused;     /* Another name is asked for. */
    uint8_t letter_count;
    uint16_t letter[SCENE_NAME_LETTERS];
    float x, y;              /* The hand, on the canvas (core/game/overlay.h). */
};

#define SCENE_BOARD_ROWS 10u /* As RANK_ROWS. */

/* The ranking, in PHASE_BOARD, by turns in attract, and on its pages of the operator's menu. */
struct scene_board {
    uint8_t shown;
    uint8_t mode;            /* enum game_mode */
    uint8_t period;          /* enum rank_period */
    float shown_s, left_s;   /* Since it came, and until it goes. */
    struct scene_row {
        uint32_t caught;     /* 0: nobody yet. */
        uint8_t seat;
        uint8_t is_new;      /* Of the round that was just played. */
        uint8_t is_sealed;   /* Its replay is kept: the shell's word. */
        uint32_t round_id;
        char name[LEDGER_NAME_SIZE]; /* UTF-8; "": none was given. */
    } row[SCENE_BOARD_ROWS];
};

/* What was paid. */
struct scene_credit {
    uint8_t price;           /* Units a credit; 0: free play. */
    uint8_t is_event;        /* ... which is an event. */
    uint8_t unpaid;          /* Nobody has paid, so nobody may play. */
    uint8_t warnings;        /* enum credit_warning */
    uint8_t came_back;       /* What the last round cost: nothing of that round was counted. */
    uint8_t coin_units;      /* What a pulse of the first coin line is worth. */
    uint32_t units;          /* Towards the next credit. */
    uint32_t credits;        /* To be played; */
    uint32_t coming;         /* and those that are not on disk yet. */
    float coin_s, asked_s;   /* Since the last coin fell, and since somebody wanted to play in
                                vain; a day or more: never. */
};

#define SCENE_AUDIT_MAX 96u /* As many as core/game/audits.h counts, and room for more. */

/* Of the page "ready for opening" (core/game/self_test.h). */
struct scene_self_test {
    uint8_t heard, moved;       /* What the operator said. */
    uint8_t present, players;   /* Seats with a controller, a bit each; seats that play. */
    uint8_t store, clock;       /* enum self_state */
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

enum scene_file_state { FILE_UNKNOWN = 0, FILE_USED, FILE_REFUSED, FILE_STATE_COUNT };

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

/* A score is shown again, over whatever is: see platform/kiosk/encore.h. */
enum scene_encore {
    ENCORE_OFF = 0,
    ENCORE_SEEKS,   /* It is fetched, and played fast up to its round. */
    ENCORE_PLAYS,
    ENCORE_GENUINE, /* It is over, and was true to the last bit. */
    ENCORE_OTHER,   /* It is over, and was not. */
    ENCORE_NONE,    /* This score has no replay. */
    ENCORE_COUNT,
};

struct scene {
    uint32_t tick;
    struct view view;
    vec3 tank_size_m;        /* Inner width (x), water depth (y), breadth (z). */
    float wall_height_m;     /* Floor to rim; more than the water is deep. */

    uint32_t fish_count;     /* <= SCENE_FISH_MAX */
    struct scene_fish fish[SCENE_FISH_MAX];
    struct scene_poi poi[POI_MAX];
    struct scene_bowl bowl[POI_MAX];
    struct scene_fan fan[SHADE_MAX];
    struct scene_pump pump;
    int8_t slope[RIPPLE_Z][RIPPLE_X][2]; /* Surface slope (x, z) * 508: +-127 is +-0.25. */

    uint8_t phase;           /* enum scene_phase */
    uint8_t language;        /* enum language */
    uint8_t hint;            /* enum scene_hint */
    float phase_s;           /* Since the phase began. */
    float veil;              /* [0, 1]: how dark the tank is, under whatever is written over it. */
    float seconds_left;      /* Of the round; in READY, until it begins; else 0. */
    uint32_t caught[POI_MAX];
    uint32_t best_today;     /* In this mode. */
    uint8_t by_bot;          /* The bot had a hand in this round: no score of a person's. */

    uint8_t mode;            /* enum game_mode of this round; in CHOOSE, the one pointed at. */
    uint8_t choice;          /* In CHOOSE: the mode pointed at, or CHOICE_LAB. */
    uint8_t modes;           /* Which are offered, a bit (1 << enum game_mode, or CHOICE_LAB). */
    struct scene_offer {
        uint16_t round_s;    /* How long at most. */
        uint8_t grade;       /* Of its paper. */
    } offer[MODE_COUNT];     /* Of every mode, offered or not. */
    uint8_t grade;           /* Of the round's paper. */
    uint8_t paused;          /* A hand is lost; the clock waits for it. */
    uint8_t call;            /* enum time_call: the latest ... */
    float call_s;            /* ... and how long ago. */
    struct scene_player {
        uint8_t plays;       /* Takes part in this round. */
        uint8_t lost;        /* Its controller is away or talks nonsense. */
        uint8_t fouls;       /* 0 .. FOUL_MAX */
        uint8_t foul;        /* enum foul: the latest ... */
        float foul_s;        /* ... and how long ago. */
        uint8_t out;         /* Its round is over: by fouls or for want of paper. */
        uint8_t place;       /* In RESULT: the best in the ranking, from 1; 0: none ... */
        uint8_t period;      /* ... and of which enum rank_period. */
    } player[POI_MAX];

    struct scene_credit credit;
    uint8_t asks_menu;       /* TEST was pressed in a round: once more, and it ends. */
    struct scene_menu menu;
    struct scene_devices devices;
    struct scene_lab lab;
    struct scene_album album;
    struct scene_name name;
    struct scene_board board;
    uint8_t encore;          /* enum scene_encore; put there by the shell. */
    float encore_progress;   /* [0, 1] of the way to its round. */
};

#endif
