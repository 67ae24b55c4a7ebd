/* morph_path.h -- the path of one point of a fish's part during the growth of the fish, as a table
 * and as a picture. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_PATH_H

#include "platform/ctl/morph/morph_options.h"
#include "platform/species/part.h"

/* Straight line from the first position of the part to its last position, in body coordinates. */
struct chord {
    vec3 from, to;
};

struct morph_path_plan {
    struct morph_options pick;
    const char *part, *side, *svg, *view;
    uint32_t vertex, steps;
    const struct species *ordinary;
    struct morph_rig ordinary_rig;
    struct chord chord, ordinary_chord;
};

/* Draws the path into the SVG file `plan->svg`. Returns EXIT_OK, or prints one line to standard
 * error and returns another exit code. */
enum exit_code morph_path_picture(const struct morph_path_plan *plan, const char *command);

#endif
