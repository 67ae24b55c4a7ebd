/* avoid.h -- avoidance between two fish that approach each other head-on, from the side or from
 * behind.
 *
 * The functions implement section 3.4 of the 2013 thesis on goldfish behavior. All section, figure
 * and equation numbers are those of the 2013 thesis. The rules below were chosen for cases in which
 * the thesis gives no rule or contradicts itself.
 *
 * - In section 3.4 a fish reacts to "something within the space". In section 3.7 a fish reacts if
 *   its personal space overlaps the personal space of another fish. The code follows section 3.7.
 *
 * - By headings alone, two harmless cases would count as encounters: fish that have passed each
 *   other head-on, and fish that swim side by side. In both cases the gap between the fish does not
 *   shrink, so the code requires a shrinking gap. In a rear-end encounter, the fish ahead must lie
 *   within 45 degrees of the follower's course.
 *
 * - Eq. 3.4 uses the angle between the headings in three dimensions, so a head-on encounter with a
 *   pitched fish would count as an encounter from the side. The code uses the angle between the
 *   headings seen from above. The code compares cosines, so that it needs no arc cosine.
 *
 * - The thesis does not define "the one that hits". In the code, the fish that faces the other fish
 *   more is the fish that hits. In a tie, the fish with the lower index hits.
 *
 * - In the thesis, the fish that is hit "turns left", whichever side is hit. Half of these turns
 *   would lead into the fish that hits. In the code the struck fish turns away from the side that
 *   is hit.
 *
 * - The thesis gives no turning rate. Fish turn as fast as the gait allows (180 deg/s while
 *   swimming). The struck fish turns at a third of that rate, because otherwise its tail would
 *   sweep into the fish that hits.
 *
 * - A fish with several encounters follows the advice for the soonest contact. A fish that has
 *   begun to turn keeps its direction. If the path is still blocked after 0.5 s, even by a
 *   different fish, avoidance by yaw has failed and the fish avoids by pitch.
 *
 * - The class of an encounter (enum meeting_kind) is determined when two fish meet. While a fish of
 *   the pair avoids, the class and the roles stay unchanged, even after the fish have turned.
 *
 * - Fig. 3.6 sends both fish of a pair up, or both down. In the code the upper fish goes up and the
 *   lower fish goes down, unless the surface or the floor is within one body height.
 *
 * - The preferred depths of section 3.6 would undo a climb or a dive. A fish ignores its preferred
 *   depth while it avoids by pitch and for 0.5 s afterwards. If a fish also ignored its preferred
 *   depth during avoidance by yaw, 600 fish would drift away from their depths by 3 to 6 cm.
 *
 * - Sections 1.1 and 4.5 name a repulsion but never define the repulsion. The comment on
 *   avoid_repulsion_m_s() describes the repulsion in this code. */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

enum meeting_kind {
    /* No encounter. The fish move apart, or approach each other more slowly than 1 cm/s
     * (CLOSING_MIN_M_S in avoid.c). */
    MEET_NONE = 0,
    MEET_HEAD_ON,  /* The headings differ by more than 160 degrees. */
    MEET_REAR_END, /* The headings differ by less than 20 degrees, and the other fish is ahead. */
    MEET_SIDE,     /* The fish runs into the side of the other fish. */
    MEET_STRUCK,   /* The other fish runs into the side of the fish. */
};

/* State of one fish of a pair, which avoid_meet() reads. */
struct avoid_party {
    vec3 position_m;
    vec3 forward; /* Unit vector along the fish's forward axis. */
    float speed_m_s;
    float length_m, height_m;
    fish_index index;
    /* Current avoidance state of the fish, copied from struct fish: `avoiding`, `avoid_kind`, the
     * partner `avoid_with` and the first tick `avoid_since`. */
    uint8_t avoiding, avoid_kind;
    fish_index avoid_with;
    uint32_t avoid_since;
};

/* Advice for one fish of a pair on how to avoid the other fish. All zeros mean that the fish need
 * not avoid the other fish. */
struct avoid_advice {
    uint8_t kind; /* Role of the fish in the encounter (enum meeting_kind). */
    /* Direction in which the fish pitches if a turn to the left or right (yaw) does not clear its
     * path within 0.5 s: -1 means down, +1 means up. */
    int8_t rise;
    fish_index with; /* Index of the other fish. */
    /* Tick in which the encounter began: the first tick in which a fish of the pair avoided the
     * other fish. */
    uint32_t since;
    float contact_s; /* Time until the two bodies touch if both fish keep their present speeds. */
    /* Turn that avoids the other fish, from -1 (hard right) to +1 (hard left). 0 means straight
     * on. */
    float turn;
};

struct avoid_pair {
    struct avoid_advice a, b;
    /* Factors [0, 1] on the speed goals of fish a and fish b. A factor below 1 makes the fish slow
     * down before a contact. */
    float brake_a, brake_b;
};

/* Returns the advice for both fish of a pair on how to avoid each other. `gap_m` is the gap between
 * their bodies. One random number decides all random choices, so that the advice for one fish fits
 * the advice for the other fish. The number depends on the tick in which the encounter began, so
 * the choices stay the same during the encounter. */
struct avoid_pair avoid_meet(const struct avoid_party *a, const struct avoid_party *b, float gap_m,
                             const struct behavior_params *params, uint32_t seed, uint32_t tick);

/* Returns true if the fish keeps its present depth and does not swim to its preferred depth. A fish
 * keeps its depth for 0.5 s after it avoided another fish by pitch. */
bool avoid_holds_depth(const struct fish *fish);

/* Advances the avoidance of a fish by `around->dt_s`. `advice` is about the nearby fish with the
 * soonest contact. `brake` is the smallest factor on the fish's speed that any nearby fish
 * requires. */
void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct perception *around);

/* Returns the speed at which repulsion separates two bodies, m/s. `gap_m` is the gap between the
 * bodies, and `length_m` is the length of the smaller fish. Returns 0 if the gap exceeds a fifth of
 * `length_m`, which is the personal space of the smaller fish. The speed of two fish of 5 cm that
 * touch is 2.25 cm/s. This is the difference between the top speed (7.5 cm/s) and the swimming
 * speed (5.25 cm/s) in section 3.3 of the 2013 thesis, which limits all "other forces" to this
 * difference. */
float avoid_repulsion_m_s(float gap_m, float length_m);
