/* loft_parts.h -- functions that the lofting of body, fins and eyes shares. Only the files loft*.c
 * may include this header. */
#ifndef KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H
#define KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H

#include "platform/species/shape.h"

/* State of the lofting of one species. `loft->vertex_count` rises while the arrays of all keys are
 * filled. */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    double unit[MORPH_KEY_MAX]; /* Measure of each key, in the units of its drawing. */
};

/* Adds a vertex, which becomes the newest vertex, and returns its index. loft_paint_masks()
 * computes the masks of all vertices later. */
uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex);

/* Sets the newest vertex's position in one key, as a point of the drawing. */
void loft_place(struct lofting *l, uint32_t key, v3d p, v3d normal);
/* Sets the newest vertex's position in one key, as an offset from its anchor. */
void loft_place_from_anchor(struct lofting *l, uint32_t key, v3d offset, v3d normal);

/* Adds a triangle of the vertices `a`, `b` and `c`. */
void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c);

/* Adds an anchor and returns it. The anchor has the same body coordinates in every key until the
 * caller changes them. */
struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, uint8_t turns);

/* Writes the body coordinate u of `count` rings. The last ring is at 1. Rings are denser where an
 * outline bends in any key. Implemented in loft_rings.c. */
void loft_place_rings(const struct species_text *species, uint32_t count, double *u);

/* Returns the index of the curve that moves `part`. 0 is the curve of the whole fish. Implemented
 * in loft_mask.c. */
uint8_t loft_curve_of(const struct species_text *species, uint32_t part);
/* Computes the masks of every vertex. */
void loft_paint_masks(struct lofting *l);

void loft_add_eyes(struct lofting *l);
void loft_add_fins(struct lofting *l);

#endif
