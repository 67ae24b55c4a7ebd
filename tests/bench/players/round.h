/* round.h -- plays one round of a simulated player with the kiosk's frame loop. Measures the catch,
 * the tears of the paper, and how the fish flee. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_ROUND_H
#define KINGYO_TESTS_BENCH_PLAYERS_ROUND_H

#include <stdbool.h>
#include <stdint.h>

#include "core/game/bot/bot.h"
#include "platform/kiosk/kiosk.h"
#include "tests/bench/players/person.h"

#define ROUND_FISH_COUNT 300u
#define ROUND_LENGTH_S 60u
#define ROUND_GRADE 6u

extern const char *const round_tear_names[TEAR_CAUSE_COUNT]; /* Names of enum tear_cause. */

/* Outcome of one attempt to catch the chosen fish. */
enum attempt_end {
    ATTEMPT_FLED_BEFORE = 0, /* The fish fled before the dip. */
    ATTEMPT_FLED_DIP,        /* The fish fled during the dip or the hold. */
    ATTEMPT_FLED_FOLLOW,     /* The fish fled while the ring followed it. */
    ATTEMPT_FLED_LIFT,       /* The fish fled during the lift. */
    ATTEMPT_BELOW,           /* The fish did not flee, but was below the ring at the lift. */
    ATTEMPT_AWAY,            /* The fish did not flee, but was beside the ring at the lift. */
    ATTEMPT_SLIPPED,         /* The fish was above the ring at the lift, but not on the paper. */
    ATTEMPT_HELD,            /* A fish lay on the paper after the lift. */
    ATTEMPT_END_COUNT,
};
extern const char *const round_attempt_names[ATTEMPT_END_COUNT];

struct player_round {
    bool is_played; /* True if the round came to its end. */
    uint32_t caught, scoops;
    bool torn;      /* True if the paper tore so far that it could no longer hold a fish. */
    double torn_s;  /* Time in the round at which `torn` became true, in seconds. */
    double first_s; /* Time of the first torn cell in the round, in seconds; 0 if no cell tore. */
    /* Time for which the paper had been wet when the first cell tore, on average over its cells. */
    double wet_s;
    uint8_t first_cause;              /* Cause of the first torn cell (enum tear_cause). */
    uint32_t cells[TEAR_CAUSE_COUNT]; /* Number of torn cells for each cause. */
    uint32_t attempts[ATTEMPT_END_COUNT];
    /* Number of times that the chosen fish fled after the dip: in total, because it saw the ring
     * approach, and because of the ring's pressure wave. */
    uint32_t flights, flights_by_sight, flights_by_pressure;
    /* Sums over these flights: time since the dip in seconds, horizontal distance between fish and
     * ring, height of the ring above the fish, and speed of the ring along its normal. */
    double flight_s, flight_m, flight_above_m, flight_m_s;
};

/* State of one worker thread, which plays one round at a time. The struct is too large for a
 * stack. */
struct round_seat {
    struct kiosk kiosk;
    struct hal hal;
    struct person person; /* The clock of the person's device is also the clock of the kiosk. */
    struct bot bot;
    bool is_bot;
    uint8_t prey_startle; /* Last startle cause of the chosen fish, until its escape begins. */
    bool prey_fled;       /* True after the chosen fish fled in this attempt. */
    uint8_t attempt_end;  /* Outcome of the current attempt, as far as known. */
    uint8_t state;        /* State of the player in the previous tick. */
    uint64_t dip_tick;    /* Tick of the last dip. */
    struct player_round *result;
};

/* Plays one round at the level `level` (enum level). Returns false if the kiosk refused to
 * start or the round did not end. */
bool round_play(struct round_seat *seat, const struct habits *habits, uint8_t level, uint32_t seed,
                struct player_round *result);

#endif
