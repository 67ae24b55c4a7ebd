/* sight.c -- the only file of the bot that accesses the core. The file reads the fields that
 * core/scene.c shows, and no others. */
#include "core/game/sight.h"

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/hand.h"
#include "core/show.h"
#include "core/tank/surface.h"

struct sight_game sight_game(const struct sight *sight)
{
    const struct core *core = sight->core;
    CORE_ASSERT(sight->player < POI_MAX);
    return (struct sight_game){
        .tick = core->tick,
        .phase = core->game.phase,
        .mode = core->game.mode,
        .fouls = core->game.player[sight->player].fouls,
        .seconds_left = game_seconds_left(&core->game, core->tick),
    };
}

vec3 sight_tank_m(const struct sight *sight)
{
    return sight->core->tank.size_m;
}

uint32_t sight_fish_count(const struct sight *sight)
{
    return sight->core->tank.fish_count;
}

struct sight_fish sight_fish(const struct sight *sight, uint32_t fish)
{
    CORE_ASSERT(fish < sight->core->tank.fish_count);
    const struct fish *seen = &sight->core->tank.fish[fish];
    return (struct sight_fish){
        .position_m = seen->position_m,
        .angles = seen->angles,
        .length_m = seen->length_m,
        .bend_rad = seen->bend_rad,
        .gape = surface_gape(seen, sight->core->tick),
        .gulp = surface_gulp(seen, sight->core->tick),
        .place = show_place(seen->gait),
    };
}

struct sight_poi sight_poi(const struct sight *sight, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct poi *poi = &sight->core->poi[index];
    if (!hand_plays(sight->core, index)) {
        return (struct sight_poi){ 0 };
    }
    return (struct sight_poi){
        .present = 1,
        .position_m = poi->position_m,
        .angles = poi->angles,
        .radius_m = POI_RADIUS_M,
        .paper_left = sheet_left(&poi->sheet),
        .water_m = poi_water_m(poi),
    };
}

struct sight_bowl sight_bowl(const struct sight *sight, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct bowl *bowl = &sight->core->bowl[index];
    if (!bowl->present) {
        return (struct sight_bowl){ 0 };
    }
    return (struct sight_bowl){
        .present = 1, .position_m = bowl->position_m, .radius_m = BOWL_RADIUS_M
    };
}

struct sight_fan sight_fan(const struct sight *sight, uint32_t index)
{
    CORE_ASSERT(index < SHADE_MAX);
    const struct shade *shade = &sight->core->tank.shade[index];
    if (!shade->cast.present) {
        return (struct sight_fan){ 0 };
    }
    return (struct sight_fan){
        .present = 1,
        .x_m = shade->cast.x_m,
        .z_m = shade->cast.z_m,
        .radius_m = shade->cast.radius_m,
        .still_s = shade->still_s,
    };
}

static const struct sheet *own_paper(const struct sight *sight, uint32_t cell)
{
    CORE_ASSERT(cell < SHEET_CELL_COUNT);
    CORE_ASSERT(sight->player < POI_MAX);
    return &sight->core->poi[sight->player].sheet;
}

uint8_t sight_integrity(const struct sight *sight, uint32_t cell)
{
    return show_integrity(own_paper(sight, cell), cell);
}

uint8_t sight_wetness(const struct sight *sight, uint32_t cell)
{
    return show_wetness(own_paper(sight, cell), cell);
}
