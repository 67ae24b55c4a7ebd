/* technique.h -- playing techniques of the bot: the habits of a player, each as a number. The
 * fields `lift` and `hunt` are styles that change several habits together.
 *
 * Two techniques that differ in one field are an experiment on that field (make bench-technique).
 * The physics code is independent of the technique. A struct with all fields 0 is invalid; start
 * from technique_novice or technique_expert. */
#pragma once

#include <stdint.h>

/* End of the fish (head or tail) under which the ring passes first. */
enum technique_side { SIDE_ANY = 0, SIDE_HEAD, SIDE_TAIL, SIDE_COUNT };
/* Part of the paper on which the bot tries to place the fish. */
enum technique_place { PLACE_CENTRE = 0, PLACE_RIM, PLACE_COUNT };
/* Style of the lift. LIFT_FAST lifts at 2.5 times `lift_m_s` and reaches that speed in less than
 * half the time, even if the ring lags behind the arm. LIFT_FAST ignores `drain_s` and does not
 * wait for the water to drain. */
enum technique_lift { LIFT_DRAINED = 0, LIFT_FAST, LIFT_COUNT };
/* Style of the hunt. HUNT_CHASE selects the nearest fish, even if it is fast or deep, and does not
 * wait over the water. Under water the poi moves at `arm_m_s` instead of `glide_m_s`, for at most
 * `patience_s`. The poi follows the fish for 25 cm instead of 7.5 cm. The search for the next fish
 * starts at the poi's current position, not beside the bowl. */
enum technique_hunt { HUNT_SHADE = 0, HUNT_CHASE, HUNT_COUNT };

struct technique {
    float wet; /* Share of the paper that is wetted before the first scoop, [0, 1]. */
    /* Tilt of the paper in degrees when the poi enters the water, [0, 60]; 0 is level. */
    float entry_deg;
    /* Angle in degrees between the paper and its motion under water, [0, 90]; 90 is broadside. */
    float glide_deg;
    /* End of the fish (head or tail) under which the ring passes first (enum technique_side). */
    uint8_t side;
    /* Part of the paper on which the bot tries to place the fish (enum technique_place). */
    uint8_t place;
    uint8_t lift; /* Style of the lift (enum technique_lift). */
    uint8_t hunt; /* Style of the hunt (enum technique_hunt). */
    /* Number of fish that the bot tries to have on the paper before it lifts the poi, 1 .. 8. */
    uint8_t fish_max;
    float fish_m; /* Preferred length of a fish in metres, [0.02, 0.1]. */
    /* Maximum speed of each motion of the arm, (0, 2] m/s. */
    float arm_m_s, dip_m_s, glide_m_s, lift_m_s, carry_m_s;
    /* Time in seconds for which the bot lets water drain from the paper during a lift, [0, 3]. */
    float drain_s;
    /* Longest time in seconds for which the bot waits for a fish to come to rest, [0, 20]. */
    float patience_s;
    float aim_m;    /* Largest aiming error in metres, [0, 0.05]. */
    float tremor_m; /* Amplitude of the arm's tremor in metres, [0, 0.01]. */
    /* Shortest and longest reaction time in seconds between a snapshot and the action, [0.15,
     * 1]. */
    float reaction_min_s, reaction_max_s;
};

/* Technique that chases fish, with level paper and a fast lift. 30 % of the paper is wet. */
extern const struct technique technique_novice;

/* Technique that wets the whole paper, tilts the paper on entry, and moves the paper edge first
 * under water. The bot holds the poi still until the fish is calm, because a still shadow does not
 * startle fish, and scoops the fish head first, near the rim. */
extern const struct technique technique_expert;
