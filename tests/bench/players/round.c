/* round.c -- implementation of round.h: plays one round of a simulated player through the kiosk's
 * own frame loop. */
#include "tests/bench/players/round.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/phases.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/preset.h"
#include "drivers/null.h"
#include "platform/cpu.h"

/* Largest number of frames of a round. The 60 s in addition to the length of the round allow for
 * the countdown. */
#define ROUND_FRAMES_MAX ((ROUND_LENGTH_S + 60u) * PLAYER_HZ)
#define START_FRAMES PLAYER_HZ /* START is pressed once per second until a round begins. */

const char *const round_tear_names[TEAR_CAUSE_COUNT] = {
    "none", "fast", "flat", "slap", "soaked", "weight",
};
const char *const round_attempt_names[ATTEMPT_END_COUNT] = {
    "fled before", "fled dip", "fled follow", "fled lift", "below", "away", "slipped", "held",
};

/* ---- Causes of tears ------------------------------------------------------------------------- */

static double mean_wet_s(const struct sheet *sheet)
{
    double ticks = 0.0;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        ticks += sheet->state[i] != CELL_OUTSIDE ? (double)sheet->soak_ticks[i] : 0.0;
    }
    return ticks / (double)sheet->paper_cells_new / CORE_TICK_HZ;
}

/* Counts the torn cells by their cause. For the first tear, the recording of the core (tear_clip)
 * has the exact cause. For later tears the cause is approximate: catch_tick() has already run, so
 * tear_cause_of() uses the loads of the fish in the next tick. */
static void observe_paper(struct player_round *result, const struct core *core)
{
    const struct poi *poi = &core->world.poi[0];
    if (core->game.phase != PHASE_ROUND || poi->strain.cells_torn == 0) {
        return;
    }
    if (result->first_s <= 0.0) {
        result->first_s = (double)(core->game.tick - core->game.phase_tick) / CORE_TICK_HZ;
        result->first_cause = core->world.tear_clip[0].cause;
        result->wet_s = mean_wet_s(&poi->sheet);
    }
    result->cells[tear_cause_of(&core->world.tear_clip[0], poi)] += poi->strain.cells_torn;
}

/* ---- Outcomes of attempts -------------------------------------------------------------------- */

/* Returns the outcome if the lift that begins now catches nothing. The outcome depends on whether
 * the fish is beside, above or below the ring. */
static uint8_t outcome_at_lift(const struct core *core, uint32_t fish)
{
    const vec3 at_m = core->world.tank.fish[fish].position_m;
    const vec3 off = v3_sub(at_m, core->world.poi[0].position_m);
    const bool is_over = off.x * off.x + off.z * off.z < POI_RADIUS_M * POI_RADIUS_M;
    return !is_over ? ATTEMPT_AWAY : off.y > 0.0f ? ATTEMPT_SLIPPED : ATTEMPT_BELOW;
}

/* Records that the chosen fish has begun to flee. After the dip, the function also records the
 * cause, the distance between fish and ring, and the speed of the ring. */
static void observe_flight(struct round_worker *worker, const struct core *core,
                           const struct fish *prey)
{
    static const uint8_t ends[PLAYER_STATE_COUNT] = {
        [PLAYER_CHOOSE] = ATTEMPT_FLED_BEFORE, [PLAYER_REACH] = ATTEMPT_FLED_BEFORE,
        [PLAYER_STILL] = ATTEMPT_FLED_DIP,     [PLAYER_FOLLOW] = ATTEMPT_FLED_FOLLOW,
        [PLAYER_RISE] = ATTEMPT_FLED_LIFT,     [PLAYER_CARRY] = ATTEMPT_FLED_LIFT,
    };
    struct player_round *result = worker->result;
    worker->prey_fled = true;
    worker->attempt_end = ends[worker->person.player.state];
    if (worker->person.player.state < PLAYER_STILL) {
        return;
    }
    const struct poi *poi = &core->world.poi[0];
    const vec3 off = v3_sub(prey->position_m, poi->position_m);
    const vec3 normal = vec_basis_from_angles(poi->angles).up;
    result->flights++;
    result->flights_by_sight += worker->prey_startle == STARTLE_LOOM;
    result->flights_by_pressure += worker->prey_startle == STARTLE_PRESSURE;
    result->flight_m += (double)v3_length(v3(off.x, 0.0f, off.z));
    result->flight_above_m -= (double)off.y;
    result->flight_m_s += (double)f_abs(v3_dot(poi->velocity_m_s, normal));
    result->flight_s += (double)(core->game.tick - worker->dip_tick) / CORE_TICK_HZ;
}

/* Checks in each tick whether the chosen fish flees and whether the player's state has changed. */
static void observe_attempt(struct round_worker *worker, const struct core *core)
{
    const struct sim_player *player = &worker->person.player;
    if (worker->is_bot || player->prey == PLAYER_NO_FISH || core->game.phase != PHASE_ROUND) {
        return;
    }
    const struct fish *prey = &core->world.tank.fish[player->prey];
    const uint8_t before = worker->state;
    worker->state = player->state;
    if (before != player->state) {
        if (player->state == PLAYER_REACH) {
            worker->prey_fled = false;
            worker->prey_startle = STARTLE_NONE;
        } else if (player->state == PLAYER_STILL) {
            worker->dip_tick = core->game.tick;
        } else if (player->state == PLAYER_RISE && !worker->prey_fled) {
            worker->attempt_end = outcome_at_lift(core, player->prey);
        } else if (before == PLAYER_RISE) {
            const bool is_held = player->state == PLAYER_CARRY;
            worker->result->attempts[is_held ? (uint8_t)ATTEMPT_HELD : worker->attempt_end]++;
        }
    }
    worker->prey_startle = prey->startle != STARTLE_NONE ? prey->startle : worker->prey_startle;
    if (!worker->prey_fled && prey->gait == GAIT_ESCAPE) {
        observe_flight(worker, core, prey);
    }
}

static void observe_tick(void *self, const struct input *input, const struct core *core)
{
    struct round_worker *worker = self;
    (void)input;
    const uint32_t miss_tick = core->world.near_miss[0].tick;
    worker->result->near_misses += miss_tick != 0 && miss_tick != worker->miss_tick;
    worker->miss_tick = miss_tick;
    observe_paper(worker->result, core);
    observe_attempt(worker, core);
}

/* ---- Round ----------------------------------------------------------------------------------- */

/* Writes the input of one tick of the bot, as kingyoctl play does. */
static int bot_input(void *self, struct input *out)
{
    struct round_worker *worker = self;
    const struct core *core = &worker->kiosk.core;
    out->poi[0].link = POI_SOURCE_LIVE;
    out->poi[0].has_wrist = 1;
    out->poi[0].trembles = worker->bot.technique.tremor_m > 0.0f;
    out->poi[0].target = bot_tick(
        &worker->bot, &(struct vision){ .game = &core->game, .world = &core->world, .player = 0 });
    return 1;
}

static bool worker_open(struct round_worker *worker, const struct habits *habits, uint8_t level,
                        uint32_t seed)
{
    const struct view *view = &tank_preset(TANK_PRESET_FESTIVAL)->view;
    struct kiosk_config config = {
        .core = { .seed = seed,
                  .preset = TANK_PRESET_FESTIVAL,
                  .fish_count = ROUND_FISH_COUNT,
                  .round_s = ROUND_LENGTH_S,
                  .modes = 1u << MODE_FESTIVAL,
                  .grade = ROUND_GRADE,
                  .lanes = cpu_lanes() },
        .tap = { .tick = observe_tick, .self = worker },
    };
    config.core.level = level;
    worker->is_bot = habits->device == PLAYER_BOT;
    worker->prey_fled = false;
    worker->state = PLAYER_CHOOSE;
    worker->miss_tick = 0;
    worker->hal = null_hal(NULL);
    person_init(&worker->person, habits, view, 0, seed, 0);
    worker->hal.clock = config.stopwatch = sim_clock_device(&worker->person.clock);
    if (worker->is_bot) {
        config.source = (struct kiosk_source){ .next = bot_input, .self = worker };
        bot_init(&worker->bot, &technique_expert, seed);
    } else {
        worker->hal.poi[0] = person_poi(&worker->person);
    }
    if (kiosk_init(&worker->kiosk, &worker->hal, &config) != CORE_OK) {
        return false;
    }
    worker->bot.hand.pose = worker->kiosk.core.game.control[0].target_pose;
    return true;
}

static void read_round(const struct core *core, struct player_round *result)
{
    const struct round_record record = game_record(&core->game, &core->world, &core->config);
    const struct player_record *player = &record.player[0];
    result->is_played = true;
    result->caught = player->caught;
    result->scoops = player->scoops;
    result->torn = player->torn_tick != 0;
    result->torn_s =
        result->torn ? (double)(player->torn_tick - record.start_tick) / CORE_TICK_HZ : 0.0;
}

bool round_play(struct round_worker *worker, const struct habits *habits, uint8_t level,
                uint32_t seed, struct player_round *result)
{
    *result = (struct player_round){ 0 };
    worker->result = result;
    if (!worker_open(worker, habits, level, seed)) {
        return false;
    }
    struct kiosk *kiosk = &worker->kiosk;
    for (uint32_t i = 0; i < ROUND_FRAMES_MAX; i++) {
        const uint8_t before = kiosk->core.game.phase;
        const bool is_idle = before == PHASE_ATTRACT || before == PHASE_MODE_SELECT;
        kiosk->input.pressed = is_idle && i % START_FRAMES == START_FRAMES / 2u ? INPUT_START : 0;
        person_act(&worker->person);
        if (kiosk_frame(kiosk, &worker->hal) != KIOSK_RUNS) {
            return false;
        }
        if (before == PHASE_ROUND && kiosk->core.game.phase != PHASE_ROUND) {
            read_round(&kiosk->core, result);
            return true;
        }
        person_see(&worker->person, &kiosk->scene);
    }
    return false;
}
