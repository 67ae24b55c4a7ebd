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

/* State of the score playback, which is drawn over every other page; see
 * platform/kiosk/score_playback.h. */
enum scene_encore {
    ENCORE_OFF = 0,
    ENCORE_SEEKS, /* The replay is loaded and played fast up to its round. */
    ENCORE_PLAYS,
    ENCORE_GENUINE, /* The playback is over, and its result matched the record bit for bit. */
    ENCORE_OTHER,   /* The playback is over, and its result differed from the record. */
    ENCORE_NONE,    /* The score has no replay. */
    ENCORE_COUNT,
};

struct scene {
    uint32_t tick;
    struct view view;
    vec3 tank_size_m;    /* Inner width (x), water depth (y), breadth (z). */
    float wall_height_m; /* Height from floor to rim, greater than the water depth. */

    uint32_t fish_count; /* <= SCENE_FISH_MAX */
    struct scene_fish fish[SCENE_FISH_MAX];
    struct scene_poi poi[POI_MAX];
    struct scene_bowl bowl[POI_MAX];
    struct scene_fan fan[SHADE_MAX];
    struct scene_pump pump;
    int8_t slope[RIPPLE_Z][RIPPLE_X][2]; /* Surface slope (x, z) * 508: +-127 is +-0.25. */

    uint8_t phase;      /* enum scene_phase */
    uint8_t language;   /* enum language */
    uint8_t hint;       /* enum scene_hint */
    float phase_s;      /* Seconds since the phase began. */
    float veil;         /* [0, 1]: darkness of the tank in the fade between two sessions; text
                           over the tank stays bright. */
    float seconds_left; /* Seconds left in the round; in READY, seconds until the round begins;
                           else 0. */
    uint32_t caught[POI_MAX];
    uint32_t best_today; /* Best score today in this mode. */
    uint8_t by_bot;      /* 1: the bot played in this round, so it is no person's score. */

    uint8_t mode;   /* enum game_mode of this round; in CHOOSE, the selected mode. */
    uint8_t choice; /* In CHOOSE: the selected mode, or CHOICE_LAB. */
    uint8_t modes;  /* Bit mask of the modes on offer (1 << enum game_mode, or 1 << CHOICE_LAB). */
    struct scene_offer {
        uint16_t round_s; /* Longest duration in seconds. */
        uint8_t grade;    /* Grade of the paper. */
    } offer[MODE_COUNT];  /* Entry for every mode, on offer or not. */
    uint8_t grade;        /* Grade of the round's paper. */
    uint8_t paused;       /* 1: a controller is lost and the clock is stopped. */
    uint8_t call;         /* enum time_call of the latest announcement. */
    float call_s;         /* Seconds since the latest announcement. */
    struct scene_player {
        uint8_t plays;  /* 1: the player takes part in this round. */
        uint8_t lost;   /* 1: the controller is disconnected or its input is invalid. */
        uint8_t fouls;  /* 0 .. FOUL_MAX */
        uint8_t foul;   /* enum foul of the latest foul. */
        float foul_s;   /* Seconds since the latest foul. */
        uint8_t out;    /* 1: the player's round is over, because of fouls or because no paper is
                           left. */
        uint8_t place;  /* In RESULT: the player's best place on the leaderboard, from 1; 0: not
                           ranked. */
        uint8_t period; /* enum rank_period of `place`. */
    } player[POI_MAX];

    struct scene_credit credit;
    uint8_t asks_menu; /* 1: TEST was pressed in a round; a second press ends the round. */
    uint8_t asks_quit; /* 1: the quit key was pressed on a desktop; a second press exits. The shell
                          fills in this field. */
    struct scene_menu menu;
    struct scene_devices devices;
    struct scene_lab lab;
    struct scene_album album;
    struct scene_name name;
    struct scene_leaderboard leaderboard;
    uint8_t playback;      /* enum scene_encore; the shell fills in this field. */
    float encore_progress; /* [0, 1] progress of the fast playback up to the round. */
};

#endif
