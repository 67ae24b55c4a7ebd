/* crowd.h -- the broad phase: which fish of a tank are near, which meet, and which could touch.
 *
 * Every column has the index of the tank's fish. A fish that does not swim (carried by a poi, or in
 * a bowl) has a row in the columns but is not in the grid. */
#ifndef KINGYO_CORE_TANK_CROWD_H
#define KINGYO_CORE_TANK_CROWD_H

#include "core/tank/avoid.h"
#include "core/tank/body.h"
#include "core/tank/fish.h"
#include "core/tank/pairs.h"

#define CROWD_CONTACT_MAX                                                                          \
    (4u * TANK_FISH_MAX) /* 1.4 overlaps per fish occur at the thesis' density. Further contacts get
                            a slot by lot in each tick. */

enum crowd_flag {
    CROWD_SWIMS = 1,    /* The fish is in the grid. */
    CROWD_AIRBORNE = 2, /* Above the surface, which therefore does not hold the fish. */
    CROWD_BESIDE = 4,   /* An obstacle is within reach. */
    CROWD_GULPS = 8,    /* The snout may stand out of the water. */
    CROWD_BACK = 16,    /* The fish went back to its pose of the previous tick. */
    CROWD_UNLISTED = 32, /* A contact of the fish found no slot in the full list. */
};

/* Results of a query for one fish about its neighbours; valid until the next query. */
struct company {
    struct avoid_advice advice; /* Advice of the encounter that is soonest. */
    vec3 push_m_s;              /* Sum of the repulsion of near fish. */
    float brake, room;          /* Same members as in struct fish. */
};

#define CROWD_LOOK_TICKS 4u /* Ticks between full queries (33 ms, the period of a fish's decisions),
                               unless a fish moves faster than expected. */
#define CROWD_TOUCH_M 0.002f /* Pairs nearer than this may come to touch while the contact solver
                                moves other pairs. Half of it is the allowance of each body by
                                default. */

/* Two fish whose bodies could touch before the next query. */
struct contact {
    fish_index a, b;
    float gap_m; /* Least gap between the bodies at the query; < 0 is an overlap. */
};

struct crowd {
    uint32_t count; /* All fish, whether they swim or not. */
    struct body body[TANK_FISH_MAX];
    uint8_t flags[TANK_FISH_MAX]; /* enum crowd_flag */
    struct company company[TANK_FISH_MAX];
    /* Results of a query stay valid until the next query. The results are state, so crowd_hash()
     * covers them. */
    uint32_t near_count;    /* Contacts in the list. */
    uint32_t contact_count; /* Leading contacts in the list that could touch in this tick. */
    struct contact contact[CROWD_CONTACT_MAX];
    float way_m[TANK_FISH_MAX];   /* Longest distance that any point of a body moved since the
                                     query. */
    float reach_m[TANK_FISH_MAX]; /* Distance that a body may move before the next query is due. */
    uint32_t overlap_count; /* Pairs whose bodies overlapped at the query. */
    uint32_t touch_count;   /* Pairs that could touch, including those without a slot in the
                               list. */
    float play_m[TANK_FISH_MAX];  /* Distance that the contact solver may move any point of a body
                                     in this tick. */
    struct pairs pairs;
    struct found found[PAIRS_BATCH + LANES_MAX];
};

/* Returns how many contacts the list of this crowd holds, at most CROWD_CONTACT_MAX. */
static inline uint32_t crowd_contact_max(const struct crowd *crowd)
{
    return CROWD_CONTACT_MAX / TANK_FISH_MAX * fish_capacity(crowd->count);
}

/* Sets `count` and `flags` from fish whose bodies are already in place. */
void crowd_mark(struct crowd *crowd, const struct fish *fish, uint32_t fish_count);

/* Copies the bodies of all fish and marks them. A personal space reaches `space` body lengths
 * beyond the body. */
void crowd_gather(struct crowd *crowd, const struct fish *fish, uint32_t fish_count, float space);

/* Options of a query. The first two affect speed only, not results. */
struct crowd_search {
    uint8_t search; /* enum pairs_search */
    uint8_t lanes;  /* 0, 4 or 8, as in lanes_built() */
    uint8_t contacts_only; /* 1: finds contacts only and leaves `company` unchanged. */
};

/* Moves each fish to its body, and adds the distance that bodies were moved since their fish moved
 * to `way_m`. */
void crowd_follow(struct crowd *crowd, struct fish *fish);

/* Returns the distance that a fish will move before the next query, from its present motion. */
float crowd_reach_m(const struct fish *fish);

/* Returns 1 if the last query no longer covers all pairs that could touch, because a fish moved
 * beyond its reach or is new in the grid. */
int crowd_is_stale(const struct crowd *crowd);

/* Moves the contacts that could touch in this tick to the front of the list. A gap shrinks by at
 * most the distances that both fish moved. Every pair that the contact solver could bring together
 * is included. Fish that left the water since the query are excluded. */
void crowd_touch(struct crowd *crowd);

/* Queries only the fish that moved beyond their reach, which completes the list at a tenth of the
 * cost of crowd_look(). Calls crowd_touch() at the end. Returns 0 and leaves the crowd unchanged if
 * there are too many such fish. */
int crowd_look_again(struct crowd *crowd, const struct fish *fish);

uint64_t crowd_hash(uint64_t hash, const struct crowd *crowd);

/* Finds every pair whose personal spaces overlap. Advises the fish that meet, adds repulsion to
 * near fish, lists the pairs that could touch before the next query, and calls crowd_touch(). With
 * `contacts_only` it does only the last two, at half the cost. `fish` are the fish whose bodies the
 * crowd holds. */
void crowd_look(struct crowd *crowd, const struct fish *fish, struct crowd_search how,
                const struct surroundings *around);

/* Returns the personal space in body lengths beyond the body. In a sparse tank it is the value of
 * the behavior parameters; in a dense tank it shrinks to a fifth of that value at worst. */
float crowd_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                  const struct law *law);

#endif
