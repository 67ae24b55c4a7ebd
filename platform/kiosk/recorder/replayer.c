/* replayer.c -- records the ticks of the frame loop, and provides recorded inputs to the frame
 * loop; see replayer.h. */
#include "platform/kiosk/recorder/replayer.h"

#include <errno.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/print.h"

/* Returns the increase from `*before` to `now`, and sets `*before` to `now`. Returns 0 if the value
 * has decreased. */
static uint32_t risen(uint32_t *before, uint32_t now)
{
    const uint32_t rise = now > *before ? now - *before : 0;
    *before = now;
    return rise;
}

void recorder_count(struct replay_totals *totals, struct recorder_tally *tally,
                    const struct core *core)
{
    const struct core_status status = core_status(core);
    totals->ticks++;
    totals->rounds += risen(&tally->rounds, status.round_count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        totals->caught += risen(&tally->caught[i], status.player[i].caught);
        totals->fouls += risen(&tally->fouls[i], status.player[i].fouls);
        if (status.phase == PHASE_ROUND && status.player[i].plays) {
            totals->modes |= (uint16_t)(1u << status.mode);
            totals->players |= (uint16_t)(1u << i);
        }
    }
}

int replayer_begin(struct replayer *replayer, const char *path, struct core_config *config)
{
    memset(replayer, 0, sizeof *replayer);
    if (replay_open(&replayer->reader, path)) {
        return -1;
    }
    *config = replayer->reader.header.config;
    return 0;
}

int replayer_begin_in(struct replayer *replayer, const uint8_t *bytes, size_t size,
                      struct core_config *config)
{
    CORE_ASSERT(bytes);
    memset(replayer, 0, sizeof *replayer);
    if (replay_open_in(&replayer->reader, bytes, size)) {
        return -1;
    }
    *config = replayer->reader.header.config;
    return 0;
}

static int replayer_next(void *self, struct input *out)
{
    struct replayer *replayer = self;
    const int result = replay_next(&replayer->reader, out);
    replayer->damaged = result < 0;
    return result == 1;
}

struct kiosk_source replayer_source(struct replayer *replayer)
{
    return (struct kiosk_source){ .next = replayer_next, .self = replayer };
}

bool replayer_is_interrupted(const struct replayer *replayer)
{
    const struct replay_reader *reader = &replayer->reader;
    return reader->as_is && reader->chunk_left == 0 && reader->totals.hash == REPLAY_HASH_NONE;
}

static void compare_replay_value(struct replayer *replayer, bool is_full, uint64_t recorded,
                                 uint64_t computed)
{
    if (recorded != computed && !replayer->difference.found) {
        replayer->difference = (struct replay_difference){
            .found = true,
            .is_full = is_full,
            .tick = replayer->totals.ticks - 1,
            .recorded = recorded,
            .computed = computed,
        };
    }
}

static void replayer_tick(void *self, const struct input *input, const struct core *core)
{
    struct replayer *replayer = self;
    const struct replay_reader *reader = &replayer->reader;
    (void)input;
    recorder_count(&replayer->totals, &replayer->tally, core);
    if (replayer_is_interrupted(replayer)) {
        return;
    }
    if (reader->has_digest) {
        compare_replay_value(replayer, false, reader->digest, (uint32_t)core_hash_quick(core));
    }
    if (reader->chunk_left == 0 && !replayer->difference.found) {
        compare_replay_value(replayer, true, reader->totals.hash, core_hash(core));
        compare_replay_value(replayer, true, reader->totals.rounds, replayer->totals.rounds);
        compare_replay_value(replayer, true, reader->totals.caught, replayer->totals.caught);
        compare_replay_value(replayer, true, reader->totals.fouls, replayer->totals.fouls);
        compare_replay_value(replayer, true, 1,
                             (uint64_t)replay_totals_agree(&reader->totals, &replayer->totals));
    }
}

struct kiosk_tap replayer_tap(struct replayer *replayer)
{
    return (struct kiosk_tap){ .tick = replayer_tick, .self = replayer };
}

void replayer_end(struct replayer *replayer)
{
    replay_close(&replayer->reader);
}

enum exit_code replayer_print_problem(const char *prefix, const char *path,
                                      const struct replay_problem *problem)
{
    return print_fail(problem->is_io ? EXIT_IO : EXIT_BAD_DATA, "%s: %s: byte %llu: %s", prefix,
                      path, (unsigned long long)problem->offset, problem->text);
}

/* ---- Recording to a file ------------------------------------------------------------------- */

void recorder_add_tick(struct replay_writer *writer, struct replay_totals *totals,
                       struct recorder_tally *tally, const struct input *input,
                       const struct core *core)
{
    recorder_count(totals, tally, core);
    if (replay_needs_hash(writer)) {
        totals->hash = core_hash(core);
    }
    replay_add(writer, input, replay_needs_digest(writer) ? (uint32_t)core_hash_quick(core) : 0,
               totals);
}

int recorder_begin(struct recorder *recorder, const char *path, const struct core *core)
{
    CORE_ASSERT(core_is_fresh(core));
    memset(&recorder->totals, 0, sizeof recorder->totals);
    memset(&recorder->tally, 0, sizeof recorder->tally);
    recorder->core = core;
    recorder->is_in_tick = recorder->is_adding = false;
    recorder->totals.hash = core_hash(core);
    return replay_create(&recorder->writer, path, &core->config, recorder->totals.hash);
}

static void recorder_before(void *self, const struct input *input)
{
    struct recorder *recorder = self;
    recorder->begun = *input;
    atomic_store(&recorder->is_in_tick, true);
}

static void recorder_tick(void *self, const struct input *input, const struct core *core)
{
    struct recorder *recorder = self;
    atomic_store(&recorder->is_adding, true);
    atomic_store(&recorder->is_in_tick, false);
    recorder_add_tick(&recorder->writer, &recorder->totals, &recorder->tally, input, core);
    atomic_store(&recorder->is_adding, false);
}

struct kiosk_tap recorder_tap(struct recorder *recorder)
{
    return (struct kiosk_tap){ .before = recorder_before, .tick = recorder_tick, .self = recorder };
}

int recorder_end(struct recorder *recorder)
{
    /* The core is hashed only if a recording is open. Otherwise the core may not exist. */
    return replay_finish(&recorder->writer,
                         replay_is_open(&recorder->writer) ? core_hash(recorder->core) : 0);
}

int recorder_end_in_panic(struct recorder *recorder)
{
    if (atomic_load(&recorder->is_adding)) {
        return -EINTR;
    }
    if (!atomic_load(&recorder->is_in_tick)) {
        return recorder_end(recorder);
    }
    recorder->totals.hash = REPLAY_HASH_NONE;
    recorder->totals.ticks++;
    replay_add(&recorder->writer, &recorder->begun, 0, &recorder->totals);
    return replay_finish(&recorder->writer, REPLAY_HASH_NONE);
}
