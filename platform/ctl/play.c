/* play.c -- `kingyoctl play`: the bot plays rounds, without a screen, at full speed. */
#include <stdio.h>
#include <string.h>

#include "platform/cpu.h"
#include "platform/ctl/ctl.h"
#include "platform/number.h"
#include "platform/kiosk/recorder.h"

static const char name[] = "play";

#define ROUND_TICKS_MAX (620u * CORE_TICK_HZ) /* The longest round with its ready and a margin. */

struct play_options {
    uint32_t rounds, seed, fish_count, round_s;
    const char *record;
    int as_json;
};

struct game_run {
    struct core core;
    struct input input;
    struct output output;
    struct recorder recorder;
};

/* ---- One round ------------------------------------------------------------------------------ */

static void tick(struct game_run *run, const struct kiosk_tap *tap)
{
    run->output.sound_count = 0;
    core_tick(&run->core, &run->input, &run->output);
    if (tap->tick) {
        tap->tick(tap->self, &run->input, &run->core);
    }
    run->input.pressed = 0;
}

/* START as often as it takes; the record says when the round is over. 0 when it never is. */
static int play_round(struct game_run *run, const struct kiosk_tap *tap)
{
    const uint32_t before = run->output.record.id;
    for (uint32_t i = 0; i < ROUND_TICKS_MAX; i++) {
        const uint8_t phase = run->core.game.phase;
        const int idle = phase == PHASE_ATTRACT || phase == PHASE_RESULT;
        run->input.pressed = idle && i % CORE_TICK_HZ == 0 ? INPUT_START : 0;
        tick(run, tap);
        if (run->output.record.id != before) {
            return 1;
        }
    }
    return 0;
}

static void tell_round(const struct game_run *run, const struct play_options *options,
                       uint32_t index)
{
    const struct round_record *record = &run->output.record;
    const double seconds = (double)(record->end_tick - record->start_tick) / CORE_TICK_HZ;
    if (options->as_json) {
        printf("%s{\"round\": %u, \"caught\": %u, \"seconds\": %.3f, \"dips\": %u}",
               index ? ", " : "", index + 1, record->caught, seconds, run->core.poi[0].dips);
    } else {
        printf("round %u: %u caught in %.1f s\n", index + 1, record->caught, seconds);
    }
}

static enum exit_code play(struct game_run *run, const struct play_options *options)
{
    const struct kiosk_tap tap =
        options->record ? recorder_tap(&run->recorder) : (struct kiosk_tap){ 0 };
    uint32_t caught = 0;
    if (options->as_json) {
        printf("{\"seed\": %u, \"bot\": \"stall\", \"rounds\": [", options->seed);
    }
    for (uint32_t i = 0; i < options->rounds; i++) {
        if (!play_round(run, &tap)) {
            fprintf(stderr, "kingyoctl play: round %u did not come to its end\n", i + 1);
            return EXIT_NOT_SO;
        }
        caught += run->output.record.caught;
        tell_round(run, options, i);
    }
    const unsigned long long hash = core_hash(&run->core);
    if (options->as_json) {
        printf("], \"caught\": %u, \"ticks\": %u, \"hash\": \"%016llx\"}\n", caught,
               run->core.tick, hash);
    } else {
        printf("%u rounds, %u caught, %u ticks, hash %016llx\n", options->rounds, caught,
               run->core.tick, hash);
    }
    return EXIT_OK;
}

/* ---- The command ---------------------------------------------------------------------------- */

static enum exit_code begin(struct game_run *run, const struct play_options *options)
{
    const struct core_config config = {
        .seed = options->seed,
        .fish_count = options->fish_count,
        .round_s = options->round_s,
        .lanes = cpu_lanes(),
    };
    if (core_init(&run->core, &config) != CORE_OK) {
        return ctl_usage(name, "no such stall: --round-s is 10 to 600");
    }
    run->input.poi[0].link = POI_LINK_BOT;
    const int error =
        options->record ? recorder_begin(&run->recorder, options->record, &run->core) : 0;
    if (error) {
        fprintf(stderr, "kingyoctl play: %s: cannot record: %s\n", options->record,
                strerror(-error));
        return EXIT_IO;
    }
    return EXIT_OK;
}

static enum exit_code end(struct game_run *run, const struct play_options *options)
{
    const int error = options->record ? recorder_end(&run->recorder) : 0;
    if (error) {
        fprintf(stderr, "kingyoctl play: %s: recording stopped: %s\n", options->record,
                strerror(-error));
        return EXIT_IO;
    }
    return EXIT_OK;
}

/* Takes the option at argv[*index] and its value. EXIT_OK, or told. */
static enum exit_code take_option(struct play_options *options, int argc, const char *const *argv,
                                  int *index)
{
    const char *option = argv[*index];
    const char *value = *index + 1 < argc ? argv[*index + 1] : NULL;
    int right = 0;
    if (strcmp(option, "--json") == 0) {
        options->as_json = 1;
        return EXIT_OK;
    }
    ++*index;
    if (strcmp(option, "--bot") == 0) {
        right = value && strcmp(value, "stall") == 0;
    } else if (strcmp(option, "--rounds") == 0) {
        right = number_parse(value, 1, 100000, &options->rounds);
    } else if (strcmp(option, "--seed") == 0) {
        right = number_parse(value, 0, UINT32_MAX, &options->seed);
    } else if (strcmp(option, "--fish") == 0) {
        const uint32_t max = tank_preset_fish_max(tank_preset(TANK_PRESET_FESTIVAL), 1.0f);
        if (!number_parse(value, 1, max, &options->fish_count)) {
            return ctl_usage(name, "--fish: '%.100s' is not right; the water holds 1 to %u",
                             value ? value : "", max);
        }
        right = 1;
    } else if (strcmp(option, "--round-s") == 0) {
        right = number_parse(value, 10, 600, &options->round_s);
    } else if (strcmp(option, "--record") == 0) {
        options->record = value;
        right = value != NULL;
    } else {
        return ctl_usage(name, "unknown option '%.100s'; --help lists them", option);
    }
    if (!right) {
        return ctl_usage(name, "%s: '%.100s' is not right; --help says what is", option,
                         value ? value : "");
    }
    return EXIT_OK;
}

static enum exit_code run(int argc, const char *const *argv)
{
    static struct game_run game;
    struct play_options options = { .rounds = 1 };
    for (int i = 0; i < argc; i++) {
        const enum exit_code code = take_option(&options, argc, argv, &i);
        if (code != EXIT_OK) {
            return code;
        }
    }
    enum exit_code code = begin(&game, &options);
    if (code == EXIT_OK) {
        code = play(&game, &options);
        const enum exit_code ended = end(&game, &options);
        code = code == EXIT_OK ? ended : code;
    }
    return code;
}

const struct ctl_command ctl_play = {
    .name = name,
    .summary = "rounds played by the bot, without a screen",
    .usage = "  --bot NAME       who plays: stall, the bot of the attract picture\n"
             "  --rounds N       how many rounds, 1 to 100000 (1)\n"
             "  --seed N         of everything random (0)\n"
             "  --fish N         how many fish, from 1 to what the water holds (the stall's own)\n"
             "  --round-s N      seconds a round, 10 to 600 (60)\n"
             "  --record FILE    write the play to FILE\n"
             "  --json           for programs\n",
    .run = run,
};
