/* avoid.h -- how two fish that come too near give way: head-on, from the side, from behind.
 *
 * The 2013 thesis, section 3.4. Where it is silent or at odds with itself:
 * - 3.4 reacts to "something within the space", 3.7 tests space against space: as 3.7 does.
 * - Headings alone call fish that have passed each other head-on, and fish side by side rear-end:
 *   only who approaches meets, and who runs up to another has it within 45 degrees of its nose.
 * - Eq. 3.4 takes the angle in space, so a pitched fish head-on would be hit from the side: the
 *   angle is that of the headings seen from above. Cosines are compared, so none is out of range.
 * - "The one that hits" is the one that faces the other more; even, the lower index.
 * - The one that is hit "turns left", on whichever side it is hit: half the time into the other. It
 *   turns away from that side; the figure shows one of two mirror images.
 * - How fast fish turn is said nowhere: as fast as the gait lets them (180 degrees a second while
 *   swimming); who is hit, a third of it, else its tail sweeps into the other.
 * - Of several meetings the soonest counts. Who has begun to turn keeps to its side, and who is
 *   clear of nobody after 0.5 s, be it another by then, has yawed in vain.
 * - The class is that of the headings as the two meet: while one of them gives way, their meeting
 *   keeps its class and its parts, however they have turned by then.
 * - Fig. 3.6 sends both fish of a pair up, or both down: the upper goes up and the lower down,
 *   unless the surface or the floor is within a body's height.
 * - The depths of 3.6 would undo a climb or a dive: they wait meanwhile, and half a second more.
 *   (Waiting in yaw as well leaves 600 fish no time for them: they drift off by 3 to 6 cm.)
 * - Repulsion is named in 1.1 and 4.5 and defined nowhere: see below. */
#ifndef KINGYO_CORE_TANK_AVOID_H
#define KINGYO_CORE_TANK_AVOID_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

enum meeting_kind {
    MEET_NONE = 0, /* Not approaching, or no faster than fish at rest drift. */
    MEET_HEAD_ON,  /* Headings within 20 degrees of opposite. */
    MEET_REAR_END, /* Headings within 20 degrees of equal, the other ahead. */
    MEET_SIDE,     /* It runs into the side of the other, ... */
    MEET_STRUCK,   /* ... or the other into its own. */
};

/* One of a pair. */
struct avoid_party {
    vec3 position_m;
    vec3 forward; /* Unit, along the nose. */
    float speed_m_s;
    float length_m, height_m;
    fish_index index;
    /* As in struct fish: who gives way already, to whom, since when. */
    uint8_t avoiding, avoid_kind;
    fish_index avoid_with;
    uint32_t avoid_since;
};

/* What a party should do. Zero `kind` is nothing. */
struct avoid_advice {
    uint8_t kind;    /* enum meeting_kind */
    int8_t rise;     /* -1 down, +1 up: should turning not do within 0.5 s. */
    fish_index with; /* The other. */
    uint32_t since;  /* Tick in which the encounter began, for either of the two. */
    float contact_s; /* Time to contact at this pace. */
    float turn;      /* -1 hard to the right .. +1 hard to the left, 0 straight on. */
};

struct avoid_pair {
    struct avoid_advice a, b;
    float brake_a, brake_b; /* [0, 1] of its speed that the gap leaves each. */
};

/* `gap_m` is between the bodies. One draw is the pair's for the whole encounter: it is keyed by the
 * tick in which the first of them gave way, so the other, however late, draws the same. */
struct avoid_pair avoid_meet(const struct avoid_party *a, const struct avoid_party *b, float gap_m,
                             const struct law *law, uint32_t seed, uint32_t tick);

/* Whether it keeps its depth, whatever the depth it wants: for 0.5 s after it gave way in pitch. */
int avoid_holds_depth(const struct fish *fish);

/* One tick of giving way by the soonest of this tick's advice, at the least brake of all. */
void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct surroundings *around);

/* Repulsion: wanted speed apart for two bodies whose gap is `gap_m`, for the smaller of them
 * `length_m` long; 0 beyond a fifth of its length, its personal space. At touch it is what section
 * 3.3 leaves between 5.25 and 7.5 cm/s, the limit of all that "other forces" may add. */
float avoid_repulsion_m_s(float gap_m, float length_m);

#endif
