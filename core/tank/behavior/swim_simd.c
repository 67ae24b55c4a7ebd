/* swim_simd.c -- moves several fish at a time by SIMD instructions. The file is the SIMD form of
 * swim_move.c, line by line.
 *
 * swim_move.c and this file compute bit-identical results, which test_swim_simd.c checks with
 * random fish. */
#include "core/tank/behavior/swim_simd.h"

#include "core/base/panic.h"
#include "core/base/simd_vec.h"

/* Indices of the quads at the start of struct fish. A quad is a group of four consecutive floats,
 * which SIMD code loads together. A member such as position_m or angles fills three of the four
 * floats. QUAD_HOLDS() verifies the first and the last member of each quad. */
enum quad {
    QUAD_PLACE,  /* Index of the quad (four floats) with position_m (three floats) and speed_m_s. */
    QUAD_ANGLES, /* Index of the quad (four floats) with angles (three floats) and
                    yaw_rate_rad_s. */
    QUAD_PUSH,   /* Index of the quad (four floats) with push_m_s (three floats) and climb_m_s. */
    QUAD_COURSE, /* Index of the quad (four floats) with heading_rad, drawn_rad, brake and room. */
    QUAD_PACE,   /* Index of the quad (four floats) with speed_goal_m_s, speed_up_keep, slow_keep
                    and turn_rate_max_rad_s. */
    QUAD_ORDERS, /* Index of the quad (four floats) with haste, climb_goal_m_s, pitch_goal_rad and
                    beats. */
    QUAD_SIZE,   /* Index of the quad (four floats) with length_m, height_m, width_m and stamina. */
    QUAD_TRUE,   /* Index of the quad (four floats) with velocity_m_s (three floats) and
                    bend_rad. */
    QUAD_TAIL,   /* Index of the quad (four floats) with tail_phase_rad, tail_beat_hz,
                    tail_amplitude and bend_goal_rad. */
};

#define QUAD_HOLDS(quad, first, last)                                                              \
    _Static_assert(offsetof(struct fish, first) == 16u * (quad) &&                                 \
                       offsetof(struct fish, last) == 16u * (quad) + 12u,                          \
                   #first " to " #last " are no quad")
QUAD_HOLDS(QUAD_PLACE, position_m, speed_m_s);
QUAD_HOLDS(QUAD_ANGLES, angles, yaw_rate_rad_s);
QUAD_HOLDS(QUAD_PUSH, push_m_s, climb_m_s);
QUAD_HOLDS(QUAD_COURSE, heading_rad, room);
QUAD_HOLDS(QUAD_PACE, speed_goal_m_s, turn_rate_max_rad_s);
QUAD_HOLDS(QUAD_ORDERS, haste, beats);
QUAD_HOLDS(QUAD_SIZE, length_m, stamina);
QUAD_HOLDS(QUAD_TRUE, velocity_m_s, bend_rad);
QUAD_HOLDS(QUAD_TAIL, tail_phase_rad, bend_goal_rad);

static inline void load_fish_quad(flanes column[4], const struct fish *fish, enum quad quad)
{
    simd_load_quads(column, (const char *)fish + 16u * quad, sizeof *fish);
}

static inline void store_fish_quads(struct fish *fish, enum quad quad, const flanes column[4])
{
    simd_store_quads((char *)fish + 16u * quad, sizeof *fish, column);
}

static inline void store_body(struct body *body, uint32_t quad, struct simd_v3 v, flanes w)
{
    const flanes column[4] = { v.x, v.y, v.z, w };
    simd_store_quads((char *)body + 16u * quad, sizeof *body, column);
}

static inline flanes ease(flanes from, flanes to, float tau_s)
{
    return from + (to - from) * f_min(1.0f, DT / tau_s);
}

static inline flanes approach_share(flanes haste, float tau_s)
{
    return simd_min(simd_splat(1.0f), haste * (DT / tau_s));
}

static inline flanes clamp_magnitude(flanes x, float most)
{
    return simd_clamp(x, simd_splat(-most), simd_splat(most));
}

void SIMD_NAME(swim_move_block)(const struct shoal *shoal, uint32_t first)
{
    CORE_ASSERT(first + SIMD_LANES <= shoal->count);
    struct fish *fish = &shoal->fish[first];
    const struct behavior_params *params = shoal->params;
    flanes place[4], angles[4], push[4], course[4], pace[4], commands[4], size[4];
    load_fish_quad(place, fish, QUAD_PLACE);
    load_fish_quad(angles, fish, QUAD_ANGLES);
    load_fish_quad(push, fish, QUAD_PUSH);
    load_fish_quad(course, fish, QUAD_COURSE);
    load_fish_quad(pace, fish, QUAD_PACE);
    load_fish_quad(commands, fish, QUAD_ORDERS);
    load_fish_quad(size, fish, QUAD_SIZE);
    const flanes haste = commands[0], rate_max = pace[3] * course[3];
    const flanes error_rad = simd_wrap_angle(course[0] + course[1] - angles[0]);
    const flanes wanted = simd_clamp(TURN_GAIN_PER_S * haste * error_rad, -rate_max, rate_max);
    const flanes rate = simd_lerp(angles[3], wanted, approach_share(haste, TURN_TAU_S));
    const flanes bank_rad =
        params->banks ? clamp_magnitude(BANK_PER_RAD_S * rate, BANK_MAX_RAD) : simd_splat(0.0f);
    const flanes yaw_rad = simd_wrap_angle(angles[0] + rate * DT);
    const flanes pitch_rad = simd_lerp(angles[1], commands[2], approach_share(haste, PITCH_TAU_S));
    const flanes roll_rad = ease(angles[2], bank_rad, BANK_TAU_S);
    const flanes climb_m_s = ease(push[3], commands[1], CLIMB_TAU_S);
    const flanes goal_m_s = pace[0] * course[2];
    const flanes slow_keep = simd_lerp(simd_splat(BRAKE_KEEP), pace[2], course[2]);
    const flanes keep = simd_select(goal_m_s > place[3], pace[1], slow_keep);
    const flanes speed_m_s = simd_lerp(goal_m_s, place[3], keep);
    const struct simd_sin_cos yaw = simd_sin_cos(yaw_rad);
    const flanes able_m_s = size[0] * (0.8f + 0.2f * size[3]);
    const flanes most_m_s =
        simd_max(able_m_s * params->swim_speed_max, simd_max(speed_m_s, simd_abs(climb_m_s)));
    const struct simd_v3 all = { -yaw.sin * speed_m_s + push[0], climb_m_s + push[1],
                                 -yaw.cos * speed_m_s + push[2] };
    const struct simd_v3 velocity = simd_v3_limit(all, most_m_s);
    const struct simd_v3 centre =
        simd_v3_muladd(simd_v3(place[0], place[1], place[2]), velocity, simd_splat(DT));
    store_fish_quads(fish, QUAD_PLACE, (flanes[4]){ centre.x, centre.y, centre.z, speed_m_s });
    store_fish_quads(fish, QUAD_ANGLES, (flanes[4]){ yaw_rad, pitch_rad, roll_rad, rate });
    store_fish_quads(fish, QUAD_PUSH, (flanes[4]){ push[0], push[1], push[2], climb_m_s });
    const struct simd_basis axes = simd_basis(yaw, simd_sin_cos(pitch_rad), simd_sin_cos(roll_rad));
    store_body(&shoal->body[first], 0, centre, 0.5f * size[2]);
    store_body(&shoal->body[first], 1, axes.right, 0.5f * size[1]);
    store_body(&shoal->body[first], 2, axes.up, 0.5f * size[0]);
    store_body(&shoal->body[first], 3, axes.back, shoal->space * size[0]);
    /* Upper bound of the distance that a corner of the body box moved: the motion of the centre
     * plus the motion by rotation. */
    const flanes turned_rad =
        simd_abs(rate * DT) + simd_abs(pitch_rad - angles[1]) + simd_abs(roll_rad - angles[2]);
    const struct simd_v3 whole = { size[2], size[1], size[0] };
    const flanes corner_m =
        simd_v3_length(velocity) * DT + 0.5f * simd_v3_length(whole) * turned_rad;
    float *way = &shoal->way_m[first];
    simd_store(way, simd_load(way) + corner_m);
}

/* Returns the amplitude that the tail approaches when it beats with `hz` hertz. `beats` is -1 in
 * the lanes whose fish beats its tail, and 0 in the lanes whose fish glides. */
static flanes stroke_goal(flanes hz, ilanes beats)
{
    const float per_hz = (1.0f - STROKE_SLOW) / (STROKE_FULL_HZ - BEAT_MIN_HZ);
    const flanes wider =
        simd_clamp(per_hz * (hz - BEAT_MIN_HZ), simd_splat(0.0f), simd_splat(1.0f - STROKE_SLOW));
    return simd_select(beats, STROKE_SLOW + wider, STROKE_GLIDE + STROKE_TRAIL * wider);
}

void SIMD_NAME(swim_settle_block)(const struct shoal *shoal, uint32_t first)
{
    CORE_ASSERT(first + SIMD_LANES <= shoal->count);
    struct fish *fish = &shoal->fish[first];
    const struct body *body = &shoal->body[first];
    flanes place[4], angles[4], pushed[4], commands[4], size[4], still[4], tail[4];
    flanes centre[4], back[4], before[4];
    load_fish_quad(place, fish, QUAD_PLACE);
    load_fish_quad(angles, fish, QUAD_ANGLES);
    load_fish_quad(pushed, fish, QUAD_PUSH);
    load_fish_quad(commands, fish, QUAD_ORDERS);
    load_fish_quad(size, fish, QUAD_SIZE);
    load_fish_quad(still, fish, QUAD_TRUE);
    load_fish_quad(tail, fish, QUAD_TAIL);
    simd_load_quads(centre, body, sizeof *body);
    simd_load_quads(back, (const char *)body + 48u, sizeof *body);
    simd_load_quads(before, &shoal->before_m[first], sizeof shoal->before_m[0]);

    const struct simd_v3 push = { pushed[0], pushed[1], pushed[2] };
    const struct simd_v3 moved_m = { centre[0] - before[0], centre[1] - before[1],
                                     centre[2] - before[2] };
    const struct simd_v3 v = simd_v3_scale(moved_m, simd_splat(1.0f / DT));
    /* Horizontal component of the fish's forward direction. The code below scales the vector to
     * length 1. */
    const struct simd_v3 flat = { -back[0], simd_splat(0.0f), -back[2] };
    const flanes true_m_s =
        simd_max(simd_splat(0.0f), simd_v3_dot(simd_v3_sub(v, push),
                                               simd_v3_scale(flat, 1.0f / simd_v3_length(flat))));
    const flanes speed_m_s = simd_select(
        true_m_s < place[3], simd_lerp(place[3], true_m_s, simd_splat(BLOCKED_SHARE)), place[3]);
    const struct simd_v3 drift = simd_v3_scale(push, simd_splat(0.5f));
    const flanes along_m_s = simd_v3_length(simd_v3_sub(v, drift));
    const flanes lengths_per_s = along_m_s / size[0];
    const flanes slow = simd_max(simd_splat(BEAT_MIN_HZ), lengths_per_s / BEAT_LENGTHS);
    const flanes fast = 4.0f / 3.0f * (lengths_per_s + 1.0f);
    const flanes hz =
        simd_lerp(tail[1], simd_select(lengths_per_s < BEAT_FAST_LENGTHS_PER_S, slow, fast),
                  approach_share(commands[0], TAIL_TAU_S));
    const flanes amplitude = simd_lerp(tail[2], stroke_goal(hz, commands[3] > 0.0f),
                                       approach_share(commands[0], STROKE_TAU_S));
    const flanes phase = tail[0] + F_TAU * hz * DT;
    /* The body bends toward `wanted_rad`: the intended bend (`bend_goal_rad`) plus a bend along the
     * arc of the turn. In a C-start (escape) no bend along the arc is added. */
    const flanes arc_rad = clamp_magnitude(BEND_PER_RAD_S * angles[3], 1.0f);
    const flanes wanted_rad =
        tail[3] + simd_select(commands[0] < HASTE_START, arc_rad, simd_splat(0.0f));
    const flanes bend_rad =
        simd_lerp(still[3], wanted_rad, approach_share(commands[0], BEND_TAU_S));

    const struct simd_v3 shoved_m = { centre[0] - place[0], centre[1] - place[1],
                                      centre[2] - place[2] };
    float *way = &shoal->way_m[first];
    simd_store(way, simd_load(way) + simd_v3_length(shoved_m));
    store_fish_quads(fish, QUAD_PLACE, (flanes[4]){ centre[0], centre[1], centre[2], speed_m_s });
    store_fish_quads(fish, QUAD_TRUE, (flanes[4]){ v.x, v.y, v.z, bend_rad });
    store_fish_quads(
        fish, QUAD_TAIL,
        (flanes[4]){ simd_select(phase >= F_TAU, phase - F_TAU, phase), hz, amplitude, tail[3] });
}
