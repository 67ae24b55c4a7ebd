/* swim_move.c -- moves one fish toward its goals for one tick, and moves all fish of a tank in SIMD
 * blocks.
 *
 * swim_simd.c computes bit-identical results for a block of fish. */
#include "core/tank/behavior/swim.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/swim_simd.h"

static float ease(float from, float to, float tau_s)
{
    return from + (to - from) * f_min(1.0f, DT / tau_s);
}

/* Returns the fraction by which a value of the fish, for example its bend, approaches its goal in
 * one tick. The fraction grows with the `haste` of the fish. */
static float approach_share(const struct fish *fish, float tau_s)
{
    return f_min(1.0f, fish->haste * (DT / tau_s));
}

float swim_move(struct fish *fish, const struct behavior_params *params)
{
    CORE_ASSERT(fish->length_m > 0.0f);
    const struct angles before = fish->angles;
    const float error_rad =
        f_wrap_angle(fish->heading_rad + fish->drawn_rad - fish->angles.yaw_rad);
    /* Limits the yaw rate. `room` lowers the limit if other fish are close beside the fish. The
     * limit also applies to a C-start (escape), because the tail would otherwise swing through fish
     * beside it. */
    const float rate_max = fish->turn_rate_max_rad_s * fish->room;
    const float wanted = f_clamp(TURN_GAIN_PER_S * fish->haste * error_rad, -rate_max, rate_max);
    fish->yaw_rate_rad_s = f_lerp(fish->yaw_rate_rad_s, wanted, approach_share(fish, TURN_TAU_S));
    fish->angles.yaw_rad = f_wrap_angle(fish->angles.yaw_rad + fish->yaw_rate_rad_s * DT);
    const float bank_rad =
        params->banks ? f_clamp(BANK_PER_RAD_S * fish->yaw_rate_rad_s, -BANK_MAX_RAD, BANK_MAX_RAD)
                      : 0.0f;
    fish->angles.roll_rad = ease(fish->angles.roll_rad, bank_rad, BANK_TAU_S);
    fish->climb_m_s = ease(fish->climb_m_s, fish->climb_goal_m_s, CLIMB_TAU_S);
    fish->angles.pitch_rad =
        f_lerp(fish->angles.pitch_rad, fish->pitch_goal_rad, approach_share(fish, PITCH_TAU_S));
    const float goal_m_s = fish->speed_goal_m_s * fish->brake;
    const float slow_keep = f_lerp(BRAKE_KEEP, fish->slow_keep, fish->brake);
    const float keep = goal_m_s > fish->speed_m_s ? fish->speed_up_keep : slow_keep;
    fish->speed_m_s = f_lerp(goal_m_s, fish->speed_m_s, keep);
    const vec3 own_m_s = { -f_sin(fish->angles.yaw_rad) * fish->speed_m_s, fish->climb_m_s,
                           -f_cos(fish->angles.yaw_rad) * fish->speed_m_s };
    /* The speed limit includes climb and pushes (section 3.3 of the 2013 thesis on goldfish
     * behavior). The limit is the top swimming speed, or the fish's own speed or climb speed if
     * that is higher. The fish's own speed is higher, for example, after a burst. */
    const vec3 velocity = v3_limit(
        v3_add(own_m_s, fish->push_m_s),
        f_max(gait_speed_max_m_s(fish, params), f_max(fish->speed_m_s, f_abs(fish->climb_m_s))));
    fish->position_m = v3_muladd(fish->position_m, velocity, DT);
    const float turned_rad = f_abs(fish->yaw_rate_rad_s * DT) +
                             f_abs(fish->angles.pitch_rad - before.pitch_rad) +
                             f_abs(fish->angles.roll_rad - before.roll_rad);
    /* A rotation by one radian moves a corner of the box by at most half the diagonal of the
     * box. */
    return v3_length(velocity) * DT +
           (0.5f * v3_length(v3(fish->width_m, fish->height_m, fish->length_m))) * turned_rad;
}

bool swim_fall(struct fish *fish)
{
    const float half_m = 0.5f * fish->height_m;
    if (fish->position_m.y < -0.55f * fish->length_m) { /* The fish is so deep that it cannot reach
                                                           the surface in any pose. */
        return false;
    }
    const struct box box = fish_box(fish);
    const float emerged_m = fish->position_m.y + box_extent_m(&box).y;
    if (emerged_m <= (fish->falls ? 0.0f : fish_emerges_m(fish))) { /* A fall ends as soon as the
                                                                       fish is completely under
                                                                       water. */
        return false;
    }
    const float wet = f_clamp((half_m - fish->position_m.y) / (2.0f * half_m), 0.0f, 1.0f);
    vec3 v = fish->velocity_m_s;
    v.y -= GRAVITY_M_S2 * (1.0f - wet) * DT;
    v = v3_scale(v, 1.0f - f_min(0.9f, 12.0f * wet * DT)); /* The drag of the water stops the fish
                                                              within one body length. */
    v.y = wet > 0.5f ? f_min(v.y, -0.12f) : v.y;           /* A fish that is more than half under
                                                              water swims down at 12 cm/s or faster,
                                                              until the water covers the fish. */
    fish->position_m = v3_muladd(fish->position_m, v, DT);
    fish->velocity_m_s = v;
    fish->angles.roll_rad = ease(fish->angles.roll_rad, 0.0f, 0.15f);
    fish->angles.pitch_rad = ease(fish->angles.pitch_rad, -10.0f * F_DEG, 0.2f);
    fish->speed_m_s = 0.0f;
    fish->climb_m_s = v.y;
    return true;
}

void swim_settle(struct fish *fish, vec3 moved_m, vec3 forward)
{
    CORE_ASSERT(fish->length_m > 0.0f);
    fish->velocity_m_s = v3_scale(moved_m, 1.0f / DT);
    /* Reduces the speed of a fish that an obstacle blocks, so that the fish does not continue to
     * swim against the obstacle. */
    const vec3 flat = v3(forward.x, 0.0f, forward.z);
    const vec3 ahead = v3_scale(flat, 1.0f / v3_length(flat)); /* The length is never zero, because
                                                                  no fish swims vertically. */
    const float true_m_s = f_max(0.0f, v3_dot(v3_sub(fish->velocity_m_s, fish->push_m_s), ahead));
    if (true_m_s < fish->speed_m_s) {
        fish->speed_m_s = f_lerp(fish->speed_m_s, true_m_s, BLOCKED_SHARE);
    }
    const float along_m_s = v3_length(v3_sub(fish->velocity_m_s, v3_scale(fish->push_m_s, 0.5f)));
    const float lengths_per_s = along_m_s / fish->length_m;
    const float hz = lengths_per_s < BEAT_FAST_LENGTHS_PER_S
                         ? f_max(BEAT_MIN_HZ, lengths_per_s / BEAT_LENGTHS)
                         : 4.0f / 3.0f * (lengths_per_s + 1.0f);
    fish->tail_beat_hz = f_lerp(fish->tail_beat_hz, hz, approach_share(fish, TAIL_TAU_S));
    /* Without tail beats (in a glide), the tail only trails behind the body, so its amplitude is
     * smaller. */
    const float per_hz = (1.0f - STROKE_SLOW) / (STROKE_FULL_HZ - BEAT_MIN_HZ);
    const float wider =
        f_clamp(per_hz * (fish->tail_beat_hz - BEAT_MIN_HZ), 0.0f, 1.0f - STROKE_SLOW);
    fish->tail_amplitude =
        f_lerp(fish->tail_amplitude,
               fish->beats > 0.0f ? STROKE_SLOW + wider : STROKE_GLIDE + STROKE_TRAIL * wider,
               approach_share(fish, STROKE_TAU_S));
    const float phase_rad = fish->tail_phase_rad + F_TAU * fish->tail_beat_hz * DT;
    fish->tail_phase_rad = phase_rad >= F_TAU ? phase_rad - F_TAU : phase_rad;
    const float arc_rad = f_clamp(BEND_PER_RAD_S * fish->yaw_rate_rad_s, -1.0f, 1.0f);
    const float bend_rad = fish->bend_goal_rad + (fish->haste < HASTE_START ? arc_rad : 0.0f);
    fish->bend_rad = f_lerp(fish->bend_rad, bend_rad, approach_share(fish, BEND_TAU_S));
}

/* ---- Motion of all fish of a tank ------------------------------------------------------------ */

/* Returns true if fish `first` and the next `width` - 1 fish all swim, so that SIMD code may
 * process the block. */
static bool is_block(const struct shoal *shoal, uint32_t first, uint32_t width)
{
    if (shoal->count - first < width) {
        return false;
    }
    bool all = true;
    for (uint32_t i = first; i < first + width; i++) {
        all &= fish_swims(&shoal->fish[i]) & !shoal->fish[i].falls;
    }
    return all;
}

void swim_move_all(const struct shoal *shoal, uint32_t lanes)
{
    CORE_ASSERT(shoal->count <= TANK_FISH_MAX);
    CORE_ASSERT(simd_is_built(lanes));
    const uint32_t width = lanes == SIMD_LANES_MAX ? SIMD_LANES_MAX : 4u;
    for (uint32_t i = 0; i < shoal->count;) {
        struct fish *fish = &shoal->fish[i];
        if (is_block(shoal, i, width)) {
            SIMD_PICK(lanes, swim_move_block)(shoal, i);
            i += width;
            continue;
        }
        if (fish_swims(fish)) {
            shoal->way_m[i] += fish->falls ? SWIM_FAR_M : swim_move(fish, shoal->params);
            const struct box box = fish_box(fish);
            shoal->body[i] = body_of(&box, shoal->space * fish->length_m);
        }
        i++;
    }
}

void swim_settle_all(const struct shoal *shoal, uint32_t lanes)
{
    CORE_ASSERT(shoal->count <= TANK_FISH_MAX);
    CORE_ASSERT(simd_is_built(lanes));
    const uint32_t width = lanes == SIMD_LANES_MAX ? SIMD_LANES_MAX : 4u;
    for (uint32_t i = 0; i < shoal->count;) {
        struct fish *fish = &shoal->fish[i];
        const struct body *body = &shoal->body[i];
        if (is_block(shoal, i, width)) {
            SIMD_PICK(lanes, swim_settle_block)(shoal, i);
            i += width;
            continue;
        }
        if (fish_swims(fish)) {
            shoal->way_m[i] += v3_length(v3_sub(body->centre_m, fish->position_m));
            fish->position_m = body->centre_m;
            swim_settle(fish, v3_sub(body->centre_m, shoal->before_m[i]),
                        v3_scale(body->back, -1.0f));
        }
        i++;
    }
}
