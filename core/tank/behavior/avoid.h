/* avoid.h -- avoidance between two fish that come too near: head-on, from the side, from behind.
 *
 * Implements section 3.4 of the 2013 thesis. The following rules were chosen where the thesis is
 * silent or contradicts itself:
 *
 * - Section 3.4 reacts to "something within the space", but section 3.7 tests space against space.
 * The code follows section 3.7.
 *
 * - Headings alone would count two cases as encounters: fish that have passed each other head-on,
 * and fish side by side (as rear-end). The code therefore requires that a fish approaches. A fish
 * that runs up to another has it within 45 degrees of its nose.
 *
 * - Eq. 3.4 takes the angle in space, so a pitched fish met head-on would count as hit from the
 * side. The code takes the angle between the headings seen from above. The comparison uses cosines,
 * so no angle is out of range.
 *
 * - "The one that hits" is the fish that faces the other more. In a tie, the fish with the lower
 * index hits.
 *
 * - The fish that is hit "turns left" on whichever side it is hit, so half the time it would turn
 * into the other. In the code it turns away from that side. The figure shows one of two mirror
 * images.
 *
 * - The thesis gives no turning rate. Fish turn as fast as the gait allows (180 deg/s while
 * swimming). The struck fish turns at a third of that rate, because otherwise its tail sweeps into
 * the other fish.
 *
 * - Of several encounters the soonest counts. A fish that has begun to turn keeps to its side. If
 * the path is still blocked after 0.5 s, even by a different fish, avoidance by yaw has failed and
 * pitch is used.
 *
 * - The class of an encounter is fixed when two fish meet. While one of them avoids the other, the
 * class and the parts stay the same, even after the fish have turned.
 *
 * - Fig. 3.6 sends both fish of a pair up, or both down. In the code the upper fish goes up and the
 * lower fish goes down, unless the surface or the floor is within one body height.
 *
 * - The preferred depths of section 3.6 would undo a climb or a dive. The depths are suspended
 * during the pitch and for 0.5 s afterwards. (If they were suspended during yaw as well, 600 fish
 * would drift off by 3 to 6 cm.)
 *
 * - Sections 1.1 and 4.5 name a repulsion but never define it: see avoid_repulsion_m_s(). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_AVOID_H
#define KINGYO_CORE_TANK_BEHAVIOR_AVOID_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

enum meeting_kind {
    MEET_NONE = 0, /* The fish do not approach, or no faster than resting fish drift. */
    MEET_HEAD_ON,  /* Headings within 20 degrees of opposite. */
    MEET_REAR_END, /* Headings within 20 degrees of equal, the other fish ahead. */
    MEET_SIDE,     /* The fish runs into the side of the other fish. */
    MEET_STRUCK,   /* The other fish runs into the side of the fish. */
};

/* A fish of a pair. */
struct avoid_party {
    vec3 position_m;
    vec3 forward; /* Unit vector along the nose. */
    float speed_m_s;
    float length_m, height_m;
    fish_index index;
    /* Current avoidance state: kind, partner and first tick, as in struct fish. */
    uint8_t avoiding, avoid_kind;
    fish_index avoid_with;
    uint32_t avoid_since;
};

/* Advice for one fish of a pair. All zeros means no advice. */
struct avoid_advice {
    uint8_t kind;    /* enum meeting_kind */
    int8_t rise;     /* -1 down or +1 up: direction of the pitch if yaw fails within 0.5 s. */
    fish_index with; /* Index of the other fish. */
    uint32_t since;  /* Tick in which the first of the two fish began to avoid. */
    float contact_s; /* Time to contact at the present speeds. */
    float turn;      /* -1 hard right .. +1 hard left, 0 straight on. */
};

struct avoid_pair {
    struct avoid_advice a, b;
    float brake_a, brake_b; /* [0, 1] share of its speed that each fish keeps. */
};

/* Returns the advice for both fish of a pair. `gap_m` is the gap between the bodies. The pair has
 * one random draw for the whole encounter. The key of the draw is the tick in which the first fish
 * began to avoid, so the other fish gets the same draw later. */
struct avoid_pair avoid_meet(const struct avoid_party *a, const struct avoid_party *b, float gap_m,
                             const struct behavior_params *params, uint32_t seed, uint32_t tick);

/* Returns 1 if the fish keeps its present depth: for 0.5 s after it avoided by pitch, whatever
 * depth its stamina prefers. */
int avoid_holds_depth(const struct fish *fish);

/* Advances the avoidance by one tick. `advice` is the soonest of this tick; `brake` is the least of
 * all. */
void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct perception *around);

/* Returns the wished separation speed of two bodies with the gap `gap_m`; `length_m` is the
 * length of the smaller fish. The speed is 0 beyond its personal space, a fifth of its length.
 * At contact it is the difference between 5.25 and 7.5 cm/s in section 3.3, the limit of all
 * "other forces". */
float avoid_repulsion_m_s(float gap_m, float length_m);

#endif
