/* scene_tank.h -- what stands and swims in the water: fish, pois, bowls, fans and the pump. */
#ifndef KINGYO_CORE_SCENE_TANK_H
#define KINGYO_CORE_SCENE_TANK_H

#include <stdint.h>

#include "core/base/vec.h"

#define SCENE_FISH_MAX 2048u /* As TANK_FISH_MAX. */
#define SHEET_SIDE 32u       /* Cells along each side of the paper's square: 2.5 mm at 80 mm. */
#define RIPPLE_X 128u        /* Cells of the water surface, left to right ... */
#define RIPPLE_Z 80u         /* ... and back to front; about 7 mm in the festival tank. */

enum scene_place {
    SCENE_IN_TANK = 0,
    SCENE_ON_POI = 1,
    SCENE_IN_BOWL = 2,
};

struct scene_fish {
    vec3 position_m;         /* Centre of the body box. */
    struct angles angles;
    float length_m;          /* Total length, snout to tail tip. */
    float age_days;          /* Since it hatched; shape and colour are of that age. */
    float tail_phase_rad;    /* Of the travelling body wave; [0, 2 pi). */
    float tail_amplitude;    /* 1 is a fifth of the length from tip to tip; 0 is still. */
    float bend_rad;          /* Whole-body bend of a turn; positive bends the tail to its right. */
    float gape;              /* [0, 1] how far its mouth is open: it gulps at the surface. */
    float gulp;              /* (0, 1] from one opening to the next; 0: it does not gulp. */
    float progress;          /* [0, 1] from the species' first key shape to its last. */
    float maturity;          /* [0, 1] along the colour keys. */
    uint32_t look;           /* Random bits that choose the individual's pattern and colours. */
    uint8_t place;           /* enum scene_place */
};

struct scene_poi {
    uint8_t present;
    uint8_t owner;           /* Player index, chooses the ring's colour. */
    vec3 position_m;         /* Ring centre. */
    struct angles angles;
    float ring_radius_m;     /* Inner: the paper's edge. */
    float sag_m;             /* Depth of the paper's belly, along -up; negative bulges upward. */
    float paper_left;        /* [0, 1] area that is still there. */
    float shade_dark;        /* [0, 1] of the light that it takes from below; 0 once it dips. */
    float water_m;           /* Mean depth of the water that lies on it, or hangs in it. */
    uint8_t shows_stress;    /* Practice: the paper is coloured by `stress`. */
    uint8_t wetness[SHEET_SIDE * SHEET_SIDE];   /* 0 dry .. 255 wet; row 0 is the far edge (-z). */
    uint8_t integrity[SHEET_SIDE * SHEET_SIDE]; /* 255 whole .. 1 nearly torn, 0 hole. */
    uint8_t stress[SHEET_SIDE * SHEET_SIDE]; /* Load over strength, raised where it gathers; 255: it
                                                tears at once. 0 where there is no paper. */
};

struct scene_bowl {
    uint8_t present;
    uint8_t owner;
    vec3 position_m;         /* Centre of the mouth: it floats, and the poi may push it about. */
    struct angles angles;    /* How it heels. */
    float radius_m;          /* Of the mouth. */
    float depth_m;
    float water_below_m;     /* So far under its mouth its own water stands. */
    uint32_t fish_count;
};

/* The air stone of a tank that has a pump. */
struct scene_pump {
    uint8_t present;
    uint8_t runs;
    vec3 stone_m; /* On the floor. */
};

/* A fan that someone holds over the water, and with it its shadow. */
struct scene_fan {
    uint8_t present;
    uint8_t owner;           /* Player index, chooses its picture. */
    uint8_t unseen;          /* Only its shadow shows: for who wants to see what is below. */
    float x_m, z_m;          /* Middle of the shadow on the water, straight below the light. */
    float radius_m;
    float dark;              /* [0, 1] of the light that it takes. */
    float still_s;           /* How long it has been held still. */
};

#endif
