/* tank.c -- the order of a tick for all fish: think, move, look, part, settle. */
#include "core/tank/tank.h"

#include "core/base/hash.h"
#include "core/base/lanes.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/morph/morph.h"
#include "core/tank/gait.h"
#include "core/tank/loose.h"
#include "core/tank/surface.h"
#include "core/tank/swim.h"
#include "core/tank/think.h"

#define PLACE_TRIES 12u /* For a spot clear of the bowl; then any will do. */
#define START_ROUNDS_MAX 200u
#define BUBBLE_TICKS 6u /* 20 a second come up, ... */
#define BUBBLES_M 0.014f /* ... so far about the stone, ... */
#define STONE_INSET_M 0.045f
#define BUBBLE_RADIUS_M 0.012f
#define BUBBLE_M 0.0011f /* ... and lift the surface so high. */
#define START_SHOVE_M 0.004f /* A round. */
#define GULP_RADIUS_M 0.010f
#define GULP_DEPTH_M 0.0004f
#define PUSH_SHARE 0.344f /* A look: pushes come and go within a twelfth of a second. */
#define ROOM_PER_S 2.0f  /* A fish that had no room takes half a second to trust that it has. */

static struct tank_bounds tank_bounds(const struct tank *tank)
{
    const vec3 half = v3_scale(tank->size_m, 0.5f);
    return (struct tank_bounds){ { -half.x, -tank->size_m.y, -half.z }, { half.x, 0.0f, half.z } };
}

const struct law *tank_law(const struct tank *tank)
{
    return &tank_preset(tank->preset)->law;
}

/* Up to the last that there is: mostly there is none, and fish need not look for any. */
static uint32_t shade_count(const struct tank *tank)
{
    uint32_t count = TANK_SHADE_MAX;
    while (count > 0 && !tank->shade[count - 1u].cast.present) {
        count--;
    }
    return count;
}

static struct surroundings surroundings_of(const struct tank *tank, uint32_t tick,
                                           const struct obstacle *obstacles,
                                           uint32_t obstacle_count)
{
    return (struct surroundings){
        .law = tank_law(tank),
        .size_m = tank->size_m,
        .wall_follow = tank->wall_follow,
        .ball_spaces = tank->ball_spaces,
        .seed = tank->seed,
        .tick = tick,
        .dt_s = CORE_TICK_S,
        .oxygen_mg_l = tank->oxygen.dissolved_mg_l,
        .obstacles = obstacles,
        .obstacle_count = obstacle_count,
        .shades = tank->shade,
        .shade_count = shade_count(tank),
    };
}

static struct crowd_search search_of(const struct tank *tank)
{
    return (struct crowd_search){ .search = tank->search, .lanes = tank->lanes };
}

static int under_bowl(vec3 point_m, vec3 bowl_m, float clear_m)
{
    const float dx = point_m.x - bowl_m.x, dz = point_m.z - bowl_m.z;
    return dx * dx + dz * dz < clear_m * clear_m;
}

/* The part of the floor that a fish is put into, as shares of it. */
struct plot {
    float x, z, width, breadth;
};

/* Each fish gets a plot of its own, about square and row by row: fish that are near each other at
 * the start are near each other in memory, too, which a tank of 100,000 is a third faster by. */
static struct plot plot_of(const struct tank *tank, uint32_t index)
{
    const float wide = f_sqrt((float)tank->fish_count * tank->size_m.x / tank->size_m.z);
    const uint32_t columns = (uint32_t)f_max(1.0f, wide);
    const uint32_t rows = (tank->fish_count + columns - 1u) / columns;
    const uint64_t plot = (uint64_t)index * columns * rows / tank->fish_count;
    const float width = 1.0f / (float)columns, breadth = 1.0f / (float)rows;
    return (struct plot){ (float)(plot % columns) * width, (float)(plot / columns) * breadth, width,
                          breadth };
}

/* In its plot; where the bowl has that, anywhere else. */
static vec3 place(const struct tank *tank, const struct fish *fish, uint32_t index,
                  const struct tank_preset *preset)
{
    const float inset_m = 0.5f * fish->length_m;
    const float half_m = 0.5f * fish->height_m;
    const float x = tank->size_m.x - 2.0f * inset_m, z = tank->size_m.z - 2.0f * inset_m;
    const uint32_t seed = tank->seed;
    vec3 point = { 0.0f, 0.0f, 0.0f };
    for (uint32_t attempt = 0; attempt < PLACE_TRIES; attempt++) {
        const struct plot plot =
            attempt == 0 ? plot_of(tank, index) : (struct plot){ 0.0f, 0.0f, 1.0f, 1.0f };
        const float share_x = rng_unit((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_X }),
                    share_z = rng_unit((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Z });
        point.x = x * (plot.x + plot.width * share_x - 0.5f);
        point.y = rng_range((struct rng_key){ seed, attempt, index, RNG_FISH_PLACE_Y },
                            half_m - tank->size_m.y, -half_m);
        point.z = z * (plot.z + plot.breadth * share_z - 0.5f);
        if (!under_bowl(point, preset->bowl_m, preset->bowl_radius_m + inset_m)) {
            break;
        }
    }
    return point;
}

static float hatch_length_m(const struct tank *tank, const struct tank_preset *preset,
                            uint32_t index, float age_days)
{
    const float spread = preset->length_spread;
    const struct rng_key key = { tank->seed, 0, index, RNG_FISH_LENGTH };
    return preset->length_m > 0.0f ? preset->length_m * (1.0f + rng_range(key, -spread, spread))
                                   : growth_length_m(&species_wakin.growth, age_days);
}

static struct fish hatch(const struct tank *tank, const struct tank_config *config, uint32_t index)
{
    const struct tank_preset *preset = tank_preset(config->preset);
    const struct surroundings around = surroundings_of(tank, 0, NULL, 0);
    const float old = rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_AGE });
    struct fish fish = { .look = rng_u32((struct rng_key){ tank->seed, 0, index, RNG_FISH_LOOK }) };
    fish.age_days = tank_preset_age_days(preset, old);
    fish_grow(&fish, hatch_length_m(tank, preset, index, fish.age_days), around.law);
    fish.stamina = rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_STAMINA },
                             config->stamina_min, config->stamina_max);
    fish.position_m = place(tank, &fish, index, preset);
    fish.angles.yaw_rad =
        rng_range((struct rng_key){ tank->seed, 0, index, RNG_FISH_YAW }, -F_PI, F_PI);
    fish.brake = 1.0f;
    fish.room = 1.0f;
    fish.tail_beat_hz = 0.5f;
    fish.tail_amplitude = 0.15f;
    fish.tail_phase_rad = (float)(fish.look & 1023u) * (F_TAU / 1024.0f);
    /* A third already swim, as in the long run; all are somewhere in the middle of what they do. */
    const struct rng_key start = { tank->seed, 0, index, RNG_FISH_START_GAIT };
    const int swims = rng_unit(start) < 0.31f;
    gait_enter(&fish, swims ? GAIT_SWIM : GAIT_REST, index, &around);
    fish.heading_rad = fish.angles.yaw_rad; /* No change of gait turned it yet. */
    swim_resolve(&fish, &around);
    fish.gait_left_s *= rng_unit((struct rng_key){ tank->seed, 0, index, RNG_FISH_START_LEFT });
    return fish;
}

/* Random places overlap; parting them until none does is quicker than drawing until none would. */
static void spread_out(struct tank *tank)
{
    const struct part_place place = { tank->fish, tank_bounds(tank), NULL, 0, START_SHOVE_M };
    for (uint32_t round = 0; round < START_ROUNDS_MAX; round++) {
        const struct surroundings around = surroundings_of(tank, round, NULL, 0);
        crowd_gather(&tank->crowd, tank->fish, tank->fish_count, tank->space);
        part_stations(&tank->part, &place);
        part_begin(&tank->part, tank->fish, tank->fish_count);
        part_clear(&tank->part, &tank->crowd, &place);
        crowd_look(&tank->crowd, tank->fish, search_of(tank), &around);
        if (round > 0 && tank->crowd.overlap_count == 0) {
            return;
        }
        part_relax(&tank->part, &tank->crowd, &place);
        part_take(&tank->crowd, tank->fish);
    }
}

struct tank_config tank_config_of(uint8_t preset_id)
{
    const struct tank_preset *preset = tank_preset(preset_id);
    return (struct tank_config){
        .preset = preset_id,
        .fish_count = preset->fish_count,
        .seed = 1,
        .area_scale = 1.0f,
        .wall_follow = preset->law.wall_follow,
        .stamina_min = preset->stamina_min,
        .stamina_max = preset->stamina_max,
        .temperature_c = preset->temperature_c,
        .pressure_hpa = OXYGEN_PRESSURE_HPA,
        .oxygen_mg_l = TANK_OXYGEN_SATURATED,
        .time_compression = preset->time_compression,
        .pump = preset->pump,
    };
}

uint32_t tank_fish_max(uint8_t preset, float area_scale)
{
    return tank_preset_fish_max(tank_preset(preset), area_scale);
}

static int within(float value, float low, float high)
{
    return value >= low && value <= high; /* So that no NaN is. */
}

static int water_fits(const struct tank_config *config)
{
    return within(config->temperature_c, OXYGEN_TEMPERATURE_MIN_C, OXYGEN_TEMPERATURE_MAX_C) &&
           within(config->pressure_hpa, OXYGEN_PRESSURE_MIN_HPA, OXYGEN_PRESSURE_MAX_HPA) &&
           within(config->time_compression, 0.0f, OXYGEN_TIME_COMPRESSION_MAX) &&
           (config->oxygen_mg_l == TANK_OXYGEN_SATURATED ||
            within(config->oxygen_mg_l, 0.0f, OXYGEN_MAX_MG_L));
}

static struct oxygen oxygen_of(const struct tank_config *config)
{
    const int full = config->oxygen_mg_l == TANK_OXYGEN_SATURATED;
    return (struct oxygen){
        .dissolved_mg_l = full ? oxygen_saturation_mg_l(config->temperature_c,
                                                        config->pressure_hpa)
                               : config->oxygen_mg_l,
        .temperature_c = config->temperature_c,
        .pressure_hpa = config->pressure_hpa,
        .time_compression = config->time_compression,
        .pump = config->pump != 0,
    };
}

static int side_fits(float side_m, float low_m, float high_m)
{
    return side_m == 0.0f || within(side_m, low_m, high_m);
}

static vec3 size_of(const struct tank_config *config)
{
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
        !within(config->area_scale, TANK_AREA_SCALE_MIN, TANK_AREA_SCALE_MAX)) {
        return 0;
    }
    const vec3 own_m = tank_preset(config->preset)->size_m, size_m = size_of(config);
    const float own_m3 = own_m.x * own_m.y * own_m.z;
    return tank_fish_max(config->preset, size_m.x * size_m.y * size_m.z / own_m3);
}

static int config_fits(const struct tank_config *config)
{
    if (config->preset >= TANK_PRESET_COUNT) {
        return 0;
    }
    return config->fish_count >= 1u && config->fish_count <= tank_config_fish_max(config) &&
           within(config->wall_follow, 0.0f, 1.0f) &&
           config->stamina_min >= 0.0f && config->stamina_max <= 1.0f &&
           config->stamina_min <= config->stamina_max && water_fits(config) &&
           lanes_built(config->lanes) && config->search <= PAIRS_ALL;
}

int tank_open(struct tank *tank, const struct tank_config *config)
{
    if (!config_fits(config)) {
        return 0;
    }
    const struct tank_preset *preset = tank_preset(config->preset);
    memset(tank, 0, sizeof *tank);
    tank->seed = config->seed;
    tank->preset = config->preset;
    tank->lanes = config->lanes;
    tank->search = config->search;
    tank->size_m = size_of(config);
    tank->wall_height_m = f_max(preset->wall_height_m, tank->size_m.y);
    tank->wall_follow = config->wall_follow;
    tank->ball_spaces = config->ball_spaces != 0;
    tank->fish_count = config->fish_count;
    water_init(&tank->water);
    tank->oxygen = oxygen_of(config);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        tank->fish[i] = hatch(tank, config, i);
    }
    tank->space = crowd_space(tank->fish, tank->fish_count, tank->size_m, &preset->law);
    spread_out(tank);
    return 1;
}

static void stage(struct fish *fish, const struct tank_stage *wanted, const struct law *law)
{
    CORE_ASSERT(wanted->gait <= GAIT_BURST);
    if (wanted->length_m > 0.0f) {
        fish_grow(fish, wanted->length_m, law);
    }
    fish->position_m = wanted->position_m;
    fish->angles = wanted->angles;
    fish->heading_rad = wanted->angles.yaw_rad;
    fish->depth_goal_m = wanted->position_m.y;
    fish->stamina = wanted->stamina;
    fish->gait = wanted->gait;
    fish->gait_left_s = wanted->gait == GAIT_BURST ? 3.0f : 20.0f; /* Thesis, section 3.2. */
    fish->speed_m_s = wanted->speed_m_s;
    fish->velocity_m_s = v3_scale(fish_forward(fish), wanted->speed_m_s);
}

void tank_stage_all(struct tank *tank, const struct tank_stage *stages, uint32_t count)
{
    const struct law *law = tank_law(tank);
    CORE_ASSERT(count <= tank->fish_count);
    for (uint32_t i = 0; i < count; i++) {
        stage(&tank->fish[i], &stages[i], law);
    }
    tank->space = crowd_space(tank->fish, tank->fish_count, tank->size_m, law);
}

void tank_init(struct tank *tank, uint8_t preset, uint32_t fish_count, uint32_t seed)
{
    struct tank_config config = tank_config_of(preset);
    config.fish_count = fish_count;
    config.seed = seed;
    const int opened = tank_open(tank, &config);
    CORE_ASSERT(opened);
}

/* A mouth that opens in the surface rings it. */
static void ring(struct tank *tank, const struct fish *fish, const struct surroundings *around)
{
    if (surface_gulps(fish, around->tick, around->dt_s)) {
        const vec3 nose_m = v3_mad(fish->position_m, fish_forward(fish), 0.5f * fish->length_m);
        water_press(&tank->water, tank->size_m, nose_m, GULP_RADIUS_M, GULP_DEPTH_M);
    }
}

static void think_in_turn(struct tank *tank, struct surroundings around)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *fish = &tank->fish[i];
        if (fish_swims(fish) && think_due(fish, i, &around)) {
            around.dt_s = think_dt_s(fish, around.tick);
            think(fish, i, &around);
            ring(tank, fish, &around);
        }
    }
}

static struct shoal shoal_of(struct tank *tank)
{
    return (struct shoal){
        .fish = tank->fish,
        .body = tank->crowd.body,
        .way_m = tank->crowd.way_m,
        .before_m = tank->part.began_m,
        .count = tank->fish_count,
        .law = tank_law(tank),
        .space = tank->space,
    };
}

/* Fish take what they saw to heart: whom they meet, who is near, how much room there is. */
static void heed(struct tank *tank, const struct surroundings *around)
{
    for (uint32_t i = 0; i < tank->crowd.count; i++) {
        if (!(tank->crowd.flags[i] & CROWD_SWIMS)) {
            continue;
        }
        const struct company *company = &tank->crowd.company[i];
        struct fish *fish = &tank->fish[i];
        fish->push_m_s = v3_lerp(fish->push_m_s,
                                 v3_limit(company->push_m_s, 0.45f * fish->length_m), PUSH_SHARE);
        fish->room = f_min(company->room, fish->room + ROOM_PER_S * around->dt_s);
        if (fish->gait != GAIT_ESCAPE) {
            avoid_tick(fish, &company->advice, company->brake, around);
        }
    }
}

/* Who is where, and what follows from it. */
static void look(struct tank *tank, uint32_t station, const struct surroundings *around)
{
    struct crowd *crowd = &tank->crowd;
    const int is_time = station == 0 && around->tick % CROWD_LOOK_TICKS == 0;
    if (station == 0) {
        crowd_follow(crowd, tank->fish);
    }
    if (!is_time && !crowd_is_stale(crowd)) {
        crowd_touch(crowd);
        return;
    }
    crowd_look(crowd, tank->fish, search_of(tank), around);
    if (is_time) {
        struct surroundings then = *around;
        then.dt_s = (float)CROWD_LOOK_TICKS * CORE_TICK_S;
        heed(tank, &then);
    }
}

/* Who must give way to whom. */
static void part_all(struct tank *tank, const struct part_place *place,
                     const struct surroundings *around)
{
    const uint32_t stations = part_stations(&tank->part, place);
    for (uint32_t station = 0; station < stations; station++) {
        part_advance(&tank->part, &tank->crowd, place, station);
        if (station == 0) {
            crowd_mark(&tank->crowd, tank->fish, tank->fish_count);
        }
        part_clear(&tank->part, &tank->crowd, place);
        look(tank, station, around);
        part_bodies(&tank->part, &tank->crowd, place);
    }
    part_end(&tank->part, &tank->crowd, place);
}

/* A surface that is never quite still. */
static void drip(struct tank *tank, uint32_t tick)
{
    if (tick % 24u != 0) {
        return;
    }
    const struct rng_key key = { tank->seed, tick, 0, RNG_WATER_DROP };
    const struct rng_key other = { tank->seed, tick, 1, RNG_WATER_DROP };
    const struct rng_key size = { tank->seed, tick, 2, RNG_WATER_DROP };
    const vec3 point = v3(rng_range(key, -0.5f, 0.5f) * tank->size_m.x, 0.0f,
                          rng_range(other, -0.5f, 0.5f) * tank->size_m.z);
    water_press(&tank->water, tank->size_m, point, 0.025f, rng_range(size, 0.0001f, 0.0006f));
}

vec3 tank_stone_m(vec3 size_m)
{
    return v3(STONE_INSET_M - 0.5f * size_m.x, -size_m.y, STONE_INSET_M - 0.5f * size_m.z);
}

/* Where its bubbles burst, the water boils. */
static void bubble(struct tank *tank, uint32_t tick)
{
    if (!tank->oxygen.pump || tick % BUBBLE_TICKS != 0) {
        return;
    }
    const struct rng_key key = { tank->seed, tick, 0, RNG_WATER_BUBBLE };
    const struct rng_key other = { tank->seed, tick, 1, RNG_WATER_BUBBLE };
    const vec3 stone = tank_stone_m(tank->size_m);
    const vec3 off = v3(rng_range(key, -BUBBLES_M, BUBBLES_M), 0.0f,
                        rng_range(other, -BUBBLES_M, BUBBLES_M));
    water_press(&tank->water, tank->size_m, v3_add(stone, off), BUBBLE_RADIUS_M, -BUBBLE_M);
}

void tank_tick(struct tank *tank, uint32_t tick, struct obstacle *obstacles,
               uint32_t obstacle_count)
{
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    const struct surroundings around = surroundings_of(tank, tick, obstacles, obstacle_count);
    const struct part_place place = { tank->fish, tank_bounds(tank), obstacles, obstacle_count,
                                      PART_SHOVE_M };
    drip(tank, tick);
    bubble(tank, tick);
    part_begin(&tank->part, tank->fish, tank->fish_count);
    think_in_turn(tank, around);
    const struct shoal shoal = shoal_of(tank);
    swim_move_all(&shoal, tank->lanes);
    part_all(tank, &place, &around);
    swim_settle_all(&shoal, tank->lanes);
    loose_tick(tank, obstacles, obstacle_count);
    oxygen_tick(&tank->oxygen, tank->fish, tank->fish_count, tank->size_m, tick);
}

void tank_part(struct tank *tank, struct obstacle *obstacles, uint32_t obstacle_count)
{
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    const struct surroundings around = surroundings_of(tank, 0, obstacles, obstacle_count);
    const struct part_place place = { tank->fish, tank_bounds(tank), obstacles, obstacle_count,
                                      PART_SHOVE_M };
    part_begin(&tank->part, tank->fish, tank->fish_count);
    crowd_gather(&tank->crowd, tank->fish, tank->fish_count, tank->space);
    part_all(tank, &place, &around);
    swim_settle_all(&(struct shoal){ .fish = tank->fish,
                                     .body = tank->crowd.body,
                                     .way_m = tank->crowd.way_m,
                                     .before_m = tank->part.began_m,
                                     .count = tank->fish_count },
                    tank->lanes);
    loose_tick(tank, obstacles, obstacle_count);
}

void tank_cast(struct tank *tank, const struct shade_cast casts[TANK_SHADE_MAX])
{
    for (uint32_t i = 0; i < TANK_SHADE_MAX; i++) {
        shade_tick(&tank->shade[i], &casts[i], CORE_TICK_S);
    }
}

uint32_t tank_shade_count(const struct tank *tank, const struct shade_cast *cast)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        count += fish_swims(fish) && shade_covers(cast, fish->position_m);
    }
    return count;
}

uint32_t tank_surfacing_count(const struct tank *tank)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        count += tank->fish[i].gait == GAIT_SURFACE;
    }
    return count;
}

uint64_t tank_hash_quick(uint64_t hash, const struct tank *tank)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        hash = fish_hash_quick(hash, &tank->fish[i]);
    }
    return hash;
}

uint64_t tank_hash(uint64_t hash, const struct tank *tank)
{
    hash = hash_u32(hash, tank->seed);
    hash = hash_u32(hash, tank->preset);
    hash = hash_vec3(hash, tank->size_m);
    hash = hash_float(hash, tank->wall_height_m);
    hash = hash_float(hash, tank->wall_follow);
    hash = hash_u32(hash, tank->ball_spaces);
    hash = hash_float(hash, tank->space);
    hash = hash_u32(hash, tank->fish_count);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        hash = fish_hash(hash, &tank->fish[i]);
    }
    for (uint32_t i = 0; i < TANK_SHADE_MAX; i++) {
        hash = shade_hash(hash, &tank->shade[i]);
    }
    hash = oxygen_hash(hash, &tank->oxygen);
    hash = crowd_hash(hash, &tank->crowd);
    return water_hash(hash, &tank->water);
}
