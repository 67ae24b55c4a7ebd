/* tank_open.c -- opens a tank: validates its configuration, creates the fish and places the fish
 * without overlap. */
#include "core/tank/tank.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/base/simd.h"
#include "core/morph/morph.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/behavior/swim.h"

/* Largest number of random start places that are tried for a fish, until a place is found that is
 * not under a bowl. If all places are under bowls, the last place is used. */
#define PLACE_TRIES 12u
/* Largest number of rounds of pushes that separate overlapping fish when a tank is opened. Full
 * tanks take 3 to 48 rounds. */
#define START_ROUNDS_MAX 100u
/* Largest number of attempts to place all fish at random when a tank is opened. In 1 % of the
 * smallest tanks, the fish of the first attempt cannot be separated. */
#define START_DRAWS_MAX 8u
/* Largest distance by which one round of pushes moves a fish. */
#define START_SHOVE_M 0.004f

/* ---- Validation of the configuration --------------------------------------------------------- */

struct tank_config tank_config_of(uint8_t preset_id)
{
    const struct tank_preset *preset = tank_preset(preset_id);
    return (struct tank_config){
        .preset = preset_id,
        .fish_count = preset->fish_count,
        .seed = 1,
        .area_scale = 1.0f,
        .wall_follow = preset->params.wall_follow,
        .stamina_min = preset->stamina_min,
        .stamina_max = preset->stamina_max,
        .temperature_c = preset->temperature_c,
        .pressure_hpa = OXYGEN_PRESSURE_HPA,
        .oxygen_mg_l = TANK_OXYGEN_SATURATED,
        .time_compression = preset->time_compression,
        .pump = preset->pump,
        .bowls = 1,
    };
}

static bool is_within_range(float value, float low, float high)
{
    return value >= low && value <= high; /* This form of the comparison rejects NaN, because every
                                             comparison with NaN is false. */
}

static bool side_fits(float side_m, float low_m, float high_m)
{
    return side_m == 0.0f || is_within_range(side_m, low_m, high_m);
}

static vec3 tank_size_of(const struct tank_config *config)
{
    CORE_ASSERT(config->area_scale > 0.0f);
    const vec3 own_m = tank_preset(config->preset)->size_m, wanted_m = config->size_m;
    const float side = f_sqrt(config->area_scale);
    return v3(side * (wanted_m.x > 0.0f ? wanted_m.x : own_m.x),
              wanted_m.y > 0.0f ? wanted_m.y : own_m.y,
              side * (wanted_m.z > 0.0f ? wanted_m.z : own_m.z));
}

uint32_t tank_config_fish_max(const struct tank_config *config)
{
    if (!side_fits(config->size_m.x, TANK_SIDE_MIN_M, TANK_SIDE_MAX_M) ||
        !side_fits(config->size_m.y, TANK_DEPTH_MIN_M, TANK_DEPTH_MAX_M) ||
        !side_fits(config->size_m.z, TANK_SIDE_MIN_M, TANK_SIDE_MAX_M) ||
        !is_within_range(config->area_scale, TANK_AREA_SCALE_MIN, TANK_AREA_SCALE_MAX)) {
        return 0;
    }
    const vec3 own_m = tank_preset(config->preset)->size_m, size_m = tank_size_of(config);
    const float own_m3 = own_m.x * own_m.y * own_m.z;
    return tank_preset_fish_max(tank_preset(config->preset),
                                size_m.x * size_m.y * size_m.z / own_m3);
}

static bool config_fits(const struct tank_config *config)
{
    return config->preset < TANK_PRESET_COUNT && config->fish_count >= 1u &&
           config->fish_count <= tank_config_fish_max(config) &&
           is_within_range(config->wall_follow, 0.0f, 1.0f) && config->stamina_min >= 0.0f &&
           config->stamina_max <= 1.0f && config->stamina_min <= config->stamina_max &&
           (is_within_range(config->temperature_c, OXYGEN_TEMPERATURE_MIN_C,
                            OXYGEN_TEMPERATURE_MAX_C) &&
            is_within_range(config->pressure_hpa, OXYGEN_PRESSURE_MIN_HPA,
                            OXYGEN_PRESSURE_MAX_HPA) &&
            is_within_range(config->time_compression, 0.0f, OXYGEN_TIME_COMPRESSION_MAX) &&
            (config->oxygen_mg_l == TANK_OXYGEN_SATURATED ||
             is_within_range(config->oxygen_mg_l, 0.0f, OXYGEN_MAX_MG_L))) &&
           config->bowls <= POI_MAX && simd_is_built(config->lanes) &&
           config->search <= PAIR_SEARCH_ALL;
}

/* ---- Creation and placement of the fish ------------------------------------------------------ */

/* Rectangle of the tank floor in which one fish is placed, in fractions of the floor. `x` and `z`
 * are the corner of the rectangle, `width` and `breadth` its size. */
struct plot {
    float x, z, width, breadth;
};

/* Returns the rectangle of the floor in which fish `index` is placed. The rectangles are nearly
 * square, do not overlap and are numbered row by row. Therefore fish that are near each other at
 * the start are also near each other in memory, so that a large tank uses the caches of the
 * processor well. */
static struct plot plot_of(const struct tank *tank, uint32_t index)
{
    CORE_ASSERT(index < tank->fish_count);
    const float wide = f_sqrt((float)tank->fish_count * tank->size_m.x / tank->size_m.z);
    const uint32_t columns = (uint32_t)f_max(1.0f, wide);
    const uint32_t rows = (tank->fish_count + columns - 1u) / columns;
    const uint64_t plot = (uint64_t)index * columns * rows / tank->fish_count;
    const float width = 1.0f / (float)columns, breadth = 1.0f / (float)rows;
    return (struct plot){ (float)(plot % columns) * width, (float)(plot / columns) * breadth, width,
                          breadth };
}

/* Returns a random start position of a fish in its own rectangle of the floor (plot_of()). If a
 * bowl covers the position, tries random positions in the whole tank. `draw` counts the earlier
 * attempts to place all fish; each attempt uses other random numbers. */
static vec3 start_place(const struct tank *tank, const struct fish *fish, uint32_t index,
                        const struct tank_config *config, uint32_t draw)
{
    CORE_ASSERT(index < tank->fish_count);
    CORE_ASSERT(draw < START_DRAWS_MAX);
    const struct tank_preset *preset = tank_preset(config->preset);
    const float inset_m = 0.5f * fish->length_m;
    const float half_m = 0.5f * fish->height_m;
    const float x = tank->size_m.x - 2.0f * inset_m, z = tank->size_m.z - 2.0f * inset_m;
    const uint32_t seed = tank->seed;
    vec3 point = { 0.0f, 0.0f, 0.0f };
    const uint32_t first = draw * PLACE_TRIES;
    for (uint32_t attempt = first; attempt < first + PLACE_TRIES; attempt++) {
        const struct plot plot =
            attempt == first ? plot_of(tank, index) : (struct plot){ 0.0f, 0.0f, 1.0f, 1.0f };
        const float share_x = rng_unit((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_X });
        const float share_z = rng_unit((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Z });
        point.x = x * (plot.x + plot.width * share_x - 0.5f);
        point.y = rng_range((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Y },
                            half_m - tank->size_m.y, -half_m);
        point.z = z * (plot.z + plot.breadth * share_z - 0.5f);
        const float clear_m = preset->bowl_radius_m + inset_m;
        bool is_free = true;
        for (uint32_t i = 0; i < config->bowls; i++) {
            const vec3 d = v3_flat(v3_sub(point, preset->bowl_m[i]));
            is_free = is_free && d.x * d.x + d.z * d.z >= clear_m * clear_m;
        }
        if (is_free) {
            break;
        }
    }
    return point;
}

static struct fish fish_create(const struct tank *tank, const struct tank_config *config,
                               uint32_t index)
{
    CORE_ASSERT(index < tank->fish_count);
    const struct tank_preset *preset = tank_preset(config->preset);
    const struct perception around = tank_perception(tank, 0, NULL, 0);
    const float old = rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_AGE });
    struct fish fish = { .look = rng_u32((struct rng_key){ tank->seed, 0, index, RNG_FISH_LOOK }) };
    fish.age_days = tank_preset_age_days(preset, old);
    const float spread = preset->length_spread;
    const struct rng_key key = { tank->seed, 0, index, RNG_FISH_LENGTH };
    fish_grow(&fish,
              preset->length_m > 0.0f ? preset->length_m * (1.0f + rng_range(key, -spread, spread))
                                      : growth_length_m(&species_wakin.card.growth, fish.age_days),
              around.params);
    fish.stamina = rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_STAMINA },
                             config->stamina_min, config->stamina_max);
    fish.position_m = start_place(tank, &fish, index, config, 0);
    fish.angles.yaw_rad =
        rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_YAW }, -F_PI, F_PI);
    fish.brake = 1.0f;
    fish.room = 1.0f;
    fish.tail_beat_hz = 0.5f;
    fish.tail_amplitude = 0.15f;
    fish.tail_phase_rad = (float)(fish.look & 1023u) * (F_TAU / 1024.0f);
    /* The initial gait is random. The probability of a gait is the fraction of time that a fish
     * spends in that gait, as if the fish had been in the water for a long time. */
    const struct gait_chance share = gait_shares(fish.stamina);
    const float draw = rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_START_GAIT });
    gait_enter(&fish,
               draw < share.swim                 ? GAIT_SWIM
               : draw < share.swim + share.burst ? GAIT_BURST
                                                 : GAIT_REST,
               index, &around);
    fish.heading_rad = fish.angles.yaw_rad; /* Undoes the random change of heading by gait_enter(),
                                               because the fish did not really change its gait. */
    swim_resolve(&fish, &around);
    /* Shortens the first gait by a random fraction, as if the gait had begun before the start. */
    fish.gait_left_s *= rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_START_LEFT });
    return fish;
}

/* Pushes the fish apart until no two fish overlap. Pushing takes less time than choosing new random
 * places. Returns true on success. */
static bool spread_out(struct tank *tank)
{
    CORE_ASSERT(tank->fish_count > 0);
    const struct solver_context place = { tank->fish, tank_bounds(tank), NULL,
                                          0,          START_SHOVE_M,     tank->lanes };
    for (uint32_t round = 0; round < START_ROUNDS_MAX; round++) {
        const struct perception around = tank_perception(tank, round, NULL, 0);
        broad_phase_gather(&tank->broad_phase, tank->fish, tank->fish_count, tank->space);
        contact_solver_substep_count(&tank->solver, &place);
        contact_solver_begin(&tank->solver, tank->fish, tank->fish_count);
        contact_solver_project(&tank->solver, &tank->broad_phase, &place);
        broad_phase_update(&tank->broad_phase, tank->fish, tank_search(tank), &around);
        if (round > 0 && tank->broad_phase.overlap_count == 0) {
            return true;
        }
        contact_solver_relax(&tank->solver, &tank->broad_phase, &place);
        contact_solver_write_back(&tank->broad_phase, tank->fish);
    }
    return false;
}

/* ---- Functions that open a tank and place its fish ------------------------------------------- */

bool tank_open(struct tank *tank, const struct tank_config *config)
{
    if (!config_fits(config)) {
        return false;
    }
    const struct tank_preset *preset = tank_preset(config->preset);
    memset(tank, 0, sizeof *tank);
    tank->seed = config->seed;
    tank->preset = config->preset;
    tank->lanes = config->lanes;
    tank->search = config->search;
    tank->size_m = tank_size_of(config);
    tank->wall_height_m = f_max(preset->wall_height_m, tank->size_m.y);
    tank->wall_follow = config->wall_follow;
    tank->ball_spaces = config->ball_spaces;
    tank->fish_count = config->fish_count;
    const bool full = config->oxygen_mg_l == TANK_OXYGEN_SATURATED;
    tank->oxygen = (struct oxygen){
        .dissolved_mg_l = full ? oxygen_saturation_mg_l(config->temperature_c, config->pressure_hpa)
                               : config->oxygen_mg_l,
        .temperature_c = config->temperature_c,
        .pressure_hpa = config->pressure_hpa,
        .time_compression = config->time_compression,
        .pump = config->pump,
    };
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        tank->fish[i] = fish_create(tank, config, i);
    }
    tank->space = broad_phase_space(tank->fish, tank->fish_count, tank->size_m, &preset->params);
    /* Separates the fish. If the separation fails, chooses new random places for all fish and tries
     * again, at most START_DRAWS_MAX times in total. */
    for (uint32_t draw = 1; !spread_out(tank); draw++) {
        if (draw == START_DRAWS_MAX) {
            return false;
        }
        for (uint32_t i = 0; i < tank->fish_count; i++) {
            tank->fish[i].position_m = start_place(tank, &tank->fish[i], i, config, draw);
        }
    }
    return true;
}

void tank_stage_all(struct tank *tank, const struct tank_stage *stages, uint32_t count)
{
    CORE_ASSERT(stages || count == 0);
    CORE_ASSERT(count <= tank->fish_count);
    const struct perception around = tank_perception(tank, 0, NULL, 0);
    for (uint32_t i = 0; i < count; i++) {
        const struct tank_stage *wanted = &stages[i];
        struct fish *fish = &tank->fish[i];
        CORE_ASSERT(wanted->gait <= GAIT_BURST || wanted->gait == GAIT_SURFACE);
        if (wanted->length_m > 0.0f) {
            fish_grow(fish, wanted->length_m, around.params);
        }
        fish->position_m = wanted->position_m;
        fish->angles = wanted->angles;
        fish->heading_rad = wanted->angles.yaw_rad;
        fish->depth_goal_m = wanted->position_m.y;
        fish->stamina = wanted->stamina;
        fish->gait = wanted->gait;
        fish->gait_left_s = wanted->gait == GAIT_BURST ? 3.0f : 20.0f; /* Longest duration of a
                                                                          burst (3 s) and of other
                                                                          gaits (20 s), as in
                                                                          gait.c. */
        fish->speed_m_s = wanted->speed_m_s;
        fish->velocity_m_s = v3_scale(fish_forward(fish), wanted->speed_m_s);
        fish->air = AIR_ENOUGH;
        if (wanted->gait == GAIT_SURFACE) {
            surface_stage(fish, around.params);
        }
        swim_resolve(fish, &around); /* Sets the goals, which the fish keeps until its first
                                        decision. */
    }
    tank->space = broad_phase_space(tank->fish, tank->fish_count, tank->size_m, around.params);
}
