/* shade.h -- shades on the water: a moving shade startles fish, a still shade attracts them.
 *
 * Anything held over the water casts a shade: a fan, a hand, a dry poi. Light falls vertically, so
 * a shade is a round column of water from the surface to the floor, and every distance here is
 * horizontal. The 2013 thesis' |N - P| in space would pull a fish below the fan upward and hardly
 * sideways. */
#ifndef KINGYO_CORE_TANK_SHADE_H
#define KINGYO_CORE_TANK_SHADE_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

#define SHADE_FAN_DARK 0.62f /* Share of the light that paper on bamboo, or a hand, takes. */

/* The thesis' rule (section 3.5) for its shade of 10 cm, in radii: the field reaches to 20 cm,
 * and there is no attraction inside 5 cm. The step from 9 cm/s to zero is a fade from 5 to 3 cm
 * here. */
#define SHADE_FIELD_RADII 2.0f
#define SHADE_DEAD_RADII 0.5f
#define SHADE_CALM_RADII 0.3f

/* A shade whose edge moves faster than this startles fish. */
#define SHADE_MOVES_M_S 0.05f
/* A shade slower than this is still. Between both speeds a shade does not startle and does not
 * restart its dwell time, so that a player can slowly lead the gathered fish along. */
#define SHADE_STILL_M_S 0.02f
/* A shade that takes more than this share of the light within SHADE_NEW_S startles fish, moving or
 * not. */
#define SHADE_SUDDEN_DARK 0.30f
#define SHADE_NEW_S 0.30f

/* An object over the water in one tick. */
struct shade_cast {
    uint8_t present;
    float x_m, z_m, radius_m; /* Finite, and radius > 0, if `present`. */
    float dark;               /* [0, 1] share of the light that the object takes. */
};

/* A shade and its history. All zero: no shade. */
struct shade {
    struct shade_cast cast; /* The object in the last tick. */
    float edge_m_s;         /* Speed of the fastest point of the edge, smoothed over 0.1 s because a
                               mouse moves in pixel steps. */
    float age_s;            /* Time since the shade fell on the water, including that tick. */
    float still_s;          /* Time since the edge last moved faster than SHADE_MOVES_M_S. */
};

/* Advances a shade by `dt_s`; `cast` is the object now. Asserts that all values are finite. */
void shade_tick(struct shade *shade, const struct shade_cast *cast, float dt_s);

/* Returns the horizontal distance of a point from the centre of the shade. */
float shade_distance_m(const struct shade_cast *cast, vec3 position_m);

/* Returns 1 if a fish at this position is in the shade. */
int shade_covers(const struct shade_cast *cast, vec3 position_m);

/* Returns the attraction toward the centre at `distance_m`, m/s, >= 0, from eq. 3.5 per second. The
 * thesis moves fish by M = 0.01 (20 - r) cm per frame. Table 4.2 gives 60 frames per second for
 * the 200 fish of that test: 0.6 (20 - r) cm/s. Returns 0 during the dwell time of the behavior
 * parameters. */
float shade_pull_m_s(const struct shade *shade, const struct behavior_params *params,
                     float distance_m);

/* Changes the course of a fish by the attraction of all shades. Course and attraction are added as
 * velocities and limited to the top swimming speed (section 3.3), or to the fish's own speed if
 * that is higher, as in a burst. The fish turns toward the sum instead of moving sideways. The
 * attraction decreases where near fish push back. Returns 1 if any shade attracts; otherwise
 * heading and speed are unchanged. */
struct shade_course {
    float heading_rad; /* In: heading of the gait. Out: goal of the heading. */
    float speed_m_s;   /* In: speed of the gait. Out: speed along the nose, lower while the nose
                          points elsewhere. */
};
int shade_draw(const struct shade *shades, uint32_t count, const struct behavior_params *params,
               const struct fish *fish, struct shade_course *course);

/* Returns the alarm, >= 0, that a shade adds for a fish whose last decision was `dt_s` ago, but not
 * for time before the shade fell. Under a fan that sweeps by or drops in, calm fish need 17 to
 * 33 ms to be startled; the nerve latency takes the rest of 60 to 150 ms (startle.h). A poi's thin
 * paper raises the alarm slightly but does not startle. Returns 0 if the behavior parameters
 * disable this response. */
float shade_alarm(const struct shade *shade, const struct behavior_params *params, vec3 position_m,
                  float dt_s);

uint64_t shade_hash(uint64_t hash, const struct shade *shade);

#endif
