/* test_proportions.c -- compares measurements of each key's mesh with known proportions of the real
 * fish, which are in the table of proportions.h. The tolerances are at least 1 % of the length for
 * positions, and 10 degrees for angles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/morph/morph.h"
#include "tests/unit/support/proportions.h"

#define FLOOR 0.01f
#define FLOOR_DEG 10.0f
/* Position of the edge of the gill cover along the body (0 is the snout, 1 is the tail root). */
#define GILL_U 0.30f
/* Position along the body at which the caudal peduncle (the narrow part before the tail) begins. */
#define STALK_FROM 0.70f
/* Fraction of a ray's maximum width. The disc of the ray ends and its whip tail begins where the
 * width falls below this fraction. */
#define DISC_END 0.15f
/* Distance from the snout, in lengths, at which the opening angle of a ray's outline is
 * measured. */
#define SNOUT_Z 0.20f

/* A fish to be measured: one key of the detailed mesh, with its snout at z = 0. All values are
 * divided by the fish's length `unit`. */
struct specimen {
    const struct species_mesh *mesh;
    uint32_t key;
    float unit;
    vec3 at[MESH_VERTEX_MAX];
};

static const struct species *species_named(const char *id)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(species_table[i]->card.id, id) == 0) {
            return species_table[i];
        }
    }
    fail_msg("no species %s", id);
    return NULL;
}

static uint32_t key_named(const struct species_card *card, const char *name)
{
    for (uint32_t key = 0; key < card->key_count; key++) {
        if (strcmp(card->key_names[key], name) == 0) {
            return key;
        }
    }
    fail_msg("%s has no key %s", card->id, name);
    return 0;
}

static vec3 grid(const struct specimen *fish, uint32_t ring, uint32_t spoke)
{
    const struct species_mesh *mesh = fish->mesh;
    return fish->at[mesh->grid_first + ring * (mesh->grid_spokes + 1u) + spoke];
}

static float ring_depth(const struct specimen *fish, uint32_t ring)
{
    return grid(fish, ring, 0).y - grid(fish, ring, fish->mesh->grid_spokes / 2u).y;
}

static float ring_width(const struct specimen *fish, uint32_t ring)
{
    float right = 0.0f, left = 0.0f;
    for (uint32_t spoke = 0; spoke < fish->mesh->grid_spokes; spoke++) {
        right = f_max(right, grid(fish, ring, spoke).x);
        left = f_min(left, grid(fish, ring, spoke).x);
    }
    return right - left;
}

static struct specimen *specimen_of(const struct known *known)
{
    static struct specimen fish;
    static struct morph_pose pose;
    const struct species *species = species_named(known->species);
    const uint32_t key_count = species->card.key_count;
    fish.mesh = &species->lod[0];
    fish.key = key_named(&species->card, known->key);
    morph_key_pose(fish.mesh, key_count, fish.key, &pose);
    morph_shape(fish.mesh, key_count, &pose, fish.at, NULL);
    for (uint32_t i = 0; i < fish.mesh->vertex_count; i++) {
        fish.at[i].z += 0.5f;
    }
    const uint8_t measure = species->card.measure;
    fish.unit = 1.0f;
    if (measure == MEASURE_TOTAL && species->card.form != FORM_EEL) {
        fish.unit = grid(&fish, fish.mesh->grid_rings - 1u, 0).z;
    }
    return &fish;
}

static void measure_body(const struct specimen *fish, float of[FIELD_COUNT])
{
    const uint32_t rings = fish->mesh->grid_rings, row = fish->mesh->grid_spokes + 1u;
    const float root = grid(fish, rings - 1u, 0).z;
    of[F_stalk] = of[F_waist] = 1.0f;
    for (uint32_t ring = 0; ring < rings; ring++) {
        const float depth = ring_depth(fish, ring), z = grid(fish, ring, 0).z;
        if (depth > of[F_depth]) {
            of[F_depth] = depth;
            of[F_depth_at] = z;
        }
        of[F_width] = f_max(of[F_width], ring_width(fish, ring));
        if (z > STALK_FROM * root) {
            of[F_stalk] = f_min(of[F_stalk], depth);
        }
        if (z < 0.6f * root) {
            of[F_waist] = depth;
        }
        const float u = fish->mesh->vertices[fish->mesh->grid_first + ring * row].u;
        if (u <= GILL_U + 1e-5f) {
            of[F_head] = z;
        }
    }
}

static bool of_right_eye(const struct species_vertex *vertex)
{
    return vertex->part == PART_EYE && vertex->side == SIDE_RIGHT;
}

/* Returns by how many degrees the right eye has moved over the back toward the left side since the
 * first key (90 at the middle of the back). The angle is computed from the girth coordinate of the
 * eye's anchor. */
static float turn_deg(const struct specimen *fish, uint8_t anchor)
{
    const float *round = fish->mesh->anchors[anchor].v;
    return 90.0f * (1.0f - round[fish->key] / round[0]);
}

/* Measures an eye, which is a sphere of rings of vertices around its line of sight. The widest ring
 * gives the diameter and the centre of the eye. */
static void measure_eye(const struct specimen *fish, float of[FIELD_COUNT])
{
    const struct species_vertex *vertices = fish->mesh->vertices;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        for (uint32_t j = 0; of_right_eye(&vertices[i]) && j < i; j++) {
            const float across = v3_length(v3_sub(fish->at[i], fish->at[j]));
            if (of_right_eye(&vertices[j]) && vertices[i].u == vertices[j].u &&
                across > of[F_eye]) {
                of[F_eye_out] = 0.5f * (fish->at[i].x + fish->at[j].x);
                of[F_eye] = across;
                of[F_eye_x] = 0.5f * (fish->at[i].z + fish->at[j].z);
                of[F_eye_y] = 0.5f * (fish->at[i].y + fish->at[j].y);
            }
        }
        if (of_right_eye(&vertices[i]) && vertices[i].u == 0.0f) {
            of[F_turn_deg] = turn_deg(fish, vertices[i].anchor);
        }
    }
}

/* Measures where the base of a fin starts and ends along the body, and how long its longest ray
 * is. */
static void measure_fin(const struct specimen *fish, uint8_t part, float *start, float *end,
                        float *length)
{
    vec3 root = v3(0.0f, 0.0f, 0.0f);
    *start = 10.0f;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        const struct species_vertex *vertex = &fish->mesh->vertices[i];
        if (vertex->part != part || vertex->side == SIDE_LEFT) {
            continue;
        }
        if (vertex->v == 0.0f) {
            root = fish->at[i];
            *start = f_min(*start, root.z);
            *end = f_max(*end, root.z);
        }
        *length = f_max(*length, v3_length(v3_sub(fish->at[i], root)));
    }
}

static void measure_tail(const struct specimen *fish, float of[FIELD_COUNT])
{
    const float root = grid(fish, fish->mesh->grid_rings - 1u, 0).z;
    float tip = 0.0f, notch = 10.0f, top = -1.0f, bottom = 1.0f;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        const struct species_vertex *vertex = &fish->mesh->vertices[i];
        if (vertex->part == PART_TAIL && vertex->v == 1.0f) {
            tip = f_max(tip, fish->at[i].z);
            notch = f_abs(vertex->u - 0.5f) < 0.01f ? fish->at[i].z : notch;
            top = f_max(top, fish->at[i].y);
            bottom = f_min(bottom, fish->at[i].y);
        }
    }
    of[F_tail] = tip - root;
    /* Depth of the fork as a fraction of the tail's length. The fraction is multiplied by `unit`,
     * because all values are divided by `unit` later. */
    of[F_fork] = (tip - notch) / (tip - root) * fish->unit;
    of[F_span] = top - bottom;
}

/* Returns the position along the body, behind the widest point, at which the body seen from above
 * has the width `width`. */
static float narrows_at(const struct specimen *fish, float width)
{
    uint32_t ring = fish->mesh->grid_rings - 1u;
    while (ring > 0 && ring_width(fish, ring) < width) {
        ring--;
    }
    if (ring + 1u == fish->mesh->grid_rings) {
        return grid(fish, ring, 0).z;
    }
    const float w = ring_width(fish, ring), next = ring_width(fish, ring + 1u);
    return f_lerp(grid(fish, ring, 0).z, grid(fish, ring + 1u, 0).z, (w - width) / (w - next));
}

static void measure_disc(const struct specimen *fish, float of[FIELD_COUNT])
{
    uint32_t ring = 0;
    while (ring + 1u < fish->mesh->grid_rings && grid(fish, ring, 0).z < SNOUT_Z) {
        ring++;
    }
    const float half = 0.5f * ring_width(fish, ring), z = grid(fish, ring, 0).z;
    of[F_snout_deg] = 2.0f * f_atan2(half, z) / F_DEG;
    of[F_disc] = narrows_at(fish, DISC_END * of[F_width]);
    of[F_whip] = grid(fish, fish->mesh->grid_rings - 1u, 0).z - of[F_disc];
    if (of[F_whip] > 0.0f) {
        /* Position of the sting as a fraction of the whip tail. The fraction is multiplied by
         * `unit`, because all values are divided by `unit` later. */
        of[F_sting] = (of[F_dorsal_start] - of[F_disc]) / of[F_whip] * fish->unit;
    }
}

static bool is_angle(uint32_t field)
{
    return field == F_turn_deg || field == F_snout_deg;
}

static void measure(const struct specimen *fish, float of[FIELD_COUNT])
{
    float end = 0.0f;
    memset(of, 0, FIELD_COUNT * sizeof *of);
    measure_body(fish, of);
    measure_eye(fish, of);
    measure_fin(fish, PART_DORSAL, &of[F_dorsal_start], &of[F_dorsal_end], &of[F_dorsal_height]);
    measure_fin(fish, PART_DORSAL_2, &of[F_dorsal2_start], &of[F_dorsal2_end],
                &of[F_dorsal2_height]);
    measure_fin(fish, PART_ANAL, &of[F_anal_start], &of[F_anal_end], &of[F_anal_height]);
    measure_fin(fish, PART_PECTORAL, &of[F_pectoral_at], &end, &of[F_pectoral]);
    measure_fin(fish, PART_PELVIC, &of[F_pelvic_at], &of[F_pelvic_end], &of[F_pelvic]);
    measure_tail(fish, of);
    measure_disc(fish, of);
    for (uint32_t i = 0; i < FIELD_COUNT; i++) {
        of[i] /= is_angle(i) ? 1.0f : fish->unit;
    }
}

/* Returns how many known values `fish` misses. Prints each missed value if `tell` is true. */
static uint32_t count_missed(const struct known *known, const struct specimen *fish, bool tell)
{
    float of[FIELD_COUNT];
    uint32_t missed = 0;
    measure(fish, of);
    for (uint32_t i = 0; i < FIELD_COUNT; i++) {
        const float want = known->of[i];
        const float leave = f_max(known->tolerance * want, is_angle(i) ? FLOOR_DEG : FLOOR);
        if (want != 0.0f && !(f_abs(of[i] - want) <= leave)) {
            missed++;
            if (tell) {
                print_message("# %s %s: %s is %.3f, should be %.3f within %.3f\n", known->species,
                              known->key, field_names[i], (double)of[i], (double)want,
                              (double)leave);
            }
        }
    }
    return missed;
}

static void check_species(const char *id, uint32_t row_count)
{
    uint32_t missed = 0, rows = 0;
    for (uint32_t i = 0; i < ROW_COUNT; i++) {
        if (strcmp(table[i].species, id) == 0) {
            missed += count_missed(&table[i], specimen_of(&table[i]), true);
            rows++;
        }
    }
    assert_int_equal(rows, row_count);
    assert_int_equal(missed, 0);
}

static void test_wakin_has_the_proportions_of_a_goldfish(void **state)
{
    (void)state;
    check_species("wakin", 5);
}

static void test_kurodai_has_the_proportions_of_a_sea_bream(void **state)
{
    (void)state;
    check_species("kurodai", 4);
}

static void test_shimafugu_has_the_proportions_of_a_puffer(void **state)
{
    (void)state;
    check_species("shimafugu", 4);
}

static void test_kuroanago_has_the_proportions_of_a_conger(void **state)
{
    (void)state;
    check_species("kuroanago", 5);
}

static void test_hirame_has_the_proportions_of_a_flatfish(void **state)
{
    (void)state;
    check_species("hirame", 4);
}

static void test_mebachi_has_the_proportions_of_a_tuna(void **state)
{
    (void)state;
    check_species("mebachi", 3);
}

static void test_ray_has_the_proportions_of_a_stingray(void **state)
{
    (void)state;
    check_species("ray", 2);
}

/* Shows that the comparison can fail. A fish that is made 40 % deeper must miss at least one value,
 * and a fish that is made 40 % shorter must miss at least three. */
static void test_the_check_detects_a_fish_out_of_proportion(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < ROW_COUNT; i++) {
        struct specimen *fish = specimen_of(&table[i]);
        for (uint32_t j = 0; j < fish->mesh->vertex_count; j++) {
            fish->at[j].y *= 1.4f;
        }
        assert_true(count_missed(&table[i], fish, false) >= 1);
        fish = specimen_of(&table[i]);
        fish->unit *= 1.4f;
        assert_true(count_missed(&table[i], fish, false) >= 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wakin_has_the_proportions_of_a_goldfish),
        cmocka_unit_test(test_kurodai_has_the_proportions_of_a_sea_bream),
        cmocka_unit_test(test_shimafugu_has_the_proportions_of_a_puffer),
        cmocka_unit_test(test_kuroanago_has_the_proportions_of_a_conger),
        cmocka_unit_test(test_hirame_has_the_proportions_of_a_flatfish),
        cmocka_unit_test(test_mebachi_has_the_proportions_of_a_tuna),
        cmocka_unit_test(test_ray_has_the_proportions_of_a_stingray),
        cmocka_unit_test(test_the_check_detects_a_fish_out_of_proportion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
