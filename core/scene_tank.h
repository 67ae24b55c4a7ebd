/* scene_tank.h -- the tank part of a scene: fish, pois, bowls, fans and the pump. */
#ifndef KINGYO_CORE_SCENE_TANK_H
#define KINGYO_CORE_SCENE_TANK_H

#include <stdint.h>

#include "core/base/vec.h"

#define SCENE_FISH_MAX 2048u /* Equal to TANK_FISH_MAX. */
/* Number of cells along each side of the square around the paper; a cell measures 2.5 mm at a
 * poi diameter of 80 mm. */
#define SHEET_SIDE 32u
#define RIPPLE_X 128u /* Number of cells of the water surface from left to right. */
/* Number of cells of the water surface from back to front. A cell measures about 7 mm in the
 * festival tank. */
#define RIPPLE_Z 80u

enum scene_place {
    SCENE_IN_TANK = 0,
    SCENE_ON_POI = 1,
    SCENE_IN_BOWL = 2,
};

struct scene_fish {
    vec3 position_m; /* Centre of the fish's body box. */
    struct angles angles;
    float length_m;       /* Total length, snout to tail tip. */
    float age_days;       /* Days since hatching. Shape and colour are those of this age. */
    float tail_phase_rad; /* Phase of the body wave that travels along a swimming fish, [0, 2
                             pi). */
    float tail_amplitude; /* Tail-beat amplitude. 1 means a fifth of the fish's length, peak to
                             peak; 0 means that the tail is still. */
    float bend_rad;       /* Bend of the whole body during a turn; a positive angle bends the tail
                             to its right. */
    float gape;           /* Opening of the mouth, [0, 1]. The fish gulps air at the surface. */
    float gulp;           /* Progress of one gulp, from one opening of the mouth to the next, (0,
                             1]; 0 means that the fish does not gulp. */
    float progress;       /* Position in the fish's life, [0, 1], from the species' first key shape
                             to its last. */
    float maturity;       /* Colour maturity, [0, 1], from the species' first colour key to its
                             last. */
    uint32_t look;        /* Random bits that choose the individual's pattern and colours. */
    uint8_t place;        /* Place of the fish (enum scene_place). */
};

struct scene_poi {
    uint8_t present;
    uint8_t owner;   /* Player index; selects the ring's colour. */
    vec3 position_m; /* Position of the ring's centre. */
    struct angles angles;
    float ring_radius_m;  /* Inner radius of the ring, at the paper's edge. */
    float sag_m;          /* Depth of the sagging paper below the ring's plane; a negative value
                             means that the paper bulges upward. */
    float paper_left;     /* Share of the paper area that is left, [0, 1]. */
    float shade_dark;     /* Share of the light that the poi blocks from the water below, [0, 1]; 0
                             while the poi is in the water. */
    float water_m;        /* Mean depth of the water on the paper. */
    uint8_t shows_stress; /* 1 in practice mode, where the paper is coloured by `stress`; otherwise
                             0. */
    uint8_t wetness[SHEET_SIDE * SHEET_SIDE];   /* Wetness of each paper cell, from 0 (dry) to 255
                                                   (wet). Row 0 is at the far edge (-z). */
    uint8_t integrity[SHEET_SIDE * SHEET_SIDE]; /* Integrity of each paper cell, from 255 (whole) to
                                                   1 (nearly torn); 0 means a hole. */
    uint8_t stress[SHEET_SIDE * SHEET_SIDE];    /* Load of each paper cell divided by its
                                                   strength, including stress concentration. 255
                                                   means that the cell tears immediately; 0 means
                                                   no paper. */
};

struct scene_bowl {
    uint8_t present;
    uint8_t owner;
    vec3 position_m;      /* Centre of the bowl's mouth. The bowl floats, and a poi can push it. */
    struct angles angles; /* Orientation of the bowl, which tilts when it floats unevenly. */
    float radius_m;       /* Radius of the mouth. */
    float depth_m;
    float water_below_m; /* Distance from the bowl's mouth down to the water inside the bowl. */
    uint32_t fish_count;
};

/* Air stone of a tank that has a pump. */
struct scene_pump {
    uint8_t present;
    uint8_t runs;
    vec3 stone_m; /* Position of the air stone on the tank's floor. */
};

/* A fan held over the water, with its shadow. */
struct scene_fan {
    uint8_t present;
    uint8_t owner;  /* Player index; selects the fan's picture. */
    uint8_t unseen; /* 1 if only the shadow is shown, so that the water below the fan stays visible;
                       otherwise 0. */
    float x_m, z_m; /* Centre of the shadow on the water, vertically below the light. */
    float radius_m;
    float dark;    /* Share of the light that the fan blocks, [0, 1]. */
    float still_s; /* Seconds for which the fan has been held still. */
};

#endif
