/* shot_options.h -- options of the command line of `make shot`. */
#ifndef KINGYO_TESTS_RENDER_SHOT_OPTIONS_H
#define KINGYO_TESTS_RENDER_SHOT_OPTIONS_H

#include <stdint.h>

#include "core/input.h"

struct shot_options {
    float seconds, scale;
    float stamina, oxygen_mg_l; /* Stamina and oxygen of the water. A negative value selects the
                                   preset's value. */
    uint8_t plain;
    float close_x_m, close_z_m, close_m; /* Point of the surface at which a close camera looks, and
                                            the distance of the camera from it; 0 means no close
                                            camera. */
    uint32_t width, height, samples, fish, seed;
    uint8_t start, english, passes, paper, preset;
    uint8_t stress, owner; /* Options of --paper: `stress` colors the stress as in practice mode,
                              and `owner` is the player who owns the poi. */
    float water_m, tilt_rad, heel_rad; /* Water on the paper, tilt of the poi, and tilt of the
                                          bowls. */
    uint8_t careless;
    float follow_m;               /* Distance of a camera that follows the first poi; 0 means
                                     none. */
    uint8_t players, mode, modes; /* Number of players, mode under the pointer, and enabled
                                     modes. */
    uint8_t lab, compare, path, size_layer; /* The growth lab and its options. */
    uint8_t album;                          /* Number of fish in the album; 0 means that the album
                                               is closed. */
    const char *menu;                       /* Page of the operator's menu; null means that the menu
                                               is closed. */
    uint8_t step, coins;                    /* `step` is the step of the menu page. `coins` is the
                                               price of a round. */
    uint8_t rotation;                       /* Rotation of the picture on the screen. */
    float inset, light, shift; /* Geometry of the picture, as in struct display_settings. */
    uint32_t species;
    /* Progress [0, 1] of the species that the growth lab shows, from its first key shape to its
     * last. */
    float progress;
    struct shade_input fan; /* Place of a fan. The command line gives X_CM,Z_CM. */
    const char *out;
};

/* Parses the command line. Ends the program with exit status 2 if a name is unknown. Ignores
 * unknown options. */
struct shot_options shot_options_parse(int argc, char **argv);

/* Returns 1 if the picture is in portrait format on its screen. */
uint8_t shot_is_upright(const struct shot_options *options);

#endif
