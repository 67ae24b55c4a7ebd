/* test_import.c -- Tests the import of meshes from other programs: the detected orientation, merged
 * vertices, and unchanged shapes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/morph/morph.h"
#include "platform/ctl/import/import.h"
#include "platform/ctl/morph/morph_export.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/species/text.h"

/* Largest rounding error of an export and an import, in steps of the 16-bit quantization. */
#define COUNTS 2.5f

static struct import_mesh mesh;
static struct import_report report;
static struct species_slot slot;
static struct species_card card;
static vec3 shapes[MORPH_KEY_MAX][MESH_VERTEX_MAX];
static char why[IMPORT_WHY_SIZE], fault[VALIDATE_WHY_SIZE];
static char folder[] = "/tmp/kingyo-import-XXXXXX";

static const char *path_of(const char *name)
{
    static char paths[4][128];
    static int next;
    char *path = paths[next++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    char command[96];
    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}

static const struct import_options *plan_of(const struct species *like)
{
    static struct import_options plan;
    plan = (struct import_options){ .id = "imported",
                                    .front = AXIS_NONE,
                                    .up = AXIS_Y,
                                    .measure = like->card.measure,
                                    .motion = 255,
                                    .form = 255,
                                    .template_id = TEMPLATE_OWN,
                                    .unit_m = 1.0,
                                    .like = like };
    return &plan;
}

static enum exit_code build_from(const struct import_options *plan)
{
    report = (struct import_report){ .front = AXIS_NONE };
    memset(&slot.species, 0, sizeof slot.species);
    if (!import_orient(&mesh, plan, &report, why) || !import_build(&mesh, &slot, &report, why) ||
        !import_life(&mesh, plan, &slot, &report, why)) {
        return EXIT_BAD_DATA;
    }
    slot.tables[1] = slot.tables[0];
    slot.species.lod[1] = slot.species.lod[0];
    return species_validate(&slot.species, fault) ? EXIT_OK : EXIT_NOT_SO;
}

static void shape_keys(const struct species *species)
{
    static struct morph_pose pose;
    const struct species_mesh *near = &species->lod[0];
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        morph_key_pose(near, species->card.key_count, key, &pose);
        morph_shape(near, species->card.key_count, &pose, shapes[key], NULL);
    }
}

/* Returns the largest distance from a vertex of the species to the nearest imported vertex of the
 * same part. The distance of two vertices is the largest of their distances in all key shapes. */
static float farthest_vertex(const struct species *species)
{
    const struct species_mesh *ours = &species->lod[0], *theirs = &slot.species.lod[0];
    float worst = 0.0f;
    for (uint32_t i = 0; i < ours->vertex_count; i++) {
        float best = INFINITY;
        for (uint32_t j = 0; j < theirs->vertex_count; j++) {
            float far = theirs->vertices[j].part == ours->vertices[i].part ? 0.0f : INFINITY;
            for (uint32_t key = 0; key < species->card.key_count && far < best; key++) {
                const vec3 d = v3_sub(morph_position(theirs, key, j), shapes[key][i]);
                far = fmaxf(far, fmaxf(fabsf(d.x), fmaxf(fabsf(d.y), fabsf(d.z))));
            }
            best = fminf(best, far);
        }
        worst = fmaxf(worst, best);
    }
    return worst;
}

/* ---- Tests of OBJ files --------------------------------------------------------------------- */

/* Writes one key shape as an OBJ file, as another program would: with other axes, another unit,
 * triangles, and one group per part. `turn` 0 uses Kingyo's axes, `turn` 1 points the nose to +x,
 * and `turn` 2 points the back to +z. */
static void write_obj(const struct species *species, uint32_t key, const char *path, int turn,
                      float unit)
{
    const struct species_mesh *near = &species->lod[0];
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fprintf(out, "# a fish\nmtllib none.mtl\n");
    for (uint32_t i = 0; i < near->vertex_count; i++) {
        const vec3 p = v3_scale(shapes[key][i], unit);
        const vec3 q = turn == 0 ? p : turn == 1 ? v3(-p.z, p.y, p.x) : v3(p.x, -p.z, p.y);
        fprintf(out, "v %.9g %.9g %.9g\n", (double)q.x, (double)q.y, (double)q.z);
    }
    uint32_t part = PART_COUNT;
    for (uint32_t i = 0; i < near->index_count; i += 3) {
        const uint16_t *t = &near->indices[i];
        if (near->vertices[t[0]].part != part) {
            part = near->vertices[t[0]].part;
            fprintf(out, "g %s\n", part_names[part]);
        }
        fprintf(out, "f %u//1 %u//1 %d\n", t[0] + 1u, t[1] + 1u,
                (int)t[2] - (int)near->vertex_count);
    }
    fclose(out);
}

static void read_objs(const struct species *species, int turn, float unit)
{
    shape_keys(species);
    for (uint32_t key = 0; key < species->card.key_count; key++) {
        write_obj(species, key, path_of("key.obj"), turn, unit);
        assert_int_equal(import_obj(&mesh, key, path_of("key.obj"), why), EXIT_OK);
    }
}

static void test_imported_obj_shapes_match_within_quantization(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species *species = species_table[i];
        read_objs(species, 0, 1.0f);
        /* The mesh already has the size and position of a Kingyo species, so the importer must not
         * move the mesh. */
        mesh.is_ours = true;
        struct import_options plan = *plan_of(species);
        plan.front = AXIS_MINUS_Z;
        assert_int_equal(build_from(&plan), EXIT_OK);
        assert_true(farthest_vertex(species) <= COUNTS * slot.species.lod[0].reach / 32767.0f);
    }
}

static void test_front_up_and_unit_are_detected(void **state)
{
    (void)state;
    static const struct {
        int turn;
        uint8_t up, front;
    } cases[] = { { 0, AXIS_Y, AXIS_MINUS_Z }, { 1, AXIS_Y, AXIS_X }, { 2, AXIS_Z, AXIS_Y } };
    for (size_t i = 0; i < 3; i++) {
        read_objs(&species_wakin, cases[i].turn, 137.0f);
        struct import_options plan = *plan_of(&species_wakin);
        plan.up = cases[i].up;
        assert_int_equal(build_from(&plan), EXIT_OK);
        assert_int_equal(report.front, cases[i].front);
        assert_float_equal(report.size[0], 137.0f, 1.0f);
        assert_string_equal(slot.species.card.id, "imported");
    }
}

static void test_an_ambiguous_up_axis_is_reported(void **state)
{
    (void)state;
    read_objs(&species_wakin, 2, 1.0f);
    /* In this file the nose points to +y, which the importer takes for the direction of the back
     * unless the options name another one. */
    struct import_options plan = *plan_of(&species_wakin);
    assert_int_equal(build_from(&plan), EXIT_BAD_DATA);
    assert_string_equal(
        why, "front: the fish is longest along +y, the direction of its back; use --up AXIS");
}

static void test_the_front_of_a_fish_without_eyes_is_its_thicker_half(void **state)
{
    (void)state;
    read_objs(&species_wakin, 1, 1.0f);
    for (uint32_t i = 0; i < mesh.group_count; i++) {
        snprintf(mesh.group_names[i], IMPORT_NAME_SIZE, "mesh_%u", i);
    }
    assert_true(import_orient(&mesh, plan_of(&species_wakin), &report, why));
    assert_int_equal(report.front, AXIS_X);
}

static void test_parts_are_recognized_by_words_in_names(void **state)
{
    (void)state;
    assert_int_equal(import_part("Fin_Dorsal.001"), PART_DORSAL);
    assert_int_equal(import_part("dorsal_2"), PART_DORSAL_2);
    assert_int_equal(import_part("EyeLeft"), PART_EYE);
    assert_int_equal(import_part("caudal fin"), PART_TAIL);
    assert_int_equal(import_part("Cube"), PART_BODY);
}

static void write_text(const char *path, const char *text)
{
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
}

#define TETRA "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"

static void test_invalid_obj_files_are_reported_with_their_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *complaint;
    } cases[] = {
        { "", ":0: no vertices" },
        { "v 0 0 0\n", ":1: no faces" },
        { "v 0 0\n", ":1: a vertex needs three numbers" },
        { "v 0 0 nan\n", ":1: 'nan' is not a number" },
        { "v 0 0 1e30\n", ":1: '1e30' is not a number" },
        { TETRA "f 1 2 9\n", ":9: corner '9' refers to no vertex" },
        { TETRA "f 1 2 0\n", ":9: corner '0' refers to no vertex" },
        { TETRA "f 1 2 -5\n", ":9: corner '-5' refers to no vertex" },
        { TETRA "f 1 2 99999999999999999999\n", ":9: corner '99999999999999999999' refers to no" },
        { TETRA "f 1/7 2 3\n", ":9: corner '1/7' refers to no texture coordinate" },
        { TETRA "f 1 2\n", ":9: a face needs three corners" },
        { TETRA "f 1 \033[31m\n", ":9: corner '?[31m' refers to no vertex" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        write_text(path_of("bad.obj"), cases[i].text);
        assert_int_equal(import_obj(&mesh, 0, path_of("bad.obj"), why), EXIT_BAD_DATA);
        if (!strstr(why, cases[i].complaint)) {
            fail_msg("'%s' and not '%s'", why, cases[i].complaint);
        }
    }
    assert_int_equal(import_obj(&mesh, 0, path_of("none.obj"), why), EXIT_IO);
}

static void test_shapes_with_different_topology_are_rejected(void **state)
{
    (void)state;
    write_text(path_of("a.obj"), TETRA);
    assert_int_equal(import_obj(&mesh, 0, path_of("a.obj"), why), EXIT_OK);
    write_text(path_of("b.obj"), "v 5 5 5\n" TETRA);
    assert_int_equal(import_obj(&mesh, 1, path_of("b.obj"), why), EXIT_BAD_DATA);
    assert_non_null(strstr(why, ":5: more than 4 vertices, which the first shape has"));
    write_text(path_of("b.obj"), TETRA "f 1 2 3\n");
    assert_int_equal(import_obj(&mesh, 1, path_of("b.obj"), why), EXIT_BAD_DATA);
    assert_non_null(strstr(why, ":9: more than 4 triangles"));
    write_text(path_of("b.obj"),
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 3 4\n");
    assert_int_equal(import_obj(&mesh, 1, path_of("b.obj"), why), EXIT_BAD_DATA);
    assert_non_null(strstr(why, ":8: this face has other vertices"));
}

static void test_a_too_fine_model_is_rejected_with_advice(void **state)
{
    (void)state;
    FILE *out = fopen(path_of("fine.obj"), "w");
    assert_non_null(out);
    for (uint32_t i = 0; i < 1500; i++) {
        fprintf(out, "v %u %u %u\n", i, i % 7, i % 3);
    }
    for (uint32_t i = 3; i <= 1500; i++) {
        fprintf(out, "f %u %u %u\n", i - 2, i - 1, i);
    }
    fclose(out);
    for (uint32_t key = 0; key < 3; key++) {
        assert_int_equal(import_obj(&mesh, key, path_of("fine.obj"), why), EXIT_OK);
    }
    struct import_options plan = *plan_of(&species_wakin);
    plan.front = AXIS_X;
    plan.measure = MEASURE_TOTAL;
    assert_int_equal(build_from(&plan), EXIT_BAD_DATA);
    assert_non_null(strstr(why, "vertices: more than 1024; reduce the model"));
}

/* ---- Tests of ages, lengths and growth ------------------------------------------------------ */

static void test_given_lengths_define_a_matching_growth_curve(void **state)
{
    (void)state;
    static struct species drawn;
    drawn = species_wakin;
    /* The lengths of the model species come from a table instead of a growth curve. */
    drawn.card.scale_knot_count = 2;
    drawn.card.scale_knots[0] = (struct scale_knot){ 0.0f, 0.005f };
    drawn.card.scale_knots[1] = (struct scale_knot){ 1.0f, 0.15f };
    read_objs(&species_wakin, 0, 1.0f);
    struct import_options plan = *plan_of(&drawn);
    plan.front = AXIS_MINUS_Z;
    plan.length_count = 5;
    for (uint32_t key = 0; key < 5; key++) {
        plan.lengths_mm[key] = 500.0 * (key + 1u);
    }
    if (build_from(&plan) != EXIT_OK) {
        fail_msg("%s %s", why, fault);
    }
    card = slot.species.card;
    assert_float_equal(card.key_age_days[4], species_wakin.card.key_age_days[4], 0.0f);
    assert_float_equal(growth_length_m(&card.growth, card.key_age_days[4]), 2.5f, 1e-4f);
    assert_float_equal(life_length_m(&card, life_progress(&card, card.key_age_days[2])), 1.5f,
                       1e-4f);
    /* The options give no lengths, so the importer must copy those of the model species. */
    plan.length_count = 0;
    assert_int_equal(build_from(&plan), EXIT_OK);
    assert_memory_equal(&slot.species.card.growth, &drawn.card.growth, sizeof drawn.card.growth);
    assert_int_equal(slot.species.card.scale_knot_count, 2);
}

static void test_ages_that_contradict_the_growth_curve_are_rejected(void **state)
{
    (void)state;
    read_objs(&species_wakin, 0, 1.0f);
    struct import_options plan = *plan_of(&species_wakin);
    plan.front = AXIS_MINUS_Z;
    plan.growth_count = 5;
    const struct growth *g = &species_wakin.card.growth;
    const double growth[5] = { 1e3 * (double)g->length_inf_m, (double)g->k_per_year,
                               (double)g->t0_year, 5.0, (double)g->fade_year };
    memcpy(plan.growth, growth, sizeof growth);
    /* With half the growth rate, the imported fish must reach each length at a higher age than the
     * goldfish. */
    plan.growth[1] *= 0.5;
    if (build_from(&plan) != EXIT_OK) {
        fail_msg("%s %s", why, fault);
    }
    card = slot.species.card;
    assert_true(card.key_age_days[4] > 1.5f * species_wakin.card.key_age_days[4]);
    assert_float_equal(growth_length_m(&card.growth, card.key_age_days[4]), 0.15f, 1e-4f);
    plan.growth[1] *= 2.0;
    plan.age_count = 5;
    for (uint32_t key = 0; key < 5; key++) {
        plan.ages_days[key] = 100.0 * key;
    }
    assert_int_equal(build_from(&plan), EXIT_NOT_SO);
    assert_non_null(strstr(fault, "aoko/length_m: 0.02 at 100 days, but the growth curve gives "));
}

static void test_rounded_weights_of_a_file_are_accepted(void **state)
{
    (void)state;
    read_objs(&species_wakin, 0, 1.0f);
    struct import_options plan = *plan_of(&species_wakin);
    plan.front = AXIS_MINUS_Z;
    mesh.time_count = 3;
    for (uint32_t i = 0; i < 3; i++) {
        mesh.times[i] = (float)i;
        memset(mesh.weights[i], 0, sizeof mesh.weights[i]);
        mesh.weights[i][2 * i] = 0.6f;
        mesh.weights[i][1] = 0.40005f;
    }
    if (build_from(&plan) != EXIT_OK) {
        fail_msg("%s %s", why, fault);
    }
    assert_int_equal(slot.species.card.curves[0].knot_count, 3);
    assert_float_equal(slot.species.card.curves[0].knots[1].weight[2], 0.6f / 1.00005f, 1e-6f);
}

static void read_three(const char *text)
{
    write_text(path_of("fin.obj"), text);
    for (uint32_t key = 0; key < 3; key++) {
        assert_int_equal(import_obj(&mesh, key, path_of("fin.obj"), why), EXIT_OK);
    }
    memset(&slot.species, 0, sizeof slot.species);
    assert_true(import_build(&mesh, &slot, &report, why));
}

static void test_a_sheet_gets_two_sides(void **state)
{
    (void)state;
    static const char fin[] = "v .1 1 0\nv .5 1 0\nv .5 1.5 0\n";
    char text[512];
    snprintf(text, sizeof text, TETRA "g dorsal\n%sf 5 6 7\n", fin);
    read_three(text);
    const struct species_mesh *near = &slot.species.lod[0];
    assert_int_equal(near->index_count, 3 * (4 + 2));
    /* A fin is imported with two sides. The two triangles begin at the same vertex. */
    assert_int_equal(near->indices[12], near->indices[15]);
    /* The other two vertices are in reverse order, because the second side faces the other way. */
    assert_int_equal(near->indices[13], near->indices[17]);
    assert_int_equal(near->indices[14], near->indices[16]);
    snprintf(text, sizeof text, TETRA "g dorsal\n%sf 5 6 7\nf 7 6 5\n", fin);
    read_three(text); /* This fin already has two sides, so no side is added. */
    assert_int_equal(near->index_count, 3 * (4 + 2));
    /* The body gets no second side. The mesh therefore has the four triangles of the body and the
     * one that this line adds. */
    snprintf(text, sizeof text, TETRA "%s", "f 1 3 2\n");
    read_three(text);
    assert_int_equal(near->index_count, 3 * 5);
}

/* ---- Tests of a template that was fitted to a mesh ------------------------------------------ */

static void test_a_fitted_template_has_the_given_life_data(void **state)
{
    (void)state;
    struct import_options plan = *plan_of(&species_wakin);
    plan.id = "fitted";
    plan.age_count = 5;
    for (uint32_t key = 0; key < 5; key++) {
        plan.ages_days[key] = 10.0 * (key + 1u);
    }
    card = species_wakin.card;
    assert_true(import_fitted_life(&plan, &card, why));
    assert_string_equal(card.id, "fitted");
    for (uint32_t key = 0; key < 5; key++) {
        assert_float_equal(growth_length_m(&card.growth, 10.0f * (float)(key + 1u)),
                           species_wakin.card.key_length_m[key], 1e-6f);
    }
    plan.age_count = 4;
    assert_false(import_fitted_life(&plan, &card, why));
    assert_string_equal(why, "--ages-days: 4 given for 5 key shapes; give one for each");
}

/* ---- Tests of glTF files -------------------------------------------------------------------- */

static void export_glb(const struct species *species, const char *path)
{
    static struct morph_options pick;
    const char *const words[] = { species->card.id };
    assert_int_equal(
        morph_options_read(&pick, "test", MORPH_REQUIRES_CURVES, &morph_options_table, 1, words),
        EXIT_OK);
    pick.fish = species;
    assert_int_equal(morph_glb_write(&pick, path), EXIT_OK);
}

static void test_an_exported_species_is_imported_within_quantization(void **state)
{
    (void)state;
    if (!import_can_flatten(why)) {
        print_message("built without assimp: no glTF is read\n");
        skip();
    }
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species *species = species_table[i];
        export_glb(species, path_of("fish.glb"));
        assert_int_equal(import_scene(&mesh, path_of("fish.glb"), why), EXIT_OK);
        assert_true(mesh.is_ours && mesh.has_life);
        assert_int_equal(mesh.measure, species->card.measure);
        struct import_options plan = *plan_of(species);
        plan.like = NULL;
        if (build_from(&plan) != EXIT_OK) {
            fail_msg("%s: %s %s", species->card.id, why, fault);
        }
        card = slot.species.card;
        assert_int_equal(card.key_count, species->card.key_count);
        for (uint32_t key = 0; key < card.key_count; key++) {
            assert_string_equal(card.key_names[key], species->card.key_names[key]);
            assert_float_equal(card.key_length_m[key], species->card.key_length_m[key],
                               1e-5f * card.key_length_m[key]);
            assert_float_equal(card.key_age_days[key], species->card.key_age_days[key],
                               1e-4f * card.key_age_days[key]);
        }
        for (uint32_t key = 0; key < card.key_count; key++) {
            /* A file stores all fields of a coat except the marks. */
            const struct species_coat *drawn = &species->coats[key];
            const struct species_coat *back = &slot.species.coats[key];
            assert_int_equal(back->mark_count, 0);
            assert_int_equal(back->back, drawn->back);
            assert_int_equal(back->flank, drawn->flank);
            assert_int_equal(back->belly, drawn->belly);
            assert_int_equal(back->fin, drawn->fin);
            assert_int_equal(back->iris, drawn->iris);
            assert_int_equal(back->clear, drawn->clear);
            assert_int_equal(back->shine, drawn->shine);
        }
        shape_keys(species);
        const float far = farthest_vertex(species);
        if (!(far <= COUNTS * slot.species.lod[0].reach / 32767.0f)) {
            fail_msg("%s: %g lengths off", species->card.id, (double)far);
        }
    }
}

static void test_quotes_in_a_name_are_exported_and_imported(void **state)
{
    (void)state;
    static struct species species;
    static const char quoted[] = "a\"b\\c";
    if (!import_can_flatten(why)) {
        skip();
    }
    species = species_wakin;
    memcpy(species.card.key_names[1], quoted, sizeof quoted);
    export_glb(&species, path_of("fish.glb"));
    assert_int_equal(import_scene(&mesh, path_of("fish.glb"), why), EXIT_OK);
    assert_string_equal(mesh.key_names[1], quoted);
}

static void test_a_damaged_scene_gives_one_message(void **state)
{
    (void)state;
    static uint8_t bytes[4u * 1024u * 1024u];
    if (!import_can_flatten(why)) {
        skip();
    }
    export_glb(&species_wakin, path_of("fish.glb"));
    FILE *in = fopen(path_of("fish.glb"), "rb");
    const size_t size = fread(bytes, 1, sizeof bytes, in);
    fclose(in);
    for (size_t cut = 0; cut < size; cut += size / 12 + 1) {
        FILE *out = fopen(path_of("cut.glb"), "wb");
        fwrite(bytes, 1, cut, out);
        fclose(out);
        assert_int_equal(import_scene(&mesh, path_of("cut.glb"), why), EXIT_BAD_DATA);
        assert_null(strchr(why, '\n'));
        assert_non_null(strstr(why, "cut.glb: "));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_imported_obj_shapes_match_within_quantization),
        cmocka_unit_test(test_front_up_and_unit_are_detected),
        cmocka_unit_test(test_an_ambiguous_up_axis_is_reported),
        cmocka_unit_test(test_the_front_of_a_fish_without_eyes_is_its_thicker_half),
        cmocka_unit_test(test_parts_are_recognized_by_words_in_names),
        cmocka_unit_test(test_invalid_obj_files_are_reported_with_their_line),
        cmocka_unit_test(test_shapes_with_different_topology_are_rejected),
        cmocka_unit_test(test_a_too_fine_model_is_rejected_with_advice),
        cmocka_unit_test(test_given_lengths_define_a_matching_growth_curve),
        cmocka_unit_test(test_ages_that_contradict_the_growth_curve_are_rejected),
        cmocka_unit_test(test_rounded_weights_of_a_file_are_accepted),
        cmocka_unit_test(test_a_sheet_gets_two_sides),
        cmocka_unit_test(test_a_fitted_template_has_the_given_life_data),
        cmocka_unit_test(test_an_exported_species_is_imported_within_quantization),
        cmocka_unit_test(test_quotes_in_a_name_are_exported_and_imported),
        cmocka_unit_test(test_a_damaged_scene_gives_one_message),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
