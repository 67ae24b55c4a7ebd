/* morph_export.c -- `kingyoctl morph export`, which writes a fish as pictures or as meshes for
 * other programs. Also cuts a mesh into pieces, and writes Wavefront OBJ files. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_export.h"
#include "platform/os/file.h"
#include "platform/species/part.h"

#define FRAMES_MAX 10000u

static const char name[] = "export";

static struct export_plan {
    struct morph_options pick;
    const char *sheet, *obj, *glb, *folder;
    uint8_t view; /* View of the frames, or VIEW_COUNT if --view is absent. */
    uint32_t frame_count;
} plan = { .view = VIEW_COUNT };

static enum exit_code check_options(void)
{
    const bool frames = plan.frame_count > 0;
    const int kinds = (plan.sheet != NULL) + (plan.obj != NULL) + (plan.glb != NULL) + frames;
    if (kinds != 1) {
        return morph_usage(name, "%s; write one of --sheet, --obj, --glb and --frames",
                           kinds ? "there is more than one output" : "the output is missing");
    }
    if (frames != (plan.folder != NULL)) {
        return morph_usage(name, "--frames N and --dir D must be used together");
    }
    if (plan.view != VIEW_COUNT && !frames) {
        return morph_usage(name, "--view needs --frames");
    }
    if (plan.obj && !plan.pick.has_place) {
        return morph_usage(name, "--obj needs --progress, --age-days or --length-mm");
    }
    if (!plan.obj && plan.pick.has_place) {
        return morph_usage(name, "--progress, --age-days and --length-mm need --obj");
    }
    return EXIT_OK;
}

#define AT(member) .offset = offsetof(struct export_plan, member)

static const struct option options[] = {
    { "sheet", "FILE.png",
      "contact sheet of every key and nine stages between each two keys, from the left, from above "
      "and at an angle, with age, length and a scale bar",
      OPTION_TEXT, AT(sheet) },
    { "frames", "N", "number of pictures at equal steps of progress", OPTION_WHOLE, AT(frame_count),
      2, FRAMES_MAX },
    { "dir", "D", "folder of the pictures D/SPECIES_0000.png and so on", OPTION_TEXT, AT(folder) },
    { "view", "VIEW", "view of the pictures; the default is side", OPTION_CHOICE, AT(view),
      .choices = fish_preview_view_names },
    { "obj", "FILE.obj",
      "mesh at the moment that --progress, --age-days or --length-mm selects: metres, coloured "
      "vertices, one group for each part. If the fish has a length more than once, as a conger "
      "has, the youngest age is used",
      OPTION_TEXT, AT(obj) },
    { "glb", "FILE.glb",
      "glTF 2.0 of the whole life: key shapes as morph targets (solved shapes where the graph is "
      "solved), weights, size and the parts on the skin animated over 10 s, one mesh for each "
      "part, coloured vertices",
      OPTION_TEXT, AT(glb) },
};

static enum exit_code export_fish(void)
{
    const struct morph_options *pick = &plan.pick;
    const enum exit_code code = check_options();
    if (code != EXIT_OK) {
        return code;
    }
    if (plan.sheet || plan.obj || plan.glb) {
        return plan.sheet ? morph_sheet_write(pick, plan.sheet)
               : plan.obj ? morph_obj_write(pick, plan.obj)
                          : morph_glb_write(pick, plan.glb);
    }
    const enum fish_preview_view view =
        plan.view == VIEW_COUNT ? VIEW_SIDE : (enum fish_preview_view)plan.view;
    return morph_frames_write(pick, view, plan.frame_count, plan.folder);
}

const struct morph_command ctl_morph_export = {
    .name = name,
    .options = MORPH_OPTION_TABLE(options),
    .groups = MORPH_REQUIRES_CURVES | MORPH_REQUIRES_PLACE,
    .words = "SPECIES|FILE WHAT [--template T] [--thesis]",
    .summary = "writes a growing fish as pictures or as meshes",
    .usage =
        "WHAT is one of --sheet, --frames with --dir, --obj and --glb. An age or a length outside\n"
        "the drawn life is rejected, and the message contains the valid range.\n"
        "If a file cannot be written completely, no file is created, and an older file is kept.\n",
    .plan = &plan.pick,
    .run_fish = export_fish,
};

/* ---- Pieces of a mesh ------------------------------------------------------------------------ */

/* This section sorts the triangles of a species' mesh into pieces, and computes the colours of the
 * vertices. */

void morph_piece_name(const struct morph_piece *piece, char out[PIECE_NAME_SIZE])
{
    CORE_ASSERT(piece->part < PART_COUNT);
    CORE_ASSERT(piece->side <= SIDE_LEFT);
    static const char *const sides[] = {
        [SIDE_MIDDLE] = "", [SIDE_RIGHT] = "_right", [SIDE_LEFT] = "_left"
    };
    snprintf(out, PIECE_NAME_SIZE, "%s%s", part_names[piece->part], sides[piece->side]);
}

/* Returns true if the front of a triangle faces in the direction of its vertex normals. `at` points
 * to the three vertex indices. */
static bool faces_out(const uint16_t *at, const vec3 *positions, const vec3 *normals)
{
    const vec3 front = v3_cross(v3_sub(positions[at[1]], positions[at[0]]),
                                v3_sub(positions[at[2]], positions[at[0]]));
    const vec3 sum = v3_add(v3_add(normals[at[0]], normals[at[1]]), normals[at[2]]);
    return v3_dot(front, sum) >= 0.0f;
}

static bool same_corners(const uint16_t *a, const uint16_t *b)
{
    for (uint32_t i = 0; i < 3; i++) {
        if (a[i] != b[0] && a[i] != b[1] && a[i] != b[2]) {
            return false;
        }
    }
    return true;
}

/* Returns true if the triangle at `index` is omitted because another triangle has the same corners.
 * The mesh stores the sheet of a fin twice, once for each side. Only the triangle whose front faces
 * in the direction of its normals is needed. */
static bool is_spare(const struct species_mesh *mesh, uint32_t index, const vec3 *positions,
                     const vec3 *normals)
{
    const uint16_t *at = &mesh->indices[index];
    const bool good = faces_out(at, positions, normals);
    for (uint32_t i = 0; mesh->vertices[at[0]].part >= PART_TAIL && i < mesh->index_count; i += 3) {
        if (i != index && same_corners(at, &mesh->indices[i])) {
            const bool twin_good = faces_out(&mesh->indices[i], positions, normals);
            return good == twin_good ? i < index : twin_good;
        }
    }
    return false;
}

void morph_mesh_cut(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                    struct morph_mesh *out)
{
    CORE_ASSERT(mesh->index_count <= MESH_INDEX_MAX);
    out->piece_count = out->face_count = 0;
    for (uint32_t part = 0; part < PART_COUNT; part++) {
        for (uint32_t side = SIDE_MIDDLE; side <= SIDE_LEFT; side++) {
            struct morph_piece *piece = &out->pieces[out->piece_count];
            *piece = (struct morph_piece){ .part = (uint8_t)part,
                                           .side = (uint8_t)side,
                                           .face_first = out->face_count };
            for (uint32_t i = 0; i < mesh->index_count; i += 3) {
                const uint16_t *at = &mesh->indices[i];
                const struct species_vertex *vertex = &mesh->vertices[at[0]];
                if (vertex->part == part && vertex->side == side &&
                    !is_spare(mesh, i, positions, normals)) {
                    memcpy(out->faces[out->face_count++], at, sizeof out->faces[0]);
                    piece->face_count++;
                }
            }
            out->piece_count += piece->face_count > 0;
        }
    }
}

static void add_paint(struct paint *sum, const struct paint *paint, float weight)
{
    sum->colour = v3_muladd(sum->colour, paint->colour, weight);
    sum->clear += paint->clear * weight;
    sum->shine += paint->shine * weight;
}

void morph_mesh_paint(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct morph_mesh *cut, struct paint *paints)
{
    CORE_ASSERT(cut->face_count <= MESH_INDEX_MAX / 3u);
    const struct species_mesh *mesh = &species->lod[0];
    float counts[MESH_VERTEX_MAX] = { 0 };
    memset(paints, 0, mesh->vertex_count * sizeof *paints);
    for (uint32_t i = 0; i < 3u * cut->face_count; i++) {
        const uint16_t *face = cut->faces[i / 3u];
        /* The colour for corner `k` of a triangle is sampled at `at`. On the body, `at` is half
         * way from the corner to the middle of the opposite edge. On an eye or a fin, `at` is
         * the corner itself, because the colours change exactly at the vertices. */
        const uint32_t k = i % 3u;
        const struct species_vertex *a = &mesh->vertices[face[(k + 1) % 3]];
        const struct species_vertex *b = &mesh->vertices[face[(k + 2) % 3]];
        struct species_vertex at = mesh->vertices[face[k]];
        if (at.part == PART_BODY) {
            at.u = 0.5f * at.u + 0.25f * (a->u + b->u);
            at.v = 0.5f * at.v + 0.25f * (a->v + b->v);
        }
        const struct paint paint = paint_at(species, weights, &at);
        add_paint(&paints[face[i % 3u]], &paint, 1.0f);
        counts[face[i % 3u]] += 1.0f;
    }
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct paint sum = paints[i];
        paints[i] = (struct paint){ .clear = 0.0f };
        add_paint(&paints[i], &sum, 1.0f / f_max(counts[i], 1.0f));
    }
}

/* ---- Wavefront OBJ --------------------------------------------------------------------------- */

/* This section writes a fish at one moment of its life as a Wavefront OBJ file for other programs.
 * The colour of a vertex follows its position (`v x y z r g b`, sRGB). MeshLab, Blender and other
 * programs read this extension. Texture coordinates are the body coordinates u and v. Each piece of
 * the mesh is one group. */

/* Shape that is being written. The variable is static because it is too large for a stack. */
static struct {
    struct morph_pose pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    struct paint paints[MESH_VERTEX_MAX];
    struct morph_mesh cut;
} work;

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
        const struct species_card *card = &pick->fish->card;
        fprintf(out.file, "# %s at progress %.6f: %.2f days, %.6g mm; kingyoctl morph export\n",
                card->id, (double)pick->progress, (double)life_age_days(card, pick->progress),
                1e3 * (double)length_m);
        fputs("# Metres, true size. +x is the fish's right, +y up, the snout looks along -z.\n"
              "# v x y z r g b: colours are sRGB, 0 to 1. vt: along and round the body, or along "
              "and\n"
              "# up a fin. A fin is a sheet: draw both its sides.\n",
              out.file);
        fprintf(out.file, "o %s\n", card->id);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            const vec3 colour = work.paints[i].colour, at = v3_scale(work.positions[i], length_m);
            fprintf(out.file, "v %.9g %.9g %.9g %.4f %.4f %.4f\n", (double)at.x, (double)at.y,
                    (double)at.z, (double)colour.x, (double)colour.y, (double)colour.z);
        }
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            fprintf(out.file, "vt %.6f %.6f\n", (double)mesh->vertices[i].u,
                    (double)mesh->vertices[i].v);
        }
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            fprintf(out.file, "vn %.5f %.5f %.5f\n", (double)work.normals[i].x,
                    (double)work.normals[i].y, (double)work.normals[i].z);
        }
        for (uint32_t p = 0; p < work.cut.piece_count; p++) {
            const struct morph_piece *piece = &work.cut.pieces[p];
            char piece_name[PIECE_NAME_SIZE];
            morph_piece_name(piece, piece_name);
            fprintf(out.file, "g %s\n", piece_name);
            for (uint32_t i = 0; i < piece->face_count; i++) {
                const uint16_t *at = work.cut.faces[piece->face_first + i];
                /* The index is increased by 1, because OBJ files count vertices from 1. */
                const unsigned a = at[0] + 1u, b = at[1] + 1u, c = at[2] + 1u;
                fprintf(out.file, "f %u/%u/%u %u/%u/%u %u/%u/%u\n", a, a, a, b, b, b, c, c, c);
            }
        }
        error = file_atomic_close(&out);
    }
    return morph_written(name, path, error);
}
