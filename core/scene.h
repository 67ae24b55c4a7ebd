/* scene.h -- the complete picture of one frame, rebuilt from the state.
 *
 * The scene is plain data without pointers, so it can be stored, compared or drawn on another
 * thread. The parts of a scene, in drawing order:
 * - scene_tank.h: objects and fish in the water,
 * - scene_game.h: phases, announcements, hints and credits,
 * - scene_pages.h: lab, album, name entry and leaderboard,
 * - scene_menu.h: the operator's menu. */
#ifndef KINGYO_CORE_SCENE_H
#define KINGYO_CORE_SCENE_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/scene_game.h"
#include "core/scene_menu.h"
#include "core/scene_pages.h"
#include "core/scene_tank.h"
#include "core/view.h"

/* State of the score playback, which is drawn over every page
 * (platform/kiosk/recorder/score_playback.h). */
enum scene_encore {
    ENCORE_OFF = 0,
    ENCORE_SEEKS, /* The replay is loaded, and is played fast until the round of the score
                     begins. */
    ENCORE_PLAYS,
    ENCORE_GENUINE, /* The playback is over, and its result matched the stored record bit for
                       bit. */
    ENCORE_OTHER,   /* The playback is over, and its result differed from the stored record. */
    ENCORE_NONE,    /* The score has no replay. */
    ENCORE_COUNT,
};

struct scene {
    uint32_t tick;
    struct view view;
    vec3 tank_size_m;    /* Inner width (x), water depth (y) and breadth (z) of the tank. */
    float wall_height_m; /* Height from floor to rim, greater than the water depth. */

    uint32_t fish_count; /* Number of fish, <= SCENE_FISH_MAX. */
    struct scene_fish fish[SCENE_FISH_MAX];
    struct scene_poi poi[POI_MAX];
    struct scene_bowl bowl[POI_MAX];
    struct scene_fan fan[SHADE_MAX];
    struct scene_pump pump;
    int8_t slope[RIPPLE_Z][RIPPLE_X][2]; /* Slope of the water surface along x and z, times 508;
                                            +-127 is a slope of +-0.25. */

    uint8_t phase;      /* enum scene_phase */
    uint8_t language;   /* enum language */
    uint8_t hint;       /* enum scene_hint */
    float phase_s;      /* Seconds since the phase began. */
    float veil;         /* Darkness of the tank in the fade between two sessions, [0, 1]. Text over
                           the tank stays bright. */
    float seconds_left; /* Seconds left in the round. In READY: seconds until the round begins. In
                           mode selection and name entry: seconds until the timeout. In other phases
                           0. */
    uint32_t caught[POI_MAX];
    uint32_t best_today; /* Best score today in this mode. */
    uint8_t by_bot;      /* 1 if the bot played in this round, so the result is no person's score;
                            otherwise 0. */

    uint8_t mode;   /* Mode of this round (enum game_mode); in PHASE_MODE_SELECT, the selected
                       mode. */
    uint8_t choice; /* In PHASE_MODE_SELECT: the selected mode, or CHOICE_LAB. */
    uint8_t modes;  /* Bit mask of the modes that can be selected (1 << enum game_mode, or 1 <<
                       CHOICE_LAB). */
    struct scene_offer {
        uint16_t round_s; /* Longest duration of a round in seconds. */
        uint8_t grade;    /* Grade of the paper. */
    } offer[MODE_COUNT];  /* Entry for each mode, including modes that cannot be selected. */
    uint8_t grade;        /* Grade of the round's paper. */
    uint8_t paused;       /* 1 if a controller is lost and the round's clock is stopped, otherwise
                             0. */
    uint8_t call;         /* enum time_call of the latest announcement. */
    float call_s;         /* Seconds since the latest announcement. */
    struct scene_player {
        uint8_t plays;  /* 1 if the player takes part in this round, otherwise 0. */
        uint8_t lost;   /* 1 if the controller is disconnected or its input is invalid, otherwise
                           0. */
        uint8_t fouls;  /* 0 .. FOUL_MAX */
        uint8_t foul;   /* Kind of the latest foul (enum foul). */
        float foul_s;   /* Seconds since the latest foul. */
        uint8_t out;    /* 1 if the player's round is over, because of fouls or because no paper is
                           left; otherwise 0. */
        uint8_t place;  /* In RESULT: the player's best place on the leaderboards, from 1; 0 means
                           not ranked. */
        uint8_t period; /* Period of the leaderboard with the best place (enum rank_period). */
    } player[POI_MAX];

    struct scene_credit credit;
    uint8_t asks_menu; /* 1 if TEST was pressed in a round, so a second press ends the round;
                          otherwise 0. */
    uint8_t asks_quit; /* 1 if the quit key was pressed on a desktop, so a second press ends the
                          program; otherwise 0. The shell fills in this field. */
    struct scene_menu menu;
    struct scene_devices devices;
    struct scene_lab lab;
    struct scene_album album;
    struct scene_name name;
    struct scene_leaderboard leaderboard;
    uint8_t playback;      /* State of the score playback (enum scene_encore). The shell fills in
                              this field. */
    float encore_progress; /* Progress of the fast playback before the round of the score, [0,
                              1]. */
};

#endif
