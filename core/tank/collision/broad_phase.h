/* broad_phase.h -- the broad phase: finds nearby fish, computes how two fish that meet avoid each
 * other, and lists the pairs of fish that could touch (the contacts).
 *
 * A query is one search for nearby pairs among all swimming fish. Every array is indexed by fish. A
 * fish that does not swim has an element in each array but takes no part in a query. Such a fish is
 * on a poi (the paper scoop), in a bowl or in reentry (reentry.c). */
#pragma once

#include "core/tank/behavior/avoid.h"
#include "core/tank/collision/box.h"
#include "core/tank/collision/narrow_phase.h"
#include "core/tank/fish.h"

/* Capacity of the contact list, which holds the pairs of fish that could touch. The list has room
 * for four pairs per fish. At the fish density of the 2013 thesis on goldfish behavior, each fish
 * overlaps the personal spaces of 1.4 other fish on average. A full list holds a random selection
 * of the pairs in each tick. */
#define BROAD_PHASE_CONTACT_MAX (4u * TANK_FISH_MAX)

enum body_flag {
    BODY_SWIMMING = 1, /* The fish takes part in broad-phase queries. */
    /* The fish is in the air, so the surface does not limit its position. */
    BODY_AIRBORNE = 2,
    BODY_NEAR_OBSTACLE = 4, /* The fish could touch an obstacle in this substep. */
    BODY_GULPING = 8,       /* The fish gulps, so its snout may be above the surface. */
    /* The contact solver moved the fish back to its pose at the start of the tick, so the fish also
     * gets back its angles at the end of the tick. */
    BODY_REVERTED = 16,
    /* The contact list was full, so a contact of the fish is missing in the list. */
    BODY_UNLISTED = 32,
};

/* Results of a broad-phase query for one fish: the influence of its nearby fish. The results are
 * valid until the next query. */
struct neighbours {
    /* Advice on how to avoid the nearby fish with the soonest contact. */
    struct avoid_advice advice;
    vec3 push_m_s;     /* Sum of the velocities by which nearby fish repel the fish. */
    float brake, room; /* New values for the members `brake` and `room` of struct fish, which limit
                          its speed and its turning rate. */
};

/* Ticks between full broad-phase queries: 33 ms, which is also the time between two decisions of a
 * fish. A fish that moves farther than expected causes an earlier query. */
#define BROAD_PHASE_UPDATE_TICKS 4u
/* Two fish could touch within one tick if the gap between them is at most this wide, because the
 * contact solver may by default move each body by half of this distance. */
#define BROAD_PHASE_CONTACT_M 0.002f

/* Two fish whose bodies could touch before the next broad-phase query, the search for nearby
 * fish. */
struct contact {
    fish_index a, b;
    /* Lower bound of the gap between the two bodies at the time of the last query. A value < 0
     * means an overlap. */
    float gap_m;
};

struct broad_phase {
    uint32_t count; /* Number of all fish, whether they swim or not. */
    struct body body[TANK_FISH_MAX];
    uint8_t flags[TANK_FISH_MAX]; /* State of each fish: bits of enum body_flag. */
    struct neighbours neighbours[TANK_FISH_MAX];
    /* Results of a broad-phase query: the members from here to `touch_count`. The results stay
     * valid until the next query, so the state hash includes the results that later ticks use. */
    uint32_t near_count; /* Number of contacts in the list `contact`. */
    /* Number of contacts whose fish could touch in this tick. These contacts are at the front of
     * the list. */
    uint32_t contact_count;
    struct contact contact[BROAD_PHASE_CONTACT_MAX];
    /* Distance that a body may have moved since the last search for nearby fish (query): the sum,
     * over the ticks, of the largest distance that any point of the body moved. */
    float way_m[TANK_FISH_MAX];
    /* Distance that a body may move before a new search for nearby fish (query) is due. */
    float reach_m[TANK_FISH_MAX];
    uint32_t overlap_count; /* Number of pairs whose bodies overlapped at the last query. */
    /* Number of pairs of fish that could touch before the next query, including pairs that are
     * missing in a full contact list. */
    uint32_t touch_count;
    /* Largest distance by which the contact solver may move any point of a body in this tick. */
    float play_m[TANK_FISH_MAX];
    struct narrow_phase narrow_phase;
    struct narrow_phase_pair found[NARROW_PHASE_BATCH + SIMD_LANES_MAX];
};

/* Returns the capacity of the contact list for the present number of fish, at most
 * BROAD_PHASE_CONTACT_MAX. */
static inline uint32_t broad_phase_contact_max(const struct broad_phase *broad_phase)
{
    return BROAD_PHASE_CONTACT_MAX / TANK_FISH_MAX * fish_capacity(broad_phase->count);
}

/* Sets the members `count`, `flags` and `play_m` of struct broad_phase from the state of the fish.
 * The caller has already set the bodies. */
void broad_phase_mark(struct broad_phase *broad_phase, const struct fish *fish,
                      uint32_t fish_count);

/* Sets the bodies of all fish from their poses and calls broad_phase_mark(). A personal space
 * extends `space` body lengths beyond the body. */
void broad_phase_gather(struct broad_phase *broad_phase, const struct fish *fish,
                        uint32_t fish_count, float space);

/* Options of a broad-phase query. `search` and `lanes` affect only speed, not results. */
struct broad_phase_search {
    uint8_t search; /* Algorithm of the pair search (enum pair_search). */
    uint8_t lanes;  /* Number of SIMD lanes: 4, 8, or 0 for the default (4). */
    /* True if the query only lists contacts (pairs that could touch) and leaves `neighbours`
     * unchanged. */
    bool contacts_only;
};

/* Moves each fish to the position of its body, because the contact solver moves only the bodies.
 * Adds the distance to `way_m`, the distance that the body moved since the last query. */
void broad_phase_sync(struct broad_phase *broad_phase, struct fish *fish);

/* Returns the distance that the fish is expected to move before the next search for nearby fish
 * (query), m. The distance follows from the present motion of the fish. */
float broad_phase_reach_m(const struct fish *fish);

/* Returns true if a new search for nearby fish (query) is necessary, because pairs that could touch
 * may be missing in the results of the last query. Causes are a fish that moved beyond its reach, a
 * fish that began to swim, and a full contact list. */
bool broad_phase_is_stale(const struct broad_phase *broad_phase);

/* Moves the contacts whose fish could touch in this tick to the front of the list, and stores their
 * number in `contact_count`. A contact is moved to the front if its present gap is smaller than the
 * distance by which the contact solver may move the two fish. The present gap is the gap at the
 * last query minus the distances that the two fish moved since then. Contacts with a fish that left
 * the water since the query are left out. */
void broad_phase_select_contacts(struct broad_phase *broad_phase);

/* Searches for the nearby fish of only those fish that moved too far for the results of the last
 * query. The function takes a tenth of the time of broad_phase_update(). Calls
 * broad_phase_select_contacts() at the end and returns true. Returns false and changes nothing if
 * too many fish moved too far or if the contact list could overflow. */
bool broad_phase_update_moved(struct broad_phase *broad_phase, const struct fish *fish);

/* Searches for nearby fish: finds every pair whose personal spaces overlap. Sets the avoidance
 * advice and the repulsion of nearby fish, lists the pairs that could touch before the next search,
 * and calls broad_phase_select_contacts(). If `how.contacts_only` is true, the function sets
 * neither advice nor repulsion, which takes half the time. `fish` holds the fish to which the
 * bodies belong. */
void broad_phase_update(struct broad_phase *broad_phase, const struct fish *fish,
                        struct broad_phase_search how, const struct perception *around);

/* Returns the width of the personal space around the body of a fish, in body lengths. In a sparse
 * tank the value is params->space_per_length. In a dense tank the value is smaller, but at least a
 * fifth of params->space_per_length. */
float broad_phase_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                        const struct behavior_params *params);
