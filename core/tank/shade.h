/* shade.h -- shadows on the water: a moving one frightens fish, a still one gathers them.
 *
 * Whatever is held over the water casts one: a fan, a hand, a dry poi. Light falls from straight
 * above, so a shadow is a round column of water from the surface to the floor, and every distance
 * here is horizontal: the 2013 thesis' |N - P| in space would pull a fish below the fan upward and
 * hardly at all. */
#ifndef KINGYO_CORE_TANK_SHADE_H
#define KINGYO_CORE_TANK_SHADE_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/tank/fish.h"
#include "core/tank/law.h"

#define SHADE_FAN_DARK 0.62f /* Of the light: what paper on bamboo, or a hand, takes. */

/* The thesis' law (section 3.5) for its shadow of 10 cm, in radii: the field reaches to 20 cm, and
 * inside 5 cm there is no pull. That step from 9 cm/s to none is a fade from 5 to 3 cm here. */
#define SHADE_FIELD_RADII 2.0f
#define SHADE_DEAD_RADII 0.5f
#define SHADE_CALM_RADII 0.3f

/* A shadow of which the edge moves faster than this frightens (facts of the stall: stand still). */
#define SHADE_MOVES_M_S 0.05f
/* One slower than this stands still. In between it neither frightens nor has it to begin anew: who
 * has gathered fish may draw them along slowly. */
#define SHADE_STILL_M_S 0.02f
/* What takes more than this share of the light within SHADE_NEW_S frightens, moving or not. */
#define SHADE_SUDDEN_DARK 0.30f
#define SHADE_NEW_S 0.30f

/* Something over the water in one tick. */
struct shade_cast {
    uint8_t present;
    float x_m, z_m, radius_m; /* Finite, radius > 0, while present. */
    float dark;               /* [0, 1] share of the light that it takes. */
};

/* A shadow with its past. All zero is none. */
struct shade {
    struct shade_cast cast; /* Of the last tick. */
    float edge_m_s;         /* Speed of its fastest edge, eased over a tenth of a second: a mouse
                               steps from pixel to pixel, a shadow does not. */
    float age_s;            /* Since it fell on the water, that tick included. */
    float still_s;          /* Since its edge last moved faster than SHADE_MOVES_M_S. */
};

/* `dt_s` later: `cast` is what is there now. What is not finite is a bug and asserts. */
void shade_tick(struct shade *shade, const struct shade_cast *cast, float dt_s);

/* From its middle, horizontally. */
float shade_distance_m(const struct shade_cast *cast, vec3 position_m);

/* Whether a fish there is in it. */
int shade_covers(const struct shade_cast *cast, vec3 position_m);

/* Speed toward its middle that it lends a fish so far from it, m/s >= 0: eq. 3.5 per second. The
 * thesis moves fish by M = 0.01 (20 - r) cm a frame, and its table 4.2 gives 60 frames a second for
 * the 200 fish of that test: 0.6 (20 - r) cm/s. 0 while the law's dwell is not over. */
float shade_pull_m_s(const struct shade *shade, const struct law *law, float distance_m);

/* What all of them do to the course of a fish: course and pull are added as velocities and kept to
 * its top speed for swimming (section 3.3) or its own, if that is more: a burst's. It turns that
 * way rather than being carried sideways. Where the crowd pushes back, the pull gives way. Returns
 * whether any pulls; if not, heading and speed stay as they are. */
struct shade_course {
    float heading_rad; /* In: where its gait takes it. Out: where to turn. */
    float speed_m_s;   /* In: its gait's. Out: along its nose, less while that points elsewhere. */
};
int shade_draw(const struct shade *shades, uint32_t count, const struct law *law,
               const struct fish *fish, struct shade_course *course);

/* What it adds to the alarm of a fish that last thought `dt_s` ago, >= 0; no more than since it
 * fell. Under a fan that sweeps by or drops in the calm need 17 to 33 ms to be startled, and their
 * nerves the rest of 60 to 150 ms (fright.h); under a poi's thin paper there is an unease (a weak
 * contrast alarms, it does not startle). 0 where the law knows no fright by shadows. */
float shade_alarm(const struct shade *shade, const struct law *law, vec3 position_m, float dt_s);

uint64_t shade_hash(uint64_t hash, const struct shade *shade);

#endif
