/* core.c -- the fixed order of the steps of a tick, and the hash of the state. */
#include "core/core.h"

#include "core/base/float_env.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/simd.h"
#include "core/game/accounting/accounts.h"
#include "core/game/control/controller.h"
#include "core/game/game_fields.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/catch.h"
#include "core/poi/poi.h"
#include "core/poi/poi_fields.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/tank_fields.h"

/* Memory budgets of the kiosk. The tank uses at most 1 MiB, and the recordings of the tears use
 * 33 KiB. Game, pois and bowls use a sixteenth of a MiB, and the growth lab uses half of that. The
 * lab holds eight custom species with all their curves (19 KiB). The lab also holds the saved
 * graphs and the edited graphs of 15 species, 8 KiB for each set of 15. The smallest board reserves
 * the budgets below for the state and for the scene.
 *
 * `kingyoctl tank` allocates a larger tank of its own (platform/ctl/tank/tank.mk). */
_Static_assert(sizeof(struct tank) <= 1024u * 1024u, "the tank outgrew its budget");
_Static_assert(sizeof(struct core) <= 1154u * 1024u, "the core's state outgrew its budget");
_Static_assert(TANK_FISH_MAX == SCENE_FISH_MAX, "every fish can be shown");
_Static_assert(sizeof(struct scene) <= 1024u * 1024u, "the scene outgrew its budget");

#define FAN_REACH_M 1.0f

/* Initializes `game` and `world` from `core->config`. If the growth lab is the only item that
 * players can choose, the session starts in the lab. */
static void open_world(struct core *core)
{
    CORE_ASSERT(core->config.preset < TANK_PRESET_COUNT);
    memset(&core->game, 0, sizeof core->game);
    memset(&core->world, 0, sizeof core->world);
    game_init(&core->game, &core->config);
    lesson_init(&core->lessons);
    table_setup_open(core->game.control, &core->game, &core->world, &core->config);
    if (table_setup_modes(&core->config) == 1u << CHOICE_LAB && core->config.credit_coins == 0 &&
        core->config.session.tick == 0) {
        struct output discarded = { 0 };
        lab_begin(&core->game, &core->world, &core->config, &discarded);
    }
}

enum core_error core_init(struct core *core, const struct core_config *config)
{
    CORE_ASSERT(core && config && &core->config != config);
    if (config->preset >= TANK_PRESET_COUNT ||
        config->fish_count > tank_preset_fish_max(tank_preset(config->preset), 1.0f) ||
        config->language >= LANGUAGE_COUNT || config->session.language.chosen >= LANGUAGE_COUNT ||
        !simd_is_built(config->lanes) ||
        (config->round_s != 0 && (config->round_s < 10 || config->round_s > 600)) ||
        config->modes >= 1u << CHOICE_COUNT || config->players > POI_MAX ||
        config->level >= LEVEL_COUNT ||
        (config->grade != 0 &&
         (config->grade < SHEET_GRADE_MIN || config->grade > SHEET_GRADE_MAX)) ||
        config->credit_coins > CREDIT_COINS_MAX || config->ticket_fish > CREDIT_TICKET_FISH_MAX ||
        !lab_book_is_valid(&config->book) || !ledger_state_is_valid(&config->persistent) ||
        !ledger_session_is_valid(&config->session)) {
        return CORE_ERR_RANGE;
    }
    if (!float_env_is_standard()) {
        return CORE_ERR_FLOAT;
    }
    memset(core, 0, sizeof *core);
    core->config = *config;
    settings_sanitize(&core->config.persistent.settings);
    open_world(core);
    return CORE_OK;
}

/* Returns true if poi `index` is in use and collides with fish and with other rings. A parked poi
 * out of the water does not collide. */
static bool is_met(const struct core *core, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return controller_is_active(&core->world, index) &&
           parking_collides(&core->game, &core->world, index);
}

static uint32_t gather_obstacles(const struct core *core, struct obstacle out[TANK_OBSTACLE_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (is_met(core, i)) {
            out[count++] = poi_obstacle(&core->world.poi[i]);
        }
        if (core->world.bowl[i].present) {
            out[count++] = bowl_obstacle(&core->world.bowl[i]);
        }
    }
    CORE_ASSERT(count <= TANK_OBSTACLE_MAX);
    return count;
}

/* Separates overlapping rings. For each ring that moved, the constraints of the walls and of its
 * own bowl are applied last. */
static void part_rings(struct core *core, const uint8_t live[POI_MAX])
{
    for (uint32_t k = 0; k < POI_MAX * POI_MAX; k++) {
        const uint32_t a = k / POI_MAX, b = k % POI_MAX;
        CORE_ASSERT(live[a] <= 1 && live[b] <= 1);
        if (a < b && live[a] && live[b] && is_met(core, a) && is_met(core, b) &&
            ring_pairs_separate(&core->world.poi[a], &core->world.poi[b])) {
            poi_constrain(&core->world.poi[a], &core->world.tank, &core->world.bowl[a]);
            poi_constrain(&core->world.poi[b], &core->world.tank, &core->world.bowl[b]);
        }
    }
}

static void tick_pois(struct core *core, const struct input *input,
                      const struct poi_target targets[POI_MAX], const uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (live[i]) {
            const struct poi_grip grip = {
                .target = targets[i],
                .has_wrist =
                    core->world.poi[i].link == POI_SOURCE_BOT ||
                    parking_is_parked(&core->game, i) ||
                    /* Treat a lost controller as one with rotation, so that its poi is not tilted
                     * over the bowl. */
                    core->world.poi[i].link == POI_SOURCE_LOST ||
                    (core->world.poi[i].link == POI_SOURCE_LIVE && input->poi[i].has_wrist),
            };
            poi_tick(&core->world.poi[i], &grip, &core->world.tank, &core->world.bowl[i]);
            /* Keep the poi out of the bowls of other players. poi_tick() handles the bowl of the
             * poi's own player. */
            for (uint32_t other = 0; other < POI_MAX; other++) {
                if (other != i) {
                    poi_constrain_to_bowl(&core->world.poi[i], &core->world.bowl[other]);
                }
            }
        }
    }
    part_rings(core, live);
    const struct stall stall = { &core->world.tank, core->world.bowl, POI_MAX, false };
    bowl_buoyancy_tick(&stall, core->world.poi, live, POI_MAX);
}

static void tick_water(struct core *core, const uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (live[i]) {
            surface_disturbance_tick(&core->world.poi[i], &core->world.tank.water,
                                     core->world.tank.size_m);
        }
    }
    if (core->game.tick % 2u == 0) {
        water_step(&core->world.tank.water, core->world.tank.size_m);
    }
}

/* Returns the shadow of a fan. The centre is clamped to FAN_REACH_M beyond the walls, so that a fan
 * entering from outside casts no shadow on the water yet. */
static struct shade_cast fan_shade(const struct core *core, const struct shade_input *shade)
{
    if (!shade->present) {
        return (struct shade_cast){ 0 };
    }
    CORE_ASSERT(f_is_finite(shade->x_m));
    CORE_ASSERT(f_is_finite(shade->z_m));
    CORE_ASSERT(f_is_finite(shade->radius_m));
    const float radius_m = f_clamp(shade->radius_m, SHADE_RADIUS_MIN_M, SHADE_RADIUS_MAX_M);
    const float x_m = 0.5f * core->world.tank.size_m.x + FAN_REACH_M;
    const float z_m = 0.5f * core->world.tank.size_m.z + FAN_REACH_M;
    return (struct shade_cast){
        .present = 1,
        .x_m = f_clamp(shade->x_m, -x_m, x_m),
        .z_m = f_clamp(shade->z_m, -z_m, z_m),
        .radius_m = radius_m,
        .dark = SHADE_FAN_DARK,
    };
}

static void gather_shades(struct core *core, const struct input *input)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { 0 };
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        casts[i] = fan_shade(core, &input->shade[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (controller_is_active(&core->world, i)) {
            casts[SHADE_MAX + i] = poi_shade(&core->world.poi[i]);
            casts[SHADE_MAX + i].present &= parking_shade(&core->game, i) > 0.0f;
            casts[SHADE_MAX + i].dark *= parking_shade(&core->game, i);
        }
    }
    tank_cast(&core->world.tank, casts);
}

/* Applies the forces of the fish to the pois and bowls. `obstacles` and `count` come from
 * gather_obstacles(), whose order of pois and bowls is repeated here. */
static void apply_obstacle_reactions(struct core *core, const struct obstacle *obstacles,
                                     uint32_t count)
{
    uint32_t at = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (controller_is_active(&core->world, i)) {
            const struct obstacle nothing = { 0 };
            poi_apply_reaction(&core->world.poi[i], is_met(core, i) ? &obstacles[at++] : &nothing);
        }
        if (core->world.bowl[i].present) {
            bowl_apply_reaction(&core->world.bowl[i], &obstacles[at++]);
        }
    }
    CORE_ASSERT(at == count);
}

static void tick_fish(struct core *core, const struct input *input)
{
    CORE_ASSERT(core->world.tank.preset < TANK_PRESET_COUNT);
    const bool has_pump = tank_preset(core->world.tank.preset)->pump;
    core->world.tank.oxygen.pump = has_pump && game_pumps(&core->game, core->game.tick);
    struct obstacle obstacles[TANK_OBSTACLE_MAX];
    const uint32_t count = gather_obstacles(core, obstacles);
    gather_shades(core, input);
    tank_tick(&core->world.tank, core->game.tick, obstacles, count);
    apply_obstacle_reactions(core, obstacles, count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        bowl_fish_tick(&core->world.bowl[i], i, &core->world.tank);
    }
}

static void tick_catch(struct core *core, const struct input *input, const uint8_t live[POI_MAX],
                       struct catch_result caught[POI_MAX], struct output *output)
{
    const struct stall stall = { &core->world.tank, core->world.bowl, POI_MAX,
                                 input->is_turned != 0 };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (live[i] && !parking_is_parked(&core->game, i)) {
            catch_tick(&core->world.poi[i], i, &stall, core->game.tick, output, caught);
        } else {
            parking_release_tick(&core->world.poi[i], i, &stall, caught);
        }
    }
}

/* Records the pois of a round for the slow motion of the result screen. */
static void record_tears(struct core *core, const uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (core->game.phase == PHASE_ROUND && live[i]) {
            tear_clip_tick(&core->world.tear_clip[i], &core->world.poi[i], core->game.tick);
        }
    }
}

/* Depth in body heights above which a fish splashes when it flees, time from the begin of its
 * C-start to the stroke of its tail, and speed at which the splash is loudest. */
#define SPLASH_DEPTH 1.2f
#define SPLASH_AFTER_S 0.04f
#define SPLASH_M_S 0.8f
#define GULP_GAIN 0.35f

#define ESCAPE_DROPS 18u
#define ESCAPE_RADIUS_M 0.008f

/* Returns true in the tick in which an escaping fish splashes at the surface. */
static bool splashes_in_escape(const struct fish *fish)
{
    return fish->gait == GAIT_ESCAPE && fish->escape_s >= SPLASH_AFTER_S &&
           fish->escape_s < SPLASH_AFTER_S + CORE_TICK_S &&
           fish->position_m.y > -SPLASH_DEPTH * fish->height_m;
}

/* Plays the sounds that fish make at the surface: gulps, and the splash of an escape. The state of
 * the fish alone determines the times, so no state is necessary. The synthesiser drops sounds that
 * follow each other too closely. */
static void sound_fish(const struct core *core, bool is_turned, struct output *output)
{
    const struct tank *tank = &core->world.tank;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        const float pan = view_pan(is_turned, tank->size_m, fish->position_m);
        if (surface_gulps(fish, core->game.tick, CORE_TICK_S)) {
            output_sound(output, SOUND_GULP, GULP_GAIN, pan);
        } else if (splashes_in_escape(fish)) {
            const float strength = v3_length(fish->velocity_m_s) / SPLASH_M_S;
            output_sound(output, SOUND_ESCAPE, f_clamp(strength, 0.15f, 1.0f), pan);
        }
    }
}

#define FALL_DROPS 22u
#define FALL_RADIUS_M 0.010f

/* Adds the splashes of escaping fish, of the pois and of the fish that fell from them, and scraps
 * of torn paper. */
static void add_splashes(struct core *core, const uint8_t live[POI_MAX],
                         const struct catch_result caught[POI_MAX])
{
    struct splashes *const splashes = &core->world.splashes;
    const struct tank *const tank = &core->world.tank;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *const fish = &tank->fish[i];
        if (splashes_in_escape(fish) && !surface_gulps(fish, core->game.tick, CORE_TICK_S)) {
            surface_splash(splashes, v3_flat(fish->position_m), false, fish->velocity_m_s,
                           ESCAPE_RADIUS_M, ESCAPE_DROPS, core->game.tick);
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (live[i]) {
            surface_splash_poi(splashes, &core->world.poi[i], core->game.tick);
            surface_splash_scrap(splashes, &core->world.poi[i], core->game.tick);
            surface_splash(splashes, caught[i].fell_m, caught[i].fell_in_bowl, caught[i].fell_m_s,
                           FALL_RADIUS_M, FALL_DROPS, core->game.tick);
        }
    }
}

/* Announces the near misses of the players in a round. */
static void watch_near_misses(struct core *core, const uint8_t live[POI_MAX],
                              const struct catch_result caught[POI_MAX], bool is_turned,
                              struct output *output)
{
    const struct tank *tank = &core->world.tank;
    for (uint32_t i = 0; i < POI_MAX && core->game.phase == PHASE_ROUND; i++) {
        const struct poi *poi = &core->world.poi[i];
        const bool plays = live[i] && !core->game.paused && !parking_is_parked(&core->game, i);
        if (plays && near_miss_tick(&core->world.near_miss[i], poi, tank, caught[i].slipped,
                                    core->game.tick)) {
            output_sound(output, SOUND_MISS, 0.6f,
                         view_pan(is_turned, tank->size_m, poi->position_m));
        }
    }
}

/* Writes the force feedback after the wall and fish contacts of this tick. catch_tick() runs later
 * and may add impacts. The added impacts take effect in the next tick, as force and as load on the
 * paper. */
static void write_poi_forces(const struct core *core, const uint8_t live[POI_MAX],
                             struct output *output)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        output->poi[i] = (struct poi_force){ 0 };
        /* No force feedback unless the player controls the poi. */
        if (live[i] && !core->world.poi[i].damage_immune) {
            poi_haptics(&core->world.poi[i], &output->poi[i]);
        }
    }
}

enum core_error core_tick(struct core *core, const struct input *input, struct output *output)
{
    CORE_ASSERT(core && input && output);
    if (core->game.tick % CORE_TICK_HZ == 0 && !float_env_is_standard()) {
        return CORE_ERR_FLOAT;
    }
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    struct catch_result caught[POI_MAX] = { 0 };

    game_tick(&core->game, &core->world, &core->config, input, output, targets, live);
    lesson_tick(&core->lessons, &core->game, &core->world);
    tick_pois(core, input, targets, live);
    tick_water(core, live);
    tick_fish(core, input);
    sound_fish(core, input->is_turned != 0, output);
    record_tears(core, live);
    write_poi_forces(core, live, output);
    tick_catch(core, input, live, caught, output);
    add_splashes(core, live, caught);
    watch_near_misses(core, live, caught, input->is_turned != 0, output);
    game_score(core->game.player, &core->game.album, &core->game, &core->world, caught,
               input->is_turned != 0, output);
    core->game.tick++;
    if (session_is_over(&core->game)) {
        session_restart(&core->game, &core->config);
        open_world(core);
    }
    /* Copy the values that the platform needs to `output`, which is not part of the hash. */
    const struct game *game = &core->game;
    output->tick = game->tick;
    output->round_tick = game->round_tick;
    output->phase = game->phase;
    output->has_pump = core->world.tank.oxygen.pump;
    output->is_idle =
        game->phase == PHASE_ATTRACT && game->accounts.ledger.balance.open == PAYMENT_NONE;
    return CORE_OK;
}

bool core_is_fresh(const struct core *core)
{
    return core->game.tick == core->config.session.tick;
}

uint64_t core_hash_quick(const struct core *core)
{
    uint64_t hash = hash_u32(HASH_START, core->game.tick);
    hash = field_hash(hash, &game_fields, &core->game);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = field_hash(hash, &poi_quick_fields, &core->world.poi[i]);
        hash = hash_u32(hash, core->world.bowl[i].fish_count);
    }
    return field_hash(hash, &tank_quick_fields, &core->world.tank);
}

static uint64_t settings_edit_hash(uint64_t hash, const struct settings_edit *edit, bool hashes_pin)
{
    return field_hash(settings_hash(hash, &edit->logged, hashes_pin), &settings_edit_fields, edit);
}

uint64_t core_hash(const struct core *core)
{
    const struct core_config *config = &core->config;
    const struct persistent_state *persistent = &config->persistent;
    const struct game_session *session = &config->session;
    const struct language_choice *language = &session->language;
    uint64_t hash = field_hash(core_hash_quick(core), &core_config_fields, config);
    hash = field_hash(hash, &ledger_start_fields, &persistent->ledger);
    hash = field_hash(hash, &audits_fields, &persistent->audits);
    hash = game_fields_hash_ranking(hash, &persistent->ranking);
    hash = settings_hash(hash, &persistent->settings, !config_has_rules(config, 8));
    hash = field_hash(hash, &game_session_fields, session);
    hash = settings_edit_hash(hash, &session->settings_edit, !config_has_rules(config, 8));
    if (language->chosen != 0 || language->until_tick != 0) {
        hash = hash_u32(hash_u32(hash, language->chosen), language->until_tick);
    }
    hash = field_hash(hash, &lab_book_fields, &config->book);
    hash = field_hash(hash, &audits_fields, &core->game.accounts.audits);
    hash = game_fields_hash_ranking(hash, &core->game.accounts.ranking);
    hash = settings_edit_hash(hash, &core->game.settings_edit, !config_has_rules(config, 8));
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = field_hash(hash, &poi_fields, &core->world.poi[i]);
        hash = field_hash(hash, &bowl_fields, &core->world.bowl[i]);
    }
    hash = field_hash(hash, &lab_saved_fields, &core->game.lab);
    return field_hash(hash, &tank_fields, &core->world.tank);
}
