/* replayer.c -- provides the recorded inputs to the frame loop and compares the results; see
 * replayer.h. */
#include "platform/kiosk/replayer.h"

#include <stdio.h>
#include <string.h>

#include "platform/kiosk/recorder.h"
#include "platform/os/print.h"

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

int replayer_is_interrupted(const struct replayer *replayer)
{
    const struct replay_reader *reader = &replayer->reader;
    return reader->as_is && reader->chunk_left == 0 && reader->totals.hash == REPLAY_HASH_NONE;
}

static void compare(struct replayer *replayer, int is_full, uint64_t recorded, uint64_t computed)
{
    if (recorded != computed && !replayer->difference.found) {
        replayer->difference = (struct replay_difference){
            .found = 1,
            .is_full = is_full != 0,
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
        compare(replayer, 0, reader->digest, (uint32_t)core_hash_quick(core));
    }
    if (reader->chunk_left == 0 && !replayer->difference.found) {
        compare(replayer, 1, reader->totals.hash, core_hash(core));
        compare(replayer, 1, reader->totals.rounds, replayer->totals.rounds);
        compare(replayer, 1, reader->totals.caught, replayer->totals.caught);
        compare(replayer, 1, reader->totals.fouls, replayer->totals.fouls);
        compare(replayer, 1, 1, (uint64_t)replay_totals_agree(&reader->totals, &replayer->totals));
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

enum exit_code replayer_print_problem(const char *speaker, const char *path,
                                      const struct replay_problem *problem)
{
    print_error("%s: %s: byte %llu: %s", speaker, path, (unsigned long long)problem->offset,
                problem->text);
    return problem->is_io ? EXIT_IO : EXIT_BAD_DATA;
}
