/* rounds.c -- plays rounds in worker threads. Each worker starts the next round as soon as its
 * previous round has ended. */
#include "platform/ctl/play/rounds.h"

#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/bot/bot.h"
#include "core/game/table_setup.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/os/thread.h"

/* Maximum number of ticks of a round. The number is enough for the longest round and its countdown,
 * with a margin. */
#define ROUND_TICKS_MAX (700u * CORE_TICK_HZ)

/* State of one worker thread. The structure is too large for a stack. */
struct worker {
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
        .level = plan->level,
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

static enum exit_code play_through(struct worker *worker, struct round_result *result)
{
    for (uint32_t i = 0; i < ROUND_TICKS_MAX; i++) {
        const uint8_t before = worker->output.phase;
        worker->output.sound_count = 0;
        /* Writes the controller input of one tick. START is pressed once per second while no round
         * is played. The controller is always connected and has a wrist sensor. `trembles` is 1
         * only if the bot's hand trembles, because otherwise the core would treat a motionless hand
         * as a stuck sensor. */
        const bool idle = before == PHASE_ATTRACT || before == PHASE_MODE_SELECT;
        struct poi_input *poi = &worker->input.poi[0];
        worker->input.pressed = idle && worker->output.tick % CORE_TICK_HZ == 0 ? INPUT_START : 0;
        poi->link = POI_SOURCE_LIVE;
        poi->has_wrist = 1;
        poi->trembles = worker->bot.technique.tremor_m > 0.0f;
        const struct vision vision = core_vision(&worker->core, 0);
        poi->target = bot_tick(&worker->bot, &vision);
        if (core_tick(&worker->core, &worker->input, &worker->output) != CORE_OK) {
            result->is_refused = true;
            return EXIT_NOT_SO;
        }
        if (worker->tap.tick) {
            worker->tap.tick(worker->tap.self, &worker->input, &worker->core);
        }
        if (before == PHASE_ROUND && worker->output.phase != PHASE_ROUND) {
            /* The values come from the game state, because the core outputs no record of a practice
             * round. */
            const struct round_record record = core_round_record(&worker->core);
            const struct player_record *player = &record.player[0];
            const bool torn = player->torn_tick != 0;
            const uint32_t torn_ticks = torn ? player->torn_tick - record.start_tick : 0;
            *result = (struct round_result){
                .caught = player->caught,
                .scoops = player->scoops,
                .fouls = player->fouls,
                .hole_area_mm2 = player->hole_area_mm2,
                .sheets = player->sheets,
                .torn = torn,
                .torn_at_s = (double)torn_ticks / CORE_TICK_HZ,
                .length_s = (double)(record.end_tick - record.start_tick) / CORE_TICK_HZ,
                .state_hash = core_hash(&worker->core),
            };
            return EXIT_OK;
        }
    }
    return EXIT_NOT_SO;
}

static struct round_result play_one(struct worker *worker, const struct round_plan *plan,
                                    uint32_t index)
{
    struct round_result result = { .code = EXIT_NOT_SO };
    const struct core_config config = config_of(plan);
    const enum core_error refused = core_init(&worker->core, &config);
    char path[ROUNDS_PATH_MAX];
    if (refused != CORE_OK) {
        result.is_refused = refused == CORE_ERR_FLOAT;
        result.code = result.is_refused ? EXIT_NOT_SO : EXIT_USAGE;
        return result;
    }
    worker->input = (struct input){ 0 };
    worker->output = (struct output){ 0 };
    worker->tap = (struct kiosk_tap){ 0 };
    bot_init(&worker->bot, &plan->technique, plan->seed);
    worker->bot.hand.pose = core_status(&worker->core).player[0].target_pose;
    if (plan->record) {
        rounds_record_path(path, plan->record, index);
        result.error = -recorder_begin(&worker->recorder, path, &worker->core);
        worker->tap = recorder_tap(&worker->recorder);
    }
    if (result.error == 0) {
        result.code = play_through(worker, &result);
        result.error = plan->record ? -recorder_end(&worker->recorder) : 0;
    }
    result.code = result.error ? EXIT_IO : result.code;
    return result;
}

/* ---- Worker threads -------------------------------------------------------------------------- */

struct hall {
    const struct rounds *rounds;
    pthread_mutex_t lock;
    uint32_t next; /* Index of the next plan (round to play) that no worker has started yet. */
    /* Exit code of the first round that failed. After a failure, no worker starts another plan. */
    enum exit_code code;
};

static void *work(void *self)
{
    struct hall *hall = self;
    const struct rounds *rounds = hall->rounds;
    cpu_set_float();
    struct worker *worker = malloc(sizeof *worker);
    pthread_mutex_lock(&hall->lock);
    hall->code = worker ? hall->code : EXIT_NOT_SO;
    while (hall->code == EXIT_OK && hall->next < rounds->count) {
        const uint32_t i = hall->next++;
        pthread_mutex_unlock(&hall->lock);
        const struct round_result result = play_one(worker, &rounds->plans[i], i);
        pthread_mutex_lock(&hall->lock);
        rounds->results[i] = result;
        hall->code = hall->code == EXIT_OK ? result.code : hall->code;
        if (rounds->done) {
            rounds->done(rounds->self, i);
        }
    }
    pthread_mutex_unlock(&hall->lock);
    free(worker);
    return NULL;
}

void rounds_record_path(char out[ROUNDS_PATH_MAX], const char *folder, uint32_t index)
{
    snprintf(out, ROUNDS_PATH_MAX, "%s/round-%05u.kgr", folder, index + 1u);
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
           thread_start(&threads[helpers], work, &hall) == 0) {
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

/* Returns the quantile `share`, in [0, 1], of `count` sorted values. `count` must be at least 1.
 * The k-th of n values is the quantile (k - 1) / (n - 1), as in most statistics programs (type
 * 7). */
static double quantile(const uint32_t *sorted, uint32_t count, double share)
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
        .median = quantile(values, count, 0.5),
        .p90 = quantile(values, count, 0.9),
        .max = values[count - 1u],
    };
}
