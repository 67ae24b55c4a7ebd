/* part.h -- names of body parts. Functions find the vertex that represents a body part, and
 * compute the position of this vertex at any time of the fish's life. The functions have no side
 * effects. */
#pragma once

#include "core/morph/morph.h"
#include "platform/species/drawing.h"

/* Names of the values of enum species_measure, enum species_motion and enum body_form, as in a
 * species text. */
extern const char *const species_measure_names[MEASURE_DISC + 2];
extern const char *const species_motion_names[MOTION_WING + 2];
extern const char *const species_form_names[FORM_PUFFER + 2];

/* Names of the body parts in a species text, in the order of enum species_part, then PART_HEAD,
 * PART_TRUNK. */
extern const char *const part_names[OWNED_COUNT];

/* Returns the enum species_part of a body part's name in a species text, such as "dorsal2". Returns
 * PART_COUNT if the name is unknown. */
enum species_part part_of_vertex(const char *name);

/* Returns the index of the vertex that represents the body part. The vertex's position over the
 * fish's life is used as the position of the part. For a fin, the vertex is the root of the first
 * ray. For an eye, the vertex is the pupil's centre. For the tail, the vertex is the tip of the
 * upper lobe. For the body, the vertex is on the back, where the body is deepest. If the part is
 * one of a pair, the vertex is on `side`. Returns vertex_count if the fish lacks the part. */
uint32_t part_vertex_range(const struct species_mesh *mesh, enum species_part part,
                           enum species_side side);

/* Returns the position of a vertex at `progress` through life [0, 1]. The unit is the fish's length
 * as the species' length measure (enum species_measure) defines it. */
vec3 part_of_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                   float progress);
