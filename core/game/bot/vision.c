/* vision.c -- the only file of the bot that reads the game and the world. The file reads only the
 * fields that core/core_scene.c shows. */
#include "core/game/bot/vision.h"

#include "core/base/panic.h"
#include "core/game/control/controller.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/poi/world.h"
#include "core/scene_helpers.h"
#include "core/tank/behavior/surface_breathing.h"

struct vision_game vision_game(const struct vision *vision)
{
    const struct game *game = vision->game;
    CORE_ASSERT(vision->player < POI_MAX);
    return (struct vision_game){
        .tick = game->tick,
        .phase = game->phase,
        .mode = game->mode,
        .fouls = game->player[vision->player].fouls,
        .seconds_left = game_seconds_left(game, game->tick),
        .tank_m = vision->world->tank.size_m,
        .fish_count = vision->world->tank.fish_count,
    };
}

struct vision_fish vision_fish(const struct vision *vision, uint32_t fish)
{
    CORE_ASSERT(fish < vision->world->tank.fish_count);
    const struct fish *seen = &vision->world->tank.fish[fish];
    return (struct vision_fish){
        .position_m = seen->position_m,
        .angles = seen->angles,
        .length_m = seen->length_m,
        .bend_rad = seen->bend_rad,
        .gape = surface_gape(seen, vision->game->tick),
        .gulp = surface_gulp(seen, vision->game->tick),
        .place = scene_place_of(seen->gait),
    };
}

struct vision_poi vision_poi(const struct vision *vision, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct poi *poi = &vision->world->poi[index];
    if (!controller_is_active(vision->world, index)) {
        return (struct vision_poi){ 0 };
    }
    return (struct vision_poi){
        .present = 1,
        .position_m = poi->position_m,
        .angles = poi->angles,
        .radius_m = poi_radius_m(poi),
        .paper_left = sheet_left(&poi->sheet),
        .water_m = carried_water_m(poi),
    };
}

struct vision_bowl vision_bowl(const struct vision *vision, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct bowl *bowl = &vision->world->bowl[index];
    if (!bowl->present) {
        return (struct vision_bowl){ 0 };
    }
    return (struct vision_bowl){ .present = 1,
                                 .position_m = bowl->position_m,
                                 .radius_m = BOWL_RADIUS_M };
}

uint8_t vision_integrity(const struct vision *vision, uint32_t cell)
{
    CORE_ASSERT(cell < SHEET_CELL_COUNT && vision->player < POI_MAX);
    return scene_integrity(&vision->world->poi[vision->player].sheet, cell);
}

uint8_t vision_wetness(const struct vision *vision, uint32_t cell)
{
    CORE_ASSERT(cell < SHEET_CELL_COUNT && vision->player < POI_MAX);
    return scene_wetness(&vision->world->poi[vision->player].sheet, cell);
}
