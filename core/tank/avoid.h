/* avoid.h -- how two fish that come too near give way: head-on, from the side, from behind.
 *
 * The 2013 thesis, section 3.4. Where it is silent: only fish on courses that nearly touch meet;
 * who is struck turns away from the side it is struck on; of several meetings the soonest counts.
 */
#ifndef KINGYO_CORE_TANK_AVOID_H
#define KINGYO_CORE_TANK_AVOID_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

enum meeting_kind {
    MEET_NONE = 0, /* Not approaching, or at walking pace. */
    MEET_HEAD_ON,  /* Headings within 20 degrees of opposite. */
    MEET_REAR_END, /* Headings within 20 degrees of equal, the other ahead. */
    MEET_SIDE,
};

/* One of a pair. */
struct avoid_party {
    vec3 position_m;
    vec3 forward; /* Unit, along the nose. */
    float speed_m_s;
    float length_m, height_m;
    fish_index index;
    /* As in struct fish: who gives way already, to whom, since when. */
    uint8_t avoiding;
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

/* Whether it keeps its depth, whatever the depth it wants: while it gives way in yaw, and 0.5 s
 * after it gave way. */
int avoid_holds_depth(const struct fish *fish);

/* One tick of giving way by the soonest of this tick's advice, at the least brake of all. */
void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct surroundings *around);

/* The thesis' repulsion (named, never written down): wanted speed apart for two bodies whose gap is
 * `gap_m`, for the smaller of them `length_m` long; 0 beyond a fifth of its length. */
float avoid_repulsion_m_s(float gap_m, float length_m);

#endif
