/* scene.h -- what there is to see, rebuilt from the state once per frame.
 *
 * Plain data with no pointers, so a scene can be kept, compared or drawn on another thread. Its
 * parts, in the order in which they are drawn: scene_tank.h (what stands and swims in the water),
 * scene_game.h (phases, calls, hints, credits), scene_pages.h (lab, album, name, ranking) and
 * scene_menu.h (the operator's). */
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
    uint8_t asks_quit; /* The quit key was pressed at a desk: once more, and the kiosk ends. The
                          shell fills it in. */
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
