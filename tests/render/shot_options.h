/* shot_options.h -- what the command line of `make shot` asks for. */
#ifndef KINGYO_TESTS_RENDER_SHOT_OPTIONS_H
#define KINGYO_TESTS_RENDER_SHOT_OPTIONS_H

#include <stdint.h>

#include "core/input.h"

struct shot_options {
    float seconds, scale;
    float stamina, oxygen_mg_l;  /* < 0: the preset's own. */
    uint8_t plain;
    float close_x_m, close_z_m, close_m; /* A camera so near to a point of the surface; 0: none. */
    uint32_t width, height, samples, fish, seed;
    uint8_t start, english, passes, paper, preset;
    uint8_t stress, owner;       /* Of --paper: coloured as in practice; whose it is, ... */
    float water_m, tilt_rad, heel_rad; /* ... what lies on it, how it lies; and how bowls lie. */
    uint8_t careless;
    float follow_m;              /* A camera so near to the first poi; 0: none. */
    uint8_t players, mode, modes; /* Who plays, what is pointed at, and what is offered. */
    uint8_t lab, compare, path, size_layer; /* The growth lab, and what is shown there: ... */
    uint8_t album;                          /* (or so many fish in the album) */
    const char *menu;                       /* (or a page of the operator's menu, at a step) */
    uint8_t step, coins;                    /* What a round costs. */
    uint8_t rotation;                       /* How the picture lies on the screen, ... */
    float inset, light, shift;              /* ... as struct showing has it. */
    uint32_t species;
    float progress;                         /* ... this species, so far in its life. */
    struct shade_input fan; /* X_CM,Z_CM on the command line. */
    const char *out;
};

/* Ends the program with 2 where a name is none. What it does not know it passes over. */
struct shot_options shot_options_parse(int argc, char **argv);

/* Whether the picture stands, as it lies on its screen. */
uint8_t shot_is_upright(const struct shot_options *options);

#endif
