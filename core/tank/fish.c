/* fish.c -- computes the size, the box, the mass and the direction of a fish. */
#include "core/tank/fish.h"

#include "core/base/panic.h"

void fish_grow(struct fish *fish, float length_m, const struct behavior_params *params)
{
    CORE_ASSERT(length_m > 0.0f);
    fish->length_m = length_m;
    fish->height_m = params->height_per_length * length_m;
    fish->width_m = params->width_per_length * length_m;
    fish->speed_up_keep = 0.0f; /* The next call of swim_resolve() computes the factor again,
                                   because the acceleration depends on the length. */
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

/* Greatest length of a calm fish (fish_is_calm()). Half of the fish in the festival tank are
 * shorter than this length. */
#define CALM_LENGTH_M 0.045f

bool fish_is_calm(const struct fish *fish, const struct temper *temper)
{
    CORE_ASSERT(temper->calm_share >= 0.0f && temper->calm_share <= 1.0f);
    const float draw = (float)((fish->look * 2654435761u) >> 24) * (1.0f / 256.0f);
    return draw < temper->calm_share && fish->length_m <= CALM_LENGTH_M;
}
