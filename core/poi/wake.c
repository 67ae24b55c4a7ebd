/* wake.c -- presses on the height field of the surface. */
#include "core/poi/wake.h"

void wake_tick(const struct poi *poi, struct water *water, vec3 tank_size_m)
{
    const float depth = -poi->position_m.y;
    const float heave = poi->velocity_m_s.y * CORE_TICK_S;
    if (poi->immersed > 0.0f && poi->immersed < 1.0f) {
        const float sweep = v3_length(poi->velocity_m_s) * CORE_TICK_S;
        const float press = f_clamp(0.5f * sweep - 0.5f * heave, -0.004f, 0.004f);
        water_press(water, tank_size_m, poi->position_m, POI_OUTER_RADIUS_M, press);
    } else if (poi->immersed >= 1.0f) {
        const float press = -0.5f * heave * f_exp(-depth / 0.03f);
        water_press(water, tank_size_m, poi->position_m, POI_OUTER_RADIUS_M,
                    f_clamp(press, -0.003f, 0.003f));
    }
}
