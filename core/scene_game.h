/* scene_game.h -- the words in which a scene tells of a game: its phases, modes, fouls, calls and
 * hints, and what was paid for it. */
#ifndef KINGYO_CORE_SCENE_GAME_H
#define KINGYO_CORE_SCENE_GAME_H

#include <stdint.h>

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

#endif
