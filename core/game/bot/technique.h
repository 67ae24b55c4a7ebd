/* technique.h -- playing techniques of the bot: the habits of a player, each as a number. The
 * fields `lift` and `hunt` are styles that change several habits at once.
 *
 * Two techniques that differ in one field are an experiment on that field (make bench-technique).
 * The physics code is independent of the technique. An all-zero struct is invalid; start from one
 * of the two constants. */
#ifndef KINGYO_CORE_GAME_BOT_TECHNIQUE_H
#define KINGYO_CORE_GAME_BOT_TECHNIQUE_H

#include <stdint.h>

enum technique_side {
    SIDE_ANY = 0,
    SIDE_HEAD,
    SIDE_TAIL,
    SIDE_COUNT
}; /* End of the fish that is scooped first. */
enum technique_place {
    PLACE_CENTRE = 0,
    PLACE_RIM,
    PLACE_COUNT
}; /* Part of the paper under the fish. */
/* LIFT_FAST is 2.5 times `lift_m_s`, reached in less than half the time, even if the ring lags.
 * LIFT_FAST does not drain, whatever `drain_s` is. */
enum technique_lift { LIFT_DRAINED = 0, LIFT_FAST, LIFT_COUNT };
/* HUNT_CHASE takes the nearest fish, however fast or deep, and does not wait over the water. The
 * poi moves at `arm_m_s` in place of `glide_m_s`, for at most `patience_s`, and follows the fish
 * for 25 cm in place of 7.5 cm. The next fish is searched from the current position, not from
 * beside the bowl. */
enum technique_hunt { HUNT_SHADE = 0, HUNT_CHASE, HUNT_COUNT };

struct technique {
    float wet;        /* [0, 1] share of the paper that is wetted before the first scoop. */
    float entry_deg;  /* [0, 60] tilt of the paper on entry in degrees; 0 is level. */
    float glide_deg;  /* [0, 90] angle in degrees between paper and its motion under water; 90 is
                         broadside. */
    uint8_t side;     /* enum technique_side: the end of the fish that is above the ring first. */
    uint8_t place;    /* enum technique_place */
    uint8_t lift;     /* enum technique_lift: level and drained, or fast. */
    uint8_t hunt;     /* enum technique_hunt: wait in a still shadow, or chase. */
    uint8_t fish_max; /* 1 .. 8, the number of fish wanted on the paper before the lift. */
    float fish_m;     /* [0.02, 0.1] preferred length of fish. */
    float arm_m_s, dip_m_s, glide_m_s, lift_m_s, carry_m_s; /* Maximum speed of each motion, (0,
                                                               2]. */
    float drain_s;                                          /* [0, 3] draining time. */
    float patience_s;                     /* [0, 20] longest wait for a fish to come to rest. */
    float aim_m;                          /* [0, 0.05] largest aiming error. */
    float tremor_m;                       /* [0, 0.01] amplitude of the tremor. */
    float reaction_min_s, reaction_max_s; /* [0.15, 1] reaction time from a snapshot to the
                                             action. */
};

/* Chases fish, level and fast, with 30 % of the paper wet. */
extern const struct technique technique_novice;

/* Wets the whole paper, tilts it on entry, glides edge first, and scoops the head first near the
 * rim, in a still shadow. */
extern const struct technique technique_expert;

uint64_t technique_hash(uint64_t hash, const struct technique *technique);

#endif
