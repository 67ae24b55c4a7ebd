/* release.c -- converts carried fish to falling fish. */
#include "core/game/control/release.h"

#include "core/base/panic.h"
#include "core/poi/catch/capture.h"

#define THROW_M_S_MAX 0.3f /* Highest speed of a released fish, so that the fish is not thrown. */

void release_all(struct poi *poi, const struct tank *tank)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        struct carried_fish *carried = &poi->carried_fish[i];
        if (carried->state == CARRIED_LYING) {
            const vec3 velocity_m_s = tank->fish[carried->fish].velocity_m_s;
            catch_fall_begin(carried, v3_limit(velocity_m_s, THROW_M_S_MAX));
        }
        carried->state = CARRIED_RELEASED;
    }
    poi->carried_kg = 0.0f;
    poi->load_count = 0;
}

static int is_held(const struct fish *fish, uint32_t poi_index)
{
    return fish->gait == GAIT_HELD && fish->holder == poi_index;
}

/* Releases fish that are marked as held but are missing in the poi's list, because no other code
 * would let them fall. */
static void free_the_forgotten(const struct poi *poi, uint32_t poi_index, struct tank *tank)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        if (is_held(&tank->fish[i], poi_index) && !catch_has_carried(poi, i)) {
            catch_set_free(tank, &tank->fish[i], v3(0.0f, 0.0f, 0.0f));
        }
    }
}

void release_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                  struct catch_result results[POI_MAX])
{
    struct tank *tank = stall->tank;
    uint32_t i = 0;
    release_all(poi, tank);
    while (i < poi->carried_count) {
        struct carried_fish *carried = &poi->carried_fish[i];
        const int is_ours = is_held(&tank->fish[carried->fish], poi_index);
        uint32_t bowl = 0;
        const enum fall_end end =
            is_ours ? catch_fall_tick(carried, stall, &bowl) : FALL_INTO_WATER;
        if (end == FALL_INTO_BOWL) {
            catch_count(carried, poi_index, bowl, results);
        }
        if (end == FALL_GOES_ON) {
            i++;
        } else {
            poi->carried_count--;
            *carried = poi->carried_fish[poi->carried_count];
        }
    }
    free_the_forgotten(poi, poi_index, tank);
}
