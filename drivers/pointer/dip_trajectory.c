/* dip_trajectory.c -- implements a dip as a quintic polynomial between two heights. */
#include "drivers/pointer/dip_trajectory.h"

/* Initial acceleration of a downward stroke, so that the first frames after the click show motion.
 * The value is twice that of the smoothest stroke. The ring is still above the water during this
 * acceleration. An upward stroke starts under water and has no added acceleration. */
#define START_M_S2 (-16.0f)

void dip_init(struct dip *dip)
{
    *dip = (struct dip){ .from_m = DIP_HOVER_M, .to_m = DIP_HOVER_M };
}

/* Evaluates the quintic polynomial. The polynomial starts with the height, velocity and
 * acceleration in `dip`, and ends at rest at dip->to_m. */
struct dip_state dip_at(const struct dip *dip, uint64_t time_ns)
{
    const float total = dip->duration_s;
    const float t = time_ns > dip->start_ns ? (float)(time_ns - dip->start_ns) * 1e-9f : 0.0f;
    if (t >= total) {
        return (struct dip_state){ .height_m = dip->to_m };
    }
    const float distance = dip->to_m - dip->from_m;
    const float v = dip->from_m_s * total;
    const float a = 0.5f * dip->from_m_s2 * total * total;
    const float c3 = 10.0f * distance - 6.0f * v - 3.0f * a;
    const float c4 = -15.0f * distance + 8.0f * v + 3.0f * a;
    const float c5 = 6.0f * distance - 3.0f * v - a;
    const float s = t / total;
    return (struct dip_state){
        .height_m = dip->from_m + s * (v + s * (a + s * (c3 + s * (c4 + s * c5)))),
        .speed_m_s =
            (v + s * (2.0f * a + s * (3.0f * c3 + s * (4.0f * c4 + s * 5.0f * c5)))) / total,
        .acceleration_m_s2 =
            (2.0f * a + s * (6.0f * c3 + s * (12.0f * c4 + s * 20.0f * c5))) / (total * total),
    };
}

void dip_begin(struct dip *dip, uint64_t time_ns, int down)
{
    const struct dip_state now = dip_at(dip, time_ns);
    dip->from_m = now.height_m;
    dip->from_m_s = now.speed_m_s;
    dip->from_m_s2 = down ? f_min(now.acceleration_m_s2, START_M_S2) : now.acceleration_m_s2;
    dip->to_m = down ? DIP_DEPTH_M : DIP_HOVER_M;
    dip->duration_s = down ? DIP_DOWN_S : DIP_UP_S;
    dip->start_ns = time_ns;
}

float dip_slant_rad(float speed_m_s)
{
    return DIP_SLANT_MAX_RAD * f_min(1.0f, f_abs(speed_m_s) / DIP_SLANT_AT_M_S);
}
