/* shot_options.h -- options of the command line of `make shot`. */
#ifndef KINGYO_TESTS_RENDER_SHOT_OPTIONS_H
#define KINGYO_TESTS_RENDER_SHOT_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"

struct shot_options {
    float seconds, scale;
    /* Number of pictures and the seconds between two of them. With more than one, `out` is
     * followed by the number of the picture, from 0, and by ".png". */
    uint8_t frames;
    float every_s;
    /* Stamina of the fish and oxygen content of the water. A negative value means that the preset's
     * value is used. */
    float stamina, oxygen_mg_l;
    uint8_t plain, day, white;
    /* Point of the water surface at which the camera looks, and distance of the camera from this
     * point. If the distance is 0, the normal camera is used. */
    float close_x_m, close_z_m, close_m;
    /* Place of the camera after the first frame. `closer`: where it is in a round with one player.
     * `drift`: as far away as in attract mode. The camera then moves from frame to frame. With
     * `live`, the picture of the rim and the counter is drawn again in each frame. */
    uint8_t closer, drift, live;
    uint32_t width, height, samples, fish, seed;
    uint8_t start, english, passes, paper, preset;
    /* With `steps`, shot writes the name of each render step on standard error after the step.
     * `quality_step` is the argument `step` of quality_lower(). */
    uint8_t steps, quality_step;
    /* Details of --paper. If `stress` is 1, the paper is coloured by its stress, as in practice
     * mode. `owner` is the index of the player who owns the poi. */
    uint8_t stress, owner;
    /* Depth of the water on the paper, tilt angle of the poi, and heel angle of the bowls. */
    float water_m, tilt_rad, heel_rad;
    uint8_t careless;
    /* Distance of a camera that follows the first poi. If it is 0, the normal camera is used. */
    float follow_m;
    /* Number of players, selected game mode, and bit set of the enabled game modes. */
    uint8_t players, mode, modes;
    /* Options of the growth lab, where `lab` opens it. */
    uint8_t lab, compare, path, size_layer;
    /* Number of fish in the album of caught fish; 0 means that the album is closed. */
    uint8_t album;
    /* Page of the operator's menu; null means that the menu is closed. */
    const char *menu;
    /* Step of the menu page (see shot_menu_open()), and price of a round in coins. */
    uint8_t step, coins;
    uint8_t rotation; /* Rotation of the picture on the screen (struct display_settings). */
    /* Size, brightness and offset of the picture on the screen, as in struct display_settings. */
    float inset, light, shift;
    uint32_t species;
    /* Growth progress (0 .. 1) of the species in the growth lab. 0 is its first key shape, 1 the
     * last. */
    float progress;
    /* Position of a fan over the water. The command line option has the form X_CM,Z_CM. */
    struct shade_input fan;
    const char *out;
};

/* Parses the command line. Ends the program with exit status 2 if a name is unknown. Ignores
 * unknown options. */
struct shot_options shot_options_parse(int argc, char **argv);

/* Returns 1 if the picture is upright (portrait format) on its screen. */
bool shot_is_upright(const struct shot_options *options);

#endif
