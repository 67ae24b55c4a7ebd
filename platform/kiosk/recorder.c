/* recorder.c -- records the ticks of the frame loop to a file; see recorder.h. */
#include "platform/kiosk/recorder.h"

#include <errno.h>
#include <string.h>

/* Returns the increase of `now` over `*before`, and sets `*before` to `now`. Returns 0 after a
 * decrease. */
static uint32_t risen(uint32_t *before, uint32_t now)
{
    const uint32_t rise = now > *before ? now - *before : 0;
    *before = now;
    return rise;
}

void recorder_count(struct replay_totals *totals, struct recorder_tally *tally,
                    const struct core *core)
{
    const struct game *game = &core->game;
    totals->ticks++;
    totals->rounds += risen(&tally->rounds, game->round_count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        totals->caught += risen(&tally->caught[i], game->player[i].caught);
        totals->fouls += risen(&tally->fouls[i], game->player[i].fouls);
        if (game->phase == PHASE_ROUND && game->player[i].plays) {
            totals->modes |= (uint16_t)(1u << game->mode);
            totals->players |= (uint16_t)(1u << i);
        }
    }
}

int recorder_begin(struct recorder *recorder, const char *path, const struct core *core)
{
    memset(&recorder->totals, 0, sizeof recorder->totals);
    memset(&recorder->tally, 0, sizeof recorder->tally);
    recorder->core = core;
    recorder->is_in_tick = recorder->is_adding = 0;
    recorder->totals.hash = core_hash(core);
    return replay_create(&recorder->writer, path, &core->config, recorder->totals.hash);
}

static void recorder_before(void *self, const struct input *input)
{
    struct recorder *recorder = self;
    recorder->begun = *input;
    atomic_store(&recorder->is_in_tick, 1);
}

static void recorder_tick(void *self, const struct input *input, const struct core *core)
{
    struct recorder *recorder = self;
    atomic_store(&recorder->is_adding, 1);
    atomic_store(&recorder->is_in_tick, 0);
    recorder_count(&recorder->totals, &recorder->tally, core);
    if (replay_wants_hash(&recorder->writer)) {
        recorder->totals.hash = core_hash(core);
    }
    const int wants_digest = replay_wants_digest(&recorder->writer);
    replay_add(&recorder->writer, input, wants_digest ? (uint32_t)core_hash_quick(core) : 0,
               &recorder->totals);
    atomic_store(&recorder->is_adding, 0);
}

struct kiosk_tap recorder_tap(struct recorder *recorder)
{
    return (struct kiosk_tap){ .before = recorder_before, .tick = recorder_tick, .self = recorder };
}

int recorder_end(struct recorder *recorder)
{
    const int is_open = replay_is_open(&recorder->writer); /* The core must not be hashed if no
                                                              recording is open, because the core
                                                              may not exist. */
    return replay_finish(&recorder->writer, is_open ? core_hash(recorder->core) : 0);
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
