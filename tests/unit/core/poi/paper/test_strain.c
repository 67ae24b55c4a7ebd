/* test_strain.c -- compares the SIMD functions for rows of cells with scalar code, bit for bit. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"
#include "core/poi/paper/strain.h"

#define RADIUS_M 0.040f

static struct sheet sheet, other;
static struct strain strain;

static float draw(uint32_t what, uint32_t cell, float low, float high)
{
    return rng_range((struct rng_key){ 11, what, cell, RNG_TEST }, low, high);
}

/* Fills the sheet at random. About a tenth of the cells are torn, and the others have a random
 * wetness, damage and softening. Three loads act on the sheet. */
static void prepare(void)
{
    sheet_init(&sheet, 6, RADIUS_M, 3);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet.state[cell] == CELL_PAPER) {
            sheet.state[cell] = draw(0, cell, 0.0f, 1.0f) < 0.1f ? CELL_HOLE : CELL_PAPER;
            sheet.wetness[cell] = draw(1, cell, 0.0f, 1.0f);
            sheet.damage[cell] = draw(2, cell, 0.0f, 1.0f);
            sheet.soak_ticks[cell] = (uint16_t)draw(3, cell, 0.0f, (float)SHEET_SOAK_TICKS);
        }
    }
    memset(&strain, 0, sizeof strain);
    strain.grade = sheet_grade(6);
    strain.centre_n_m = 9.0f;
    strain.edge_n_m = 7.0f;
    strain.cell_m = sheet_cell_m(&sheet);
    strain.load_count = 3;
    strain.footprints[0] = (struct footprint){ 0.0f, 0.01f, 0.0015f, 0.05f, 0.015f };
    strain.footprints[1] = (struct footprint){ -0.02f, 0.0f, 0.01f, 0.015f, 0.0045f };
    strain.footprints[2] = (struct footprint){ 0.01f, -0.02f, 0.01f, 0.0025f, 0.0004f };
    other = sheet;
}

/* Returns the fraction of the initial wet strength that a cell still has after softening. */
static float softened(const struct sheet *paper, uint32_t cell)
{
    return 1.0f - SHEET_SOFTENING * (float)paper->soak_ticks[cell] / (float)SHEET_SOAK_TICKS;
}

/* Computes the load of one cell with scalar code, following the definition in strain.h. */
static float plain_load(uint32_t cell, float *tension_max_n_m)
{
    const float x = sheet_line_m(&sheet, cell % SHEET_SIDE);
    const float z = sheet_line_m(&sheet, cell / SHEET_SIDE);
    const float square = x * x + z * z;
    float tension =
        f_lerp(strain.centre_n_m, strain.edge_n_m, square * (1.0f / (RADIUS_M * RADIUS_M)));
    for (uint32_t i = 0; i < strain.load_count; i++) {
        const struct footprint *foot = &strain.footprints[i];
        const float dx = x - foot->x_m, dz = z - foot->z_m, away2 = dx * dx + dz * dz;
        if (away2 < foot->reach_m * foot->reach_m) {
            tension += foot->pull_n_m_m / f_max(foot->own_m, f_sqrt(away2) - 0.5f * strain.cell_m);
        }
    }
    if (sheet.state[cell] != CELL_PAPER) {
        return 0.0f;
    }
    *tension_max_n_m = f_max(*tension_max_n_m, tension);
    const float wet = strain.grade->wet_n_m * softened(&sheet, cell);
    const float holds =
        f_lerp(strain.grade->dry_n_m, wet, sheet.wetness[cell]) * sheet.strength[cell];
    const float load = tension / f_max(holds, 1e-3f);
    return load < STRAIN_NIL ? 0.0f : load;
}

static void test_a_row_equals_plain_arithmetic(void **state)
{
    (void)state;
    float plain_max = 0.0f, most = 0.0f;
    prepare();
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        most = f_max(most, strain_row(&strain, &sheet, row));
        for (uint32_t cell = row * SHEET_SIDE; cell < (row + 1u) * SHEET_SIDE; cell++) {
            const float load = plain_load(cell, &plain_max);
            const float x = sheet_line_m(&sheet, cell % SHEET_SIDE);
            const float z = sheet_line_m(&sheet, row);
            const float inner = RADIUS_M - strain.cell_m;
            const float edge = x * x + z * z > inner * inner ? STRAIN_EDGE : 1.0f;
            const float ratio = load * edge;
            assert_memory_equal(&strain.load[cell], &load, sizeof load);
            assert_memory_equal(&strain.ratio[cell], &ratio, sizeof ratio);
        }
    }
    assert_float_equal(most, plain_max, 0.0f);
}

static void test_wear_is_the_tenth_power_and_tears_a_cell_at_one(void **state)
{
    (void)state;
    prepare();
    uint32_t torn = 0;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        strain.ratio[cell] = sheet.state[cell] == CELL_PAPER ? draw(4, cell, 0.0f, 1.5f) : 0.0f;
    }
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const int tears = strain_tears(&strain, &sheet, row, CORE_TICK_S);
        const uint32_t bits = strain_wear(&strain, &sheet, row, CORE_TICK_S);
        assert_int_equal(tears, bits != 0);
        for (uint32_t column = 0; column < SHEET_SIDE; column++) {
            const uint32_t cell = row * SHEET_SIDE + column;
            double power = 1.0;
            for (uint32_t i = 0; i < SHEET_DAMAGE_EXPONENT; i++) {
                power *= (double)strain.ratio[cell];
            }
            const double damage = (double)other.damage[cell] + power / 120.0 / 0.05;
            assert_float_equal(sheet.damage[cell], f_min((float)damage, 1.0f), 1e-4f);
            if (damage < 0.9999 || damage > 1.0001) {
                assert_int_equal(bits >> column & 1u, damage > 1.0 && strain.ratio[cell] > 0.0f);
            }
            torn += bits >> column & 1u;
        }
    }
    assert_in_range(torn, 50, 700);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_row_equals_plain_arithmetic),
        cmocka_unit_test(test_wear_is_the_tenth_power_and_tears_a_cell_at_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
