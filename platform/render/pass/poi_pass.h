/* poi_pass.h -- draws the scoops: ring, handle, and paper with the wet cells and holes of the
 * simulated sheet. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_POI_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_POI_PASS_H

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/shape.h"
#include "platform/render/textures.h"

struct poi_pass {
    GLuint frame_program, paper_program;
    GLint frame_pose, frame_paint, paper_pose, paper_paper, paper_rests, paper_spines, paper_pool;
    struct shape_buffers solid, disc;
    struct gl_ring sheet_ring;                 /* Texture arrays with one layer a player. */
    uint8_t cells[SHEET_SIDE * SHEET_SIDE][4]; /* Wetness, integrity, presence, stress. */
};

/* Returns the player's colour (red, green, blue), and as fourth value the number of white marks
 * that distinguish the players without colour. `owner` < POI_MAX. */
const float *poi_paint(uint8_t owner);

void poi_pass_open(struct gl_status *status, struct poi_pass *pass);
void poi_pass_close(struct poi_pass *pass);

/* Uploads the sheets. */
void poi_pass_prepare(struct poi_pass *pass, const struct scene *scene);

/* Return whether any part of the poi may be below (above) the surface. */
bool poi_is_below(const struct scene_poi *poi);
bool poi_is_above(const struct scene_poi *poi);

/* Draws ring and handle. poi_pass_frame() and poi_pass_paper() need a target with depth; papers
 * blend. */
void poi_pass_frame(const struct poi_pass *pass, const struct scene_poi *poi);
/* Draws the paper of poi `index` of the scene, darker where fish lie on it. */
void poi_pass_paper(const struct poi_pass *pass, const struct scene *scene, uint32_t index,
                    const struct textures *textures);

#endif
