/* morph_outline.h -- draws a fish as an outline of one colour in an SVG picture, and draws the path
 * of one point of a part during the growth of the fish. */
#pragma once

#include "platform/ctl/lib/svg.h"
#include "platform/ctl/morph/morph_options.h"

/* Returns the colour of a key (growth stage) in SVG notation, for example "#d23a2c". The string is
 * static, and different keys have different strings. */
const char *morph_outline_key_colour(const struct species_card *card, uint32_t key);

/* Colour of the curve of the fish's size, purple as in the 2005 thesis. */
#define MORPH_SCALE_COLOUR "#8e4bb8"

enum morph_outline_view {
    MORPH_OUTLINE_SIDE,  /* View from the fish's left side. The head points left. */
    MORPH_OUTLINE_FRONT, /* View of the fish's head from the front. The back is at the top. */
    MORPH_OUTLINE_TOP,   /* View from above the fish. The head points left. */
    MORPH_OUTLINE_COUNT,
};

struct morph_outline {
    const struct species *species;
    const struct morph_rig *rig;
    float progress;
    enum morph_outline_view view;
    /* Position, in pixels, at which the origin of the fish's body frame lies in the picture. */
    double x, y;
    double length_px; /* Length of the fish's body in the picture, in pixels. */
    const char *colour;
    double opacity; /* Opacity of the body, in [0, 1]. Fins have half of this opacity. */
    double line_px; /* Width of the contour line in pixels. 0 means that no contour is drawn. */
};

/* A point of the picture, in pixels. */
struct outline_point {
    double x, y;
};

/* Converts a point of the body frame to a point of the picture. */
struct outline_point morph_outline_project(const struct morph_outline *outline, vec3 p);

/* Adds a point of the body frame to the polyline that svg_begin_line() has begun. */
void morph_outline_point(struct svg *svg, const struct morph_outline *outline, vec3 p);

/* Extends the box from `low` to `high`, in pixels, so that the box contains the fish. */
void morph_outline_measure(const struct morph_outline *outline, double low[2], double high[2]);

/* Draws the outline of the fish into the picture. */
void morph_outline_draw(struct svg *svg, const struct morph_outline *outline);

/* ---- Path of a part (morph_table.c, morph_path_picture.c) ------------------------------------ */

/* Straight line from the first position of the part to its last position, in body coordinates. */
struct chord {
    vec3 from, to;
};

struct morph_path_plan {
    struct morph_options pick;
    const char *part, *svg;
    /* Side of the fish on which the part lies: the index of the word "right" or "left". */
    uint8_t side;
    uint8_t view; /* View of the picture, or MORPH_OUTLINE_COUNT if --view is absent. */
    uint32_t vertex, steps;
    struct chord chord;
};

/* Draws the path into the SVG file `plan->svg`. Returns EXIT_OK, or prints one line to standard
 * error and returns another exit code. */
enum exit_code morph_path_picture(const struct morph_path_plan *plan, const char *command);
