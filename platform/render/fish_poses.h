/* fish_poses.h -- stores the poses of many fish of one mesh in a texture for morph.glsl, with one
 * texture row for each fish.
 *
 * A row is uploaded again only if the fish has grown. Otherwise the row costs one comparison in
 * each frame. */
#ifndef KINGYO_PLATFORM_RENDER_FISH_POSES_H
#define KINGYO_PLATFORM_RENDER_FISH_POSES_H

#include "core/morph/morph.h"
#include "core/scene.h"
#include "platform/render/gl_util.h"

/* Maximum number of texels of one pose. A texel holds four floats. */
#define POSE_TEXELS_MAX (2u * MORPH_CURVE_MAX + 2u * ANCHOR_MAX)
/* Maximum number of consecutive texture rows (poses) that are uploaded in one call. */
#define POSE_RUN 16u

/* Writes a pose to `out` in the texel layout that morph.glsl reads: two texels for each curve, then
 * two texels for each anchor. Returns the number of texels. `curve_count` is the number of
 * deformation curves (CURVES in the shader), and `anchor_count` is the number of anchors of the
 * mesh. */
uint32_t fish_poses_pack(float out[][4], const struct morph_pose *pose, uint32_t curve_count,
                         uint32_t anchor_count);

/* Writes the #define lines of a shader program that draws only this species, such as "#define KEYS
 * 5". If `fins` is true, the lines are for a program that draws only the fins. */
void fish_poses_defines(char *out, size_t size, const struct species *species, bool fins);

struct fish_poses {
    const struct species_mesh *mesh;
    GLuint texture;
    uint32_t curve_count, width;    /* Number of curves in a pose, and number of texels in a texture
                                       row. */
    float progress[SCENE_FISH_MAX]; /* Progress through life that each texture row shows, [0, 1].
                                       A negative value means that the row has not been written
                                       yet. */
    uint32_t run_first, run_count;  /* First row and number of rows in `run` that have not been
                                       uploaded yet. */
    float run[POSE_RUN * POSE_TEXELS_MAX][4];
    struct morph_pose pose;
    uint32_t posed_count; /* Number of rows written since the last fish_poses_begin(), for
                             measurements. */
};

void fish_poses_open(struct gl_status *status, struct fish_poses *poses,
                     const struct species *species, uint32_t lod);
void fish_poses_close(struct fish_poses *poses);

/* Starts an update of the poses. Call fish_poses_set() for each fish, then fish_poses_end(). */
void fish_poses_begin(struct fish_poses *poses);
/* Writes the pose of a fish with the curves of `rig` at `progress` [0, 1] to the texture row `row`.
 * Fastest if the rows are written in ascending order. */
void fish_poses_set(struct fish_poses *poses, const struct morph_rig *rig, uint32_t row,
                    float progress);
/* Uploads the rows that are not uploaded yet. */
void fish_poses_end(struct fish_poses *poses);

#endif
