/* species_write.c -- the lofted species as C: constant tables, in hexadecimal to lose no bit. */
#include "assets/bake/species.h"

static void write_vec3s(FILE *file, const char *name, uint32_t lod, uint32_t key,
                        const vec3 *values, uint32_t count)
{
    fprintf(file, "static const vec3 %s_%u_%u[%u] = {\n", name, lod, key, count);
    for (uint32_t i = 0; i < count; i++) {
        fprintf(file, "    { %af, %af, %af },\n", (double)values[i].x, (double)values[i].y,
                (double)values[i].z);
    }
    fprintf(file, "};\n\n");
}

static void write_lod(FILE *file, const struct loft *loft, uint32_t lod, uint32_t key_count)
{
    fprintf(file, "static const struct species_vertex vertices_%u[%u] = {\n", lod,
            loft->vertex_count);
    for (uint32_t i = 0; i < loft->vertex_count; i++) {
        const struct species_vertex *v = &loft->vertices[i];
        fprintf(file, "    { %af, %af, %u, %u },\n", (double)v->u, (double)v->v, v->part, v->flex);
    }
    fprintf(file, "};\n\n");
    for (uint32_t key = 0; key < key_count; key++) {
        write_vec3s(file, "positions", lod, key, loft->positions[key], loft->vertex_count);
        write_vec3s(file, "normals", lod, key, loft->normals[key], loft->vertex_count);
    }
    fprintf(file, "static const uint16_t indices_%u[%u] = {", lod, loft->index_count);
    for (uint32_t i = 0; i < loft->index_count; i++) {
        fprintf(file, "%s%u,", i % 12 == 0 ? "\n    " : " ", loft->indices[i]);
    }
    fprintf(file, "\n};\n\n");
}

static void write_keys(FILE *file, const struct species_text *s)
{
    fprintf(file, "    .key_count = %u,\n", s->key_count);
    for (uint32_t i = 0; i < s->key_count; i++) {
        const struct key_text *key = &s->keys[i];
        fprintf(file, "    .key_names[%u] = \"%s\",\n", i, key->name);
        fprintf(file, "    .key_length_m[%u] = %af,\n", i, (double)key->length_m);
        fprintf(file, "    .key_tint[%u] = { 0x%06xu, 0x%06xu, 0x%06xu, 0x%06xu },\n", i,
                key->tint.back, key->tint.flank, key->tint.belly, key->tint.fin);
    }
}

static void write_curves(FILE *file, const struct species_text *s)
{
    const struct growth *g = &s->growth;
    fprintf(file, "    .growth = { %af, %af, %af, %af, %af },\n", (double)g->length_inf_m,
            (double)g->k_per_year, (double)g->t0_year, (double)g->hatch_length_m,
            (double)g->hatch_tau_year);
    fprintf(file, "    .knot_count = %u,\n", s->knot_count);
    for (uint32_t i = 0; i < s->knot_count; i++) {
        fprintf(file, "    .knots[%u] = { %af, {", i, (double)s->knots[i].progress);
        for (uint32_t key = 0; key < s->key_count; key++) {
            fprintf(file, " %af,", (double)s->knots[i].weight[key]);
        }
        fprintf(file, " } },\n");
    }
}

static void write_mesh(FILE *file, const struct loft *loft, uint32_t lod, uint32_t key_count)
{
    fprintf(file, "    .lod[%u] = {\n", lod);
    fprintf(file, "        .vertex_count = %u,\n        .index_count = %u,\n",
            loft->vertex_count, loft->index_count);
    fprintf(file, "        .vertices = vertices_%u,\n        .indices = indices_%u,\n", lod, lod);
    for (uint32_t key = 0; key < key_count; key++) {
        fprintf(file, "        .positions[%u] = positions_%u_%u,\n", key, lod, key);
        fprintf(file, "        .normals[%u] = normals_%u_%u,\n", key, lod, key);
    }
    fprintf(file, "    },\n");
}

bool species_write(FILE *file, const struct species_text *s,
                   const struct loft lofts[SPECIES_LOD_COUNT])
{
    fprintf(file, "/* Baked from assets/species/%s.txt: change that. */\n", s->id);
    fprintf(file, "#include \"core/morph/species.h\"\n\n");
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        write_lod(file, &lofts[lod], lod, s->key_count);
    }
    fprintf(file, "const struct species species_%s = {\n    .id = \"%s\",\n", s->id, s->id);
    write_keys(file, s);
    write_curves(file, s);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        write_mesh(file, &lofts[lod], lod, s->key_count);
    }
    fprintf(file, "};\n");
    return fflush(file) == 0 && !ferror(file);
}
