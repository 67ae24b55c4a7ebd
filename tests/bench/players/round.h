/* round.h -- plays one round of a simulated player with the kiosk's frame loop. Measures how many
 * fish the player catches, how the paper tears, and how the fish flee. */
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

/* Names of the values of enum tear_cause. */
extern const char *const round_tear_names[TEAR_CAUSE_COUNT];

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
    /* True if the round was played to its end. */
    bool is_played;
    uint32_t caught, scoops;
    uint32_t near_misses; /* Number of near misses that the kiosk announced (near_miss.h). */
    bool torn;            /* True if the paper tore so far that it could no longer hold a fish. */
    double torn_s;        /* Time in the round at which `torn` became true, in seconds. */
    double first_s; /* Time of the first torn cell in the round, in seconds; 0 if no cell tore. */
    /* Time in seconds for which the paper had been wet when the first cell tore, as a mean over all
     * cells of the paper. */
    double wet_s;
    uint8_t first_cause;              /* Cause of the first torn cell (enum tear_cause). */
    uint32_t cells[TEAR_CAUSE_COUNT]; /* Number of torn cells for each cause. */
    uint32_t attempts[ATTEMPT_END_COUNT];
    /* Number of times that the chosen fish fled after the dip: for any cause, because the fish saw
     * the ring approach, and because of the ring's pressure wave. */
    uint32_t flights, flights_by_sight, flights_by_pressure;
    /* Sums over these flights: the time since the dip, the horizontal distance between fish and
     * ring, the height of the fish below the ring (positive if the ring is higher), and the speed
     * of the ring along its normal. */
    double flight_s, flight_m, flight_above_m, flight_m_s;
};

/* State of one worker thread, which plays one round after another. The struct is too large for a
 * stack. */
struct round_worker {
    struct kiosk kiosk;
    struct hal hal;
    struct person person; /* The clock of the person's device is also the clock of the kiosk. */
    struct bot bot;
    bool is_bot;
    uint8_t prey_startle; /* Cause of the last startle of the chosen fish before its escape began
                             (enum startle_cause). */
    bool prey_fled;       /* True after the chosen fish has fled in this attempt. */
    /* Outcome that the current attempt has so far (enum attempt_end). */
    uint8_t attempt_end;
    uint8_t state;      /* State of the player in the previous tick. */
    uint64_t dip_tick;  /* Tick of the last dip. */
    uint32_t miss_tick; /* Tick of the last near miss that was announced; 0 means none. */
    struct player_round *result;
};

/* Plays one round at the level `level` (enum level). Returns false if the kiosk refused to
 * start or the round did not end. */
bool round_play(struct round_worker *worker, const struct habits *habits, uint8_t level,
                uint32_t seed, struct player_round *result);

#endif
