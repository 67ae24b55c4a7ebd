/* loft_parts.h -- functions that the lofting (building a mesh from cross sections) of the body, the
 * fins and the eyes share. Only the files loft*.c may include this header. */
#pragma once

#include "platform/species/shape.h"

/* State of building the meshes of one species. Each added vertex increases `loft->vertex_count` and
 * gets a position in every key (modelled growth stage). */
struct lofting {
    const struct species_text *species;
    const struct detail *detail;
    struct loft *loft;
    /* Length of the fish in each key, in the units of the key's drawing. The species' length
     * measure (enum species_measure) defines the length. */
    double unit[MORPH_KEY_MAX];
};

/* Adds a vertex and returns its index. This vertex is the newest vertex until the next call. The
 * vertex's mask (the weights of the deformation curves) is computed after all parts were added. */
uint16_t loft_next_vertex(struct lofting *l, struct species_vertex vertex);

/* Position of the snout in the mesh, where the origin of the drawing lies. */
extern const v3d loft_snout;
/* Sets the newest vertex's position in the key number `key`. For a vertex without an anchor,
 * `origin` is loft_snout, and `offset` is a point of the drawing. For a vertex with an anchor,
 * `origin` is 0, and `offset` is the vertex's distance from its anchor. The units of `offset` are
 * those of the drawing. */
void loft_place(struct lofting *l, uint32_t key, v3d origin, v3d offset, v3d normal);

/* Adds a triangle of the vertices `a`, `b` and `c`. */
void loft_triangle(struct lofting *l, uint32_t a, uint32_t b, uint32_t c);

/* Adds an anchor (a point of the skin to which the vertices of a fin or an eye are attached) and
 * returns it. The anchor's body coordinates are 0 in every key until the caller sets them. `turns`
 * is true if the attached vertices rotate with the skin. */
struct species_anchor *loft_next_anchor(struct lofting *l, enum species_part part, bool turns);

/* Adds the ball of an eye. `side` is 0 for the right eye, 1 for the left eye. */
void loft_add_eye(struct lofting *l, uint32_t side);
void loft_add_fins(struct lofting *l);
