/* technique.h -- how somebody plays: the habits of a scooping hand, each a figure of its own. But
 * `lift` and `hunt` are styles: each stands for several things that a hand does together.
 *
 * Two techniques that differ in one field are an experiment on that field (make bench-technique).
 * Nothing here is known to the physics, and nothing in the physics knows who plays. Zero is no
 * technique: start from one of the two. */
#ifndef KINGYO_CORE_GAME_TECHNIQUE_H
#define KINGYO_CORE_GAME_TECHNIQUE_H

#include <stdint.h>

enum technique_side { SIDE_ANY = 0, SIDE_HEAD, SIDE_TAIL, SIDE_COUNT };  /* Of the fish, first. */
enum technique_place { PLACE_CENTRE = 0, PLACE_RIM, PLACE_COUNT }; /* Of the paper, under it. */
/* Fast is two and a half times `lift_m_s`, reached in less than half the time, whether the ring
 * follows or not; and nothing runs off, whatever `drain_s` says. */
enum technique_lift { LIFT_DRAINED = 0, LIFT_FAST, LIFT_COUNT };
/* Who chases takes the nearest fish, however quick or deep, does not wait over the water, goes
 * under it at `arm_m_s` in place of `glide_m_s`, for `patience_s` at most, follows it 25 cm far in
 * place of 7.5, and looks for the next from where the hand is, not from beside the bowl. */
enum technique_hunt { HUNT_SHADE = 0, HUNT_CHASE, HUNT_COUNT };

struct technique {
    float wet;            /* [0, 1] share of the paper that is wetted before the first scoop. */
    float entry_deg;      /* [0, 60] slant of the paper as it goes into the water; 0 is flat. */
    float glide_deg;      /* [0, 90] between paper and its way under water; 90 is broadside. */
    uint8_t side;         /* enum technique_side: which end of the fish is over the ring first. */
    uint8_t place;        /* enum technique_place */
    uint8_t lift;         /* enum technique_lift: level and drained, or fast and flat. */
    uint8_t hunt;         /* enum technique_hunt: wait in a still shade, or chase. */
    uint8_t fish_max;     /* 1 .. 8 that it wants on the paper before it lifts. */
    float fish_m;         /* [0.02, 0.1] the length of fish that it likes best. */
    float arm_m_s, dip_m_s, glide_m_s, lift_m_s, carry_m_s; /* (0, 2] at most, each. */
    float drain_s;        /* [0, 3] that it lets water run off. */
    float patience_s;     /* [0, 20] that it waits for a fish to come to rest. */
    float aim_m;          /* [0, 0.05] how far it misses, at most. */
    float tremor_m;       /* [0, 0.01] of its hand. */
    float reaction_min_s, reaction_max_s; /* [0.15, 1] from the sight to the act. */
};

/* Chases, flat and fast, with half of the paper wet. */
extern const struct technique technique_novice;

/* Wets all, slants in, glides edge first, takes the head first, near the rim, in still shade. */
extern const struct technique technique_expert;

uint64_t technique_hash(uint64_t hash, const struct technique *technique);

#endif
