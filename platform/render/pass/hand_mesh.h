/* hand_mesh.h -- the mesh of a right hand that holds a poi, and of the sleeve of a yukata.
 *
 * The mesh has the axes of the handle. Its unit is the inner radius of the ring. The handle extends
 * along z. */
#pragma once

#include "platform/render/shape.h"

/* Position of the wrist, and start and end of the sleeve along the forearm. */
#define HAND_WRIST_X 0.22f
#define HAND_WRIST_Y 0.14f
#define HAND_WRIST_Z 5.0f
#define HAND_CUFF_Z 6.3f
#define HAND_SLEEVE_END_Z 12.3f

/* Appends the mesh of the hand and of the sleeve to `shape`. Takes 5 ms on a desktop. */
void hand_mesh(struct shape *shape);
