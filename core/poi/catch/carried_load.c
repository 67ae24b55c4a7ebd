/* carried_load.c -- computes the loads of carried fish: one load for each body and one for each
 * slap. */
#include "core/poi/catch/carried_load.h"

#include "core/base/panic.h"

#define BODY_FOOT_M 0.020f /* Diameter of the patch of paper on which a body acts. */

float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish)
{
    const float paper_y =
        poi->position_m.y + carried->x_m * axes->right.y + carried->z_m * axes->back.y;
    return f_clamp(1.0f + paper_y / fish->width_m, 0.0f, 1.0f);
}

static void add_load(struct poi *poi, struct sheet_load load)
{
    if (load.force_n != 0.0f) {
        CORE_ASSERT(poi->load_count < SHEET_LOAD_MAX);
        poi->loads[poi->load_count++] = load;
    }
}

/* Adds the load of a slap at the fish's tail or body. If the slap ends during this tick, the force
 * is reduced in proportion to its remaining time. */
static void add_slap(struct poi *poi, const struct carried_fish *carried, const struct fish *fish)
{
    const float share = f_min(1.0f, carried->slap_s * (float)CORE_TICK_HZ);
    const float force_n = -carried->slap_n * share;
    float x, z;
    carried_fish_tail(carried, fish->length_m, &x, &z);
    if (share <= 0.0f) {
        return;
    }
    if (sheet_holds(&poi->sheet, x, z)) {
        add_load(poi, (struct sheet_load){ x, z, carried->slap_d_m, force_n });
    } else {
        add_load(poi, (struct sheet_load){ carried->x_m, carried->z_m, BODY_FOOT_M, force_n });
    }
}

void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish)
{
    poi->load_count = 0;
    poi->carried_kg = 0.0f;
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        if (poi->carried_fish[i].state == CARRIED_LYING) {
            add_slap(poi, &poi->carried_fish[i], &fish[poi->carried_fish[i].fish]);
        }
    }
    poi->slap_count = poi->load_count;
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        const struct carried_fish *carried = &poi->carried_fish[i];
        const struct fish *who = &fish[carried->fish];
        if (carried->state == CARRIED_LYING) {
            const float kg =
                fish_mass_kg(who->length_m) * carried_load_dryness(poi, axes, carried, who);
            poi->carried_kg += kg;
            add_load(poi, (struct sheet_load){ carried->x_m, carried->z_m, BODY_FOOT_M,
                                               f_min(kg * pull_m_s2, 0.0f) });
        }
    }
}
