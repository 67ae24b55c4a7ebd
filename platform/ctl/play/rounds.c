/* rounds.c -- plays rounds in worker threads. Each worker starts the next round as soon as its
 * previous round has ended. */
#include "platform/ctl/play/rounds.h"

#include <pthread.h>
#include <sched.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/bot/bot.h"
#include "core/game/phases.h"
#include "core/game/table_setup.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/replayer.h"

/* Maximum number of ticks of a round. The longest round, its countdown and a margin are
 * included. */
#define ROUND_TICKS_MAX (700u * CORE_TICK_HZ)

/* State of one worker thread. The structure is too large for a stack. */
struct seat {
    struct core core;
    struct input input;
    struct output output;
    struct bot bot;
    struct recorder recorder;
    struct kiosk_tap tap;
};

/* ---- One round ------------------------------------------------------------------------------- */

/* Returns the configuration of the core for a plan. All defaults of the game mode are written into
 * the configuration, so that another kiosk with this configuration plays the same round. */
static struct core_config config_of(const struct round_plan *plan)
{
    CORE_ASSERT(plan->mode < MODE_COUNT);
    struct core_config config = {
        .seed = plan->seed,
        .fish_count = plan->fish_count,
        .round_s = plan->round_s,
        .modes = (uint8_t)(1u << plan->mode),
        .grade = plan->grade,
        .lanes = cpu_lanes(),
    };
    config.preset = table_setup_preset(&config, plan->mode);
    config.grade = table_setup_grade(&config, plan->mode);
    config.round_s = table_setup_round_s(&config, plan->mode);
    if (config.fish_count == 0) {
        config.fish_count = tank_preset(config.preset)->fish_count;
    }
    return config;
}

/* Writes the controller input of one tick. START is pressed once per second while no round is
 * played. The controller is always connected and has a wrist sensor. `trembles` is 1 only if the
 * bot's hand trembles, because otherwise the core would treat a motionless hand as a stuck
 * sensor. */
static void act(struct seat *seat)
{
    const uint8_t phase = seat->core.game.phase;
    const int idle = phase == PHASE_ATTRACT || phase == PHASE_MODE_SELECT;
    struct poi_input *poi = &seat->input.poi[0];
    seat->input.pressed = idle && seat->core.game.tick % CORE_TICK_HZ == 0 ? INPUT_START : 0;
    poi->link = POI_SOURCE_LIVE;
    poi->has_wrist = 1;
    poi->trembles = seat->bot.technique.tremor_m > 0.0f;
    poi->target = bot_tick(
        &seat->bot,
        &(struct vision){ .game = &seat->core.game, .world = &seat->core.world, .player = 0 });
}

/* Advances the core by one tick and records the tick. Returns the result of core_tick(). */
static enum core_error tick_and_record(struct seat *seat)
{
    seat->output.sound_count = 0;
    act(seat);
    const enum core_error error = core_tick(&seat->core, &seat->input, &seat->output);
    if (error == CORE_OK && seat->tap.tick) {
        seat->tap.tick(seat->tap.self, &seat->input, &seat->core);
    }
    return error;
}

static double ticks_to_seconds(uint32_t ticks)
{
    return (double)ticks / CORE_TICK_HZ;
}

/* Reads the result of the round in the tick in which the round ended. The values come from the game
 * state, because the core outputs no record of a practice round. */
static void read_result(const struct seat *seat, struct round_result *result)
{
    const struct round_record record =
        game_record(&seat->core.game, &seat->core.world, &seat->core.config);
    const struct player_record *player = &record.player[0];
    result->caught = player->caught;
    result->scoops = player->scoops;
    result->fouls = player->fouls;
    result->hole_area_mm2 = player->hole_area_mm2;
    result->sheets = player->sheets;
    result->torn = player->torn_tick != 0;
    result->torn_at_s =
        result->torn ? ticks_to_seconds(player->torn_tick - record.start_tick) : 0.0;
    result->length_s = ticks_to_seconds(record.end_tick - record.start_tick);
    result->state_hash = core_hash(&seat->core);
}

static enum exit_code play_through(struct seat *seat, struct round_result *result)
{
    for (uint32_t i = 0; i < ROUND_TICKS_MAX; i++) {
        const uint8_t before = seat->core.game.phase;
        if (tick_and_record(seat) != CORE_OK) {
            result->is_refused = 1;
            return EXIT_NOT_SO;
        }
        if (before == PHASE_ROUND && seat->core.game.phase != PHASE_ROUND) {
            read_result(seat, result);
            return EXIT_OK;
        }
    }
    return EXIT_NOT_SO;
}

static enum exit_code rounds_begin(struct seat *seat, const struct round_plan *plan,
                                   struct round_result *result)
{
    const struct core_config config = config_of(plan);
    const enum core_error refused = core_init(&seat->core, &config);
    if (refused != CORE_OK) {
        result->is_refused = refused == CORE_ERR_FLOAT;
        return result->is_refused ? EXIT_NOT_SO : EXIT_USAGE;
    }
    seat->input = (struct input){ 0 };
    seat->output = (struct output){ 0 };
    seat->tap = (struct kiosk_tap){ 0 };
    bot_init(&seat->bot, &plan->technique, plan->seed);
    seat->bot.hand.pose = seat->core.game.hand_pose[0];
    if (plan->record) {
        result->error = -recorder_begin(&seat->recorder, plan->record, &seat->core);
        seat->tap = recorder_tap(&seat->recorder);
    }
    return result->error ? EXIT_IO : EXIT_OK;
}

static struct round_result play_one(struct seat *seat, const struct round_plan *plan)
{
    struct round_result result = { 0 };
    result.code = rounds_begin(seat, plan, &result);
    if (result.code != EXIT_OK) {
        return result;
    }
    result.code = play_through(seat, &result);
    if (plan->record) {
        result.error = -recorder_end(&seat->recorder);
        result.code = result.error ? EXIT_IO : result.code;
    }
    return result;
}

/* ---- Worker threads -------------------------------------------------------------------------- */

struct hall {
    const struct rounds *rounds;
    pthread_mutex_t lock;
    uint32_t next; /* Index of the next plan that no worker has started. */
    /* Exit code of the first round that failed. After a failure, no worker starts another plan. */
    enum exit_code code;
};

/* Returns the index of the next plan and marks the plan as started. Returns `count` if no plan is
 * left or a round has failed. */
static uint32_t rounds_next_plan(struct hall *hall)
{
    pthread_mutex_lock(&hall->lock);
    const uint32_t index = hall->code == EXIT_OK ? hall->next : hall->rounds->count;
    hall->next += index < hall->rounds->count ? 1u : 0u;
    pthread_mutex_unlock(&hall->lock);
    return index;
}

static void *work(void *self)
{
    struct hall *hall = self;
    cpu_set_float();
    struct seat *seat = malloc(sizeof *seat);
    if (!seat) {
        pthread_mutex_lock(&hall->lock);
        hall->code = EXIT_NOT_SO;
        pthread_mutex_unlock(&hall->lock);
        return NULL;
    }
    for (uint32_t i = rounds_next_plan(hall); i < hall->rounds->count; i = rounds_next_plan(hall)) {
        const struct rounds *rounds = hall->rounds;
        const struct round_result result = play_one(seat, &rounds->plans[i]);
        pthread_mutex_lock(&hall->lock);
        rounds->results[i] = result;
        hall->code = hall->code == EXIT_OK ? result.code : hall->code;
        if (rounds->done) {
            rounds->done(rounds->self, i);
        }
        pthread_mutex_unlock(&hall->lock);
    }
    free(seat);
    return NULL;
}

uint32_t rounds_workers(void)
{
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) {
        return 1;
    }
    const uint32_t cores = (uint32_t)CPU_COUNT(&allowed);
    return cores < 1 ? 1 : cores > ROUNDS_WORKERS_MAX ? ROUNDS_WORKERS_MAX : cores;
}

/* Plays rounds in the caller's thread too. If no other thread can be created, the caller's thread
 * plays all rounds. */
enum exit_code rounds_play(const struct rounds *rounds)
{
    CORE_ASSERT(rounds->count <= ROUNDS_MAX && rounds->plans && rounds->results);
    CORE_ASSERT(rounds->workers >= 1 && rounds->workers <= ROUNDS_WORKERS_MAX);
    struct hall hall = { .rounds = rounds, .lock = PTHREAD_MUTEX_INITIALIZER };
    pthread_t threads[ROUNDS_WORKERS_MAX];
    uint32_t helpers = 0;
    for (uint32_t i = 0; i < rounds->count; i++) {
        rounds->results[i] = (struct round_result){ .code = EXIT_NOT_SO };
    }
    while (helpers + 1u < rounds->workers && helpers + 1u < rounds->count &&
           pthread_create(&threads[helpers], NULL, work, &hall) == 0) {
        helpers++;
    }
    work(&hall);
    for (uint32_t i = 0; i < helpers; i++) {
        pthread_join(threads[i], NULL);
    }
    return hall.code;
}

static int by_size(const void *left, const void *right)
{
    const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    return (a > b) - (a < b);
}

double rounds_quantile(const uint32_t *sorted, uint32_t count, double share)
{
    CORE_ASSERT(count >= 1 && share >= 0.0 && share <= 1.0);
    const double place = share * (double)(count - 1u);
    const uint32_t below = (uint32_t)place;
    const uint32_t above = below + 1u < count ? below + 1u : below;
    const double part = place - (double)below;
    return (double)sorted[below] * (1.0 - part) + (double)sorted[above] * part;
}

struct summary rounds_summary(uint32_t *values, uint32_t count)
{
    qsort(values, count, sizeof values[0], by_size);
    return (struct summary){
        .median = rounds_quantile(values, count, 0.5),
        .p90 = rounds_quantile(values, count, 0.9),
        .max = values[count - 1u],
    };
}
