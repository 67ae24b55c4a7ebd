/* table_setup.c -- functions that prepare the table for a game: open the tank, place the bowls and
 * supply paper. */
#include "core/game/table_setup.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/control/controller.h"
#include "core/game/rules.h"

uint32_t game_poi_seed(uint32_t seed, uint32_t index, uint32_t number, enum game_series series)
{
    CORE_ASSERT(index < POI_MAX && series <= GAME_SERIES_SPARE);
    return rng_u32(
        (struct rng_key){ seed, number, index + POI_MAX * (uint32_t)series, RNG_ROUND_SEED });
}

/* ---- Modes, tank and paper of a configuration ------------------------------------------------ */

uint8_t table_setup_modes(const struct core_config *config)
{
    CORE_ASSERT(config->modes < 1u << CHOICE_COUNT);
    return config->modes ? config->modes : 1u << MODE_FESTIVAL;
}

uint8_t table_setup_first_mode(const struct core_config *config)
{
    const uint8_t modes = table_setup_modes(config);
    uint8_t mode = 0;
    while (!(modes & (1u << mode))) {
        mode++;
    }
    return mode < MODE_COUNT ? mode : (uint8_t)MODE_FESTIVAL;
}

uint8_t table_setup_preset(const struct core_config *config, uint8_t mode)
{
    CORE_ASSERT(mode < MODE_COUNT);
    const uint8_t preset = rules_of(mode)->tank;
    return preset == RULES_STALLS_TANK ? config->preset : preset;
}

uint8_t table_setup_grade(const struct core_config *config, uint8_t mode)
{
    const uint8_t grade = rules_of(mode)->grade;
    const uint8_t own = config->grade ? config->grade : GAME_POI_GRADE;
    const bool is_only_mode = table_setup_modes(config) == 1u << mode;
    return grade && !(config->grade && is_only_mode) ? grade : own;
}

/* Initializes `poi` with dry paper and with the ring and the paper grade of the player's level. */
static void init_poi(const struct game *game, const struct core_config *config, uint32_t index,
                     struct poi *poi, vec3 position_m, uint32_t seed)
{
    const uint8_t level = game->player[index].level;
    const uint8_t grade = rules_grade_at_level(table_setup_grade(config, game->mode), level);
    poi_init_sized(poi, grade, rules_of_level(level)->ring_radius_m, position_m, seed);
}

uint32_t table_setup_round_s(const struct core_config *config, uint8_t mode)
{
    return config->round_s ? config->round_s : rules_of(mode)->round_s;
}

/* ---- Opening of the tank, with bowls and pois ------------------------------------------------ */

static uint32_t player_count(const struct core_config *config)
{
    CORE_ASSERT(config->players <= POI_MAX);
    return config->players ? config->players : 1u;
}

static uint32_t preset_fish_count(const struct core_config *config, uint8_t preset)
{
    CORE_ASSERT(preset < TANK_PRESET_COUNT);
    const bool is_own = preset == config->preset && config->fish_count != 0;
    return is_own ? config->fish_count : tank_preset(preset)->fish_count;
}

static void place_all(struct control control[POI_MAX], const struct game *game, struct world *world,
                      const struct core_config *config, const struct tank_preset *preset)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint32_t seed = game_poi_seed(config->seed, i, game->round_count, GAME_SERIES_ROUND);
        const uint8_t link = world->poi[i].link;
        init_poi(game, config, i, &world->poi[i], parking_place(world, i).position_m, seed);
        world->poi[i].link = link;
        control[i].target_pose = parking_place(world, i);
        /* The next source of the poi then takes control from the rest position. */
        control[i].holder = POI_SOURCE_ABSENT;
        controller_forget_path(&control[i]);
        world->bowl[i] = (struct bowl){ 0 };
        if (i < player_count(config)) {
            bowl_init(&world->bowl[i], preset->bowl_m[i]);
        }
    }
}

static void open_tank(struct world *world, const struct core_config *config, uint32_t tick,
                      uint8_t preset, uint32_t seed)
{
    struct tank_config opening = tank_config_of(preset);
    opening.fish_count = preset_fish_count(config, preset);
    opening.seed = seed;
    opening.bowls = (uint8_t)player_count(config);
    opening.lanes = config->lanes;
    const bool opened = tank_open(&world->tank, &opening);
    CORE_ASSERT(opened);
    for (uint32_t i = 0; i < world->tank.fish_count; i++) {
        /* Treat the fish as if it had made its last decision in the current tick. */
        world->tank.fish[i].thought_tick = (uint8_t)tick;
    }
}

void table_setup_open(struct control control[POI_MAX], const struct game *game, struct world *world,
                      const struct core_config *config)
{
    CORE_ASSERT(config->preset < TANK_PRESET_COUNT);
    open_tank(world, config, game->tick, config->preset, config->seed);
    place_all(control, game, world, config, tank_preset(config->preset));
}

/* Prepares the tank for a game. A new tank is opened only if the present tank does not match, for
 * example because the operator changed the number of fish or players in the menu. */
void table_setup_prepare(struct control control[POI_MAX], const struct game *game,
                         struct world *world, const struct core_config *config, uint8_t preset)
{
    CORE_ASSERT(preset < TANK_PRESET_COUNT);
    bool is_set_up =
        preset == world->tank.preset && world->tank.fish_count == preset_fish_count(config, preset);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        is_set_up = is_set_up && world->bowl[i].present == (i < player_count(config));
    }
    if (!is_set_up) {
        const struct rng_key key = { config->seed, game->round_count, preset, RNG_TANK_SEED };
        open_tank(world, config, game->tick, preset, rng_u32(key));
        place_all(control, game, world, config, tank_preset(preset));
    }
}

/* ---- Side of the bowl ------------------------------------------------------------------------ */

uint8_t table_setup_bowl_place(const struct world *world, const struct core_config *config,
                               bool is_turned, vec3 dip_m)
{
    const int32_t side = config->persistent.settings.value[SET_SIDE];
    CORE_ASSERT(side >= 0 && side < BOWL_SIDE_COUNT);
    const bool turns = is_turned && config_has_rules(config, 12);
    const float width_m = turns ? world->tank.size_m.z : world->tank.size_m.x;
    const float dip_x_m = turns || !is_turned ? dip_m.x : view_to_world(true, dip_m).x;
    const bool is_left_dip = dip_x_m < -width_m / 6.0f;
    const bool is_left = side == BOWL_LEFT || (side == BOWL_BY_FIRST_DIP && is_left_dip);
    return !config_has_rules(config, 10) ? BOWL_PLACE_RIGHT
           : turns                       ? (is_left ? BOWL_PLACE_NEAR_LEFT : BOWL_PLACE_NEAR_RIGHT)
           : is_left                     ? BOWL_PLACE_LEFT
                                         : BOWL_PLACE_RIGHT;
}

void table_setup_moor_bowl(const struct game *game, struct world *world,
                           const struct core_config *config)
{
    CORE_ASSERT(game->bowl_place < BOWL_PLACE_COUNT);
    const vec3 home_m = tank_preset(world->tank.preset)->bowl_m[0];
    const uint8_t place = player_count(config) == 1u ? game->bowl_place : BOWL_PLACE_RIGHT;
    world->bowl[0].home_m.x = place == BOWL_PLACE_LEFT ? -home_m.x : home_m.x;
    world->bowl[0].home_m.z = place == BOWL_PLACE_NEAR_RIGHT ? -home_m.z : home_m.z;
}

/* ---- Replacement of paper, and emptying of bowls --------------------------------------------- */

void table_setup_replace_poi(const struct game *game, struct world *world,
                             const struct core_config *config, uint32_t index, uint32_t number,
                             enum game_series series)
{
    CORE_ASSERT(index < POI_MAX);
    struct poi *poi = &world->poi[index];
    const uint8_t link = poi->link;
    const struct angles angles = poi->angles;
    const uint32_t carried_count = poi->carried_count;
    struct carried_fish carried_fish[POI_CARRIED_MAX];
    parking_release_all(poi, &world->tank);
    memcpy(carried_fish, poi->carried_fish, sizeof carried_fish);
    init_poi(game, config, index, poi, poi->position_m,
             game_poi_seed(config->seed, index, number, series));
    poi->link = link;
    poi->angles = angles;
    poi->carried_count = carried_count;
    memcpy(poi->carried_fish, carried_fish, sizeof carried_fish);
}

void table_setup_empty_bowls(struct world *world)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        bowl_empty(&world->bowl[i], i, &world->tank);
    }
}
