/* specimen_pass.c -- draws specimens (single fish on a page), and manages the cache slots and the
 * textures of their species. */
#include "platform/render/pass/specimen_pass.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/os/clock.h"
#include "platform/render/fish_colours.h"
#include "platform/render/gl_util.h"
#include "shaders.h"

#define DEFINES "#define KEYS 8\n#define CURVES 4\n#define ANCHORS 2\n"
#define SAMPLERS "paints shines patterns"
/* Minimum fish length in pixels from which the near mesh is drawn. A shorter fish is drawn with the
 * far mesh. */
#define NEAR_PX 150.0f
/* Maximum distance, in body lengths, by which the swimming motion moves a vertex outside the extent
 * of the mesh at rest. */
#define SWAY_LENGTHS 0.3f
/* Maximum painting time per frame in ns while a visible texture is only coarsely painted. */
#define WORK_NS 10000000u
/* Maximum painting time per frame in ns while no visible texture is only coarsely painted. */
#define REST_NS 3000000u
#define CLEAR_MIN 0.02f /* Minimum transparency from which a fish's body is drawn as transparent. */

/* Finds the locations of all uniforms of a program. OpenGL ignores a write to a uniform that the
 * program does not have. */
static struct specimen_program find_uniforms(GLuint name)
{
    struct specimen_program program = { .name = name };
#define X(uniform) program.uniform = glGetUniformLocation(name, #uniform);
    SPECIMEN_UNIFORMS
#undef X
    return program;
}

void specimen_pass_open(struct gl_status *status, struct specimen_pass *pass,
                        const struct textures *textures)
{
    pass->patterns = textures->patterns;
    pass->body = find_uniforms(gl_program(status, "specimen", DEFINES, shader_specimen_vert,
                                          shader_specimen_frag, SAMPLERS));
    pass->fin = find_uniforms(gl_program(status, "specimen's fins", DEFINES "#define FIN\n",
                                         shader_specimen_vert, shader_specimen_frag, SAMPLERS));
    pass->shadow =
        find_uniforms(gl_program(status, "specimen's shadow", "", shader_specimen_shadow_vert,
                                 shader_specimen_shadow_frag, ""));
    pass->pose_buffer = gl_buffer(GL_UNIFORM_BUFFER, NULL, sizeof pass->texels);
    glGenVertexArrays(1, &pass->no_attributes);
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        struct specimen_slot *const slot = &pass->slots[i];
        fish_texture_open(status, &slot->skin);
        for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
            fish_mesh_reserve(&slot->mesh[lod]);
        }
    }
}

void specimen_pass_close(struct specimen_pass *pass)
{
    glDeleteProgram(pass->body.name);
    glDeleteProgram(pass->fin.name);
    glDeleteProgram(pass->shadow.name);
    glDeleteBuffers(1, &pass->pose_buffer);
    glDeleteVertexArrays(1, &pass->no_attributes);
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        struct specimen_slot *const slot = &pass->slots[i];
        fish_texture_close(&slot->skin);
        for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
            fish_mesh_close(&slot->mesh[lod]);
        }
        slot->species = NULL;
    }
}

static void specimen_pass_fill_slot(struct specimen_pass *pass, struct specimen_slot *slot,
                                    const struct specimen *specimen)
{
    const struct species *const species = specimen->species;
    slot->species = species;
    slot->edition = specimen->edition;
    morph_rig_init(&slot->rig, &species->card, TEMPLATE_OWN);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        fish_mesh_fill(&slot->mesh[lod], &pass->memory, &species->lod[lod],
                       species->card.key_count);
    }
    /* If a built-in species has identical paint, this species shares its texture. For example, the
     * growth lab's comparison fish is a copy of a species with other shapes and the same paint. */
    slot->worn = &slot->skin;
    for (uint32_t i = 0; i < SPECIES_BUILT_IN && slot->worn == &slot->skin; i++) {
        const struct species *const other = pass->slots[i].species;
        if (other && other != species && other->card.key_count == species->card.key_count &&
            other->card.form == species->card.form && other->card.motion == species->card.motion &&
            memcmp(other->coats, species->coats, sizeof species->coats) == 0) {
            slot->worn = &pass->slots[i].skin;
        }
    }
    if (slot->worn == &slot->skin) {
        fish_texture_bind(&slot->skin, species);
    }
}

/* Returns the cache slot with the data of the specimen's species. A built-in species has its own
 * slot. The data of a built-in species never change, so the function compares only the address. Any
 * other species is loaded into the least recently used of the remaining slots, unless one of these
 * slots already has the species. */
static struct specimen_slot *slot_of(struct specimen_pass *pass, const struct specimen *specimen)
{
    CORE_ASSERT(specimen->species);
    struct specimen_slot *slot = &pass->slots[SPECIES_BUILT_IN];
    bool is_home = false, is_loaded = false;
    for (uint32_t i = 0; i < species_table_count && i < SPECIES_BUILT_IN && !is_home; i++) {
        is_home = species_table[i] == specimen->species;
        slot = is_home ? &pass->slots[i] : slot;
    }
    for (uint32_t i = SPECIES_BUILT_IN; i < SPECIMEN_SLOTS && !is_home && !is_loaded; i++) {
        struct specimen_slot *const other = &pass->slots[i];
        is_loaded = other->species == specimen->species && other->edition == specimen->edition;
        slot = is_loaded || other->last_used < slot->last_used ? other : slot;
    }
    if (is_home ? slot->species != specimen->species : !is_loaded) {
        specimen_pass_fill_slot(pass, slot, specimen);
    }
    slot->last_used = ++pass->draw_count;
    return slot;
}

/* Returns the texture to paint next, or null if all textures are finished. A texture that is
 * visible and only coarsely painted comes before all other unfinished textures. Among textures of
 * the same priority, the one with the largest fish on the screen comes first. Sets `is_seen` to
 * true if the returned texture is visible and coarse. */
static struct fish_texture *unfinished(struct specimen_pass *pass, bool *is_seen)
{
    struct fish_texture *found = NULL;
    *is_seen = false;
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        struct specimen_slot *const slot = &pass->slots[i];
        struct fish_texture *const skin = &slot->skin;
        if (!slot->species || slot->worn != skin || fish_texture_is_done(skin)) {
            continue;
        }
        const bool seen = skin->shown_px > 0.0f && !fish_texture_is_fine(skin);
        if (!found || (seen && !*is_seen) ||
            (seen == *is_seen && skin->shown_px > found->shown_px)) {
            found = skin;
            *is_seen = seen;
        }
    }
    return found;
}

void specimen_pass_work(struct specimen_pass *pass, bool ahead)
{
    const struct hal_clock clock = clock_device();
    const uint64_t start_ns = clock.ops->now_ns(clock.self);
    bool is_seen;
    struct fish_texture *skin = unfinished(pass, &is_seen);
    for (uint32_t i = 0; !skin && ahead && i < species_table_count && i < SPECIES_BUILT_IN; i++) {
        if (!pass->slots[i].species) {
            /* Only one built-in species is loaded in a frame, because loading takes about a
             * millisecond. */
            specimen_pass_fill_slot(pass, &pass->slots[i],
                                    &(struct specimen){ .species = species_table[i] });
            break;
        }
    }
    while (skin && clock.ops->now_ns(clock.self) - start_ns < (is_seen ? WORK_NS : REST_NS)) {
        fish_texture_work(skin, &pass->brush, 1);
        skin = unfinished(pass, &is_seen);
    }
    for (uint32_t i = 0; i < SPECIMEN_SLOTS; i++) {
        pass->slots[i].skin.shown_px = 0.0f;
    }
}

void specimen_pass_finish(struct specimen_pass *pass, const struct specimen *specimen)
{
    fish_texture_work(slot_of(pass, specimen)->worn, &pass->brush,
                      FISH_TEXTURE_SHEETS * FISH_TEXTURE_BANDS);
}

/* Values of the shader uniforms that are identical in the programs for the body and for the
 * fins. */
struct uniforms {
    float sheets[3];
    float look[4];
    const struct display_transform *transform;
    struct fish_texture_lines lines[FISH_TEXTURE_LINES];
};

/* Makes `program` the current program, and sets its uniforms for the screen and for the specimen's
 * position and length. */
static void use_program(const struct specimen_program *program, const struct specimen *specimen,
                        const struct display_transform *transform)
{
    float turn[4], move[2];
    display_clip_matrix(transform, turn, move);
    glUseProgram(program->name);
    glUniform2f(program->screen_px, transform->width, transform->height);
    glUniformMatrix2fv(program->turn, 1, GL_FALSE, turn);
    glUniform2fv(program->move, 1, move);
    glUniform3f(program->place, specimen->x_px, specimen->y_px, specimen->length_px);
}

static void send_specimen_uniforms(const struct specimen_program *program,
                                   const struct specimen *specimen,
                                   const struct specimen_slot *slot, const struct uniforms *values)
{
    const struct species_card *const card = &slot->species->card;
    const struct specimen_axes axes = specimen_axes(specimen);
    const float rows[9] = { axes.right.x,  axes.up.x,    axes.toward.x, axes.right.y, axes.up.y,
                            axes.toward.y, axes.right.z, axes.up.z,     axes.toward.z };
    float tint[4];
    for (uint32_t i = 0; i < 4; i++) {
        tint[i] = (float)(specimen->tint >> (24u - 8u * i) & 255u) / 255.0f;
    }
    use_program(program, specimen, values->transform);
    glUniformMatrix3fv(program->axes, 1, GL_FALSE, rows);
    glUniform3f(program->swim, specimen->phase_rad, specimen->amplitude, (float)card->motion);
    glUniform4fv(program->look, 1, values->look);
    glUniform4fv(program->tint, 1, tint);
    glUniform4f(program->worn, textures_pattern(specimen->look), textures_hue(specimen->look),
                specimen->ripe, specimen->maturity);
    float red[3];
    fish_colours_red(red, textures_hue(specimen->look));
    glUniform3fv(program->worn_red, 1, red);
    glUniform3fv(program->sheets, 1, values->sheets);
    for (GLint i = 0; i < (GLint)FISH_TEXTURE_LINES && program->line_place >= 0; i++) {
        glUniform4fv(program->line_place + i, 1, values->lines[i].place);
        glUniform4fv(program->line_shape + i, 1, values->lines[i].shape);
        glUniform3fv(program->line_colour + i, 1, values->lines[i].colour);
    }
}

static void draw_part(const struct specimen_program *program, const struct fish_mesh *mesh,
                      bool fins)
{
    glUseProgram(program->name);
    glUniform1f(program->reach, mesh->reach);
    fish_mesh_draw(mesh, fins ? FISH_FINS : FISH_BODY, 1);
}

/* Draws the parts of the fins that are behind the body. These parts are drawn before the body, so
 * that the body's smooth outline blends with the fins, and the fins are visible through a
 * transparent body. */
static void draw_behind(const struct specimen_pass *pass, const struct fish_mesh *mesh, bool clear,
                        const float look[4])
{
    CORE_ASSERT(look[0] >= 0.0f && look[0] <= 1.0f);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_part(&pass->body, mesh, false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    glUseProgram(pass->fin.name);
    glUniform4f(pass->fin.look, look[0], look[1], look[2], clear ? 1.0f : 0.0f);
    draw_part(&pass->fin, mesh, true);
    glUniform4fv(pass->fin.look, 1, look);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
}

void specimen_pass_draw(struct specimen_pass *pass, const struct specimen *specimen,
                        const struct display_transform *transform)
{
    CORE_ASSERT(specimen->progress >= 0.0f && specimen->progress <= 1.0f);
    CORE_ASSERT(specimen->length_px > 0.0f);
    struct specimen_slot *const slot = slot_of(pass, specimen);
    const uint32_t lod = specimen->length_px < NEAR_PX ? 1 : 0;
    const struct species_mesh *const mesh = &slot->species->lod[lod];
    struct uniforms values = { .look = { 1.0f - specimen->fade, fish_texture_scales(slot->worn) },
                               .transform = transform };
    morph_pose(specimen->rig ? specimen->rig : &slot->rig, mesh, specimen->progress, &pass->pose);
    fish_texture_request(slot->worn, &pass->brush, pass->pose.weight[0], specimen->length_px,
                         values.sheets);
    fish_texture_lines(slot->worn, pass->pose.weight[0], values.lines);
    fish_poses_pack(pass->texels, &pass->pose, MORPH_CURVE_MAX, mesh->anchor_count);
    glBindBuffer(GL_UNIFORM_BUFFER, pass->pose_buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, pass->texels, sizeof pass->texels);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, pass->pose_buffer);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (specimen->shadow > 0.0f) {
        use_program(&pass->shadow, specimen, transform);
        glUniform3f(pass->shadow.look, specimen->shadow * (1.0f - specimen->fade),
                    f_abs(f_cos(specimen->yaw_rad)), 0.0f);
        glBindVertexArray(pass->no_attributes);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    values.look[2] = fish_texture_opacity(slot->worn, pass->pose.weight[0]);
    send_specimen_uniforms(&pass->body, specimen, slot, &values);
    send_specimen_uniforms(&pass->fin, specimen, slot, &values);
    /* The scissor rectangle limits the clearing of the depth buffer to the area around the
     * specimen. The depth of earlier specimens is not needed, because specimens on a screen do not
     * overlap. */
    const float reach = (mesh->reach + SWAY_LENGTHS) * specimen->length_px;
    const float x = transform->x + transform->xx * specimen->x_px + transform->xy * specimen->y_px;
    const float y = transform->y + transform->yx * specimen->x_px + transform->yy * specimen->y_px;
    glEnable(GL_SCISSOR_TEST);
    glScissor((GLint)(x - reach), (GLint)(transform->screen_height - y - reach),
              (GLsizei)(2.0f * reach), (GLsizei)(2.0f * reach));
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, slot->worn->paints);
    gl_bind_texture(1, GL_TEXTURE_2D_ARRAY, slot->worn->shines);
    gl_bind_texture(2, GL_TEXTURE_2D_ARRAY, pass->patterns);
    glBindVertexArray(slot->mesh[lod].vertex_array);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    draw_behind(pass, &slot->mesh[lod], values.look[2] > CLEAR_MIN, values.look);
    draw_part(&pass->body, &slot->mesh[lod], false);
    glDepthMask(GL_FALSE);
    draw_part(&pass->fin, &slot->mesh[lod], true);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(0);
}
