/* tear_clip.c -- determines the cause of a tear, records the second around the tear, and returns
 * the frames of the slow motion. */
#include "core/poi/tear_clip.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* ---- Cause of a tear ------------------------------------------------------------------------- */

/* Fraction of the ring under water below which the ring counts as in the air. */
#define DRY_SHARE 0.02f
/* Acceleration above which a ring in the air counts as jerked. */
#define JERK_M_S2 3.0f
/* Limit, as a fraction of SHEET_SOAK_TICKS, of the mean time for which the cells of the paper were
 * wet: 12 s. Above the limit, the paper counts as soaked too long. A dip then does 1.7 times the
 * damage that the same dip does to fresh wet paper. */
#define SOAKED_SHARE 0.2f
/* Tension, as a fraction of the strength of fresh wet paper, below which a load counts as moderate.
 * Simulated visitors who move with care reach about 0.5 of that strength. */
#define MODERATE_SHARE 0.567f

/* Returns the highest tension, N/m, that a single load of the poi causes in the patch of paper on
 * which the load acts. Only the loads with the numbers `from` to `to` - 1 are included. */
static float patch_tension_n_m(const struct poi *poi, uint32_t from, uint32_t to)
{
    float most = 0.0f;
    for (uint32_t i = from; i < to; i++) {
        const struct sheet_load *load = &poi->loads[i];
        most = f_max(most, f_abs(load->force_n) / (F_PI * load->diameter_m));
    }
    return most;
}

/* Returns the mean time for which the cells of the new sheet were wet, as a fraction of
 * SHEET_SOAK_TICKS. */
static float soaked_share(const struct sheet *sheet)
{
    uint32_t ticks = 0;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        ticks += sheet->state[i] != CELL_OUTSIDE ? sheet->soak_ticks[i] : 0u;
    }
    return (float)ticks / f_max((float)sheet->paper_cells_new, 1.0f) / (float)SHEET_SOAK_TICKS;
}

/* Returns the highest tension in the paper as a fraction of the strength of fresh wet paper. */
static float tension_share(const struct poi *poi)
{
    return poi->strain.tension_max_n_m / sheet_grade(poi->sheet.grade)->wet_n_m;
}

/* Returns the damage that the highest tension does in one tick. The damage is the tension, as a
 * fraction of the strength of fresh wet paper, to the power SHEET_DAMAGE_EXPONENT. The result is
 * positive for a high load and negative for a moderate load. */
static float damage_in_tick(const struct poi *poi)
{
    const float share = tension_share(poi), square = share * share, fourth = square * square;
    const float wear = fourth * fourth * square;
    return share < MODERATE_SHARE ? -wear : wear;
}

uint8_t tear_cause_of(const struct tear_clip *clip, const struct poi *poi)
{
    CORE_ASSERT(poi->slap_count <= poi->load_count);
    const struct sheet *sheet = &poi->sheet;
    const struct paper_grade *grade = sheet_grade(sheet->grade);
    if (poi->strain.cells_torn == 0) {
        return TEAR_NONE;
    }
    /* A moderate load tears paper that earlier loads have damaged. If high loads did most of this
     * damage, the paper was not soaked too long. */
    if (tension_share(poi) < MODERATE_SHARE && clip->haste <= 0.0f &&
        soaked_share(sheet) > SOAKED_SHARE) {
        return TEAR_SOAKED;
    }
    const float even =
        sheet_tension_edge(grade, poi->pressure_pa * sheet_left(sheet), sheet->radius_m);
    const float slap = patch_tension_n_m(poi, 0, poi->slap_count);
    const float body = patch_tension_n_m(poi, poi->slap_count, poi->load_count);
    if (slap > even || body > even) {
        return slap > body ? TEAR_SLAP : TEAR_WEIGHT;
    }
    if (poi->immersed < DRY_SHARE) {
        return v3_length(poi->acceleration_m_s2) > JERK_M_S2 ? TEAR_FAST : TEAR_WEIGHT;
    }
    /* The cause is TEAR_FLAT (paper that was pushed along its normal) if the ring moves more along
     * its normal than along its plane. */
    const vec3 v = poi->velocity_m_s;
    const float normal_m_s = v3_dot(v, vec_basis_from_angles(poi->angles).up);
    return 2.0f * normal_m_s * normal_m_s > v3_dot(v, v) ? TEAR_FLAT : TEAR_FAST;
}

/* ---- Recording ------------------------------------------------------------------------------- */

#define PER_M 1e4f
#define PER_RAD 1e4f
#define LOAD_MAX 15u /* Highest value of a load in four bits. */

static int16_t quantised(float value)
{
    return (int16_t)(int32_t)f_clamp(value, -32767.0f, 32767.0f);
}

/* Returns the load of cell `cell` of the frame: the highest load of 2 x 2 cells of the sheet, from
 * 1 to LOAD_MAX. Returns 0 if one of these cells is a hole, or if none of them is paper. */
static uint8_t quantised_load(const struct sheet *sheet, uint32_t cell)
{
    uint32_t most = 0, paper = 0, holes = 0;
    for (uint32_t i = 0; i < 4u; i++) {
        const uint32_t row = 2u * (cell / TEAR_SIDE) + i / 2u;
        const uint32_t at = row * SHEET_SIDE + 2u * (cell % TEAR_SIDE) + i % 2u;
        paper += sheet->state[at] == CELL_PAPER;
        holes += sheet->state[at] == CELL_HOLE;
        most = sheet->stress[at] > most ? sheet->stress[at] : most;
    }
    return (uint8_t)(paper == 0 || holes > 0 ? 0u : 1u + most * (LOAD_MAX - 1u) / 255u);
}

void tear_clip_tick(struct tear_clip *clip, const struct poi *poi, uint32_t tick)
{
    CORE_ASSERT(clip->next < TEAR_CLIP_FRAMES && clip->count <= TEAR_CLIP_FRAMES);
    if (clip->cause == TEAR_NONE) {
        clip->haste += damage_in_tick(poi);
        clip->cause = tear_cause_of(clip, poi);
    }
    if (tick % TEAR_CLIP_FRAME_TICKS != 0 || clip->after == TEAR_CLIP_FRAMES_AFTER) {
        return;
    }
    struct tear_frame *frame = &clip->frames[clip->next];
    const vec3 at_m = poi->position_m;
    const struct angles angles = poi->angles;
    frame->position[0] = quantised(PER_M * at_m.x);
    frame->position[1] = quantised(PER_M * at_m.y);
    frame->position[2] = quantised(PER_M * at_m.z);
    frame->angles[0] = quantised(PER_RAD * angles.yaw_rad);
    frame->angles[1] = quantised(PER_RAD * angles.pitch_rad);
    frame->angles[2] = quantised(PER_RAD * angles.roll_rad);
    for (uint32_t i = 0; i < TEAR_CELL_COUNT / 2u; i++) {
        const uint32_t high = quantised_load(&poi->sheet, 2u * i + 1u);
        frame->load[i] = (uint8_t)(quantised_load(&poi->sheet, 2u * i) | high << 4);
    }
    clip->next = (uint8_t)((clip->next + 1u) % TEAR_CLIP_FRAMES);
    clip->count = (uint8_t)(clip->count + (clip->count < TEAR_CLIP_FRAMES));
    clip->after = (uint8_t)(clip->after + (clip->cause != TEAR_NONE));
}

/* ---- Slow motion ----------------------------------------------------------------------------- */

static vec3 frame_position_m(const struct tear_frame *frame)
{
    return v3_scale(v3(frame->position[0], frame->position[1], frame->position[2]), 1.0f / PER_M);
}

void tear_clip_show(const struct tear_clip *clip, uint32_t elapsed_ticks, struct scene_tear *out)
{
    memset(out, 0, sizeof *out);
    if (clip->cause == TEAR_NONE || clip->count == 0) {
        return;
    }
    const uint32_t wanted = elapsed_ticks % TEAR_CLIP_LOOP_TICKS / TEAR_CLIP_SHOWN_TICKS;
    const uint32_t at = wanted < clip->count ? wanted : clip->count - 1u;
    /* Number 0 is the oldest frame. The velocity follows from the positions in this frame and in
     * the previous frame. */
    const uint32_t oldest = TEAR_CLIP_FRAMES + clip->next - clip->count;
    const struct tear_frame *frame = &clip->frames[(oldest + at) % TEAR_CLIP_FRAMES];
    const struct tear_frame *last = &clip->frames[(oldest + at - (at > 0)) % TEAR_CLIP_FRAMES];
    const float hz = (float)CORE_TICK_HZ / (float)TEAR_CLIP_FRAME_TICKS;
    out->cause = clip->cause;
    out->time_s = ((float)at - (float)(clip->count - clip->after)) / hz;
    out->position_m = frame_position_m(frame);
    out->velocity_m_s = v3_scale(v3_sub(out->position_m, frame_position_m(last)), hz);
    out->angles = (struct angles){ .yaw_rad = (float)frame->angles[0] / PER_RAD,
                                   .pitch_rad = (float)frame->angles[1] / PER_RAD,
                                   .roll_rad = (float)frame->angles[2] / PER_RAD };
    for (uint32_t i = 0; i < TEAR_CELL_COUNT; i++) {
        const uint32_t load = frame->load[i / 2u] >> (i % 2u * 4u) & LOAD_MAX;
        out->load[i] = (uint8_t)(load * 255u / LOAD_MAX);
    }
}
