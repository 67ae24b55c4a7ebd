/* scene.h -- the complete picture of one frame, rebuilt from the state.
 *
 * The scene is plain data without pointers, so it can be stored, compared or drawn on another
 * thread. The parts of a scene, in drawing order:
 * - scene.h: objects and fish in the water, phases, announcements, hints and credits,
 * - scene_pages.h: lab, album, name entry and leaderboard,
 * - scene_menu.h: the operator's menu. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene_menu.h"
#include "core/scene_pages.h"
#include "core/view.h"

/* ---- Tank ------------------------------------------------------------------------------------ */

#define SCENE_FISH_MAX 2048u /* Largest number of fish in a scene, equal to TANK_FISH_MAX. */
/* Number of cells along each side of the square around the paper; a cell measures 2.5 mm at a poi
 * diameter of 80 mm. */
#define SHEET_SIDE 32u
#define SHEET_GRADE_MIN 4u /* Strongest paper grade. */
#define SHEET_GRADE_MAX 7u /* Weakest paper grade. */
#define RIPPLE_X 128u      /* Number of cells of the water surface from left to right. */
/* Number of cells of the water surface from back to front. A cell measures about 7 mm in the
 * festival tank. */
#define RIPPLE_Z 80u

enum scene_place {
    SCENE_IN_TANK = 0,
    SCENE_ON_POI = 1,
    SCENE_IN_BOWL = 2,
};

struct scene_fish {
    vec3 position_m; /* Centre of the box around the fish's body. */
    struct angles angles;
    float length_m; /* Total length, snout to tail tip. */
    float age_days; /* Days since hatching. Shape and colour are those of this age. */
    /* Phase of the body wave that travels along a swimming fish, [0, 2 pi). */
    float tail_phase_rad;
    /* Tail-beat amplitude. 1 means a fifth of the fish's length, peak to peak; 0 means that the
     * tail is still. */
    float tail_amplitude;
    /* Bend of the whole body during a turn; a positive angle bends the tail to its right. */
    float bend_rad;
    float gape; /* Opening of the mouth, [0, 1]. The fish gulps air at the surface. */
    /* Progress of one gulp, from one opening of the mouth to the next, (0, 1]; 0 means that the
     * fish does not gulp. */
    float gulp;
    /* Position in the fish's life, [0, 1], from the species' first key shape to its last. */
    float progress;
    /* Colour maturity, [0, 1], from the species' first colour key to its last. */
    float maturity;
    uint32_t look; /* Random bits that choose the individual's pattern and colours. */
    uint8_t place; /* Place of the fish (enum scene_place). */
};

/* Causes of a tear of the paper. The load with the highest tension is the cause. */
enum tear_cause {
    TEAR_NONE = 0, /* The paper is not torn. */
    TEAR_FAST,     /* Pressure of the water or of the carried mass on paper that moved too fast. */
    TEAR_FLAT,     /* Pressure of the water on paper that was pushed along its normal. */
    TEAR_SLAP,     /* Slap of a fish's tail. */
    TEAR_SOAKED,   /* Moderate load on paper that was wet for too long. */
    TEAR_WEIGHT,   /* Weight at one place of the paper. */
    TEAR_CAUSE_COUNT,
};

#define TEAR_SIDE (SHEET_SIDE / 2u) /* Cells along each side of the paper in the slow motion. */
#define TEAR_CELL_COUNT (TEAR_SIDE * TEAR_SIDE)

/* One frame of the slow motion, which shows the second around the first tear of a player's paper.
 * The slow motion is present in PHASE_RESULT only. */
struct scene_tear {
    uint8_t cause; /* Cause of the first tear (enum tear_cause); TEAR_NONE means no tear. */
    /* Time of the frame since the first tear, in seconds; negative before the tear. */
    float time_s;
    vec3 position_m;   /* Position of the ring's centre. */
    vec3 velocity_m_s; /* Velocity of the ring's centre. */
    struct angles angles;
    /* Load of each cell divided by its strength, from 17 (no load) to 255 (the cell tears); 0 means
     * no paper. Row 0 is at the far edge (-z). */
    uint8_t load[TEAR_CELL_COUNT];
};

struct scene_poi {
    uint8_t present;
    uint8_t owner;   /* Player index; selects the ring's colour. */
    vec3 position_m; /* Position of the ring's centre. */
    struct angles angles;
    /* Rotation of the drawn handle about the axis of the ring, in rad. The handle of a bot points
     * to the bot's place at the tank. 0 for the poi of a player, whose handle follows `angles`. */
    float handle_rad;
    /* 1 if a left hand holds the poi, because the player's bowl is on the left. */
    uint8_t left_hand;
    /* The same two values for a portrait screen (scene_use_turned()). */
    float turned_handle_rad;
    uint8_t turned_left_hand;
    float ring_radius_m; /* Inner radius of the ring, at the paper's edge. */
    /* Depth of the sagging paper below the ring's plane; a negative value means that the paper
     * bulges upward. */
    float sag_m;
    float paper_left; /* Share of the paper area that is left, [0, 1]. */
    /* Share of the light that the poi blocks from the water below, [0, 1]; 0 while the poi is in
     * the water. */
    float shade_dark;
    float water_m; /* Mean depth of the water on the paper. */
    float warning; /* Danger that the paper tears, from 0 (none) to 1 (imminent). */
    /* 1 in practice mode, where the paper is coloured by `stress`; otherwise 0. */
    uint8_t shows_stress;
    /* Wetness of each paper cell, from 0 (dry) to 255 (wet). Row 0 is at the far edge (-z). */
    uint8_t wetness[SHEET_SIDE * SHEET_SIDE];
    /* Integrity of each paper cell, from 255 (whole) to 1 (nearly torn); 0 means a hole. */
    uint8_t integrity[SHEET_SIDE * SHEET_SIDE];
    /* Load of each paper cell divided by its strength, including stress concentration. 255 means
     * that the cell tears immediately; 0 means no paper. */
    uint8_t stress[SHEET_SIDE * SHEET_SIDE];
};

/* Returns the axes of the drawn handle of a poi. The handle extends along `back`. */
static inline struct basis scene_handle_axes(const struct scene_poi *poi)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float c = f_cos(poi->handle_rad), s = f_sin(poi->handle_rad);
    return (struct basis){ .right = v3_sub(v3_scale(axes.right, c), v3_scale(axes.back, s)),
                           .up = axes.up,
                           .back = v3_add(v3_scale(axes.back, c), v3_scale(axes.right, s)) };
}

struct scene_bowl {
    uint8_t present;
    uint8_t owner;
    vec3 position_m;      /* Centre of the bowl's mouth. The bowl floats, and a poi can push it. */
    struct angles angles; /* Orientation of the bowl, which tilts when it floats unevenly. */
    float radius_m;       /* Radius of the bowl's mouth. */
    float depth_m;
    float water_below_m; /* Distance from the bowl's mouth down to the water inside the bowl. */
    uint32_t fish_count;
};

/* Largest number of splashes in a scene. Each of them lasts at most SCENE_SPLASH_S. */
#define SCENE_SPLASH_MAX 16u
#define SCENE_SPLASH_S 1.2f

/* A splash that throws drops of water. */
struct scene_splash {
    vec3 position_m; /* Centre of the splash, on the surface of the water. */
    uint8_t in_bowl; /* 1 for a splash in the water of a bowl, 0 for a splash in the tank. */
    vec3 push_m_s;   /* Velocity of the body that caused the splash. */
    float radius_m;  /* Radius of the circle from which the drops fly. */
    float age_s;     /* Seconds since the splash. */
    uint32_t seed;   /* Random bits that choose the paths of the drops. */
    uint8_t drops;   /* Number of drops. */
};

/* Largest number of scraps of paper in a scene. Each of them is shown for SCENE_SCRAP_S. */
#define SCENE_SCRAP_MAX 8u
#define SCENE_SCRAP_S 14.0f

/* A scrap of torn paper that sinks in the tank. */
struct scene_scrap {
    vec3 position_m; /* Place at which the paper tore. */
    vec3 push_m_s;   /* Velocity of the poi when its paper tore. */
    float age_s;     /* Seconds since the tear. */
    uint32_t seed;   /* Random bits that choose the path and the shape. */
};

/* Air stone of a tank that has a pump. */
struct scene_pump {
    uint8_t present;
    uint8_t runs;
    vec3 stone_m; /* Position of the air stone on the tank's floor. */
};

/* A translucent poi that shows the technique. */
struct scene_ghost {
    uint8_t is_present;
    uint8_t carries; /* 1 if the ghost carries a fish, otherwise 0. */
    float opacity;   /* Opacity of the ghost, [0, 1]. */
    vec3 position_m; /* Position of the ring's centre. */
    struct angles angles;
};

/* Lesson of one player (core/game/lesson/lesson.h): aids that are drawn in the tank. */
struct scene_lesson {
    uint8_t hint;           /* Hint beside the player's poi (enum scene_hint). */
    float hint_s;           /* Seconds since the hint `hint` appeared. */
    uint8_t marks_fish;     /* 1 if a ring marks the fish `fish`, otherwise 0. */
    uint8_t points_to_bowl; /* 1 if an arrow points from the poi to the bowl, otherwise 0. */
    uint16_t fish;          /* Index of the marked fish. */
    float mark_s;           /* Seconds since the fish was marked. */
    struct scene_ghost ghost;
};

/* A fan held over the water, with its shadow. */
struct scene_fan {
    uint8_t present;
    uint8_t owner; /* Player index; selects the fan's picture. */
    /* 1 if only the shadow is shown, so that the water below the fan stays visible; otherwise 0. */
    uint8_t unseen;
    float x_m, z_m; /* Centre of the shadow on the water, vertically below the light. */
    float radius_m;
    float dark; /* Share of the light that the fan blocks, [0, 1]. */
};

/* ---- Game ------------------------------------------------------------------------------------ */

enum scene_phase {
    PHASE_ATTRACT = 0,
    PHASE_READY = 1, /* A few seconds in which the player takes the poi. */
    PHASE_ROUND = 2,
    PHASE_RESULT = 3,
    /* The tank alone is shown, without text. The phase is not part of a game. */
    PHASE_WORDLESS = 4,
    PHASE_MODE_SELECT = 5,  /* Selection of the mode. */
    PHASE_LAB = 6,          /* The growth lab. */
    PHASE_ALBUM = 7,        /* Album: the caught fish grow up. */
    PHASE_MENU = 8,         /* The operator's menu. */
    PHASE_NAME = 9,         /* A ranked player enters a name. */
    PHASE_LEADERBOARD = 10, /* The leaderboard with the new name. */
};

enum game_mode {
    /* The round lasts until the paper cannot hold a fish or the time is over. */
    MODE_FESTIVAL = 0,
    MODE_CHAMPIONSHIP = 1, /* Rules of the federation: three minutes, one No. 5 poi, fouls. */
    /* The paper shows its stress, torn paper is replaced, and no score is kept. */
    MODE_PRACTICE = 2,
    MODE_COUNT = 3,
};

/* Levels of difficulty. A mode with levels (core/game/rules.h) lets each player choose one. The
 * values are stored in recordings and in the ledger. */
enum level {
    LEVEL_MASTER = 0, /* Full physics, as in the championship. */
    LEVEL_NORMAL = 1,
    LEVEL_EASY = 2,
    LEVEL_COUNT = 3,
};

/* The growth lab as an item of the mode selection. The lab is not scored. Used as a bit index in
 * `modes`. */
#define CHOICE_LAB ((uint8_t)MODE_COUNT)
#define CHOICE_COUNT (MODE_COUNT + 1u)

/* Fouls, which the umpire (core/game/phases.h) detects from the simulation. The third foul ends a
 * player's round. */
enum foul {
    FOUL_NONE = 0,
    /* The player poured fish into the bowl while part of the ring was still in the water. */
    FOUL_POURED = 1,
    FOUL_WALL = 2,  /* The player pressed fish against the tank's wall and scooped them there. */
    FOUL_SHADE = 3, /* The player held a shadow over the water before the start. */
    FOUL_COUNT = 4,
};
#define FOUL_MAX 3u

/* Time announcements. Each announcement is shown and played once. */
enum time_call {
    CALL_NONE = 0,
    CALL_ONE_MINUTE = 1,  /* The first minute has passed. */
    CALL_TWO_MINUTES = 2, /* Two minutes have passed. */
    CALL_TEN_SECONDS = 3, /* Ten seconds are left. */
    CALL_COUNTDOWN = 4,   /* One of the last five seconds begins; see seconds_left. */
    CALL_TIME = 5,        /* Time is up. */
};

/* Hints for the player. The renderer supplies the text in the scene's language. */
enum scene_hint {
    HINT_NONE = 0,
    HINT_START, /* Press START to play. */
    /* Move the poi over a fish. The lessons show HINT_DIP instead, but recordings contain the value
     * of HINT_MOVE. */
    HINT_MOVE,
    HINT_DIP,       /* Dip beside a fish. */
    HINT_LIFT,      /* Lift the fish that is over the paper. */
    HINT_BOWL,      /* Carry the fish to the bowl. */
    HINT_TILT,      /* Turn the wheel to tilt the poi. */
    HINT_SLOWLY,    /* Fast movement tears paper. */
    HINT_GLIDE,     /* Dip beside a fish, slide under it, lift softly. */
    HINT_TORN,      /* The paper is useless. */
    HINT_LOST_POI,  /* The controller is disconnected, and the round is paused. */
    HINT_WET_ALL,   /* Wet the whole paper, because paper tears between wet and dry areas. */
    HINT_NO_SHADE,  /* Keep the shadow off the water before the start. */
    HINT_CLEAR_RIM, /* Lift the whole ring out of the water before the bowl. */
    HINT_CHOOSE,    /* LEFT and RIGHT select a mode, START begins the round. */
    HINT_COIN,      /* Insert a coin to play. */
    HINT_PAID_BACK, /* The round ended because no poi was left; the credit was refunded. */
    HINT_COUNT,
};

enum language {
    LANGUAGE_JA = 0,
    LANGUAGE_EN = 1,
    LANGUAGE_COUNT,
};

/* State of the credits. */
struct scene_credit {
    uint8_t price;    /* Units per credit; 0 means free play. */
    uint8_t is_event; /* 1 if play is free because of an event, otherwise 0. */
    uint8_t unpaid;   /* 1 if no credit is available, so no round can start; otherwise 0. */
    uint8_t warnings; /* Bit mask of enum credit_warning. */
    /* 1 if the last round was refunded and none of its results were counted, otherwise 0. */
    uint8_t came_back;
    uint8_t coin_units; /* Units per pulse of the first coin line. */
    uint32_t units;     /* Units inserted towards the next credit. */
    uint32_t credits;   /* Credits that can be played. */
    uint32_t coming;    /* Credits that are not on disk yet. */
    /* Seconds since the last coin (`coin_s`), and since the last start attempt without a credit
     * (`request_s`). A value of one day or more means never. */
    float coin_s, request_s;
};

/* ---- Whole scene ----------------------------------------------------------------------------- */

/* State of the score playback, which is drawn over every page
 * (platform/kiosk/recorder/score_playback.h). */
enum scene_playback {
    PLAYBACK_OFF = 0,
    /* The replay is loaded, and is played fast until the round of the score begins. */
    PLAYBACK_SEEKS,
    PLAYBACK_PLAYS,
    /* The playback is over, and its result matched the stored record bit for bit. */
    PLAYBACK_GENUINE,
    PLAYBACK_OTHER, /* The playback is over, and its result differed from the stored record. */
    PLAYBACK_NONE,  /* The score has no replay. */
    PLAYBACK_COUNT,
};

struct scene {
    uint32_t tick;
    /* Camera in the axes of the world. core_scene() sets `view` to the camera for wide screens and
     * `turned_view` to the camera on the short side of the tank. The frame loop copies
     * `turned_view` to `view` if the screen is in portrait format. */
    struct view view, turned_view;
    vec3 tank_size_m;    /* Inner width (x), water depth (y) and breadth (z) of the tank. */
    float wall_height_m; /* Height from floor to rim, greater than the water depth. */

    uint32_t fish_count; /* Number of fish, <= SCENE_FISH_MAX. */
    struct scene_fish fish[SCENE_FISH_MAX];
    struct scene_poi poi[POI_MAX];
    struct scene_bowl bowl[POI_MAX];
    struct scene_fan fan[SHADE_MAX];
    struct scene_pump pump;
    struct scene_splash splash[SCENE_SPLASH_MAX]; /* Sorted from the newest to the oldest. */
    uint32_t splash_count;
    struct scene_scrap scrap[SCENE_SCRAP_MAX];
    uint32_t scrap_count;
    /* Slope of the water surface along x and z, times 508; +-127 is a slope of +-0.25. */
    int8_t slope[RIPPLE_Z][RIPPLE_X][2];

    uint8_t phase;    /* enum scene_phase */
    uint8_t language; /* enum language */
    /* Size of small texts on the pages for players: 0 normal, 1 large, 2 largest. */
    uint8_t text_size;
    /* Hint for the whole screen (enum scene_hint). The hints beside the pois are in `lesson`. */
    uint8_t hint;
    float phase_s; /* Seconds since the phase began. */
    /* Darkness of the tank, [0, 1], while the core reinitializes itself between two games. Text
     * over the tank stays bright. */
    float veil;
    /* Seconds left in the round. In READY: seconds until the round begins. In mode selection and
     * name entry: seconds until the timeout. In other phases 0. */
    float seconds_left;
    uint32_t caught[POI_MAX];
    uint32_t best_today; /* Best score today in this mode, at the level of the round. */
    /* 1 if the bot played in this round, so the result is no person's score; otherwise 0. */
    uint8_t by_bot;

    /* Mode of this round (enum game_mode); in PHASE_MODE_SELECT, the selected mode. */
    uint8_t mode;
    uint8_t level;        /* Easiest level of the players in this round (enum level). */
    uint8_t choice;       /* In PHASE_MODE_SELECT: the selected mode, or CHOICE_LAB. */
    uint8_t tags;         /* Bit mask of the tags of the mode selection (core/game/mode_tags.h). */
    uint8_t pointed_tags; /* Bit mask of the tags that players have selected. */
    uint8_t upright;      /* 1 if the tags of the mode selection are on the portrait canvas. */
    /* Bit mask of the modes that can be selected (1 << enum game_mode, or 1 << CHOICE_LAB). */
    uint8_t modes;
    struct scene_offer {
        uint16_t round_s; /* Longest duration of a round in seconds. */
        uint8_t grade;    /* Grade of the paper. */
    } offer[MODE_COUNT];  /* Entry for each mode, including modes that cannot be selected. */
    uint8_t grade;        /* Grade of the round's paper, or 0 if players have different grades. */
    /* 1 if a controller is lost and the round's clock is stopped, otherwise 0. */
    uint8_t paused;
    uint8_t call; /* enum time_call of the latest announcement. */
    float call_s; /* Seconds since the latest announcement. */
    struct scene_player {
        uint8_t plays; /* 1 if the player takes part in this round, otherwise 0. */
        /* 1 if the controller is disconnected or its input is invalid, otherwise 0. */
        uint8_t lost;
        uint8_t fouls; /* Number of the player's counted fouls, 0 .. FOUL_MAX. */
        uint8_t foul;  /* Kind of the latest foul (enum foul). */
        float foul_s;  /* Seconds since the latest foul. */
        /* 1 if the player's round is over, because of fouls or because no paper is left; otherwise
         * 0. */
        uint8_t out;
        /* In RESULT: the player's best place on the leaderboards, from 1; 0 means not ranked. */
        uint8_t place;
        uint8_t period; /* Period of the leaderboard with the best place (enum rank_period). */
        uint8_t level;  /* Level of the player in the round, or the selected level (enum level). */
        uint8_t has_pointer; /* In PHASE_MODE_SELECT: 1 if the player has a pointer. */
        float x, y;          /* In PHASE_MODE_SELECT: position of the pointer on the canvas. */
        /* In RESULT: 1 if the player caught no fish and gets one as a present, otherwise 0. */
        uint8_t has_present;
        float miss_s; /* In ROUND: seconds since the latest near miss; 0 means none. */
    } player[POI_MAX];
    struct scene_tear tear[POI_MAX];
    struct scene_lesson lesson[POI_MAX];

    struct scene_credit credit;
    /* 1 if TEST was pressed in a round, so a second press ends the round; otherwise 0. */
    uint8_t is_confirming_menu;
    /* 1 if the quit key was pressed on a desktop, so a second press ends the program; otherwise 0.
     * The shell fills in this field. */
    uint8_t is_confirming_quit;
    struct scene_menu menu;
    struct scene_devices devices;
    struct scene_lab lab;
    struct scene_album album;
    struct scene_name name;
    struct scene_leaderboard leaderboard;
    /* State of the score playback (enum scene_playback). The shell fills in this field. */
    uint8_t playback;
    /* Progress of the fast playback before the round of the score, [0, 1]. */
    float playback_progress;
};

/* Changes the scene from a wide screen to a portrait screen, whose player stands at the short side
 * of the tank: the camera, the handles of bots, and the hands. A second call changes nothing. */
static inline void scene_use_turned(struct scene *scene)
{
    scene->view = scene->turned_view;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene->poi[i].handle_rad = scene->poi[i].turned_handle_rad;
        scene->poi[i].left_hand = scene->poi[i].turned_left_hand;
    }
}
