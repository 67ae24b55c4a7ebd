/* fish_poses.c -- implementation of fish_poses.h. */
#include "platform/render/fish_poses.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

uint32_t fish_poses_pack(float out[][4], const struct morph_pose *pose, uint32_t curve_count,
                         uint32_t anchor_count)
{
    CORE_ASSERT(curve_count <= MORPH_CURVE_MAX);
    CORE_ASSERT(anchor_count <= ANCHOR_MAX);
    uint32_t at = 0;
    for (uint32_t i = 0; i < curve_count; i++, at += 2) {
        memcpy(out[at], pose->weight[i], 2 * sizeof *out);
    }
    for (uint32_t i = 0; i < anchor_count; i++, at += 2) {
        const struct anchor_pose *const anchor = &pose->anchor[i];
        const float texels[2][4] = {
            { anchor->position.x, anchor->position.y, anchor->position.z, 0.0f },
            { anchor->turn.x, anchor->turn.y, anchor->turn.z, anchor->turn.w },
        };
        memcpy(out[at], texels, sizeof texels);
    }
    return at;
}

/* Returns the value of the macro ANCHORS for morph.glsl. 0 means that no vertex has an anchor. 1
 * means that the anchors keep the orientation of the body's axes. 2 means that at least one anchor
 * rotates. */
static uint32_t riding(const struct species_mesh *mesh, bool fins)
{
    uint32_t most = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *const vertex = &mesh->vertices[i];
        if (vertex->anchor != ANCHOR_NONE && (!fins || vertex->part >= PART_TAIL)) {
            const uint32_t rides = mesh->anchors[vertex->anchor].turns ? 2u : 1u;
            most = rides > most ? rides : most;
        }
    }
    return most;
}

void fish_poses_defines(char *out, size_t size, const struct species *species, bool fins)
{
    const uint32_t near = riding(&species->lod[0], fins), far = riding(&species->lod[1], fins);
    snprintf(out, size,
             "#define POSE_ROWS\n#define KEYS %u\n#define CURVES %u\n#define ANCHORS %u\n",
             species->card.key_count, species->card.curve_count, near > far ? near : far);
}

_Static_assert(SCENE_FISH_MAX <= GL_TEXTURE_SURE && POSE_TEXELS_MAX <= GL_TEXTURE_SURE,
               "a row for each fish, on every driver");

void fish_poses_open(struct gl_status *status, struct fish_poses *poses,
                     const struct species *species, uint32_t lod)
{
    poses->mesh = &species->lod[lod];
    poses->curve_count = species->card.curve_count;
    poses->width = 2u * poses->curve_count + 2u * poses->mesh->anchor_count;
    for (uint32_t i = 0; i < SCENE_FISH_MAX; i++) {
        poses->progress[i] = -1.0f;
    }
    poses->texture = gl_texture(status, "poses",
                                &(struct gl_texture_desc){ .internal_format = GL_RGBA32F,
                                                           .width = poses->width,
                                                           .height = SCENE_FISH_MAX,
                                                           .nearest = true });
}

void fish_poses_close(struct fish_poses *poses)
{
    glDeleteTextures(1, &poses->texture);
}

static void send_run(struct fish_poses *poses)
{
    if (poses->run_count > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, (GLint)poses->run_first, (GLsizei)poses->width,
                        (GLsizei)poses->run_count, GL_RGBA, GL_FLOAT, poses->run);
        poses->run_count = 0;
    }
}

void fish_poses_begin(struct fish_poses *poses)
{
    poses->run_count = poses->posed_count = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_bind_texture(0, GL_TEXTURE_2D, poses->texture);
}

void fish_poses_set(struct fish_poses *poses, const struct morph_rig *rig, uint32_t row,
                    float progress)
{
    CORE_ASSERT(row < SCENE_FISH_MAX);
    if (poses->progress[row] == progress) {
        return;
    }
    if (poses->run_count == POSE_RUN || row != poses->run_first + poses->run_count) {
        send_run(poses);
    }
    if (poses->run_count == 0) {
        poses->run_first = row;
    }
    morph_pose(rig, poses->mesh, progress, &poses->pose);
    fish_poses_pack(poses->run + poses->run_count * poses->width, &poses->pose, poses->curve_count,
                    poses->mesh->anchor_count);
    poses->progress[row] = progress;
    poses->run_count++;
    poses->posed_count++;
}

void fish_poses_end(struct fish_poses *poses)
{
    send_run(poses);
}
