/* pose.c -- where the anchors of a blended fish are. */
#include "core/morph/morph.h"

void morph_pose(const struct morph_rig *rig, const struct species_mesh *mesh, float progress,
                struct morph_pose *pose)
{
    morph_weights(rig, progress, pose->weight);
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        pose->anchor[i] = (struct anchor_pose){ .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    }
}
