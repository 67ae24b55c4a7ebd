/* shade.h -- shades on the water: a moving shade startles fish, a still shade attracts them.
 *
 * Every object over the water casts a shade: a fan, a human hand, a dry poi (the paper scoop).
 * Light falls vertically, so a shade is a round column of water from the surface to the floor, and
 * every distance is horizontal. The 2013 thesis uses the distance |N - P| in space, which would
 * pull a fish below the fan upward and hardly sideways. */
#ifndef KINGYO_CORE_TANK_SHADE_H
#define KINGYO_CORE_TANK_SHADE_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

/* Share of the light that a fan of paper on bamboo, or a human hand, takes. */
#define SHADE_FAN_DARK 0.62f

/* Radii of the attraction in units of the shade's radius, for the thesis' shade of 10 cm (section
 * 3.5). The attraction reaches to 20 cm and is zero near the centre. The thesis switches from 9
 * cm/s to zero at 5 cm. In this code the attraction fades from SHADE_DEAD_RADII to SHADE_CALM_RADII
 * (5 cm to 3 cm). */
#define SHADE_FIELD_RADII 2.0f
#define SHADE_DEAD_RADII 0.5f
#define SHADE_CALM_RADII 0.3f

/* A shade whose edge moves faster than this speed startles fish. */
#define SHADE_MOVES_M_S 0.05f
/* A shade whose edge is not faster than this speed is still. Between SHADE_STILL_M_S and
 * SHADE_MOVES_M_S a shade neither startles fish nor restarts its dwell time. Therefore a player can
 * slowly lead the gathered fish along. */
#define SHADE_STILL_M_S 0.02f
/* A shade that takes at most this share of the light never startles fish. A darker shade startles
 * fish while it moves, and during its first SHADE_NEW_S even if it is still. */
#define SHADE_SUDDEN_DARK 0.30f
#define SHADE_NEW_S 0.30f

/* Shade of one object over the water in one tick. `present` is 1 if the object exists, otherwise
 * 0. */
struct shade_cast {
    uint8_t present;
    float x_m, z_m, radius_m; /* Centre and radius of the shade. If `present` is 1, all values are
                                 finite and the radius is > 0. */
    float dark;               /* Share [0, 1] of the light that the object takes. */
};

/* A shade and its history. All zeros mean that there is no shade. */
struct shade {
    struct shade_cast cast; /* The object over the water in the last tick. */
    float edge_m_s;         /* Speed of the fastest point of the edge. The speed is smoothed over
                               0.1 s, because a mouse moves in steps of a pixel. */
    float age_s;            /* Time since the shade appeared, including the tick in which it
                               appeared. */
    float still_s;          /* Time since the edge was last faster than SHADE_MOVES_M_S. The time
                               grows only while the shade is still. */
};

/* Advances a shade by `dt_s`. `cast` is the object over the water now. Asserts that its values are
 * finite and that its radius is > 0. */
void shade_tick(struct shade *shade, const struct shade_cast *cast, float dt_s);

/* Returns the horizontal distance of a point from the centre of the shade. */
float shade_distance_m(const struct shade_cast *cast, vec3 position_m);

/* Returns 1 if a fish at this position is in the shade, otherwise 0. */
int shade_covers(const struct shade_cast *cast, vec3 position_m);

/* Returns the speed of attraction toward the shade's centre at `distance_m`, m/s, >= 0. In eq. 3.5
 * of the 2013 thesis a fish moves by M = 0.01 (20 - r) cm per frame. Table 4.2 gives 60 frames per
 * second for the 200 fish of that test, which results in 0.6 (20 - r) cm/s. Returns 0 until the
 * shade has been still for `params->shade_dwell_s`. */
float shade_pull_m_s(const struct shade *shade, const struct behavior_params *params,
                     float distance_m);

/* Course of a fish, which shade_draw() changes. */
struct shade_course {
    float heading_rad; /* Heading. Input: heading of the gait. Output: goal of the heading. */
    float speed_m_s;   /* Speed. Input: speed of the gait. Output: speed along the fish's forward
                          axis, which is lower while the fish faces another direction. */
};

/* Changes the course of a fish by the attraction of all shades. Course and attraction are added as
 * velocities. The sum is limited to the top swimming speed (section 3.3 of the 2013 thesis). A fish
 * that is already faster, as in a burst, is limited to its own speed. The fish turns toward the sum
 * and does not move sideways. Pushes by near fish reduce the attraction. Returns 1 if a shade
 * attracts the fish. Otherwise returns 0 and leaves `course` unchanged. */
int shade_draw(const struct shade *shades, uint32_t count, const struct behavior_params *params,
               const struct fish *fish, struct shade_course *course);

/* Returns the alarm >= 0 that a shade adds to a fish whose last decision was `dt_s` ago. Time
 * before the shade appeared does not count. A fan that sweeps over calm fish raises their alarm
 * above the threshold within 17 to 33 ms. The nerve latency is the rest of the total reaction time
 * of 60 to 150 ms (startle.h). The thin paper of a poi raises the alarm slightly but does not
 * startle. Returns 0 if `params->shade_frights` is 0. */
float shade_alarm(const struct shade *shade, const struct behavior_params *params, vec3 position_m,
                  float dt_s);

uint64_t shade_hash(uint64_t hash, const struct shade *shade);

#endif
