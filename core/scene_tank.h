/* scene_tank.h -- the tank part of a scene: fish, pois, bowls, fans and the pump. */
#ifndef KINGYO_CORE_SCENE_TANK_H
#define KINGYO_CORE_SCENE_TANK_H

#include <stdint.h>

#include "core/base/vec.h"

#define SCENE_FISH_MAX 2048u /* Equal to TANK_FISH_MAX. */
#define SHEET_SIDE 32u       /* Cells along each side of the paper's square: 2.5 mm at 80 mm. */
#define RIPPLE_X 128u        /* Cells of the water surface from left to right. */
/* Cells of the water surface from back to front; about 7 mm each in the festival tank. */
#define RIPPLE_Z 80u

enum scene_place {
    SCENE_IN_TANK = 0,
    SCENE_ON_POI = 1,
    SCENE_IN_BOWL = 2,
};

struct scene_fish {
    vec3 position_m; /* Centre of the body box. */
    struct angles angles;
    float length_m;       /* Total length, snout to tail tip. */
    float age_days;       /* Days since hatching; shape and colour are those of this age. */
    float tail_phase_rad; /* Phase of the travelling body wave; [0, 2 pi). */
    float tail_amplitude; /* Tail-beat amplitude; 1: a fifth of the length, peak to peak; 0: the
                             tail is still. */
    float bend_rad;       /* Whole-body bend of a turn; positive bends the tail to its right. */
    float gape;           /* [0, 1] opening of the mouth; the fish gulps at the surface. */
    float gulp;           /* (0, 1] progress of one gulp, from one opening to the next; 0: the
                             fish does not gulp. */
    float progress;       /* [0, 1] from the species' first key shape to its last. */
    float maturity;       /* [0, 1] along the colour keys. */
    uint32_t look;        /* Random bits that choose the individual's pattern and colours. */
    uint8_t place;        /* enum scene_place */
};

struct scene_poi {
    uint8_t present;
    uint8_t owner;   /* Player index; selects the ring's colour. */
    vec3 position_m; /* Ring centre. */
    struct angles angles;
    float ring_radius_m;  /* Inner radius, at the paper's edge. */
    float sag_m;          /* Depth of the sagging paper, along -up; negative bulges upward. */
    float paper_left;     /* [0, 1] share of the paper area that is left. */
    float shade_dark;     /* [0, 1] share of the light that the poi blocks from the water below;
                             0 once the poi is in the water. */
    float water_m;        /* Mean depth of the water on the paper. */
    uint8_t shows_stress; /* 1 in practice mode: the paper is coloured by `stress`. */
    uint8_t wetness[SHEET_SIDE * SHEET_SIDE];   /* 0 dry .. 255 wet; row 0 is the far edge (-z). */
    uint8_t integrity[SHEET_SIDE * SHEET_SIDE]; /* 255 whole .. 1 nearly torn, 0 hole. */
    uint8_t stress[SHEET_SIDE * SHEET_SIDE]; /* Load over strength, including stress concentration;
                                                255: the paper tears at once; 0: no paper. */
};

struct scene_bowl {
    uint8_t present;
    uint8_t owner;
    vec3 position_m;      /* Centre of the mouth. The bowl floats, and the poi may push it. */
    struct angles angles; /* Heel of the bowl. */
    float radius_m;       /* Radius of the mouth. */
    float depth_m;
    float water_below_m; /* Depth of the bowl's own water level below its mouth. */
    uint32_t fish_count;
};

/* Air stone of a tank with a pump. */
struct scene_pump {
    uint8_t present;
    uint8_t runs;
    vec3 stone_m; /* Position on the floor. */
};

/* A fan held over the water, with its shadow. */
struct scene_fan {
    uint8_t present;
    uint8_t owner;  /* Player index; selects the fan's picture. */
    uint8_t unseen; /* 1: only the shadow is shown, so that the water below stays visible. */
    float x_m, z_m; /* Centre of the shadow on the water, vertically below the light. */
    float radius_m;
    float dark;    /* [0, 1] share of the light that the fan blocks. */
    float still_s; /* Seconds for which the fan has been held still. */
};

#endif
