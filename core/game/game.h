/* game.h -- the state of the game, and the functions of game_tick.c that core.c calls.
 *
 * The phases are attract, mode selection, ready, round, result, name, leaderboard and album, plus
 * the growth lab and the operator's menu. Each phase works on `struct game`. phases.h declares the
 * functions of the phases. game_tick.c runs the steps of a tick and calls every phase. No phase
 * includes a header that belongs to game_tick.c alone. Differences between modes are data
 * (rules.h). */
#pragma once

#include <stdint.h>

#include "core/game/accounting/accounts.h"
#include "core/game/bot/bot_state.h"
#include "core/game/control/control_state.h"
#include "core/game/lab/lab_state.h"
#include "core/game/menu/menu_state.h"
#include "core/game/pointer_mapping.h"
#include "core/game/ranking/name_keyboard.h"
#include "core/game/rules.h"
#include "core/game/session_state.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

struct game;
struct world;
struct core_config;

/* Length of READY, the phase before a round, in the festival mode and in the practice mode. */
#define GAME_READY_TICKS (RULES_READY_S * CORE_TICK_HZ)
/* Duration of the result screen, long enough to read the result and to call a friend. */
#define GAME_RESULT_TICKS (12u * CORE_TICK_HZ)
/* Delay between the moment when the last player is out of the round and the result screen. In this
 * time the player sees the hole in the paper. */
#define GAME_GONE_TICKS (3u * CORE_TICK_HZ)
/* Time after the end of the round in which the last fish can be carried to the bowl. */
#define GAME_CARRY_TICKS (3u * CORE_TICK_HZ)
/* Time after the result screen appears in which START presses are ignored. Afterwards a START press
 * starts the next game. */
#define GAME_AGAIN_TICKS (3u * CORE_TICK_HZ / 2u)
/* Time after the result screen appears in which dips of the poi are ignored. Afterwards a dip
 * starts the next game. The time for dips is longer than the time for START, because a dip happens
 * more easily by accident. */
#define GAME_AGAIN_DIP_TICKS (5u * CORE_TICK_HZ / 2u)
/* Longest duration of the mode selection, even if a poi moves all the time. Such long motion comes
 * from a poi that swings on its cord. */
#define GAME_MODE_SELECT_TICKS_MAX (120u * CORE_TICK_HZ)
/* Time after the mode selection appears in which presses are ignored, so that the player sees the
 * items first. */
#define GAME_MODE_SELECT_TICKS_MIN (CORE_TICK_HZ / 2u)
/* Time in attract mode for which the air pump is off. */
#define GAME_STALE_TICKS (115u * CORE_TICK_HZ)
/* Time in attract mode for which the air pump runs. The pump is off for GAME_STALE_TICKS and then
 * on for GAME_AIR_TICKS, again and again. */
#define GAME_AIR_TICKS (45u * CORE_TICK_HZ)
/* Default grade (strength) of the paper, which real stalls use most. */
#define GAME_POI_GRADE 6u

/* Distance from the rest position within which a controller counts as resting. */
#define PLAYER_STIR_M 0.03f

/* Type of the functions that run one tick of a phase of the game. */
typedef void game_phase_tick(struct game *game, struct world *world, struct core_config *config,
                             const struct input *input, struct output *output);

/* Motion of a controller since READY (the phase before a round) or the mode selection began. */
enum player_stance { STANCE_UNSEEN = 0, STANCE_RESTS, STANCE_MOVED };

struct player {
    uint8_t plays; /* 1 if the player has had a poi in use in this round, otherwise 0. */
    /* 1 if the player is out, which means that the player's round ended before the time was up.
     * Otherwise 0. */
    uint8_t out;
    uint8_t handed; /* 1 if the player has received fresh paper for this round, otherwise 0. */
    /* Tag under the player's pointer in the mode selection, as its number among the offered tags,
     * counted from 1. 0 means no tag. */
    uint8_t points;
    /* Level of the player in this round, or the level that the player has selected in the mode
     * selection (enum level). */
    uint8_t level;
    uint8_t has_pointer; /* 1 if the player has a pointer in the mode selection, otherwise 0. */
    struct layout_point pointer; /* Position of the player's pointer on the canvas. */
    uint8_t fouls;               /* Number of the player's counted fouls, 0 .. FOUL_MAX. */
    uint8_t foul;                /* Kind of the player's latest foul (enum foul). */
    uint32_t foul_tick;          /* Tick of the player's latest counted foul. */
    /* Tick at which the player last committed each kind of foul, counted or not. */
    uint32_t offence_tick[FOUL_COUNT];
    uint32_t caught;
    /* Number of dips that the player made in this round with earlier sheets of paper. The dips with
     * the current sheet are not included. */
    uint32_t scoops;
    /* Tick at which the player's current sheet of paper became useless; 0 means that the sheet is
     * usable. */
    uint32_t torn_tick;
    /* Tick at which the player's first sheet of paper became useless, minus the ticks for which the
     * round had been paused until then. 0 means that the first sheet is usable. */
    uint32_t first_torn_tick;
    /* Number of sheets that the player used up before the current sheet. */
    uint32_t sheets_before;
    /* Duration in ticks of the current pause in which other players wait for this player's
     * controller. */
    uint32_t lost_ticks;
    /* Total ticks in this round for which other players have waited for this player's
     * controller. */
    uint32_t waited_ticks;
    /* Motion of the controller since READY or the mode selection began (enum player_stance). */
    uint8_t stance;
    /* Rest position of the controller. In READY: position at which the controller was first seen.
     * In the mode selection: position at the controller's last motion. */
    float rest_x_m, rest_z_m;
};

/* Longest single pause of a round while no player has a working controller. After this time the
 * round ends. */
#define GAME_LOST_TICKS_MAX (60u * CORE_TICK_HZ)
/* Longest single pause in which other players wait for one lost controller. After this time the
 * player of that controller is out. */
#define GAME_LOST_TICKS_OTHERS (10u * CORE_TICK_HZ)
/* Longest total time per round for which other players wait for one lost controller. After this
 * time the player of that controller is out. */
#define GAME_WAIT_TICKS_OTHERS (30u * CORE_TICK_HZ)
/* Longest total time per round for which the round pauses because no player has a working
 * controller. After this time the round ends, even if a loose plug causes many short pauses. */
#define GAME_WAIT_TICKS_MAX POI_WAIT_TICKS_MAX
_Static_assert(GAME_LOST_TICKS_MAX <= GAME_WAIT_TICKS_MAX &&
                   GAME_WAIT_TICKS_OTHERS <= GAME_WAIT_TICKS_MAX,
               "the other players wait no longer than the whole pause");

/* Shortest time for which a hint is shown: 1.5 s, enough to read a short line. */
#define HINT_TICKS_MIN 180u

struct hints {
    uint8_t pupil;       /* Player who receives the hints, < POI_MAX. */
    uint8_t shown;       /* Hint that is shown (enum scene_hint). */
    uint32_t shown_tick; /* Tick at which the hint appeared. */
    /* Bit mask (1 << enum scene_hint) of the hints whose actions the player has done. */
    uint32_t learned;
    uint32_t haste_tick; /* Tick at which fast motion last tore the paper; 0 means never. */
    /* Number of paper cells torn by fast motion since the hint rules were last evaluated. */
    uint32_t haste_cells;
    uint32_t paper_cells; /* Number of paper cells that the player's poi had in the last tick. */
    /* Number of dips that the player's poi had made when the player last caught a fish; 0 for a new
     * poi. */
    uint32_t dips_before;
    /* Number of fish that the player had caught when the hint rules were last evaluated. */
    uint32_t caught;
    float moved_m; /* Distance that the poi has moved in this round, up to 1 m. */
};

/* Time without pointing or pressing after which the name entry ends. */
#define NAME_IDLE_TICKS (20u * CORE_TICK_HZ)
/* Longest time in which one player may enter a name, even with help from friends. */
#define NAME_TICKS_MAX (60u * CORE_TICK_HZ)
/* Time after the start of a player's name entry in which presses are ignored, because such a press
 * was meant for the previous screen. */
#define NAME_SEEN_TICKS (CORE_TICK_HZ / 2u)
/* Time after which a held LEFT or RIGHT button starts to repeat. */
#define NAME_RUN_TICKS (CORE_TICK_HZ / 2u)
/* Ticks from one key to the next while a held LEFT or RIGHT button repeats. */
#define NAME_STEP_TICKS (CORE_TICK_HZ / 10u)
/* Number of rejected names after which a player may enter another name. If that name is rejected
 * too, the score has no name. */
#define NAME_REFUSALS_MAX 1u

struct name {
    uint32_t round_id; /* Ledger id of the last round with a ranked player; 0 means none. */
    uint8_t ranked;    /* Bit mask of the slots that are ranked in the round `round_id`. */
    uint8_t waits;     /* Bit mask of the ranked slots that still need a name. */
    uint8_t slot;      /* Slot of the player who enters a name. */
    uint8_t alphabet;  /* Displayed alphabet (enum name_alphabet). */
    uint8_t key;       /* Highlighted key: the index of a letter's cell, or an enum name_key. */
    uint8_t points;    /* Key under the pointer, counted from 1. 0 means no key. */
    uint8_t upright, has_pointer, presses;
    /* Number of names that the current player entered and the name filter rejected. */
    uint8_t refusals;
    uint8_t letter_count;
    uint16_t letter[NAME_LETTERS_MAX];
    uint32_t start_tick;  /* Tick at which the current player's name entry began. */
    uint32_t act_tick;    /* Tick of the current player's last press or pointer motion. */
    uint32_t held_ticks;  /* Ticks for which LEFT or RIGHT has been held. */
    float x, y;           /* Pointer position on the canvas. */
    float rest_x, rest_y; /* Position of the pointer when it last moved. */
};

/* Places of the bowl of a player who plays alone. The first two are on the right and on the left
 * of a player at the long side of the tank (wide screen). The last two are on the left and on the
 * right of a player at the short side with positive x (portrait screen). */
enum bowl_place {
    BOWL_PLACE_RIGHT,
    BOWL_PLACE_LEFT,
    BOWL_PLACE_NEAR_LEFT,
    BOWL_PLACE_NEAR_RIGHT,
    BOWL_PLACE_COUNT,
};

struct game {
    uint32_t tick;    /* Number of the current tick, counted from 0 at the start of the kiosk. */
    uint8_t phase;    /* Current phase (enum scene_phase). */
    uint8_t language; /* Display language (enum language). */
    /* Mode (enum game_mode) of the running round; in the mode selection, the mode that is
     * selected. */
    uint8_t mode;
    uint8_t lab_chosen; /* 1 if the growth lab is selected in the mode selection, otherwise 0. */
    /* 1 if the mode selection is shown on the portrait canvas, otherwise 0. */
    uint8_t upright;
    uint8_t bot_played; /* 1 if the bot controlled a poi in this round, otherwise 0. */
    /* 1 if a player or the bot has had a poi in use in this round, otherwise 0. */
    uint8_t played;
    uint8_t paused;     /* 1 if the round is paused because a controller is lost, otherwise 0. */
    uint8_t call;       /* Latest time announcement in this round (enum time_call). */
    uint32_t call_tick; /* Tick of the latest time announcement. */
    /* Tick at which the phase began. While the round's clock is paused, `phase_tick` rises by one
     * per tick, so that the time since the start of the phase stays the same. */
    uint32_t phase_tick;
    uint32_t round_tick;   /* Tick at which the round began; not changed by pauses. */
    uint32_t paused_ticks; /* Ticks for which the round's clock was paused, for any reason. */
    /* Tick at which a player last selected an item in the mode selection. */
    uint32_t point_tick;
    /* Duration in ticks of the current pause in which no player has a working controller. */
    uint32_t lost_ticks;
    /* Total duration in ticks of all pauses of this round in which no player had a working
     * controller. */
    uint32_t waited_ticks;
    /* Tick at which the last player was out, or 0 while a player is still in the round. During
     * pauses the value rises by one per tick. In attract mode: tick at which the bot's paper was
     * torn or its bowl was full. */
    uint32_t gone_tick;
    /* Tick at which a visitor's choice of language in attract mode ends; 0 means no choice. */
    uint32_t language_until;
    /* Place of the bowl of a player who plays alone (enum bowl_place). */
    uint8_t bowl_place;
    /* Tick at which a new session starts, which means that the core reinitializes itself
     * (session.c); 0 means that no session was requested. */
    uint32_t turn_tick;
    uint32_t round_s;     /* Length of this round in seconds. */
    uint32_t round_count; /* Number of started rounds; part of the seed of the next paper. */
    struct accounts accounts;
    struct settings_edit settings_edit;
    struct name name;
    struct player player[POI_MAX];
    struct control control[POI_MAX];
    struct hints hints;
    struct bot bot[POI_MAX];
    struct health_log health_log;
    struct menu menu;
    struct album album;
    struct lab lab;
};

/* Initializes `game` from `config`, including the state that `config->session` carries over from
 * the time before the initialization. */
void game_init(struct game *game, const struct core_config *config);

/* Runs the first step of a tick: updates the phase, and supplies fresh paper and empty bowls at the
 * start of a round. Fills `targets` with the target pose of each poi, from the controller or the
 * bot. Fills `live` with 1 for each poi in use, otherwise 0. */
void game_tick(struct game *game, struct world *world, struct core_config *config,
               const struct input *input, struct output *output, struct poi_target targets[POI_MAX],
               uint8_t live[POI_MAX]);
