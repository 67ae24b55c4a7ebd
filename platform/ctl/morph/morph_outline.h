/* morph_outline.h -- draws a fish as an outline of one colour in an SVG picture. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_OUTLINE_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_OUTLINE_H

#include "core/morph/morph.h"
#include "platform/ctl/lib/svg.h"

/* Returns the colour of a key (growth stage) in SVG notation, for example "#d23a2c". The string is
 * static, and different keys have different strings. */
const char *morph_outline_key_colour(const struct species_card *card, uint32_t key);

/* Converts a name to readable words, for example "long_leaf" to "long leaf". */
void morph_outline_words(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

/* Converts a name to readable words with a capital first letter, for example "long_leaf" to "Long
 * leaf". */
void morph_outline_title(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

/* Colour of the curve of the fish's size, purple as in the 2005 thesis. */
#define MORPH_SCALE_COLOUR "#8e4bb8"

enum morph_outline_view {
    MORPH_OUTLINE_SIDE,  /* View from the fish's left side. The head points left. */
    MORPH_OUTLINE_FRONT, /* View of the fish's head from the front. The back is at the top. */
    MORPH_OUTLINE_TOP,   /* View from above the fish. The head points left. */
};

struct morph_outline {
    const struct species *species;
    const struct morph_rig *rig;
    float progress;
    enum morph_outline_view view;
    double x, y;      /* Position in the picture of the origin of the fish's body frame, in
                         pixels. */
    double length_px; /* Length of the fish's body in the picture, in pixels. */
    const char *colour;
    double opacity; /* Opacity of the body, in [0, 1]. Fins have half of this opacity. */
    double line_px; /* Width of the contour line in pixels. 0 means that no contour is drawn. */
};

/* Returns the best view for a fish of the species' body form, in which the largest area of the body
 * is visible. */
enum morph_outline_view morph_outline_view_of(const struct species_card *card);

/* Converts a point of the body frame to pixels of the picture. */
void morph_outline_project(const struct morph_outline *outline, vec3 p, double *x, double *y);

/* Extends the box from `low` to `high`, in pixels, so that the box contains the fish. */
void morph_outline_measure(const struct morph_outline *outline, double low[2], double high[2]);

/* Draws the outline of the fish into the picture. */
void morph_outline_draw(struct svg *svg, const struct morph_outline *outline);

#endif
