/* loft_parts.h -- functions that the lofting (building a mesh from cross sections) of the body, the
 * fins and the eyes share. Only the files loft*.c may include this header. */
#ifndef KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H
#define KINGYO_PLATFORM_SPECIES_LOFT_PARTS_H

#include "platform/species/shape.h"

/* State while the meshes of one species are built. Each added vertex increases `loft->vertex_count`
 * and gets a position in every key. */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    double unit[MORPH_KEY_MAX]; /* Length of the fish in each key, in the units of the key's
                                   drawing. The species' length measure (enum species_measure)
                                   defines the length. */
};

/* Adds a vertex and returns its index. This vertex is the newest vertex until the next call.
 * loft_paint_masks() computes the masks of all vertices later. */
uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex);

/* Sets the newest vertex's position in one key to point `p` of the drawing. */
void loft_place(struct lofting *l, uint32_t key, v3d p, v3d normal);
/* Sets the newest vertex's position in one key to `offset` from its anchor, in the units of the
 * drawing. */
void loft_place_from_anchor(struct lofting *l, uint32_t key, v3d offset, v3d normal);

/* Adds a triangle of the vertices `a`, `b` and `c`. */
void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c);

/* Adds an anchor and returns the anchor. All body coordinates of the anchor are equal in every key
 * until the caller changes them. */
struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, uint8_t turns);

/* Writes the body coordinate u of each of `count` rings. The last ring is at u = 1. Rings are
 * closer to each other where an outline bends in any key. */
void loft_place_rings(const struct species_text *species, uint32_t count, double *u);

/* Returns the index of the deformation curve that moves `part`. 0 is the curve of the whole
 * fish. */
uint8_t loft_curve_of(const struct species_text *species, uint32_t part);
/* Computes the masks of every vertex. A mask is the weight with which a deformation curve moves the
 * vertex. */
void loft_paint_masks(struct lofting *l);

void loft_add_eyes(struct lofting *l);
void loft_add_fins(struct lofting *l);

#endif
