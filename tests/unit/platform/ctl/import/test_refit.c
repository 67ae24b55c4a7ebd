/* test_refit.c -- Tests how the vertices of one species are fitted to the surface of another mesh.
 * The meshes show known fish, so that the correct result is known. */
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
#include "platform/ctl/import/refit.h"
#include "platform/species/text.h"

/* clang-format off */
static const char *const mark_names[] = {
    "snout",        "tail_root",    "back",          "belly",          "eye_right",
    "eye_left",     "tail_top",     "tail_bottom",   "dorsal_start",   "dorsal_end",
    "dorsal_tip",   "anal_start",   "anal_end",      "pectoral_right_start",
    "pectoral_left_start", "pectoral_right_tip", "pectoral_left_tip", "pelvic_right_start",
    "pelvic_left_start",   "pelvic_right_tip",   "pelvic_left_tip",
};
/* clang-format on */
#define MARK_COUNT_HERE (sizeof mark_names / sizeof mark_names[0])

static struct species_text text;
static struct loft loft;
static struct mesh_tables tables;
static struct species_mesh other; /* Mesh of the built-in fish, but with another tessellation. */
static struct species_slot slot;
static struct import_mesh mesh;
static struct refit_marks marks;
static vec3 truth[MESH_VERTEX_MAX], positions[MESH_VERTEX_MAX];
static char why[IMPORT_WHY_SIZE];

/* Builds `other` with different numbers of rings, spokes and rays than the built-in mesh. No vertex
 * except the snout then keeps its position. */
static void loft_otherwise(const char *path)
{
    struct detail detail = species_detail[0];
    detail.rings -= 4;
    detail.spokes += 5;
    detail.eye_spokes -= 3;
    for (uint32_t part = 0; part < PART_COUNT; part++) {
        detail.fins[part].across += detail.fins[part].across > 0 ? 2 : 0;
        detail.fins[part].along += detail.fins[part].along > 3 ? 1 : 0;
    }
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    assert_true(species_read(in, path, stderr, &text));
    fclose(in);
    species_loft(&text, &detail, &loft);
    species_pack(&loft, text.card.key_count, &tables, &other);
}

static void shape_of(const struct species_mesh *body, uint32_t key_count, uint32_t key, vec3 *out)
{
    static struct morph_pose pose;
    morph_key_pose(body, key_count, key, &pose);
    morph_shape(body, key_count, &pose, out, NULL);
}

/* Fills `mesh` with the key shape `key` of `other`, as if another program had exported it. Every
 * third vertex is moved off the surface by up to `noise` body lengths, as in a 3D scan. */
static void make_mesh(uint32_t key, float noise)
{
    memset(&mesh, 0, sizeof mesh);
    shape_of(&other, text.card.key_count, key, mesh.positions[0]);
    mesh.key_count = 1;
    mesh.vertex_count = other.vertex_count;
    mesh.triangle_count = other.index_count / 3;
    mesh.group_count = PART_COUNT;
    for (uint32_t part = 0; part < PART_COUNT; part++) {
        snprintf(mesh.group_names[part], IMPORT_NAME_SIZE, "%s", part_names[part]);
    }
    for (uint32_t i = 0; i < other.index_count; i++) {
        mesh.triangles[i / 3][i % 3] = other.indices[i];
        mesh.groups[i / 3] = other.vertices[other.indices[i]].part;
    }
    for (uint32_t i = 0; i < mesh.vertex_count; i += 3) {
        const float off = noise * ((float)(i * 7919u % 101u) / 50.0f - 1.0f);
        mesh.positions[0][i] = v3_add(mesh.positions[0][i], v3(off, -off, off));
    }
}

static void mark_truth(const struct species_mesh *body, const vec3 *at)
{
    marks.count = 0;
    for (size_t i = 0; i < MARK_COUNT_HERE; i++) {
        struct refit_landmark *mark = &marks.marks[marks.count];
        if (refit_marks_of_template(body, at, mark_names[i], &mark->place)) {
            snprintf(mark->name, MARK_NAME_SIZE, "%s", mark_names[i]);
            marks.count++;
        }
    }
}

static void tell(const char *what, const struct refit_error *e)
{
    print_message("%s: mean %.3f, RMS %.3f, max %.2f %% of length\n", what, 100.0 * (double)e->mean,
                  100.0 * (double)e->rms, 100.0 * (double)e->max);
}

/* Fits the youngest key shape (a fry) to the surface of the adult. Each vertex must end near its
 * true position in the adult. */
static void test_fitting_a_fry_to_the_adult_finds_each_vertex(void **state)
{
    (void)state;
    struct refit_result result;
    loft_otherwise("assets/species/wakin.txt");
    const uint32_t n = species_wakin.card.key_count, adult = n - 1;
    shape_of(&species_wakin.lod[0], n, adult, truth);
    mark_truth(&species_wakin.lod[0], truth);
    make_mesh(adult, 0.0f);
    pack_copy(&species_wakin, &slot);
    refit_key(&slot, 1, &mesh, &marks, &result); /* Shape key 1 is the fry, which is 20 mm long. */
    tell("fry onto adult, fit to mesh", &result.to_mesh);
    tell("fry onto adult, mesh to fit", &result.from_mesh);
    shape_of(&slot.species.lod[0], n, 1, positions);
    double squares = 0.0;
    float max = 0.0f;
    for (uint32_t i = 0; i < slot.species.lod[0].vertex_count; i++) {
        const float off = v3_length(v3_sub(positions[i], truth[i]));
        squares += (double)off * (double)off;
        max = fmaxf(max, off);
    }
    const double rms = sqrt(squares / slot.species.lod[0].vertex_count);
    print_message("each vertex to its true place: RMS %.3f, max %.2f %% of length\n", 100.0 * rms,
                  100.0 * (double)max);
    assert_true(result.to_mesh.mean < 0.002f && result.from_mesh.mean < 0.005f);
    assert_true(result.from_mesh.max < 0.03f);
    assert_true(rms < 0.02);
}

static void test_one_species_is_fitted_to_another(void **state)
{
    (void)state;
    struct refit_result result;
    const struct species *perch = NULL;
    for (uint32_t i = 0; i < species_table_count; i++) {
        perch = strcmp(species_table[i]->card.id, "kurodai") == 0 ? species_table[i] : perch;
    }
    assert_non_null(perch);
    loft_otherwise("assets/species/wakin.txt");
    const uint32_t n = species_wakin.card.key_count;
    char fault[VALIDATE_WHY_SIZE] = "";
    pack_copy(perch, &slot);
    for (uint32_t key = 0; key < perch->card.key_count; key++) {
        shape_of(&species_wakin.lod[0], n, key + n - perch->card.key_count, truth);
        mark_truth(&species_wakin.lod[0], truth);
        make_mesh(key + n - perch->card.key_count, 0.0f);
        refit_key(&slot, key, &mesh, &marks, &result);
        tell("kurodai onto wakin, fit to mesh", &result.to_mesh);
        tell("kurodai onto wakin, mesh to fit", &result.from_mesh);
        assert_true(result.to_mesh.mean < 0.003f && result.from_mesh.mean < 0.005f);
        assert_true(result.from_mesh.max < 0.04f);
    }
    if (!species_validate(&slot.species, fault)) {
        fail_msg("%s", fault);
    }
}

/* Adds a hair to the mesh: a triangle without area between one vertex and a tip far away. The
 * fitted fish does not reach the tip, so the fit error must include the distance to the tip. */
static void test_the_fit_error_covers_every_vertex(void **state)
{
    (void)state;
    struct refit_result result;
    for (uint32_t corner = 0; corner < 3; corner++) {
        loft_otherwise("assets/species/wakin.txt");
        shape_of(&species_wakin.lod[0], species_wakin.card.key_count, 0, truth);
        mark_truth(&species_wakin.lod[0], truth);
        make_mesh(0, 0.0f);
        const uint32_t tip = mesh.vertex_count++, root = mesh.triangles[0][0];
        const uint32_t hair = mesh.triangle_count++;
        for (uint32_t k = 0; k < 3; k++) {
            mesh.triangles[hair][k] = k == corner ? tip : root;
        }
        mesh.positions[0][tip] = v3_add(mesh.positions[0][root], v3(0.0f, 0.3f, 0.0f));
        mesh.groups[hair] = mesh.groups[0];
        pack_copy(&species_wakin, &slot);
        refit_key(&slot, 0, &mesh, &marks, &result);
        /* Of each triangle, only the corner `hair % 3` attracts the fish. If the tip is another
         * corner, the fish stays away from the tip, and the error is more than 0.1. */
        assert_true(corner == hair % 3 || result.from_mesh.max > 0.1f);
    }
}

static void test_a_landmark_off_the_mesh_is_reported(void **state)
{
    (void)state;
    struct refit_result result;
    loft_otherwise("assets/species/wakin.txt");
    shape_of(&species_wakin.lod[0], species_wakin.card.key_count, 0, truth);
    mark_truth(&species_wakin.lod[0], truth);
    make_mesh(0, 0.0f);
    pack_copy(&species_wakin, &slot);
    refit_key(&slot, 0, &mesh, &marks, &result);
    assert_true(result.stray_gap < 0.02f);
    marks.marks[3].place.y += 0.4f;
    refit_key(&slot, 0, &mesh, &marks, &result);
    assert_string_equal(result.stray, marks.marks[3].name);
    assert_true(result.stray_gap > 0.1f && result.stray_gap <= 0.42f);
}

static void test_scan_noise_is_averaged(void **state)
{
    (void)state;
    struct refit_result clean, noisy;
    loft_otherwise("assets/species/wakin.txt");
    const uint32_t n = species_wakin.card.key_count;
    shape_of(&species_wakin.lod[0], n, n - 1, truth);
    mark_truth(&species_wakin.lod[0], truth);
    pack_copy(&species_wakin, &slot);
    make_mesh(n - 1, 0.0f);
    refit_key(&slot, 1, &mesh, &marks, &clean);
    make_mesh(n - 1, 0.005f);
    pack_copy(&species_wakin, &slot);
    refit_key(&slot, 1, &mesh, &marks, &noisy);
    tell("with 0.5 % noise, fit to mesh", &noisy.to_mesh);
    make_mesh(n - 1, 0.0f);
    assert_true(noisy.to_mesh.mean < clean.to_mesh.mean + 0.002f);
}

static void test_meshes_without_parts_are_fitted(void **state)
{
    (void)state;
    struct refit_result result;
    loft_otherwise("assets/species/wakin.txt");
    const uint32_t n = species_wakin.card.key_count;
    shape_of(&species_wakin.lod[0], n, n - 1, truth);
    mark_truth(&species_wakin.lod[0], truth);
    make_mesh(n - 1, 0.0f);
    for (uint32_t part = 0; part < PART_COUNT; part++) {
        snprintf(mesh.group_names[part], IMPORT_NAME_SIZE, "mesh");
    }
    pack_copy(&species_wakin, &slot);
    refit_key(&slot, 1, &mesh, &marks, &result);
    tell("without parts, fit to mesh", &result.to_mesh);
    tell("without parts, mesh to fit", &result.from_mesh);
    assert_true(result.to_mesh.mean < 0.003f && result.from_mesh.mean < 0.006f);
}

static void test_the_warp_moves_landmarks_to_their_targets(void **state)
{
    (void)state;
    const vec3 from[5] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
    vec3 to[5], points[5];
    memcpy(points, from, sizeof from);
    refit_marks_warp(from, from, 5, points, 5);
    for (int i = 0; i < 5; i++) {
        assert_true(v3_length(v3_sub(points[i], from[i])) < 1e-5f);
        to[i] = v3(2.0f * from[i].x + 0.1f * from[i].y, from[i].y - 3.0f, from[i].z * from[i].z);
    }
    refit_marks_warp(from, to, 5, points, 5);
    for (int i = 0; i < 5; i++) {
        assert_true(v3_length(v3_sub(points[i], to[i])) < 3e-3f);
    }
}

static void test_the_tree_finds_the_same_point_as_brute_force(void **state)
{
    (void)state;
    static struct refit_tree tree, one;
    uint32_t random = 12345;
    for (uint32_t i = 0; i < 500; i++) {
        vec3 corner[3];
        for (int k = 0; k < 9; k++) {
            random = random * 1664525u + 1013904223u;
            (&corner[0].x)[k] = (float)(random >> 8) / 16777216.0f + (float)(i % 10) * 0.3f;
        }
        refit_tree_add(&tree, corner[0], corner[1], corner[2], (uint8_t)(i % 3));
    }
    refit_tree_build(&tree);
    for (uint32_t q = 0; q < 200; q++) {
        vec3 at, best_at;
        float best = INFINITY;
        random = random * 1664525u + 1013904223u;
        const vec3 p = v3((float)(random >> 8) / 4e6f, (float)(q % 17) / 5.0f, 0.7f);
        const uint8_t part = q % 4 == 3 ? REFIT_TREE_ANY_PART : (uint8_t)(q % 4);
        for (uint32_t i = 0; i < tree.triangle_count; i++) {
            const struct refit_tree_triangle *t = &tree.triangles[i];
            one.triangle_count = 0;
            refit_tree_add(&one, t->corner[0], t->corner[1], t->corner[2], t->part);
            refit_tree_build(&one);
            best = fminf(best, refit_tree_nearest(&one, p, part, &best_at));
        }
        assert_float_equal(refit_tree_nearest(&tree, p, part, &at), best, 1e-6f);
    }
}

static void test_invalid_landmarks_are_reported_with_their_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *complaint;
    } cases[] = {
        { "", ":0: at least four landmarks" },
        { "snout 0 0\n", ":1: expected NAME X Y Z" },
        { "snout 0 0 nan\n", ":1: expected NAME X Y Z" },
        { "snout 0 0 1 2\n", ":1: expected NAME X Y Z" },
        { "# head\nnose 0 0 1\n", ":2: unknown landmark" },
        { "_\n", ":1: unknown landmark" },
        { "dorsal 0 0 1\n", ":1: unknown landmark" },
        { "snout 0 0 1\ntail_root 0 0 1\nback 0 0 1\n", ":3: at least four landmarks" },
    };
    char path[] = "/tmp/kingyo-marks-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        FILE *out = fopen(path, "w");
        fputs(cases[i].text, out);
        fclose(out);
        assert_int_equal(refit_marks_read(path, &marks, why), EXIT_BAD_DATA);
        if (!strstr(why, cases[i].complaint)) {
            fail_msg("'%s' and not '%s'", why, cases[i].complaint);
        }
    }
    FILE *out = fopen(path, "w");
    for (size_t i = 0; i < MARK_COUNT_HERE; i++) {
        fprintf(out, " %s\t%zu 0.5 -1e-3 # here\n", mark_names[i], i);
    }
    fclose(out);
    assert_int_equal(refit_marks_read(path, &marks, why), EXIT_OK);
    assert_int_equal(marks.count, MARK_COUNT_HERE);
    for (uint32_t i = 0; i < marks.count; i++) {
        assert_string_equal(marks.marks[i].name, mark_names[i]);
        assert_float_equal(marks.marks[i].place.x, (float)i, 0.0f);
    }
    out = fopen(path, "w");
    fprintf(out, "snout 0 0 %0300d\n", 1); /* A line that is too long must be rejected instead of
                                              split. */
    fclose(out);
    assert_int_equal(refit_marks_read(path, &marks, why), EXIT_BAD_DATA);
    assert_non_null(strstr(why, ":1: the line is longer than 255 characters"));
    assert_int_equal(truncate(path, 0) | truncate(path, 65537), 0);
    assert_int_equal(refit_marks_read(path, &marks, why), EXIT_BAD_DATA);
    assert_non_null(strstr(why, ": larger than 64 KiB"));
    unlink(path);
    assert_int_equal(refit_marks_read(path, &marks, why), EXIT_IO);
    assert_int_equal(refit_marks_read("/dev/zero", &marks, why), EXIT_IO);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fitting_a_fry_to_the_adult_finds_each_vertex),
        cmocka_unit_test(test_one_species_is_fitted_to_another),
        cmocka_unit_test(test_the_fit_error_covers_every_vertex),
        cmocka_unit_test(test_a_landmark_off_the_mesh_is_reported),
        cmocka_unit_test(test_scan_noise_is_averaged),
        cmocka_unit_test(test_meshes_without_parts_are_fitted),
        cmocka_unit_test(test_the_warp_moves_landmarks_to_their_targets),
        cmocka_unit_test(test_the_tree_finds_the_same_point_as_brute_force),
        cmocka_unit_test(test_invalid_landmarks_are_reported_with_their_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
