/* scene_game.h -- the game part of a scene: phases, modes, fouls, announcements, hints and
 * credits. */
#ifndef KINGYO_CORE_SCENE_GAME_H
#define KINGYO_CORE_SCENE_GAME_H

#include <stdint.h>

enum scene_phase {
    PHASE_ATTRACT = 0,
    PHASE_READY = 1, /* A few seconds in which the player takes the poi. */
    PHASE_ROUND = 2,
    PHASE_RESULT = 3,
    PHASE_WORDLESS = 4,     /* The tank alone is shown, without text. The phase is not part of a
                               game. */
    PHASE_MODE_SELECT = 5,  /* Selection of the mode. */
    PHASE_LAB = 6,          /* The growth lab. */
    PHASE_ALBUM = 7,        /* Album: the caught fish grow up. */
    PHASE_MENU = 8,         /* The operator's menu. */
    PHASE_NAME = 9,         /* A ranked player enters a name. */
    PHASE_LEADERBOARD = 10, /* The leaderboard with the new name. */
};

enum game_mode {
    MODE_FESTIVAL = 0,     /* The round lasts until the paper cannot hold a fish or the time is
                              over. */
    MODE_CHAMPIONSHIP = 1, /* Rules of the federation: three minutes, one No. 5 poi, fouls. */
    MODE_PRACTICE = 2,     /* The paper shows its stress, torn paper is replaced, and no score is
                              kept. */
    MODE_COUNT = 3,
};

/* The growth lab as an item of the mode selection. The lab is not scored. Used as a bit index in
 * `modes`. */
#define CHOICE_LAB ((uint8_t)MODE_COUNT)
#define CHOICE_COUNT (MODE_COUNT + 1u)

/* Fouls, which the umpire (core/game/phases.h) detects from the simulation. The third foul ends a
 * player's round. */
enum foul {
    FOUL_NONE = 0,
    FOUL_POURED = 1, /* The player poured fish into the bowl while part of the ring was still in the
                        water. */
    FOUL_WALL = 2,   /* The player pressed fish against the tank's wall and scooped them there. */
    FOUL_SHADE = 3,  /* The player held a shadow over the water before the start. */
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
    HINT_START,     /* Press START to play. */
    HINT_MOVE,      /* Move the poi over a fish. */
    HINT_DIP,       /* Hold the button to dip. */
    HINT_LIFT,      /* Release the button to lift. */
    HINT_BOWL,      /* Carry the fish to the bowl. */
    HINT_TILT,      /* The wheel tilts the poi. */
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
    uint8_t price;         /* Units per credit; 0 means free play. */
    uint8_t is_event;      /* 1 if play is free because of an event, otherwise 0. */
    uint8_t unpaid;        /* 1 if no credit is available, so no round can start; otherwise 0. */
    uint8_t warnings;      /* Bit mask of enum credit_warning. */
    uint8_t came_back;     /* 1 if the last round was refunded and none of its results were counted,
                              otherwise 0. */
    uint8_t coin_units;    /* Units per pulse of the first coin line. */
    uint32_t units;        /* Units inserted towards the next credit. */
    uint32_t credits;      /* Credits that can be played. */
    uint32_t coming;       /* Credits that are not on disk yet. */
    float coin_s, asked_s; /* Seconds since the last coin (`coin_s`), and since the last start
                              attempt without a credit (`asked_s`). A value of one day or more means
                              never. */
};

#endif
