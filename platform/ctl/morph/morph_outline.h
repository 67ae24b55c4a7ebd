/* morph_outline.h -- draws a fish as a flat outline in an SVG picture, in one colour. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_OUTLINE_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_OUTLINE_H

#include "core/morph/morph.h"
#include "platform/ctl/lib/svg.h"

/* Returns key_colour() in SVG notation, for example "#d23a2c". The string is static, and each key
 * has its own string. */
const char *morph_outline_key_colour(const struct species_card *card, uint32_t key);

/* Converts a name to readable words, for example "long leaf". */
void morph_outline_words(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

/* Converts a name to readable words with a capital first letter, for example "Long leaf". */
void morph_outline_title(char out[SPECIES_NAME_SIZE], const char name[SPECIES_NAME_SIZE]);

/* Colour of the size curve. The size is purple as in the 2005 thesis. */
#define MORPH_SCALE_COLOUR "#8e4bb8"

enum morph_outline_view {
    MORPH_OUTLINE_SIDE,  /* View from the fish's left side. The head points left. */
    MORPH_OUTLINE_FRONT, /* View from ahead of the fish. The back is up. */
    MORPH_OUTLINE_TOP,   /* View from above the fish. The head points left. */
};

struct morph_outline {
    const struct species *species;
    const struct morph_rig *rig;
    float progress;
    enum morph_outline_view view;
    double x, y;      /* Position of the body frame's origin, in pixels. */
    double length_px; /* Pixels for one body length. */
    const char *colour;
    double opacity; /* Opacity of the body. Fins have half of this value. */
    double line_px; /* Width of the contour line in pixels. A value of 0 draws no contour. */
};

/* Returns the view that shows most of a body of the species' form. */
enum morph_outline_view morph_outline_view_of(const struct species_card *card);

/* Converts a point of the body frame to pixels of the picture. */
void morph_outline_project(const struct morph_outline *outline, vec3 p, double *x, double *y);

/* Extends the box `low` .. `high`, in pixels, so that the box also contains the fish. */
void morph_outline_measure(const struct morph_outline *outline, double low[2], double high[2]);

/* Draws the outline into the picture. */
void morph_outline_draw(struct svg *svg, const struct morph_outline *outline);

#endif
