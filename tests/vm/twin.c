/* twin.c -- recomputes the game of a kiosk from new ticks of its recording, and compares the digest
 * of each tick. */
#include "tests/vm/twin.h"

#include <string.h>

void twin_tick(struct core *core, const struct input *input, struct output *output)
{
    output->sound_count = 0;
    core_tick(core, input, output);
}

static void count_link(struct twin *twin)
{
    const uint8_t link = twin->input.poi[0].link;
    if (link == POI_SOURCE_LOST && twin->was_live) {
        twin->lost_spans++;
        twin->lost_ticks = 0;
    }
    twin->lost_ticks += link == POI_SOURCE_LOST;
    twin->was_live = link == POI_SOURCE_LIVE;
}

static void count(struct twin *twin)
{
    twin->coins += input_coin_pulses(&twin->input);
    for (uint32_t i = 0; i < sizeof twin->presses / sizeof twin->presses[0]; i++) {
        twin->presses[i] += twin->input.pressed >> i & 1u;
    }
    count_link(twin);
    const bool starts = twin->presses[0] > 0 && twin->start_tick == 0;
    const bool dips =
        twin->core.game.phase == PHASE_ROUND && twin->core.world.poi[0].immersed > 0.0f;
    twin->start_tick = starts ? twin->core.game.tick : twin->start_tick;
    twin->dip_tick = dips && twin->dip_tick == 0 ? twin->core.game.tick : twin->dip_tick;
    twin->paused_ticks += twin->core.game.phase == PHASE_ROUND && twin->core.game.paused;
}

/* Decodes the recorded ticks that the core has already run, so that the next decoded tick is a new
 * one. */
static int skip_known(struct twin *twin, struct input *input)
{
    for (uint32_t i = 0; i < twin->ticks; i++) {
        if (replay_next(&twin->reader, input) != 1) {
            return 0;
        }
    }
    return 1;
}

static int begin(struct twin *twin)
{
    if (!twin->begun && core_init(&twin->core, &twin->reader.header.config) != CORE_OK) {
        return 0;
    }
    twin->begun = 1;
    return 1;
}

int twin_follow(struct twin *twin)
{
    struct input input = { 0 };
    const uint32_t before = twin->ticks;
    if (twin->differs_at || replay_open(&twin->reader, twin->path)) {
        /* The recording does not exist yet, or the kiosk is just writing it. A later call can read
         * it. */
        return twin->differs_at ? -1 : 0;
    }
    if (!begin(twin) || !skip_known(twin, &input)) {
        replay_close(&twin->reader);
        return twin->begun ? 0 : -1;
    }
    while (replay_next(&twin->reader, &input) == 1) {
        twin->input = input;
        twin_tick(&twin->core, &input, &twin->output);
        twin->ticks++;
        count(twin);
        twin->caught = twin->reader.totals.caught;
        if ((uint32_t)core_hash_quick(&twin->core) != twin->reader.digest) {
            twin->differs_at = twin->ticks;
            break;
        }
    }
    replay_close(&twin->reader);
    return twin->differs_at ? -1 : twin->ticks > before;
}
