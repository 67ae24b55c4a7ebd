/* part.h -- nothing passes through anything: bodies are moved apart, and who cannot be goes back.
 *
 * Two steps, every tick. First rounds of small pushes part what the fish's own motion brought
 * together: that settles nearly all of it, and looks natural. Then every pair that could touch is
 * judged, and a fish that is still deeper than PART_FREE_M in another, a wall, the ring or a hull
 * goes back to the pose that it had a tick before, until nobody is left who is too deep; or the poi
 * gives way, where the fish cannot. That ends, and it ends free: the poses of the tick before were
 * free of each other, so at worst all go back.
 *
 * Where more pairs could touch than the crowd has room for, those left out keep still for the tick.
 *
 * A crowd that starts with overlaps (staged by hand) is parted over its first ticks: then a pair
 * may be as deep as it was a tick before, and no deeper. */
#ifndef KINGYO_CORE_TANK_PART_H
#define KINGYO_CORE_TANK_PART_H

#include "core/tank/crowd.h"
#include "core/tank/obstacle.h"

#define TANK_OBSTACLE_MAX 8u /* A poi and a bowl of each player. */

#define PART_FREE_M 0.0003f  /* Two bodies that share no more than this count as apart. */
#define PART_SHOVE_M 0.002f  /* For place.shove_max_m: more would look like a jump ... */
#define PART_CALM_SHOVE_M 0.0005f /* ... and where no poi stirs the water: 6 cm/s. */

/* Inner faces that bodies keep within. */
struct tank_bounds {
    vec3 low_m, high_m;
};

/* What parting knows of a tank. */
struct part_place {
    struct fish *fish;
    struct tank_bounds bounds;
    struct obstacle *obstacles; /* They may give way; see rim.h. */
    uint32_t obstacle_count;
    float shove_max_m; /* What others shove a body by in a tick, beyond its own motion, at most. */
    uint8_t lanes;     /* 0, 4 or 8, as lanes_built(): a matter of speed alone. */
};

enum part_fate { /* What the judgement of this step made of a fish. */
    PART_MOVES = 0,
    PART_BACK = 1,    /* It is where the step began. */
    PART_PRESSED = 2, /* It moves, and obstacle 0 was in its way; obstacle k: k more. */
    PART_CARRIED = PART_PRESSED + TANK_OBSTACLE_MAX, /* It goes along with obstacle 0; as above. */
};

/* Scratch of one tick; all columns as the tank's fish. */
struct part {
    vec3 began_m[TANK_FISH_MAX + 1u]; /* Where all were when the tick began; lanes read a float
                                         beyond the last. */
    vec3 step_began_m[TANK_FISH_MAX]; /* The same of a later step of the tick. */
    struct angles began_angles[TANK_FISH_MAX + 1u];
    float step_max_m[TANK_FISH_MAX];     /* How far from `before` a body may end. */
    uint8_t fate[TANK_FISH_MAX]; /* enum part_fate */
    uint16_t fresh_round[TANK_FISH_MAX];     /* 0, or one more than the round of the judgement that
                                                last moved it; */
    uint16_t gave_round[TANK_OBSTACLE_MAX]; /* the same of obstacles that gave way. */
    uint32_t beside_count;
    fish_index beside[TANK_FISH_MAX]; /* Who could touch an obstacle in this step. */
    struct course { /* Of an obstacle, as it wanted to go. */
        vec3 from_m, step_m;
        uint8_t turned;
    } course[TANK_OBSTACLE_MAX];
    uint32_t station, station_count;
    uint8_t turns_back;  /* Somebody has its old angles again. */
    uint32_t back_count; /* Fish put back in this tick, in all its steps. */
};

/* At the start of a tick, before any fish moves: keeps the poses that they may go back to. */
void part_begin(struct part *part, const struct fish *fish, uint32_t fish_count);

/* After they moved: how many short steps this tick takes. One, but for a poi that is fast: a crowd
 * must be shoved along at its pace, and no fish may be on its other side before it has touched it.
 */
uint32_t part_stations(struct part *part, const struct part_place *place);

/* Each step begins so: obstacles go on, and fish take the places that the last step found. */
void part_advance(struct part *part, struct crowd *crowd, const struct part_place *place,
                  uint32_t station);

/* Then: moves bodies out of obstacles and within bounds, so that the look sees where they really
 * are. */
void part_clear(struct part *part, struct crowd *crowd, const struct part_place *place);

/* Moves bodies apart as far as some rounds can. Walls, floor and surface always hold. */
void part_relax(struct part *part, struct crowd *crowd, const struct part_place *place);

/* Each step ends so: the same, and puts back those that cannot be parted. */
void part_bodies(struct part *part, struct crowd *crowd, const struct part_place *place);

/* At the end of a tick: who was put back has its old angles again and turns no more; an obstacle
 * that gave way has lost the speed that it could not use. */
void part_end(struct part *part, const struct crowd *crowd, const struct part_place *place);

/* Gives all fish the places of their bodies. */
void part_take(const struct crowd *crowd, struct fish *fish);

#endif
