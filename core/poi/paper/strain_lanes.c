/* strain_lanes.c -- computes the tension, the strength and the wear of a row of cells, with SIMD
 * code for four cells at a time. */
#include "core/poi/paper/strain.h"

#include "core/base/panic.h"

_Static_assert(SHEET_SIDE % SIMD_LANES == 0, "a row is whole blocks");
_Static_assert(SHEET_DAMAGE_EXPONENT == 10, "as it is multiplied here");

/* Upper limit of ratio^10, which keeps the damage of a strongly overloaded cell finite. */
#define WEAR_MAX 1e6f

typedef uint8_t byte_lanes __attribute__((vector_size(SIMD_LANES)));
typedef uint16_t short_lanes __attribute__((vector_size(2 * SIMD_LANES)));

/* Returns `tension` plus the tensions of all footprints. A footprint with the force F and the
 * diameter d causes a tension of F / (pi * d) at its edge. Beyond the edge, the tension is
 * inversely proportional to the distance from the centre. */
static inline flanes feet(const struct strain *strain, flanes x_m, float z_m, flanes tension)
{
    for (uint32_t i = 0; i < strain->load_count; i++) {
        const struct footprint *foot = &strain->footprints[i];
        const flanes dx = x_m - foot->x_m;
        const float dz = z_m - foot->z_m;
        const flanes square = dx * dx + dz * dz;
        const ilanes felt = square < foot->reach_m * foot->reach_m;
        if (simd_bits(felt)) {
            const flanes away =
                simd_max(simd_splat(foot->own_m), simd_sqrt(square) - 0.5f * strain->cell_m);
            tension += simd_select(felt, foot->pull_n_m_m / away, simd_splat(0.0f));
        }
    }
    return tension;
}

static inline flanes holds_n_m(const struct strain *strain, const struct sheet *sheet,
                               uint32_t cell)
{
    /* `wet` is the strength of SIMD_LANES wet cells, which is lower for cells that have been wet
     * for longer. */
    short_lanes ticks;
    MEM_COPY(&ticks, &sheet->soak_ticks[cell], sizeof ticks);
    const flanes soaked = __builtin_convertvector(__builtin_convertvector(ticks, ilanes), flanes);
    const flanes wet =
        strain->grade->wet_n_m * (1.0f - SHEET_SOFTENING * soaked / (float)SHEET_SOAK_TICKS);
    const flanes wetness = simd_load(&sheet->wetness[cell]);
    const flanes material = simd_lerp(simd_splat(strain->grade->dry_n_m), wet, wetness);
    return simd_max(material * simd_load(&sheet->strength[cell]), simd_splat(1e-3f));
}

float strain_row(struct strain *strain, const struct sheet *sheet, uint32_t row)
{
    CORE_ASSERT(row < SHEET_SIDE);
    CORE_ASSERT(strain->load_count <= SHEET_LOAD_MAX);
    const float z_m = sheet_line_m(sheet, row);
    const float per_radius2 = 1.0f / (sheet->radius_m * sheet->radius_m);
    const float inner_m = sheet->radius_m - strain->cell_m;
    const float edge = sheet->ideal ? 1.0f : STRAIN_EDGE;
    flanes most = simd_splat(0.0f);
    for (uint32_t column = 0; column < SHEET_SIDE; column += SIMD_LANES) {
        const uint32_t cell = row * SHEET_SIDE + column;
        flanes x_m;
        for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
            x_m[lane] = (float)(column + lane) + 0.5f;
        }
        x_m = x_m * strain->cell_m - sheet->radius_m;
        const flanes square = x_m * x_m + z_m * z_m;
        const flanes membrane = simd_lerp(simd_splat(strain->centre_n_m),
                                          simd_splat(strain->edge_n_m), square * per_radius2);
        byte_lanes state;
        MEM_COPY(&state, &sheet->state[cell], sizeof state);
        const flanes tension =
            simd_select(__builtin_convertvector(state, ilanes) == (int32_t)CELL_PAPER,
                        feet(strain, x_m, z_m, membrane), simd_splat(0.0f));
        const flanes full = tension / holds_n_m(strain, sheet, cell);
        const flanes load = simd_select(full < STRAIN_NIL, simd_splat(0.0f), full);
        const ilanes at_ring = square > inner_m * inner_m;
        simd_store(&strain->load[cell], load);
        simd_store(&strain->ratio[cell], simd_select(at_ring, load * edge, load));
        most = simd_max(most, tension);
    }
    float greatest = 0.0f;
    for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
        greatest = f_max(greatest, most[lane]);
    }
    return greatest;
}

static inline flanes wear_in(flanes ratio, float seconds)
{
    const flanes r2 = ratio * ratio, r4 = r2 * r2, r8 = r4 * r4;
    return simd_min(r8 * r2, simd_splat(WEAR_MAX)) * (seconds / SHEET_DAMAGE_TAU_S);
}

bool strain_tears(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                  float seconds)
{
    CORE_ASSERT(row < SHEET_SIDE);
    CORE_ASSERT(seconds > 0.0f);
    ilanes torn = { 0 };
    for (uint32_t cell = row * SHEET_SIDE; cell < (row + 1u) * SHEET_SIDE; cell += SIMD_LANES) {
        const flanes ratio = simd_load(&strain->ratio[cell]);
        const flanes damage = simd_load(&sheet->damage[cell]) + wear_in(ratio, seconds);
        torn |= (damage >= 1.0f) & (ratio > 0.0f);
    }
    return simd_bits(torn) != 0;
}

uint32_t strain_wear(const struct strain *strain, struct sheet *sheet, uint32_t row, float seconds)
{
    CORE_ASSERT(row < SHEET_SIDE);
    CORE_ASSERT(seconds > 0.0f);
    uint32_t torn = 0;
    for (uint32_t column = 0; column < SHEET_SIDE; column += SIMD_LANES) {
        const uint32_t cell = row * SHEET_SIDE + column;
        const flanes ratio = simd_load(&strain->ratio[cell]);
        const flanes damage = simd_load(&sheet->damage[cell]) + wear_in(ratio, seconds);
        simd_store(&sheet->damage[cell], simd_min(damage, simd_splat(1.0f)));
        torn |= simd_bits((damage >= 1.0f) & (ratio > 0.0f)) << column;
    }
    return torn;
}

void strain_show(const struct strain *strain, struct sheet *sheet, uint32_t row)
{
    CORE_ASSERT(row < SHEET_SIDE);
    for (uint32_t cell = row * SHEET_SIDE; cell < (row + 1u) * SHEET_SIDE; cell += SIMD_LANES) {
        const flanes ratio = simd_min(simd_load(&strain->ratio[cell]), simd_splat(1.0f));
        const ilanes whole = __builtin_convertvector(ratio * 255.0f, ilanes);
        const byte_lanes bytes = __builtin_convertvector(whole, byte_lanes);
        MEM_COPY(&sheet->stress[cell], &bytes, sizeof bytes);
    }
}
