/* behavior_params.h -- the parameters that determine how the fish of a tank behave.
 *
 * Each tank preset has one set of parameters. The code reads the parameters and never tests which
 * preset is in use. Lengths and speeds are in body lengths, so that one set is valid for fish of
 * every size. Stamina is in [0, 1], where the 2013 thesis counts from 0 to 100; "section" means a
 * section of that thesis. A parameter of 0 disables its feature. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_PARAMS_H
#define KINGYO_CORE_TANK_BEHAVIOR_PARAMS_H

#include <stdint.h>

struct behavior_params {
    /* Height and width of the body box per body length (section 3.1: a fish of 5 x 2 x 1 cm). */
    float height_per_length, width_per_length;

    /* Personal space beyond the body on every side, in body lengths (section 3.4). */
    float space_per_length;
    float space_fill_max; /* Largest share of the water volume that all personal spaces may fill
                             together. The spaces shrink if necessary. */

    /* Speeds at full stamina, in body lengths per second (sections 2.1 and 3.3). At zero stamina a
     * fish reaches 0.8 of the speeds. `drift_speed` is the upper limit for a resting fish. */
    float burst_speed, swim_speed, swim_speed_max, drift_speed;

    /* Standard deviation of the change of heading when a fish begins to swim or to rest (section
     * 3.3). */
    float turn_swim_rad, turn_rest_rad;
    float depth_stray; /* Standard deviation of a fish's depth around the depth for its stamina, as
                          a share of the water depth. */

    /* The next four parameters control how a fish avoids other fish (section 3.4). */
    float meet_within_s; /* Longest time to contact at which a fish begins to avoid another fish. 0
                            means no limit. */
    float meet_miss;     /* Largest miss distance at which two fish avoid each other, as a share of
                            the sum of their lengths. 0 means any distance. */
    float brake_s;       /* Time to contact below which the fish slows down. */
    float swerve_haste;  /* Factor >= 1 on the speed at which an avoiding turn begins. */

    /* A fish turns away from a wall that is nearer to its nose than the sum of two distances:
     * `wall_per_length` and `wall_within_s` (section 3.1). */
    float wall_per_length; /* First part of the distance, in body lengths. */
    float wall_within_s;   /* Second part of the distance, as a time at the fish's present speed. */

    /* The next parameters describe living fish and have no source in the thesis. */
    float kick_rad;      /* Standard deviation of a random turn at each kick of the tail. 0 means
                            that a fish keeps its course until its gait changes. */
    uint8_t glides;      /* 1 if a swimming fish alternates between tail beats and glides, otherwise
                            0. */
    uint8_t banks;       /* 1 if the fish rolls into its turns, otherwise 0. */
    float flow_share;    /* Share [0, 1] of the flow around a poi (flow.h) that moves the fish. */
    float wall_follow;   /* Strength [0, 1] of the attraction of walls (wall_following.h). */
    float shade_dwell_s; /* Time that a shade must be still before it attracts fish. */
    uint8_t shade_draws_bursts; /* 1 if a shade also attracts fish in a burst (in section 3.5 a
                                   shade attracts every fish), otherwise 0. */
    uint8_t shade_frights;      /* 1 if a new or moving shade startles fish, otherwise 0. */
    uint8_t escapes;            /* 1 if fish escape from a poi and from other stimuli by a C-start
                                   (escape.h), otherwise 0. */

    /* The next parameters control surface breathing (section 3.6). */
    uint8_t air_by_oxygen;        /* Cause of surface breathing: 1 means low oxygen of the water, 0
                                     means low stamina. */
    float gulp_min_s, gulp_max_s; /* Shortest and longest duration of a bout of gulps; the duration
                                     is uniform between them. */
    float gulp_gain_per_s;        /* Stamina gained per second while the mouth is at the surface
                                     film. */
    float stifle_per_s; /* Stamina lost per second in water without oxygen. The loss begins below 4
                           mg/L and grows linearly. */
};

#endif
