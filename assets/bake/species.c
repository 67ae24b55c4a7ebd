/* species.c -- the tool `bake_species IN.txt OUT.c`, which converts a species text to the core's
 * constant tables.
 *
 * Exit status: 0 for success, 2 for wrong usage, 65 for an invalid species text, 74 for a file
 * error. */
#include "core/base/panic.h"
#include "core/morph/species.h"
#include "platform/os/exit_code.h"
#include "platform/species/pack.h"

#include <assert.h>
#include <err.h>
#include <stdio.h>
#include <stdlib.h>

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}

/* Writes a list of `count` floats in braces. Floats are hexadecimal, so that no bit is lost. */
static void write_floats(FILE *file, const float *values, uint32_t count)
{
    fprintf(file, " {");
    for (uint32_t i = 0; i < count; i++) {
        fprintf(file, " %af,", (double)values[i]);
    }
    fprintf(file, " }");
}

static void write_anchors(FILE *file, const struct species_mesh *mesh, uint32_t lod,
                          uint32_t key_count)
{
    assert(mesh->anchor_count <= ANCHOR_MAX && key_count <= MORPH_KEY_MAX);
    fprintf(file, "static const struct species_anchor anchors_%u[%u] = {\n", lod,
            mesh->anchor_count + 1u);
    for (uint32_t i = 0; i < mesh->anchor_count; i++) {
        const struct species_anchor *a = &mesh->anchors[i];
        fprintf(file, "    { %u, %u,", a->curve, a->turns);
        write_floats(file, a->u, key_count);
        fprintf(file, ",");
        write_floats(file, a->v, key_count);
        fprintf(file, " },\n");
    }
    fprintf(file, "    { 0, 0, { 0.0f }, { 0.0f } }, /* C has no empty arrays. */\n};\n\n");
}

static void write_tables(FILE *file, const struct species_mesh *mesh, uint32_t lod,
                         uint32_t key_count)
{
    assert(mesh->vertex_count <= MESH_VERTEX_MAX && mesh->index_count <= MESH_INDEX_MAX);
    fprintf(file, "static const struct species_vertex vertices_%u[%u] = {\n", lod,
            mesh->vertex_count);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *v = &mesh->vertices[i];
        fprintf(file, "    { %af, %af, %u, %u, %u, %u, { %u, %u, %u, %u } },\n", (double)v->u,
                (double)v->v, v->part, v->side, v->flex, v->anchor, v->mask[0], v->mask[1],
                v->mask[2], v->mask[3]);
    }
    fprintf(file, "};\n\n");
    for (uint32_t key = 0; key < key_count; key++) {
        fprintf(file, "static const struct species_point points_%u_%u[%u] = {\n", lod, key,
                mesh->vertex_count);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            const struct species_point *p = &mesh->points[key][i];
            fprintf(file, "    { %d, %d, %d, %d },\n", p->x, p->y, p->z, p->normal);
        }
        fprintf(file, "};\n\n");
    }
    write_anchors(file, mesh, lod, key_count);
    fprintf(file, "static const uint16_t indices_%u[%u] = {", lod, mesh->index_count);
    for (uint32_t i = 0; i < mesh->index_count; i++) {
        fprintf(file, "%s%u,", i % 12 == 0 ? "\n    " : " ", mesh->indices[i]);
    }
    fprintf(file, "\n};\n\n");
}

static void write_card(FILE *file, const struct species_card *card)
{
    fprintf(file,
            "    .id = \"%s\",\n    .key_count = %u,\n    .measure = %u,\n    .motion = %u,\n"
            "    .form = %u,\n    .thesis_key = { %u, %u, %u },\n    .thesis_template = %u,\n",
            card->id, card->key_count, card->measure, card->motion, card->form, card->thesis_key[0],
            card->thesis_key[1], card->thesis_key[2], card->thesis_template);
    for (uint32_t key = 0; key < card->key_count; key++) {
        fprintf(file,
                "    .key_names[%u] = \"%s\",\n    .key_age_days[%u] = %af,\n"
                "    .key_length_m[%u] = %af,\n",
                key, card->key_names[key], key, (double)card->key_age_days[key], key,
                (double)card->key_length_m[key]);
    }
    const struct growth *g = &card->growth;
    fprintf(file, "    .growth = { %af, %af, %af, %af, %u, {", (double)g->length_inf_m,
            (double)g->k_per_year, (double)g->t0_year, (double)g->fade_year, g->point_count);
    for (uint32_t i = 0; i < g->point_count; i++) {
        fprintf(file, " { %af, %af },", (double)g->points[i].age_days,
                (double)g->points[i].length_m);
    }
    fprintf(file, " } },\n    .scale_knot_count = %u,\n", card->scale_knot_count);
    for (uint32_t i = 0; i < card->scale_knot_count; i++) {
        fprintf(file, "    .scale_knots[%u] = { %af, %af },\n", i,
                (double)card->scale_knots[i].progress, (double)card->scale_knots[i].length_m);
    }
    fprintf(file, "    .curve_count = %u,\n", card->curve_count);
    for (uint32_t i = 0; i < card->curve_count; i++) {
        const struct graph *graph = &card->curves[i];
        fprintf(file, "    .curve_names[%u] = \"%s\",\n    .curves[%u] = { %u, %u, %u, {\n", i,
                card->curve_names[i], i, graph->knot_count, graph->line, graph->solved);
        for (uint32_t knot = 0; knot < graph->knot_count; knot++) {
            fprintf(file, "        { %af,", (double)graph->knots[knot].progress);
            write_floats(file, graph->knots[knot].weight, card->key_count);
            fprintf(file, " },\n");
        }
        fprintf(file, "    } },\n");
    }
}

static void write_coat(FILE *file, const struct species_coat *coat, uint32_t key)
{
    assert(coat->mark_count <= MARK_MAX);
    fprintf(file, "    .coats[%u] = { 0x%06x, 0x%06x, 0x%06x, 0x%06x, 0x%06x, %u, %u, %u, {\n", key,
            coat->back, coat->flank, coat->belly, coat->fin, coat->iris, coat->clear, coat->shine,
            coat->mark_count);
    for (uint32_t i = 0; i < coat->mark_count; i++) {
        const struct species_mark *m = &coat->marks[i];
        fprintf(file, "        { %u, %u, %u, %u, 0x%06x, %af, %af, %af, %af, %af, %af },\n",
                m->kind, m->part, m->count, m->seed, m->colour, (double)m->from, (double)m->to,
                (double)m->width, (double)m->slant, (double)m->low, (double)m->high);
    }
    fprintf(file, "    } },\n");
}

/* Writes the C constant `const struct species species_ID`, in which ID is the species' name. */
static void species_write(FILE *file, const struct species *species)
{
    const struct species_card *card = &species->card;
    assert(card->key_count <= MORPH_KEY_MAX && card->curve_count <= MORPH_CURVE_MAX);
    fprintf(file, "/* Baked from assets/species/%s.txt: change that. */\n", card->id);
    fprintf(file, "#include \"core/morph/species.h\"\n\n");
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        write_tables(file, &species->lod[lod], lod, card->key_count);
    }
    fprintf(file, "extern const struct species species_%s;\n", card->id);
    fprintf(file, "const struct species species_%s = {\n    .card = {\n", card->id);
    write_card(file, card);
    fprintf(file, "    },\n");
    for (uint32_t key = 0; key < card->key_count; key++) {
        write_coat(file, &species->coats[key], key);
    }
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &species->lod[lod];
        fprintf(file, "    .lod[%u] = {\n        %u, %u, %u, %u, %u, %u, %af, vertices_%u,\n", lod,
                mesh->vertex_count, mesh->index_count, mesh->anchor_count, mesh->grid_first,
                mesh->grid_rings, mesh->grid_spokes, (double)mesh->reach, lod);
        fprintf(file, "        {");
        for (uint32_t key = 0; key < card->key_count; key++) {
            fprintf(file, " points_%u_%u,", lod, key);
        }
        fprintf(file, " }, anchors_%u, indices_%u,\n    },\n", lod, lod);
    }
    fprintf(file, "};\n");
}

int main(int argc, char **argv)
{
    static struct species_text text;
    static struct species_slot slot;
    if (argc != 3) {
        fprintf(stderr, "usage: %s SPECIES.txt OUT.c\n", argv[0]);
        return EXIT_USAGE;
    }
    FILE *in = fopen(argv[1], "r");
    if (!in) {
        err(EXIT_IO, "%s", argv[1]);
    }
    if (!species_read(in, argv[1], stderr, &text)) {
        return EXIT_BAD_DATA;
    }
    fclose(in);
    pack_text(&text, &slot);
    FILE *out = fopen(argv[2], "w");
    if (!out) {
        err(EXIT_IO, "%s", argv[2]);
    }
    species_write(out, &slot.species);
    if (fflush(out) != 0 || ferror(out) || fclose(out) != 0) {
        err(EXIT_IO, "%s", argv[2]);
    }
    return EXIT_OK;
}
