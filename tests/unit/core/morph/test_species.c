/* test_species.c -- checks the meshes of the built-in species: completeness, orientation, and the
 * proportions of the species text. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/morph.h"

/* Ratio of the total length of a goldfish to its standard length, which excludes the tail fin. */
#define TOTAL_PER_STANDARD 1.27f
#define DEPTH_TOLERANCE 0.05f
/* Tolerance for the symmetry of the two flanks. The mesh for distant fish has large cells, and both
 * flanks are cut into triangles in the same direction. The fin roots of the two flanks therefore
 * differ slightly. */
#define ROOT_APART 1e-3f
#define COUNT (1.0f / 32767.0f) /* One step of the coordinates in the tables of the mesh. */

static const struct species *const wakin = &species_wakin;

/* Shape of one key in one level of detail, with its anchors applied. */
struct shape {
    const struct species *species;
    const struct species_mesh *mesh;
    uint32_t key;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
};

static const struct shape *shape_of(const struct species *species, uint32_t lod, uint32_t key)
{
    static struct shape shape;
    static struct morph_pose pose;
    const uint32_t key_count = species->card.key_count;
    shape.species = species;
    shape.mesh = &species->lod[lod];
    shape.key = key;
    morph_key_pose(shape.mesh, key_count, key, &pose);
    morph_shape(shape.mesh, key_count, &pose, shape.positions, shape.normals);
    return &shape;
}

/* Calls `check` for every key of every level of detail of a species. */
static void each_shape_of(const struct species *species, void (*check)(const struct shape *shape))
{
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        for (uint32_t key = 0; key < species->card.key_count; key++) {
            check(shape_of(species, lod, key));
        }
    }
}

static void each_wakin(void (*check)(const struct shape *shape))
{
    each_shape_of(wakin, check);
}

static void each_shape(void (*check)(const struct shape *shape))
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        each_shape_of(species_table[i], check);
    }
}

struct face {
    vec3 corner[3];
    /* Normal of the face. It points outward, and its length is twice the area of the face. */
    vec3 twice_area;
    uint8_t part;
};

static struct face face_at(const struct shape *shape, uint32_t index)
{
    struct face face;
    for (uint32_t k = 0; k < 3; k++) {
        face.corner[k] = shape->positions[shape->mesh->indices[index + k]];
    }
    face.twice_area =
        v3_cross(v3_sub(face.corner[1], face.corner[0]), v3_sub(face.corner[2], face.corner[0]));
    face.part = shape->mesh->vertices[shape->mesh->indices[index]].part;
    return face;
}

static void test_levels_of_detail_keep_their_vertex_budgets(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        assert_in_range(species_table[i]->lod[0].vertex_count, 400, 860);
        assert_in_range(species_table[i]->lod[1].vertex_count, 80, 240);
    }
    assert_in_range(wakin->lod[0].vertex_count, 600, 780);
    assert_in_range(wakin->lod[1].vertex_count, 120, 170);
}

static void check_triangles(const struct shape *shape)
{
    const struct species_mesh *mesh = shape->mesh;
    assert_int_equal(mesh->index_count % 3, 0);
    for (uint32_t i = 0; i < mesh->index_count; i++) {
        assert_in_range(mesh->indices[i], 0, mesh->vertex_count - 1);
        const struct species_vertex *vertex = &mesh->vertices[mesh->indices[i]];
        assert_int_equal(vertex->part, mesh->vertices[mesh->indices[i - i % 3]].part);
    }
}

static void test_triangles_use_existing_vertices_of_one_part(void **state)
{
    (void)state;
    each_shape(check_triangles);
}

static void check_length(const struct shape *shape)
{
    float front = 1.0f, rear = -1.0f;
    for (uint32_t i = 0; i < shape->mesh->vertex_count; i++) {
        front = f_min(front, shape->positions[i].z);
        rear = f_max(rear, shape->positions[i].z);
    }
    assert_float_equal(front, -0.5f, COUNT);
    assert_float_equal(rear, 0.5f, 0.01f);
}

static void test_each_key_has_length_1_from_snout_to_tail_tip(void **state)
{
    (void)state;
    each_wakin(check_length);
}

static void check_normals(const struct shape *shape)
{
    for (uint32_t i = 0; i < shape->mesh->vertex_count; i++) {
        assert_float_equal(v3_length(shape->normals[i]), 1.0f, 1e-5f);
    }
    for (uint32_t i = 0; i < shape->mesh->index_count; i += 3) {
        const struct face face = face_at(shape, i);
        for (uint32_t k = 0; k < 3 && face.part < PART_TAIL; k++) {
            const vec3 normal = shape->normals[shape->mesh->indices[i + k]];
            assert_true(v3_dot(normal, face.twice_area) > 0.0f);
        }
    }
}

static void test_normals_have_unit_length_and_face_outward(void **state)
{
    (void)state;
    each_shape(check_normals);
}

static void check_area(const struct shape *shape)
{
    for (uint32_t i = 0; i < shape->mesh->index_count; i += 3) {
        assert_true(v3_length(face_at(shape, i).twice_area) > 1e-7f);
    }
}

static void test_no_triangle_is_degenerate_in_any_key(void **state)
{
    (void)state;
    each_shape(check_area);
}

/* If the triangles were wound in the wrong direction, the volume would be negative. If the mesh had
 * a hole, the volume would differ much from that of an ellipsoid of this size, which is about
 * 0.015. */
static void check_volume(const struct shape *shape)
{
    float volume = 0.0f;
    for (uint32_t i = 0; i < shape->mesh->index_count; i += 3) {
        const struct face face = face_at(shape, i);
        if (face.part == PART_BODY) {
            volume += v3_dot(face.corner[0], face.twice_area) / 6.0f;
        }
    }
    assert_true(volume > 0.005f && volume < 0.03f);
}

static void test_the_body_encloses_a_positive_volume(void **state)
{
    (void)state;
    each_wakin(check_volume);
}

static void check_closed(const struct shape *shape)
{
    vec3 sum = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < shape->mesh->index_count; i += 3) {
        const struct face face = face_at(shape, i);
        sum = v3_add(sum, face.twice_area);
    }
    assert_true(v3_length(sum) < 1e-5f);
}

static void test_body_and_eyes_are_closed_and_fins_have_two_sides(void **state)
{
    (void)state;
    each_shape(check_closed);
}

static void check_mirror(const struct shape *shape)
{
    float right = 0.0f, left = 0.0f;
    for (uint32_t i = 0; i < shape->mesh->vertex_count; i++) {
        const uint8_t part = shape->mesh->vertices[i].part;
        if (part != PART_TAIL && part != PART_DORSAL && part != PART_ANAL) {
            right = f_max(right, shape->positions[i].x);
            left = f_min(left, shape->positions[i].x);
        }
    }
    assert_float_equal(right, -left, ROOT_APART);
    assert_true(right > 0.05f);
}

static void test_eyes_flanks_and_paired_fins_are_symmetric(void **state)
{
    (void)state;
    each_wakin(check_mirror);
}

static float body_depth(const struct shape *shape)
{
    float top = -1.0f, bottom = 1.0f;
    for (uint32_t i = 0; i < shape->mesh->vertex_count; i++) {
        if (shape->mesh->vertices[i].part == PART_BODY) {
            top = f_max(top, shape->positions[i].y);
            bottom = f_min(bottom, shape->positions[i].y);
        }
    }
    return top - bottom;
}

static void test_the_stages_have_the_depth_of_goldfish_of_their_length(void **state)
{
    (void)state;
    const float depth_per_standard[] = { 0.0f, 0.31f, 0.35f, 0.37f, 0.41f };
    /* The larva (key 0) is skipped, because its tail fin is too short for TOTAL_PER_STANDARD. */
    for (uint32_t key = 1; key < 5; key++) {
        const float depth = body_depth(shape_of(wakin, 0, key)) * TOTAL_PER_STANDARD;
        assert_float_equal(depth, depth_per_standard[key], DEPTH_TOLERANCE * depth);
    }
}

static float width_from_above(const struct shape *shape, uint8_t part)
{
    float right = -1.0f, left = 1.0f;
    for (uint32_t i = 0; i < shape->mesh->vertex_count; i++) {
        if (shape->mesh->vertices[i].part == part) {
            right = f_max(right, shape->positions[i].x);
            left = f_min(left, shape->positions[i].x);
        }
    }
    return right - left;
}

/* Returns the area of `part` that is visible from the direction `eye`. Only the triangles that face
 * the eye count. This is enough, because fins have triangles on both sides. */
static float seen_area(const struct shape *shape, uint8_t part, vec3 eye)
{
    float area = 0.0f;
    for (uint32_t i = 0; i < shape->mesh->index_count; i += 3) {
        const struct face face = face_at(shape, i);
        if (face.part == part) {
            area += 0.5f * f_max(v3_dot(face.twice_area, eye), 0.0f);
        }
    }
    return area;
}

static void check_fins_from_above(const struct shape *shape)
{
    if (shape->key == 0) {
        /* The larva is skipped, because its tail is a flat fold, and no larva swims in the kiosk's
         * tanks. */
        return;
    }
    const vec3 side = v3(1.0f, 0.0f, 0.0f);
    const vec3 above[] = { v3(0.0f, 1.0f, 0.0f), v3(0.6f, 0.8f, 0.0f), v3(-0.6f, 0.8f, 0.0f) };
    const float tail = seen_area(shape, PART_TAIL, side);
    for (int i = 0; i < 3; i++) {
        assert_true(seen_area(shape, PART_TAIL, above[i]) > 0.3f * tail);
    }
    assert_true(width_from_above(shape, PART_PECTORAL) >
                width_from_above(shape, PART_BODY) + 0.04f);
}

/* A flat horizontal tail would look like a line from the side, and a flat vertical tail would look
 * like a line from above. The tail of each fish must be visible from all these directions. */
static void test_tail_and_pectorals_are_visible_from_above_and_from_each_slant(void **state)
{
    (void)state;
    each_wakin(check_fins_from_above);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_levels_of_detail_keep_their_vertex_budgets),
        cmocka_unit_test(test_triangles_use_existing_vertices_of_one_part),
        cmocka_unit_test(test_each_key_has_length_1_from_snout_to_tail_tip),
        cmocka_unit_test(test_normals_have_unit_length_and_face_outward),
        cmocka_unit_test(test_no_triangle_is_degenerate_in_any_key),
        cmocka_unit_test(test_the_body_encloses_a_positive_volume),
        cmocka_unit_test(test_body_and_eyes_are_closed_and_fins_have_two_sides),
        cmocka_unit_test(test_eyes_flanks_and_paired_fins_are_symmetric),
        cmocka_unit_test(test_the_stages_have_the_depth_of_goldfish_of_their_length),
        cmocka_unit_test(test_tail_and_pectorals_are_visible_from_above_and_from_each_slant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
