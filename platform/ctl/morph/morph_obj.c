/* morph_obj.c -- writes a fish at one moment of its life as a Wavefront OBJ file for other
 * programs.
 *
 * The colour of a vertex follows its position (`v x y z r g b`, sRGB). MeshLab, Blender and other
 * programs read this extension. Texture coordinates are the body coordinates u and v. Each piece of
 * the mesh is one group. */
#include <errno.h>
#include <string.h>

#include "platform/ctl/morph/morph_mesh.h"
#include "platform/os/file.h"

static const char command[] = "export";

/* Shape that is being written. The variable is static because it is too large for a stack. */
static struct {
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    struct paint paints[MESH_VERTEX_MAX];
    struct morph_mesh cut;
} work;

static void write_head(FILE *file, const struct morph_options *pick, float length_m)
{
    const struct species_card *card = &pick->fish->card;
    fprintf(file, "# %s at progress %.6f: %.2f days, %.6g mm; kingyoctl morph export\n", card->id,
            (double)pick->progress, (double)life_age_days(card, pick->progress),
            1e3 * (double)length_m);
    fputs("# Metres, true size. +x is the fish's right, +y up, the snout looks along -z.\n"
          "# v x y z r g b: colours are sRGB, 0 to 1. vt: along and round the body, or along and\n"
          "# up a fin. A fin is a sheet: draw both its sides.\n",
          file);
    fprintf(file, "o %s\n", card->id);
}

static void write_vertices(FILE *file, const struct morph_options *pick, float length_m)
{
    const struct species_mesh *mesh = &pick->fish->lod[0];
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const vec3 colour = work.paints[i].colour, at = v3_scale(work.positions[i], length_m);
        fprintf(file, "v %.9g %.9g %.9g %.4f %.4f %.4f\n", (double)at.x, (double)at.y, (double)at.z,
                (double)colour.x, (double)colour.y, (double)colour.z);
    }
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        fprintf(file, "vt %.6f %.6f\n", (double)mesh->vertices[i].u, (double)mesh->vertices[i].v);
    }
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        fprintf(file, "vn %.5f %.5f %.5f\n", (double)work.normals[i].x, (double)work.normals[i].y,
                (double)work.normals[i].z);
    }
}

static void write_faces(FILE *file)
{
    for (uint32_t p = 0; p < work.cut.piece_count; p++) {
        const struct morph_piece *piece = &work.cut.pieces[p];
        char name[PIECE_NAME_SIZE];
        morph_piece_name(piece, name);
        fprintf(file, "g %s\n", name);
        for (uint32_t i = 0; i < piece->face_count; i++) {
            const uint16_t *at = work.cut.faces[piece->face_first + i];
            /* Vertices in OBJ files are counted from 1. */
            const unsigned a = at[0] + 1u, b = at[1] + 1u, c = at[2] + 1u;
            fprintf(file, "f %u/%u/%u %u/%u/%u %u/%u/%u\n", a, a, a, b, b, b, c, c, c);
        }
    }
}

enum exit_code morph_obj_write(const struct morph_options *pick, const char *path)
{
    const struct species_mesh *mesh = &pick->fish->lod[0];
    const float length_m = life_length_m(&pick->fish->card, pick->progress);
    struct atomic_file out;
    int error = file_atomic_open(&out, path);
    if (error == 0) {
        morph_pose(&pick->rig, mesh, pick->progress, &work.pose);
        morph_shape(mesh, pick->fish->card.key_count, &work.pose, work.positions, work.normals);
        morph_mesh_cut(mesh, work.positions, work.normals, &work.cut);
        morph_mesh_paint(pick->fish, work.pose.weight[0], &work.cut, work.paints);
        write_head(out.file, pick, length_m);
        write_vertices(out.file, pick, length_m);
        write_faces(out.file);
        error = file_atomic_close(&out);
    }
    return error ? morph_fail(EXIT_IO, command, "%.900s: %s", path, strerror(-error)) : EXIT_OK;
}
