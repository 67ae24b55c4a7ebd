/* fish.c -- computes the size, the box, the mass, the direction and the hash of a fish. */
#include "core/tank/fish.h"

#include "core/base/hash.h"
#include "core/base/panic.h"

void fish_grow(struct fish *fish, float length_m, const struct behavior_params *params)
{
    CORE_ASSERT(length_m > 0.0f);
    fish->length_m = length_m;
    fish->height_m = params->height_per_length * length_m;
    fish->width_m = params->width_per_length * length_m;
    fish->speed_up_keep = 0.0f; /* The value 0 makes the next call of swim_resolve() compute
                                   `speed_up_keep` for the new length. */
}

struct box fish_box(const struct fish *fish)
{
    return (struct box){
        .centre_m = fish->position_m,
        .axes = vec_basis_from_angles(fish->angles),
        .half_m = { 0.5f * fish->width_m, 0.5f * fish->height_m, 0.5f * fish->length_m },
    };
}

float fish_mass_kg(float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    return 2.10e-5f * f_exp(3.0598f * f_log(100.0f * length_m));
}

vec3 fish_forward(const struct fish *fish)
{
    const float cos_pitch = f_cos(fish->angles.pitch_rad);
    return v3(-f_sin(fish->angles.yaw_rad) * cos_pitch, f_sin(fish->angles.pitch_rad),
              -f_cos(fish->angles.yaw_rad) * cos_pitch);
}

uint64_t fish_hash_quick(uint64_t hash, const struct fish *fish)
{
    hash = hash_vec3(hash, fish->position_m);
    hash = hash_float(hash, fish->angles.yaw_rad);
    hash = hash_float(hash, fish->angles.pitch_rad);
    hash = hash_float(hash, fish->angles.roll_rad);
    return hash_u32(hash, fish->gait);
}

uint64_t fish_hash(uint64_t hash, const struct fish *fish)
{
    CORE_ASSERT(fish->gait < GAIT_COUNT);
    CORE_ASSERT(fish->air <= AIR_DUCKS);
    /* clang-format off */
    const float values[] = {
        fish->speed_m_s,      fish->climb_m_s,  fish->yaw_rate_rad_s, fish->age_days,
        fish->length_m,       fish->stamina,    fish->tail_phase_rad, fish->tail_beat_hz,
        fish->tail_amplitude, fish->bend_rad,   fish->gait_left_s,    fish->heading_rad,
        fish->avoid_left_s,   fish->avoid_turn, fish->brake,          fish->depth_goal_m,
        fish->alarm,          fish->room,       fish->height_m,       fish->width_m,
        fish->depth_stray,
        fish->drawn_rad,      fish->speed_goal_m_s, fish->speed_up_keep, fish->slow_keep,
        fish->turn_rate_max_rad_s, fish->haste, fish->climb_goal_m_s, fish->pitch_goal_rad,
        fish->beats,          fish->habit,      fish->startle_s,  fish->refractory_s,
        fish->escape_s,       fish->escape_from_rad, fish->escape_turn_rad,
        fish->escape_course_rad, fish->bend_goal_rad,
    };
    /* clang-format on */
    hash = fish_hash_quick(hash, fish);
    hash = hash_vec3(hash, fish->velocity_m_s);
    hash = hash_vec3(hash, fish->push_m_s);
    hash = hash_vec3(hash, fish->startle_from_m);
    hash = hash_floats(hash, values, sizeof values / sizeof values[0]);
    hash = hash_u32(hash, fish->look);
    hash = hash_u32(hash, fish->avoid_since);
    hash = hash_u32(hash, fish->avoid_with);
    hash = hash_u32(hash, fish->avoid_kind);
    hash = hash_u32(hash, (uint32_t)fish->startle << 16 | (uint32_t)fish->air << 8 | fish->falls);
    return hash_u32(hash, (uint32_t)fish->avoiding << 16 | (uint32_t)fish->holder << 8 |
                              fish->thought_tick);
}
