/* ui.c -- draws the batch of quads from one vertex buffer. Consecutive quads of the same kind are
 * drawn by one draw call. */
#include "platform/render/ui/ui.h"

#include <GLES3/gl3.h>
#include <stdio.h>

#include "assets.h"
#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "fonts.h"
#include "platform/render/gl_util.h"
#include "shaders.h"

#define INDICES_PER_QUAD 6u

_Static_assert(UI_QUADS_MAX * 4u <= 65536u, "indices are 16 bits wide");

/* Compiles one shader program for each kind of quad. */
static void make_programs(struct gl_status *status, struct ui *ui)
{
    static const char *const kinds[UI_KIND_COUNT] = {
        [UI_GLYPH] = "UI_GLYPH", [UI_PANEL] = "UI_PANEL", [UI_WASHI] = "UI_WASHI",
        [UI_WAVES] = "UI_WAVES", [UI_RING] = "UI_RING",   [UI_GLOW] = "UI_GLOW",
        [UI_FISH] = "UI_FISH",   [UI_POI] = "UI_POI",     [UI_LANTERN] = "UI_LANTERN",
        [UI_WOOD] = "UI_WOOD",   [UI_HEAT] = "UI_HEAT",   [UI_WATER] = "UI_WATER",
        [UI_GHOST] = "UI_GHOST",
    };
    const char *const vertex_parts[] = { "#version 300 es\n", shader_ui_vert };
    const GLuint vertex = gl_compile(status, "words", GL_VERTEX_SHADER, vertex_parts, 2);
    for (uint32_t i = 0; i < UI_KIND_COUNT && gl_is_well(status); i++) {
        char head[192];
        snprintf(head, sizeof head,
                 "#version 300 es\n// %s\n#define %s\n#define FONT_EDGE %u.0\n"
                 "#define FONT_STEP %u.0\n#define FONT_SIZE vec2(%u.0, %u.0)\n",
                 kinds[i], kinds[i], ASSET_FONT_EDGE, ASSET_FONT_STEP, ASSET_FONT_WIDTH,
                 ASSET_FONT_ROWS);
        const char *const parts[] = { head, shader_ui_frag };
        const GLuint fragment = gl_compile(status, "words", GL_FRAGMENT_SHADER, parts, 2);
        ui->programs[i] = gl_link(status, "words", vertex, fragment);
        /* OpenGL keeps a deleted shader until no program uses the shader. If the compilation
         * failed, the name is 0, which OpenGL ignores. */
        glDeleteShader(fragment);
        if (ui->programs[i] != 0) {
            gl_program_bind(ui->programs[i], "font paper waves");
            ui->to_clip[i] = glGetUniformLocation(ui->programs[i], "to_clip");
            ui->turn[i] = glGetUniformLocation(ui->programs[i], "turn");
            ui->move[i] = glGetUniformLocation(ui->programs[i], "move");
        }
    }
    glDeleteShader(vertex);
}

/* Number of texels for a length of one unit in the pattern of sea waves. */
#define WAVE_UNIT 128u

/* Returns the brightness of the pattern of sea waves at a point, 0 or more. Each wave consists of
 * three arcs, and each row of waves hides a part of the row above. The pattern repeats after 2
 * units to the right and after 1 unit downward. */
static float wave_arcs(float x, float y)
{
    const float row = f_floor(y * 2.0f);
    float result = 0.0f;
    for (uint32_t i = 0; i < 3; i++) {
        const float r = row + (float)i;
        const float shifted = x + r - 2.0f * f_floor(0.5f * (x + r)) - 1.0f;
        const float below = y - 0.5f * r - 1.0f;
        const float distance = f_sqrt(shifted * shifted + below * below);
        const float along = 3.0f * distance - f_floor(3.0f * distance);
        if (distance < 1.0f) {
            result = f_smoothstep(0.10f, 0.22f, 0.5f - f_abs(along - 0.5f));
        }
    }
    return 1.0f - result;
}

/* Draws the pattern of sea waves once, because a pixel of a panel would compute it slowly. */
static GLuint make_waves(struct gl_status *status)
{
    static uint8_t texels[WAVE_UNIT][2u * WAVE_UNIT];
    for (uint32_t y = 0; y < WAVE_UNIT; y++) {
        for (uint32_t x = 0; x < 2u * WAVE_UNIT; x++) {
            const float unit = 1.0f / (float)WAVE_UNIT;
            const float value = wave_arcs(((float)x + 0.5f) * unit, ((float)y + 0.5f) * unit);
            texels[y][x] = (uint8_t)(value * 255.0f + 0.5f);
        }
    }
    return gl_texture(status, "waves",
                      &(struct gl_texture_desc){ .internal_format = GL_R8,
                                                 .width = 2u * WAVE_UNIT,
                                                 .height = WAVE_UNIT,
                                                 .pixels = texels[0],
                                                 .mipmaps = true,
                                                 .wrap = GL_REPEAT });
}

bool ui_init(struct ui *ui, char *why, size_t why_size)
{
    CORE_ASSERT(why_size > 0);
    *ui = (struct ui){ 0 };
    struct gl_status status = { 0 };
    make_programs(&status, ui);
    ui->font_texture = gl_texture(&status, "font",
                                  &(struct gl_texture_desc){ .internal_format = GL_R8,
                                                             .width = ASSET_FONT_WIDTH,
                                                             .height = ASSET_FONT_ROWS,
                                                             .layers = ASSET_FONT_PAGES,
                                                             .pixels = asset_font });
    ui->paper_texture = gl_texture(&status, "paper",
                                   &(struct gl_texture_desc){ .internal_format = GL_R8,
                                                              .width = ASSET_PAPER_SIZE,
                                                              .height = ASSET_PAPER_SIZE,
                                                              .pixels = asset_paper,
                                                              .wrap = GL_REPEAT });
    ui->waves_texture = make_waves(&status);
    if (!gl_is_well(&status)) {
        snprintf(why, why_size, "%s", status.text);
        ui_close(ui);
        return false;
    }
    /* The indices of all quads are constant. Only the vertices change from frame to frame. */
    static uint16_t indices[UI_QUADS_MAX * INDICES_PER_QUAD];
    static const uint16_t corners[INDICES_PER_QUAD] = { 0, 2, 1, 1, 2, 3 };
    for (uint32_t i = 0; i < UI_QUADS_MAX * INDICES_PER_QUAD; i++) {
        indices[i] = (uint16_t)(i / INDICES_PER_QUAD * 4u + corners[i % INDICES_PER_QUAD]);
    }
    const size_t stride = sizeof(struct ui_vertex);
    glGenVertexArrays(1, &ui->vertex_array);
    glBindVertexArray(ui->vertex_array);
    ui->index_buffer = gl_buffer(GL_ELEMENT_ARRAY_BUFFER, indices, sizeof indices);
    ui->vertex_buffer = gl_buffer(GL_ARRAY_BUFFER, NULL, sizeof ui->batch.vertices);
    gl_attribute_floats(0, 2, stride, offsetof(struct ui_vertex, x));
    gl_attribute_floats(1, 2, stride, offsetof(struct ui_vertex, u));
    gl_attribute_floats(2, 4, stride, offsetof(struct ui_vertex, shape));
    gl_attribute_bytes(3, 4, true, stride, offsetof(struct ui_vertex, fill));
    gl_attribute_bytes(4, 4, true, stride, offsetof(struct ui_vertex, line));
    glBindVertexArray(0);
    return true;
}

static void set_state(const struct ui *ui, const struct display_transform *transform)
{
    glViewport(0, 0, (GLsizei)transform->screen_width, (GLsizei)transform->screen_height);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_bind_texture(2, GL_TEXTURE_2D, ui->waves_texture);
    gl_bind_texture(1, GL_TEXTURE_2D, ui->paper_texture);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, ui->font_texture);
    glBindVertexArray(ui->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, ui->vertex_buffer);
}

/* Draws the quads whose indices are at least `first` and less than `limit`. */
static void draw_quads(const struct ui *ui, uint32_t first, uint32_t limit,
                       const struct display_transform *transform)
{
    CORE_ASSERT(limit <= ui->batch.quad_count);
    if (first < limit) {
        set_state(ui, transform);
    }
    while (first < limit) {
        /* All consecutive quads of one kind, from index `first` to index `end` - 1, are drawn in
         * one draw call. */
        const uint8_t kind = ui->batch.kinds[first];
        float turn[4], move[2];
        uint32_t end = first + 1u;
        while (end < limit && ui->batch.kinds[end] == kind) {
            end++;
        }
        glUseProgram(ui->programs[kind]);
        display_clip_matrix(transform, turn, move);
        glUniform2f(ui->to_clip[kind], 2.0f / transform->width, -2.0f / transform->height);
        glUniformMatrix2fv(ui->turn[kind], 1, GL_FALSE, turn);
        glUniform2fv(ui->move[kind], 1, move);
        glDrawElements(GL_TRIANGLES, (GLsizei)((end - first) * INDICES_PER_QUAD), GL_UNSIGNED_SHORT,
                       (const void *)(first * INDICES_PER_QUAD * sizeof(uint16_t)));
        first = end;
    }
}

void ui_show(struct ui *ui, struct specimen_pass *specimens,
             const struct display_transform *transform)
{
    set_state(ui, transform);
    /* The buffer gets new storage in each frame, so that the driver does not wait for the drawing
     * of the previous frame. */
    glBufferData(GL_ARRAY_BUFFER, sizeof ui->batch.vertices, NULL, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0,
                    (GLsizeiptr)(ui->batch.quad_count * 4u * sizeof(struct ui_vertex)),
                    ui->batch.vertices);
    uint32_t quad = 0;
    for (uint32_t i = 0; i < ui->batch.specimen_count && specimens != NULL; i++) {
        draw_quads(ui, quad, ui->batch.specimen_quad[i], transform);
        quad = ui->batch.specimen_quad[i];
        specimen_pass_draw(specimens, &ui->batch.specimens[i], transform);
    }
    draw_quads(ui, quad, ui->batch.quad_count, transform);
    glBindVertexArray(0);
}

void ui_draw(struct ui *ui, struct specimen_pass *specimens, const struct scene *scene,
             const struct display_transform *transform)
{
    ui_screens(&ui->batch, &ui->memory, scene, transform->width, transform->height);
    ui_show(ui, specimens, transform);
}

void ui_close(struct ui *ui)
{
    for (uint32_t i = 0; i < UI_KIND_COUNT; i++) {
        glDeleteProgram(ui->programs[i]);
    }
    glDeleteVertexArrays(1, &ui->vertex_array);
    glDeleteBuffers(1, &ui->vertex_buffer);
    glDeleteBuffers(1, &ui->index_buffer);
    glDeleteTextures(1, &ui->font_texture);
    glDeleteTextures(1, &ui->paper_texture);
    glDeleteTextures(1, &ui->waves_texture);
    *ui = (struct ui){ 0 };
}
