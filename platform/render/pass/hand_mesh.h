/* hand_mesh.h -- the mesh of a right hand that holds a poi, and of the sleeve of a yukata. Also the
 * picture of the skin, with the shadows between the fingers, the creases and the nails.
 *
 * The mesh has the axes of the handle. Its unit is the inner radius of the ring. The handle extends
 * along z. */
#pragma once

#include "platform/render/shape.h"

/* Position of the wrist, and start and end of the sleeve along the forearm. */
#define HAND_WRIST_X 0.22f
#define HAND_WRIST_Y 0.14f
#define HAND_WRIST_Z 5.0f
#define HAND_CUFF_Z 5.3f
#define HAND_SLEEVE_END_Z 12.3f

/* Capacity for the vertices of a hand. */
#define HAND_VERTEX_MAX 384u

/* Side in texels of the picture of the skin. */
#define HAND_SKIN_SIDE 128u
/* Surface coordinate `v` of the vertices of the hem, which has no pattern. */
#define HAND_HEM 9.0f

/* Builds the mesh of the hand and of the sleeve in `shape`, which must be empty. On skin, the
 * surface coordinates (u, v) are the place in the picture of the skin, where v is lower by 1 and
 * thus negative. On the sleeve, u is the fraction of the light from all sides that arrives, and v
 * is the distance around the sleeve or HAND_HEM. Writes to `axes` the direction of the bone at each
 * vertex of the thumb and of the index finger, and 0 at the other vertices. The normals of these
 * two fingers are the directions from the bone. */
void hand_mesh(struct shape *shape, vec3 axes[HAND_VERTEX_MAX]);
/* Draws the picture of the skin. */
void hand_skin(uint8_t texels[HAND_SKIN_SIDE * HAND_SKIN_SIDE][3]);
