/* crowd.h -- all bodies of a tank at once: which are near, who meets whom, which could touch.
 *
 * Every column is indexed as the tank's fish are; fish that do not swim (held, in a bowl) have a
 * place in the columns and none in the grid. */
#ifndef KINGYO_CORE_TANK_CROWD_H
#define KINGYO_CORE_TANK_CROWD_H

#include "core/tank/avoid.h"
#include "core/tank/body.h"
#include "core/tank/fish.h"
#include "core/tank/pairs.h"

#define CROWD_CONTACT_MAX                                                                          \
    (4u * TANK_FISH_MAX) /* 1.4 overlap a fish at the thesis' density. Further                     \
                            ones draw lots for a place, anew each tick. */

enum crowd_flag {
    CROWD_SWIMS = 1,    /* Is in the grid. */
    CROWD_AIRBORNE = 2, /* Above the surface: the surface does not hold it. */
    CROWD_BESIDE = 4,   /* An obstacle is in reach. */
    CROWD_GULPS = 8,    /* Its snout may stand out of the water. */
    CROWD_BACK = 16,    /* Went back to the pose of the tick before. */
    CROWD_UNLISTED = 32, /* One of its contacts found no place in the list. */
};

/* What the look tells a fish of those about it; holds until the next look. */
struct company {
    struct avoid_advice advice; /* Of the meeting that is soonest. */
    vec3 push_m_s;              /* Nearness pushes it so. */
    float brake, room;          /* As in struct fish. */
};

#define CROWD_LOOK_TICKS 4u /* From one look to the next, unless somebody moves faster than it
                               seemed: 33 ms, as a fish thinks. */
#define CROWD_TOUCH_M 0.002f /* Nearer pairs may come to touch while others are parted: half of it
                               is the play of a body, unless parting knows better. */

/* Two fish whose bodies could touch before the next look. */
struct contact {
    fish_index a, b;
    float gap_m; /* Between the bodies when the look found them, at least; < 0 overlap. */
};

struct crowd {
    uint32_t count; /* Of fish, whether they swim or not. */
    struct body body[TANK_FISH_MAX];
    uint8_t flags[TANK_FISH_MAX]; /* enum crowd_flag */
    struct company company[TANK_FISH_MAX];
    /* What a look finds holds until the next one: state, which crowd_hash() covers. */
    uint32_t near_count;    /* Contacts, ... */
    uint32_t contact_count; /* ... the first of which could touch in this tick. */
    struct contact contact[CROWD_CONTACT_MAX];
    float way_m[TANK_FISH_MAX];   /* So far any point of a body came since the look, at most; ... */
    float reach_m[TANK_FISH_MAX]; /* ... so far it could before the next one is due. */
    uint32_t overlap_count; /* Pairs whose bodies the look found overlapping. */
    uint32_t touch_count;   /* Pairs that could touch; the list has room for some of them. */
    float play_m[TANK_FISH_MAX];  /* So far parting may move any point of a body in this tick. */
    struct pairs pairs;
    struct found found[PAIRS_BATCH + LANES_MAX];
};

/* Returns how many contacts the list of this crowd holds, at most CROWD_CONTACT_MAX. */
static inline uint32_t crowd_contact_max(const struct crowd *crowd)
{
    return CROWD_CONTACT_MAX / TANK_FISH_MAX * fish_capacity(crowd->count);
}

/* Sets `count` and `flags` anew from fish whose bodies are in place. */
void crowd_mark(struct crowd *crowd, const struct fish *fish, uint32_t fish_count);

/* Takes the bodies of all fish, and marks them. Personal spaces reach `space` body lengths beyond
 * bodies. */
void crowd_gather(struct crowd *crowd, const struct fish *fish, uint32_t fish_count, float space);

/* How the crowd is searched; the first two are a matter of speed alone. */
struct crowd_search {
    uint8_t search; /* enum pairs_search */
    uint8_t lanes;  /* 0, 4 or 8, as lanes_built() */
    uint8_t contacts_only; /* Nobody is told of anybody: `company` stays as it is. */
};

/* Counts as way what has moved bodies since their fish moved, and moves the fish there. */
void crowd_follow(struct crowd *crowd, struct fish *fish);

/* How far a fish will come before the next look, by what it does now. */
float crowd_reach_m(const struct fish *fish);

/* Whether the last look no longer tells all pairs that could touch: somebody came farther than its
 * reach, or was not there. */
int crowd_is_stale(const struct crowd *crowd);

/* Brings those contacts to the front that could touch in this tick: gaps shrink by no more than the
 * ways of both. Every pair that parting could bring together is among them, and nobody who was
 * taken out of the water since the look. */
void crowd_touch(struct crowd *crowd);

/* Where only some came farther than their reach, a look at those alone makes the list whole again:
 * it ends with crowd_touch(), and costs a tenth of crowd_look(). Returns 0, and leaves the crowd as
 * it is, where they are too many. */
int crowd_look_again(struct crowd *crowd, const struct fish *fish);

uint64_t crowd_hash(uint64_t hash, const struct crowd *crowd);

/* Finds every pair whose personal spaces overlap: advises those that meet, pushes those that are
 * near, lists those that could touch before the next look, and calls crowd_touch(). Or only the
 * last two, which is half the work. `fish` are those whose bodies the crowd holds. */
void crowd_look(struct crowd *crowd, const struct fish *fish, struct crowd_search how,
                const struct surroundings *around);

/* The personal space that a crowd leaves, in body lengths beyond the body: the law's own in sparse
 * tanks, a fifth of it at worst. */
float crowd_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                  const struct law *law);

#endif
