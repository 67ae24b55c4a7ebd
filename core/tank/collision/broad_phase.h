/* broad_phase.h -- the broad phase: which fish of a tank are near, which meet, and which could
 * touch.
 *
 * Every column has the index of the tank's fish. A fish that does not swim (carried by a poi, or in
 * a bowl) has a row in the columns but is not in the grid. */
#ifndef KINGYO_CORE_TANK_COLLISION_BROAD_PHASE_H
#define KINGYO_CORE_TANK_COLLISION_BROAD_PHASE_H

#include "core/tank/behavior/avoid.h"
#include "core/tank/collision/body.h"
#include "core/tank/collision/narrow_phase.h"
#include "core/tank/fish.h"

/* 1.4 overlaps per fish occur at the thesis' density. Further contacts get a slot by lot in each
 * tick. */
#define BROAD_PHASE_CONTACT_MAX (4u * TANK_FISH_MAX)

enum body_flag {
    BODY_SWIMMING = 1,      /* The fish is in the grid. */
    BODY_AIRBORNE = 2,      /* Above the surface, which therefore does not hold the fish. */
    BODY_NEAR_OBSTACLE = 4, /* An obstacle is within reach. */
    BODY_GULPING = 8,       /* The snout may stand out of the water. */
    BODY_REVERTED = 16,     /* The fish went back to its pose of the previous tick. */
    BODY_UNLISTED = 32,     /* A contact of the fish found no slot in the full list. */
};

/* Results of a query for one fish about its neighbours; valid until the next query. */
struct neighbours {
    struct avoid_advice advice; /* Advice of the encounter that is soonest. */
    vec3 push_m_s;              /* Sum of the repulsion of near fish. */
    float brake, room;          /* Same members as in struct fish. */
};

/* Ticks between full queries (33 ms, the period of a fish's decisions), unless a fish moves
 * faster than expected. */
#define BROAD_PHASE_UPDATE_TICKS 4u
/* Pairs nearer than this may come to touch while the contact solver moves other pairs. Half of
 * it is the allowance of each body by default. */
#define BROAD_PHASE_CONTACT_M 0.002f

/* Two fish whose bodies could touch before the next query. */
struct contact {
    fish_index a, b;
    float gap_m; /* Least gap between the bodies at the query; < 0 is an overlap. */
};

struct broad_phase {
    uint32_t count; /* All fish, whether they swim or not. */
    struct body body[TANK_FISH_MAX];
    uint8_t flags[TANK_FISH_MAX]; /* enum body_flag */
    struct neighbours neighbours[TANK_FISH_MAX];
    /* Results of a query stay valid until the next query. The results are state, so
     * broad_phase_hash() covers them. */
    uint32_t near_count;    /* Contacts in the list. */
    uint32_t contact_count; /* Leading contacts in the list that could touch in this tick. */
    struct contact contact[BROAD_PHASE_CONTACT_MAX];
    float way_m[TANK_FISH_MAX];   /* Longest distance that any point of a body moved since the
                                     query. */
    float reach_m[TANK_FISH_MAX]; /* Distance that a body may move before the next query is due. */
    uint32_t overlap_count;       /* Pairs whose bodies overlapped at the query. */
    uint32_t touch_count;         /* Pairs that could touch, including those without a slot in
                                     the list. */
    float play_m[TANK_FISH_MAX];  /* Distance that the contact solver may move any point of a body
                                     in this tick. */
    struct narrow_phase narrow_phase;
    struct narrow_phase_pair found[NARROW_PHASE_BATCH + SIMD_LANES_MAX];
};

/* Returns how many contacts the list of this crowd holds, at most BROAD_PHASE_CONTACT_MAX. */
static inline uint32_t broad_phase_contact_max(const struct broad_phase *broad_phase)
{
    return BROAD_PHASE_CONTACT_MAX / TANK_FISH_MAX * fish_capacity(broad_phase->count);
}

/* Sets `count` and `flags` from fish whose bodies are already in place. */
void broad_phase_mark(struct broad_phase *broad_phase, const struct fish *fish,
                      uint32_t fish_count);

/* Copies the bodies of all fish and marks them. A personal space reaches `space` body lengths
 * beyond the body. */
void broad_phase_gather(struct broad_phase *broad_phase, const struct fish *fish,
                        uint32_t fish_count, float space);

/* Options of a query. The first two affect speed only, not results. */
struct broad_phase_search {
    uint8_t search;        /* enum pair_search */
    uint8_t lanes;         /* 0, 4 or 8, as in simd_is_built() */
    uint8_t contacts_only; /* 1: finds contacts only and leaves `neighbours` unchanged. */
};

/* Moves each fish to its body, and adds the distance that bodies were moved since their fish moved
 * to `way_m`. */
void broad_phase_sync(struct broad_phase *broad_phase, struct fish *fish);

/* Returns the distance that a fish will move before the next query, from its present motion. */
float broad_phase_reach_m(const struct fish *fish);

/* Returns 1 if the last query no longer covers all pairs that could touch, because a fish moved
 * beyond its reach or is new in the grid. */
int broad_phase_is_stale(const struct broad_phase *broad_phase);

/* Moves the contacts that could touch in this tick to the front of the list. A gap shrinks by at
 * most the distances that both fish moved. Every pair that the contact solver could bring together
 * is included. Fish that left the water since the query are excluded. */
void broad_phase_select_contacts(struct broad_phase *broad_phase);

/* Queries only the fish that moved beyond their reach, which completes the list at a tenth of the
 * cost of broad_phase_update(). Calls broad_phase_select_contacts() at the end. Returns 0 and
 * leaves the crowd unchanged if there are too many such fish. */
int broad_phase_update_moved(struct broad_phase *broad_phase, const struct fish *fish);

uint64_t broad_phase_hash(uint64_t hash, const struct broad_phase *broad_phase);

/* Finds every pair whose personal spaces overlap. Advises the fish that meet, adds repulsion to
 * near fish, lists the pairs that could touch before the next query, and calls
 * broad_phase_select_contacts(). With `contacts_only` it does only the last two, at half the cost.
 * `fish` are the fish whose bodies the crowd holds. */
void broad_phase_update(struct broad_phase *broad_phase, const struct fish *fish,
                        struct broad_phase_search how, const struct perception *around);

/* Returns the personal space in body lengths beyond the body. In a sparse tank it is the value of
 * the behavior parameters; in a dense tank it shrinks to a fifth of that value at worst. */
float broad_phase_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                        const struct behavior_params *params);

#endif
