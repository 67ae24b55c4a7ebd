/* test_poi_pool.c -- Tests the pool of water that is drawn on a poi: its level surface, its volume
 * and its position. Also tests the refraction around a poi that crosses the water surface, and the
 * flaps of torn paper. */
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/pass/poi_pass.h"

#define RADIUS_M 0.040f
#define FINE 160

static struct scene_poi poi_with(float water_m, float pitch_deg, float roll_deg, float sag_m)
{
    return (struct scene_poi){
        .present = 1,
        .position_m = v3(0.1f, 0.07f, -0.05f),
        .angles = { 0.7f, pitch_deg * F_DEG, roll_deg * F_DEG },
        .ring_radius_m = RADIUS_M,
        .sag_m = sag_m,
        .water_m = water_m,
    };
}

/* Returns the height of the paper at the point (x, z) of its disc, as the vertex shader computes
 * it. x and z are in radii. */
static float height_m(const struct scene_poi *poi, float x, float z)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 local = v3(RADIUS_M * x, -poi->sag_m * (1.0f - x * x - z * z), RADIUS_M * z);
    return v3_add(poi->position_m, vec_basis_to_world(&axes, local)).y;
}

/* Returns the mean depth of the drawn water over the disc. The test samples a grid of its own, so
 * that it does not repeat errors of the tested module. */
static float drawn_m(const struct scene_poi *poi, const struct poi_pool *pool)
{
    double sum = 0.0;
    uint32_t count = 0;
    for (int i = 0; i < FINE * FINE; i++) {
        const float x = 2.0f * ((float)(i % FINE) + 0.5f) / (float)FINE - 1.0f;
        const float z = 2.0f * ((float)(i / FINE) + 0.5f) / (float)FINE - 1.0f;
        if (x * x + z * z <= 1.0f) {
            sum += (double)f_max(pool->level_m - height_m(poi, x, z), 0.0f);
            count++;
        }
    }
    return (float)(sum / (double)count) + pool->film_m;
}

static void test_a_dry_poi_has_no_pool(void **state)
{
    (void)state;
    const struct scene_poi poi = poi_with(0.0f, 0.0f, 0.0f, 0.002f);
    const struct poi_pool pool = poi_pool_of(&poi);
    assert_float_equal(pool.film_m, 0.0f, 0.0f);
    assert_float_equal(pool.level_m, POI_NO_POOL_M, 0.0f);
}

static void test_a_small_amount_of_water_is_a_film(void **state)
{
    (void)state;
    const struct scene_poi poi = poi_with(0.5f * POI_FILM_M, 10.0f, 0.0f, 0.002f);
    const struct poi_pool pool = poi_pool_of(&poi);
    assert_float_equal(pool.film_m, 0.5f * POI_FILM_M, 1e-9f);
    assert_float_equal(pool.level_m, POI_NO_POOL_M, 0.0f);
}

static void test_the_drawn_volume_equals_the_water_volume_at_any_tilt(void **state)
{
    (void)state;
    static const float waters_m[] = { 0.0008f, 0.0012f, 0.002f, 0.003f };
    static const float tilts_deg[] = { 0.0f, 3.0f, 12.0f, -25.0f, 40.0f, 168.0f, 180.0f };
    for (uint32_t w = 0; w < 4u; w++) {
        for (uint32_t p = 0; p < 7u; p++) {
            for (uint32_t r = 0; r < 7u; r++) {
                const struct scene_poi poi =
                    poi_with(waters_m[w], tilts_deg[p], tilts_deg[r], r % 2u ? 0.003f : 0.0f);
                const struct poi_pool pool = poi_pool_of(&poi);
                const float drawn = drawn_m(&poi, &pool);
                assert_float_equal(drawn, waters_m[w], 0.08f * waters_m[w] + 2e-5f);
            }
        }
    }
}

static void test_a_tilted_pool_moves_to_the_low_side(void **state)
{
    (void)state;
    /* The poi is pitched by 20 degrees, so its far edge is above the level of its pool and its near
     * edge is below this level. */
    const struct scene_poi poi = poi_with(0.0015f, 20.0f, 0.0f, 0.002f);
    const struct poi_pool pool = poi_pool_of(&poi);
    assert_true(height_m(&poi, 0.0f, -0.9f) > pool.level_m);
    assert_true(height_m(&poi, 0.0f, 0.9f) < pool.level_m);
}

static void test_sagging_level_paper_holds_the_pool_in_the_middle(void **state)
{
    (void)state;
    const struct scene_poi poi = poi_with(0.0012f, 0.0f, 0.0f, 0.004f);
    const struct poi_pool pool = poi_pool_of(&poi);
    assert_true(height_m(&poi, 0.0f, 0.0f) < pool.level_m);
    assert_true(height_m(&poi, 0.95f, 0.0f) > pool.level_m);
    assert_true(height_m(&poi, 0.0f, -0.95f) > pool.level_m);
}

/* Returns the share of the refraction at the horizontal offset (x_m, z_m) from the centre of the
 * ring. */
static float share(const struct scene_poi *poi, float x_m, float z_m)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    return poi_refraction_share(poi, &axes, poi->position_m.x + x_m, poi->position_m.z + z_m);
}

static void test_refraction_vanishes_only_where_the_poi_crosses_the_surface(void **state)
{
    (void)state;
    struct scene_poi poi = poi_with(0.0f, 0.0f, 0.0f, 0.0f);
    poi.angles = (struct angles){ .pitch_rad = 60.0f * F_DEG };
    poi.position_m.y = 0.0f;
    /* The left and the right end of the ring are at the surface. Its far and its near end are 3 cm
     * above and below the surface. */
    assert_float_equal(share(&poi, RADIUS_M, 0.0f), 0.0f, 0.001f);
    assert_float_equal(share(&poi, -RADIUS_M, 0.0f), 0.0f, 0.001f);
    assert_float_equal(share(&poi, 0.0f, 0.5f * RADIUS_M), 1.0f, 0.001f);
    assert_float_equal(share(&poi, 0.0f, -0.5f * RADIUS_M), 1.0f, 0.001f);
    assert_float_equal(share(&poi, poi_calm_reach_m(&poi), 0.0f), 1.0f, 0.001f);
    poi.angles = (struct angles){ 0 };
    assert_float_equal(share(&poi, 0.01f, 0.01f), 0.0f, 0.001f);
    poi.position_m.y = -0.05f;
    assert_float_equal(share(&poi, 0.01f, 0.01f), 1.0f, 0.001f);
}

static uint8_t cells[SHEET_SIDE * SHEET_SIDE][4];
static uint8_t ages[SHEET_SIDE * SHEET_SIDE];

/* Returns a poi with whole, half wet paper. */
static struct scene_poi whole_poi(void)
{
    struct scene_poi poi = poi_with(0.0f, 0.0f, 0.0f, 0.0f);
    poi.paper_left = 1.0f;
    memset(poi.wetness, 128, sizeof poi.wetness);
    memset(poi.integrity, 200, sizeof poi.integrity);
    memset(poi.stress, 30, sizeof poi.stress);
    return poi;
}

static void test_whole_paper_has_no_flap(void **state)
{
    (void)state;
    const struct scene_poi poi = whole_poi();
    poi_sheet_cells(&poi, ages, cells);
    for (uint32_t i = 0; i < SHEET_SIDE * SHEET_SIDE; i++) {
        assert_memory_equal(cells[i], ((const uint8_t[4]){ 128, 200, 255, 0 }), 4);
    }
}

static void test_only_paper_that_shows_its_stress_has_stress_in_its_cells(void **state)
{
    (void)state;
    struct scene_poi poi = whole_poi();
    poi.shows_stress = 1;
    poi_sheet_cells(&poi, ages, cells);
    for (uint32_t i = 0; i < SHEET_SIDE * SHEET_SIDE; i++) {
        assert_memory_equal(cells[i], ((const uint8_t[4]){ 128, 200, 255, 30 }), 4);
    }
}

/* Returns a poi with torn paper, whose columns 0 to 3 are whole. */
static struct scene_poi torn_poi(void)
{
    struct scene_poi poi = whole_poi();
    poi.paper_left = 0.3f;
    for (uint32_t cell = 0; cell < SHEET_SIDE * SHEET_SIDE; cell++) {
        poi.integrity[cell] = cell % SHEET_SIDE < 4u ? 200 : 0;
    }
    return poi;
}

/* Returns the number of cells of a poi's paper that are drawn as a hole. */
static uint32_t open_cells(const struct scene_poi *poi)
{
    uint32_t count = 0;
    poi_sheet_cells(poi, ages, cells);
    for (uint32_t i = 0; i < SHEET_SIDE * SHEET_SIDE; i++) {
        count += cells[i][2] < 128;
    }
    return count;
}

static void test_a_hole_opens_from_a_slit_in_a_quarter_of_a_second(void **state)
{
    (void)state;
    const struct scene_poi whole = whole_poi(), torn = torn_poi();
    uint32_t before = 0;
    poi_sheet_age(&whole, 1000u, ages);
    assert_int_equal(open_cells(&whole), 0);
    for (uint32_t tick = 0; tick < POI_OPEN_TICKS; tick++) {
        const uint32_t count = open_cells(&torn);
        assert_true(count >= before);
        before = count;
        if (tick == 0) {
            assert_true(count > 0 && count < 200u);
        }
        poi_sheet_age(&torn, 1u, ages);
    }
    const uint32_t full = open_cells(&torn);
    assert_true(full > before && full > 400u);
    /* A time that went backward, or a long pause, opens the hole completely. */
    memset(ages, 0, sizeof ages);
    poi_sheet_age(&torn, 0u - 7u, ages);
    assert_int_equal(open_cells(&torn), full);
}

static void test_flaps_reach_into_a_hole_but_leave_it_open(void **state)
{
    (void)state;
    const struct scene_poi poi = torn_poi();
    uint32_t holes = 0, covered = 0;
    memset(ages, POI_OPEN_TICKS, sizeof ages);
    poi_sheet_cells(&poi, ages, cells);
    for (uint32_t row = 8; row < 24; row++) {
        assert_int_equal(cells[row * SHEET_SIDE + 3u][2], 255); /* Paper. */
        for (uint32_t column = 4; column < SHEET_SIDE; column++) {
            const uint8_t *const cell = cells[row * SHEET_SIDE + column];
            holes++;
            covered += cell[2] >= 128;
        }
        /* The first cell of the hole is one cell away from the paper. */
        assert_int_equal(cells[row * SHEET_SIDE + 4u][3], 255 / 8);
        assert_true(cells[row * SHEET_SIDE + 4u][2] < 255);
        /* The middle of the hole is more than eight cells away. */
        assert_int_equal(cells[row * SHEET_SIDE + 16u][3], 255);
        assert_int_equal(cells[row * SHEET_SIDE + 16u][2] < 128, 1);
    }
    assert_true(covered > holes / 20u && covered < holes / 3u);
    /* A strip of paper stays at the ring. */
    assert_int_equal(cells[16u * SHEET_SIDE + SHEET_SIDE - 1u][2], 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_dry_poi_has_no_pool),
        cmocka_unit_test(test_a_small_amount_of_water_is_a_film),
        cmocka_unit_test(test_the_drawn_volume_equals_the_water_volume_at_any_tilt),
        cmocka_unit_test(test_a_tilted_pool_moves_to_the_low_side),
        cmocka_unit_test(test_sagging_level_paper_holds_the_pool_in_the_middle),
        cmocka_unit_test(test_refraction_vanishes_only_where_the_poi_crosses_the_surface),
        cmocka_unit_test(test_whole_paper_has_no_flap),
        cmocka_unit_test(test_only_paper_that_shows_its_stress_has_stress_in_its_cells),
        cmocka_unit_test(test_a_hole_opens_from_a_slit_in_a_quarter_of_a_second),
        cmocka_unit_test(test_flaps_reach_into_a_hole_but_leave_it_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
