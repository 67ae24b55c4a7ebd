/* fish_shapes.c -- blends the shapes of the tank's fish and uploads them to a texture. */
#include "platform/render/fish_shapes.h"

#include "core/base/panic.h"

_Static_assert(SCENE_FISH_MAX <= GL_TEXTURE_SURE && 2u * MESH_VERTEX_MAX <= GL_TEXTURE_SURE,
               "a row for each fish, on every driver");

void fish_shapes_open(struct gl_status *status, struct fish_shapes *shapes,
                      const struct species_mesh *mesh)
{
    CORE_ASSERT(mesh->vertex_count <= MESH_VERTEX_MAX);
    shapes->width = 2u * mesh->vertex_count;
    for (uint32_t i = 0; i < SCENE_FISH_MAX; i++) {
        shapes->progress[i] = -1.0f;
    }
    shapes->texture = gl_texture(status, "shapes",
                                 &(struct gl_texture_desc){ .internal_format = GL_RGBA16F,
                                                            .width = shapes->width,
                                                            .height = SCENE_FISH_MAX,
                                                            .nearest = true });
}

void fish_shapes_close(struct fish_shapes *shapes)
{
    glDeleteTextures(1, &shapes->texture);
}

void fish_shapes_end(struct fish_shapes *shapes)
{
    CORE_ASSERT(shapes->run_count <= SHAPE_RUN);
    if (shapes->run_count > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, (GLint)shapes->run_first, (GLsizei)shapes->width,
                        (GLsizei)shapes->run_count, GL_RGBA, GL_HALF_FLOAT, shapes->run);
        shapes->run_count = 0;
    }
}

void fish_shapes_begin(struct fish_shapes *shapes)
{
    shapes->run_count = shapes->written_count = 0;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_bind_texture(0, GL_TEXTURE_2D, shapes->texture);
}

static void write_texel(uint16_t texel[4], vec3 v)
{
    texel[0] = half_float(v.x);
    texel[1] = half_float(v.y);
    texel[2] = half_float(v.z);
    texel[3] = 0;
}

void fish_shapes_set(struct fish_shapes *shapes, const struct morph_rig *rig,
                     const struct species_mesh *mesh, uint32_t row, float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(row < SCENE_FISH_MAX && 2u * mesh->vertex_count == shapes->width);
    if (shapes->progress[row] == progress && shapes->mesh[row] == mesh) {
        return;
    }
    if (shapes->run_count == SHAPE_RUN || row != shapes->run_first + shapes->run_count) {
        fish_shapes_end(shapes);
    }
    if (shapes->run_count == 0) {
        shapes->run_first = row;
    }
    morph_pose(rig, mesh, progress, &shapes->pose);
    morph_shape(mesh, rig->key_count, &shapes->pose, shapes->positions, shapes->normals);
    uint16_t(*const out)[4] = shapes->run + (size_t)shapes->run_count * shapes->width;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        write_texel(out[2u * i], shapes->positions[i]);
        write_texel(out[2u * i + 1u], shapes->normals[i]);
    }
    shapes->progress[row] = progress;
    shapes->mesh[row] = mesh;
    shapes->run_count++;
    shapes->written_count++;
}
