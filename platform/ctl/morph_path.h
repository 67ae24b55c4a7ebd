/* morph_path.h -- a part's way through the life of its fish, as a table and as a picture. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_PATH_H
#define KINGYO_PLATFORM_CTL_MORPH_PATH_H

#include "platform/ctl/morph_part.h"
#include "platform/ctl/morph_pick.h"

struct path_plan {
    struct morph_pick pick;
    const char *part, *side, *svg, *view;
    uint32_t vertex, steps;
    const struct species *ordinary;
    struct morph_rig ordinary_rig;
    vec3 from, to; /* The chord: its first place, its last. */
};

/* How far `p` is from the chord's line, or from its point where it has no length. */
float path_from_chord(const struct path_plan *plan, vec3 p);

/* Draws it into the file plan->svg. EXIT_OK, or another code, told. */
enum exit_code path_picture(const struct path_plan *plan, const char *command);

#endif
