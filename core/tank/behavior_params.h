/* behavior_params.h -- the input of a fish's decisions: the behavior parameters of its tank (struct
 * behavior_params) and the fish's surroundings in one tick (struct perception).
 *
 * Each tank preset has one set of parameters. The code reads the parameters and never tests which
 * preset is in use. Lengths and speeds are in body lengths, so that one set is valid for fish of
 * every size. Stamina is in [0, 1]; the 2013 thesis on goldfish behavior uses 0 to 100. A parameter
 * of 0 disables its feature, unless the comment on the parameter gives another meaning. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/rng.h"
#include "core/base/vec.h"

struct behavior_params {
    /* Height and width of the body box per body length. In section 3.1 of the 2013 thesis a fish is
     * 5 cm long, 2 cm high and 1 cm wide. */
    float height_per_length, width_per_length;

    /* Width of the personal space around the body of a fish, on every side, in body lengths. Fish
     * whose personal spaces overlap may avoid each other (2013 thesis, section 3.4). */
    float space_per_length;
    /* Largest fraction of the water volume that the personal spaces of all fish may fill together.
     * If the spaces would fill more, every space shrinks. */
    float space_fill_max;

    /* Speeds at full stamina, in body lengths per second (2013 thesis, sections 2.1 and 3.3). A
     * fish with zero stamina reaches 0.8 times these speeds. `drift_speed` is the upper limit for a
     * resting fish. */
    float burst_speed, swim_speed, swim_speed_max, drift_speed;

    /* Standard deviation of the change of heading when a fish begins to swim (`turn_swim_rad`) or
     * to rest (`turn_rest_rad`). Section 3.3 of the 2013 thesis describes the change. */
    float turn_swim_rad, turn_rest_rad;
    /* Standard deviation of the depths that fish with equal stamina prefer, as a fraction of the
     * water depth. */
    float depth_stray;

    /* The next four parameters control how a fish avoids other fish (2013 thesis, section 3.4). */
    float meet_within_s; /* Time to contact below which a fish begins to avoid another fish. 0 means
                            no limit. */
    /* Two fish avoid each other only if their courses pass each other at less than this distance,
     * in units of the sum of the two body lengths. 0 means any distance. */
    float meet_miss;
    float brake_s; /* Time to contact with another fish below which a fish slows down. */
    /* Value >= 1 of `haste` (fish.h) while a fish turns to avoid another fish. A larger value makes
     * the turn begin faster. */
    float swerve_haste;

    /* A fish turns away from a wall when the distance from its nose to the wall is below a limit
     * (2013 thesis, section 3.1). The limit is `wall_per_length` body lengths plus the distance
     * that the fish swims in the time `wall_within_s`. */
    float wall_per_length;
    /* Part of the limit distance to a wall, given as the time in which the fish swims that part. A
     * fish turns away from a wall that is nearer than the limit distance. */
    float wall_within_s;

    /* The next parameters add the behavior of living fish to the rules of the 2013 thesis. */
    float kick_rad; /* Standard deviation of the random turn at each kick of the tail (gait.h). 0
                       means that a fish keeps its course until its gait changes. */
    bool glides;    /* True if a swimming fish alternates between tail beats and glides. */
    bool banks;     /* True if the fish rolls into its turns. */
    /* Velocity with which fish drift in the flow around a moving poi (paper scoop), as a fraction
     * [0, 1] of the flow velocity (water.h). */
    float flow_share;
    float wall_follow;   /* Strength [0, 1] with which walls attract fish (fish_behavior.h). */
    float shade_dwell_s; /* Time that a shade must be still before it attracts fish. */
    /* True if a shade also attracts fish in a burst. In section 3.5 of the 2013 thesis a shade
     * attracts every fish. */
    bool shade_draws_bursts;
    bool shade_frights; /* True if a new or moving shade startles fish. */
    /* True if startled fish escape by a C-start, a fast turn and thrust (startle.h), for example
     * from a poi (paper scoop). */
    bool escapes;

    /* The next parameters control surface breathing (2013 thesis, section 3.6). */
    bool air_by_oxygen; /* Cause of surface breathing: true means low oxygen in the water, false
                           means low stamina. */
    /* Shortest and longest duration of a bout, which is a series of gulps. The random duration has
     * a uniform distribution. */
    float gulp_min_s, gulp_max_s;
    /* Stamina that a fish gains per second while its mouth is in the surface film. */
    float gulp_gain_per_s;
    /* Stamina that a fish loses per second in water without oxygen. The loss is zero at 4 mg/L or
     * more and grows linearly as the concentration falls. */
    float stifle_per_s;
};

/* Temper of the fish of a tank: how much calmer they are than living fish. All fields are 0 for
 * living fish. Calmer fish escape in the same way as living fish, but later or only from a stronger
 * stimulus. */
struct temper {
    float threshold_gain; /* Fraction by which the alarm that starts an escape is higher than for
                             living fish. */
    float latency_gain;   /* Fraction by which the time from alarm to escape is longer than for
                             living fish. */
    /* A moving poi (paper scoop) startles living fish within some distance. This member is the
     * fraction [0, 1] by which that distance is shorter. */
    float reach_loss;
    /* Fraction [0, 1] of the small fish that are calm: they stay near the surface, and only a
     * higher alarm startles them (fish_is_calm()). */
    float calm_share;
};

struct obstacle;
struct shade;

/* Ticks between two decisions of an undisturbed fish: 33 ms, the reaction time of a fish. */
#define FISH_BEHAVIOR_TICKS 4u

/* Input of a fish's decision. The caller owns the arrays, which stay valid during the decision. */
struct perception {
    const struct behavior_params *params;
    struct temper temper;
    vec3 size_m;       /* Inner width, water depth and length of the tank. */
    float wall_follow; /* Strength [0, 1] with which walls attract fish. */
    /* True if the personal space around each fish is a ball instead of a box; see struct
     * tank_config. */
    bool ball_spaces;
    uint32_t seed, tick;
    float dt_s;        /* Time between this decision of the fish and its previous decision. */
    float oxygen_mg_l; /* Oxygen dissolved in the water. */
    const struct obstacle *obstacles;
    uint32_t obstacle_count;
    /* Shades on the water. Some of the `shade_count` entries may be absent (cast.present is 0). */
    const struct shade *shades;
    uint32_t shade_count;
};

/* Returns the key of a random number for one decision of fish `index`. `purpose` distinguishes the
 * random numbers of one decision. */
static inline struct rng_key perception_key(const struct perception *around, uint32_t index,
                                            enum rng_purpose purpose)
{
    return (struct rng_key){ around->seed, around->tick, index, purpose };
}
