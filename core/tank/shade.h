/* shade.h -- shades on the water, which are shadows of objects over the water. A moving shade
 * startles fish, and a still shade attracts fish.
 *
 * Every object over the water casts a shade, for example a hand-held fan, a human hand or a dry poi
 * (the paper scoop). Light falls vertically, so a shade is a round column of water from the surface
 * to the floor. All distances from a shade are horizontal. The 2013 thesis on goldfish behavior
 * uses distances in three dimensions, with which the fan's shade would pull a fish below the fan
 * upward and hardly sideways. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

/* Darkness of the shade of a hand-held fan of paper and bamboo, or of a human hand: the fraction of
 * the light that the object takes. */
#define SHADE_FAN_DARK 0.62f

/* Distances from the centre of a shade, in radii of the shade. Fish nearer than SHADE_FIELD_RADII
 * are attracted. Nearer than SHADE_DEAD_RADII the attraction decreases. At SHADE_CALM_RADII and
 * nearer the attraction is zero, so that the fish in the shade come to rest.
 *
 * In section 3.5 of the 2013 thesis the radius is 10 cm, and the attraction reaches to 20 cm from
 * the centre. At 5 cm from the centre the attraction falls abruptly from 9 cm/s to zero. In this
 * code the attraction falls gradually between 5 cm and 3 cm. */
#define SHADE_FIELD_RADII 2.0f
#define SHADE_DEAD_RADII 0.5f
#define SHADE_CALM_RADII 0.3f

/* A shade whose edge moves faster than this speed startles fish. */
#define SHADE_MOVES_M_S 0.05f
/* A shade whose edge is at most this fast counts as still. A shade that was still for
 * params->shade_dwell_s seconds attracts fish. A shade that then moves faster, but not faster than
 * SHADE_MOVES_M_S, continues to attract fish, so that the fish follow the shade. */
#define SHADE_STILL_M_S 0.02f
/* A shade that takes at most SHADE_SUDDEN_DARK of the light never startles fish. A darker shade
 * startles fish while it moves, and during the first SHADE_NEW_S seconds after it appears even if
 * it is still. */
#define SHADE_SUDDEN_DARK 0.30f
#define SHADE_NEW_S 0.30f

/* Shade on the water that one object casts in one tick. `present` is true if the object exists. */
struct shade_cast {
    bool present;
    /* Centre and radius of the shade. If `present` is true, all values are finite and the radius is
     * > 0. */
    float x_m, z_m, radius_m;
    /* Fraction [0, 1] of the light that the object over the water takes. */
    float dark;
};

/* A shade on the water and its history. All zeros mean that there is no shade. */
struct shade {
    struct shade_cast cast; /* Place, size and darkness of the shade in the last tick. */
    /* Speed of the fastest point of the shade's edge. The speed is smoothed over 0.1 s, because a
     * mouse moves in steps of a pixel. */
    float edge_m_s;
    /* Time since the shade appeared, including the tick in which it appeared. */
    float age_s;
    /* Total time for which the shade was still. A motion of the edge faster than SHADE_MOVES_M_S
     * resets the time. */
    float still_s;
};

/* Updates the age and the motion of a shade after `dt_s`. `cast` is the present shade of the object
 * over the water. Asserts that its values are finite and that its radius is > 0. */
void shade_tick(struct shade *shade, const struct shade_cast *cast, float dt_s);

/* Returns the horizontal distance of a point from the centre of the shade, m. */
float shade_distance_m(const struct shade_cast *cast, vec3 position_m);

/* Returns true if a fish at this position is in the shade. */
bool shade_covers(const struct shade_cast *cast, vec3 position_m);

/* Returns the speed, m/s, >= 0, by which a shade attracts a fish toward the shade's centre.
 * `distance_m` is the distance of the fish from the centre. In eq. 3.5 of the 2013 thesis, a fish
 * at a distance of r cm moves by 0.01 * (20 - r) cm per frame. Table 4.2 of the 2013 thesis gives
 * 60 frames per second, which results in 0.6 * (20 - r) cm/s. Returns 0 until the shade has been
 * still for `params->shade_dwell_s` seconds. */
float shade_pull_m_s(const struct shade *shade, const struct behavior_params *params,
                     float distance_m);

/* Heading and speed of a fish, which shade_draw() changes. */
struct shade_course {
    /* Before shade_draw(): heading of the fish's gait. After shade_draw(): heading to which the
     * fish turns. */
    float heading_rad;
    /* Before shade_draw(): speed of the fish's gait. After shade_draw(): speed along the fish's
     * forward axis, which is lower while the fish faces another direction. */
    float speed_m_s;
};

/* Changes the course of a fish by the attraction of all shades. The new velocity is the sum of the
 * fish's own velocity and the velocity of the attraction. The speed is limited to the top swimming
 * speed (2013 thesis, section 3.3), or to the fish's own speed if that is higher, as in a burst.
 * The fish turns to the direction of the new velocity and does not move sideways.
 *
 * Pushes by nearby fish reduce the attraction.
 *
 * Returns true if a shade attracts the fish. Otherwise returns false and leaves `course`
 * unchanged. */
bool shade_draw(const struct shade *shades, uint32_t count, const struct behavior_params *params,
                const struct fish *fish, struct shade_course *course);

/* Returns the alarm >= 0 that a shade adds to a fish. `dt_s` is the time since the last decision of
 * the fish. If the shade is younger than `dt_s`, only its age counts.
 *
 * The shade of a hand-held fan raises the alarm of calm fish above the startle threshold within 17
 * to 33 ms. The nerve latency (startle.h) follows, and the total reaction time is 60 to 150 ms. The
 * shade of a poi's thin paper raises the alarm slightly but does not startle fish.
 *
 * Returns 0 if `params->shade_frights` is false. */
float shade_alarm(const struct shade *shade, const struct behavior_params *params, vec3 position_m,
                  float dt_s);
