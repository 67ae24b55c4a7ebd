/* fish_poses.h -- the poses of many fish of one mesh, one texture row each, for morph.glsl.
 *
 * A fish that has not grown since its row was written costs one comparison. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_POSES_H
#define KINGYO_PLATFORM_RENDER_FISH_POSES_H

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/gl_util.h"

/* Texels of one pose, of four floats each. */
#define POSE_TEXELS_MAX (2u * MORPH_CURVE_MAX + 2u * ANCHOR_MAX)
#define POSE_RUN 16u /* Number of rows that are uploaded together. */

/* Writes a pose as morph.glsl reads it: two texels a curve, then two an anchor. Returns the number
 * of texels. `curve_count` is the shader's CURVES; the anchors are the mesh's. */
uint32_t fish_poses_pack(float out[][4], const struct morph_pose *pose, uint32_t curve_count,
                         uint32_t anchor_count);

/* Writes "#define KEYS 5" and the other definitions for a program that draws only this species, or
 * only its `fins`. */
void fish_poses_defines(char *out, size_t size, const struct species *species, bool fins);

struct fish_poses {
    const struct species_mesh *mesh;
    GLuint texture;
    uint32_t curve_count, width;    /* Texels of a row. */
    float progress[SCENE_FISH_MAX]; /* Progress that each row shows; < 0: the row is not written
                                       yet. */
    uint32_t run_first, run_count;  /* Rows in `run` that are not uploaded yet. */
    float run[POSE_RUN * POSE_TEXELS_MAX][4];
    struct morph_pose pose;
    uint32_t posed_count; /* Rows written since begin(), for measurements. */
};

void fish_poses_open(struct gl_status *status, struct fish_poses *poses,
                     const struct species *species, uint32_t lod);
void fish_poses_close(struct fish_poses *poses);

/* Between fish_poses_begin() and fish_poses_end(), fish_poses_set() makes `row` show `progress` by
 * `rig`. Ascending rows are the fastest order. */
void fish_poses_begin(struct fish_poses *poses);
void fish_poses_set(struct fish_poses *poses, const struct morph_rig *rig, uint32_t row,
                    float progress);
void fish_poses_end(struct fish_poses *poses);

#endif
