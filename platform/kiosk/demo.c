/* demo.c -- runs the demonstration, which is `kingyo` without a screen. The README's pictures come
 * from the demonstration. */
#include "platform/kiosk/demo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/tank/preset.h"
#include "platform/board.h"
#include "platform/os/clock.h"
#include "platform/os/log.h"
#include "platform/os/png.h"
#include "platform/os/print.h"

/* Simulated duration of one frame: six ticks. A software renderer needs about the same time for one
 * picture. */
#define FRAME_NS 50000000ull
#define START_NS FRAME_NS /* Simulated time at which START is pressed. */
/* Simulated duration of one frame before the round. The frames before the round are not drawn. */
#define PRELUDE_NS 100000000ull
/* Maximum number of ticks before the round. */
#define PRELUDE_TICKS_MAX (60u * CORE_TICK_HZ)
/* Number of ticks from the start of the round until each poi has moved from the side of the tank to
 * the water. */
#define IN_ROUND_TICKS (3u * CORE_TICK_HZ / 4u)
/* Seconds that the demonstration continues after the round, to move the last fish to the bowl and
 * to show the result. */
#define AFTER_ROUND_S 5u
/* Minimum length of the round in seconds. A shorter demonstration ends during the round. */
#define ROUND_S_MIN 25u
#define FOLDER_DEFAULT "out/demo"
#define PATH_SIZE (OPTIONS_PATH_MAX + 32u)

struct demo {
    struct run_common *session;
    const char *folder;
    struct contact_sheet sheet;
    uint64_t now_ns, end_ns;
    uint32_t shots;
    uint32_t width, height; /* Size of the pictures in pixels. */
    bool whole_replay;      /* True if the demonstration ends with the last tick of a replayed
                               recording. False if the demonstration ends at the simulated time
                               end_ns. */
    bool failed;            /* True if a picture could not be captured or written. */
};

static enum exit_code demo_begin(struct demo *demo)
{
    const struct options *options = &demo->session->options;
    struct kiosk_config config = {
        .core = {
            .seed = options->has_seed ? options->seed : DEMO_SEED,
            .preset = options->tank,
        },
        .stopwatch = clock_device(),
    };
    struct settings *settings = &config.core.persistent.settings;
    options_first(options, settings);
    options_last(options, settings);
    settings_hide_pin(settings, config.core.seed);
    settings->value[SET_PLAY] = PLAY_FREE; /* The demonstration uses free play because the bot
                                              cannot insert coins. */
    if (!options_query(options, SET_MODES)) {
        settings->value[SET_MODES] = 1 << MODE_FESTIVAL;
    }
    const uint32_t round_s = options->demo_s > AFTER_ROUND_S ? options->demo_s - AFTER_ROUND_S : 0;
    config_apply_settings(&config.core, settings);
    config.core.round_s = round_s > ROUND_S_MIN ? round_s : ROUND_S_MIN;
    for (uint32_t i = 0; i < config.core.players; i++) {
        config.bot[i] = true;
    }
    demo->whole_replay = options->replay[0] && !options->demo;
    demo->end_ns = demo->whole_replay ? demo->session->replayed.ticks * NS_PER_S / CORE_TICK_HZ
                                      : options->demo_s * NS_PER_S;
    return run_common_begin(demo->session, &config);
}

/* ---- Pictures ------------------------------------------------------------------------------ */

static void take_shot(struct demo *demo)
{
    CORE_ASSERT(demo->shots < SHEET_PICTURES);
    char path[PATH_SIZE];
    struct hal_image image;
    snprintf(path, sizeof path, "%s/shot-%02u.png", demo->folder, demo->shots + 1);
    if (run_common_shot(demo->session, path, &image)) {
        demo->failed = true;
        return;
    }
    if (!demo->sheet.rgb) {
        demo->sheet.rgb = malloc(demo_sheet_plan(&demo->sheet, image.width, image.height));
        if (!demo->sheet.rgb) {
            log_print(LOG_LEVEL_ERROR, "no memory for the contact sheet");
            demo->failed = true;
            return;
        }
        demo_sheet_clear(&demo->sheet);
    }
    demo_sheet_put(&demo->sheet, demo->shots, image.rgb, image.width, image.height);
    demo->shots++;
}

/* ---- Main loop ----------------------------------------------------------------------------- */

static enum kiosk_end demo_run_frames(struct demo *demo)
{
    struct run_common *session = demo->session;
    const struct output *output = &session->kiosk.output;
    const bool is_replay = session->options.replay[0] != '\0';
    enum kiosk_end end = KIOSK_RUNS;
    /* Runs frames without pictures until the pois are over the water in the round. Until then the
     * bot's poi is beside the tank. */
    while (!is_replay && end == KIOSK_RUNS && !*session->stop &&
           !(output->phase == PHASE_ROUND && output->tick - output->round_tick >= IN_ROUND_TICKS) &&
           output->tick < PRELUDE_TICKS_MAX) {
        end = kiosk_frame(&session->kiosk, &session->hal);
        board_rehearsal_advance(PRELUDE_NS);
    }
    const bool on_terminal = isatty(STDERR_FILENO);
    const uint64_t step_ns = on_terminal ? NS_PER_S / 2 : 5 * NS_PER_S;
    while (end == KIOSK_RUNS && !*session->stop &&
           (demo->whole_replay || demo->now_ns < demo->end_ns)) {
        end = kiosk_frame(&session->kiosk, &session->hal);
        /* The duration of the demonstration is divided into equal intervals, and each picture is
         * taken in the middle of an interval. */
        const uint64_t due_ns = demo->end_ns * (2 * demo->shots + 1) / (2 * SHEET_PICTURES);
        if (end != KIOSK_DISPLAY_LOST && !demo->failed && demo->shots < SHEET_PICTURES &&
            demo->now_ns >= due_ns) {
            take_shot(demo);
        }
        board_rehearsal_advance(FRAME_NS);
        demo->now_ns += FRAME_NS;
        /* Prints the progress. On a terminal, one line is updated. Otherwise one line is printed
         * every five seconds. */
        if (demo->now_ns % step_ns == 0) {
            fprintf(stderr, "%s%s: %4.1f of %.0f s, %u pictures%s", on_terminal ? "\r" : "",
                    is_replay ? "replay" : "demo", (double)demo->now_ns / (double)NS_PER_S,
                    (double)demo->end_ns / (double)NS_PER_S, demo->shots, on_terminal ? "" : "\n");
        }
    }
    if (on_terminal) {
        fputc('\n', stderr);
    }
    return end;
}

static void print_summary(const struct demo *demo)
{
    const struct run_common *session = demo->session;
    const struct kiosk *kiosk = &session->kiosk;
    const struct frame_timing *frame = &kiosk->work_time;
    const double ticks = kiosk->output.tick > 0 ? kiosk->output.tick : 1;
    const double share = frame->sum_ns > 0 ? (double)kiosk->core_ns / (double)frame->sum_ns : 0.0;
    printf("Kingyo %s: %.0f s %s, seed %u, %u fish\n", KINGYO_VERSION,
           (double)demo->now_ns / (double)NS_PER_S,
           session->options.replay[0] ? "of a recording" : "played by the bot",
           kiosk->core.config.seed, core_status(&kiosk->core).fish_count);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (kiosk->scene.bowl[i].present) {
            printf("  player %u      %u fish caught, %.0f %% of the paper left\n", i + 1u,
                   kiosk->scene.caught[i], 100.0 * (double)kiosk->scene.poi[i].paper_left);
        }
    }
    printf("  ticks         %u, %llu dropped\n", kiosk->output.tick,
           (unsigned long long)kiosk->pace.dropped);
    printf("  frames        %llu of %ux%u%s; frame time median %.1f ms, p99 %.1f ms\n",
           (unsigned long long)kiosk->frames, demo->width, demo->height,
           session->options.replay[0] ? ", drawn where pictures are" : "",
           (double)frame_timing_quantile_ns(frame, 0.5) * 1e-6,
           (double)frame_timing_quantile_ns(frame, 0.99) * 1e-6);
    printf("  core          %.1f %% of the frame; %.3f ms a tick\n", 100.0 * share,
           (double)kiosk->core_ns * 1e-6 / ticks);
    printf("  state hash    %016llx\n", (unsigned long long)core_hash(&kiosk->core));
    print_line(stdout, "  drawn by      %s",
               session->hal.display.ops->describe(session->hal.display.self));
    if (demo->shots > 0) {
        print_line(stdout, "  pictures      %s/contact-sheet.png and %u shots beside it",
                   demo->folder, demo->shots);
    } else {
        printf("  pictures      none\n");
    }
}

enum exit_code demo_run(struct run_common *session)
{
    const struct options *options = &session->options;
    struct demo demo = {
        .session = session,
        .width = options->width ? options->width : 1280,
        .height = options->height ? options->height : 720,
    };
    demo.folder = options->shots[0] ? options->shots : FOLDER_DEFAULT;
    enum exit_code code = run_common_make_folder(demo.folder);
    if (code != EXIT_OK) {
        return code;
    }
    const struct board_options board = {
        .width = demo.width,
        .height = demo.height,
        /* Pictures are drawn only on demand while a replay plays. In a demonstration without a
         * replay, every frame is drawn, because the demonstration measures its frame times. */
        .on_demand = options->replay[0] != '\0',
        .view = tank_preset(options->tank)->view,
        .library = &session->library,
    };
    board_open_rehearsal(&session->hal, &board, START_NS);
    code = run_common_make_room(session, demo.width, demo.height);
    if (code == EXIT_OK) {
        code = demo_begin(&demo);
    }
    if (code != EXIT_OK) {
        return code;
    }
    run_common_print_library(session);
    const enum kiosk_end end = demo_run_frames(&demo);
    if (demo.shots == 0) {
        log_print(LOG_LEVEL_ERROR, "no picture could be made here");
    }
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/contact-sheet.png", demo.folder);
    const int error =
        demo.sheet.rgb ? png_write(path, demo.sheet.rgb, demo.sheet.width, demo.sheet.height) : 0;
    if (error) {
        log_print(LOG_LEVEL_ERROR, "%s: cannot write: %s", path, strerror(-error));
        demo.failed = true;
    }
    free(demo.sheet.rgb);
    print_summary(&demo);
    code = run_common_end(session);
    session->hal.display.ops->close(session->hal.display.self);
    if (end == KIOSK_FLOAT) {
        return run_common_print_float();
    }
    if (code == EXIT_OK && (demo.failed || demo.shots == 0 || end == KIOSK_DISPLAY_LOST)) {
        code = EXIT_NOT_SO;
    }
    return code;
}

/* ---- Contact sheet ------------------------------------------------------------------------- */

size_t demo_sheet_plan(struct contact_sheet *sheet, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width > 0);
    const uint32_t tall = (uint32_t)((uint64_t)SHEET_PICTURE_WIDTH * height / width);
    sheet->picture_height = tall > 0 ? tall : 1;
    sheet->width = SHEET_COLUMNS * SHEET_PICTURE_WIDTH + (SHEET_COLUMNS + 1) * SHEET_MARGIN;
    sheet->height = SHEET_ROWS * sheet->picture_height + (SHEET_ROWS + 1) * SHEET_MARGIN;
    return (size_t)sheet->width * sheet->height * 3;
}

void demo_sheet_clear(struct contact_sheet *sheet)
{
    CORE_ASSERT(sheet->rgb);
    static const uint8_t night[3] = { 24, 28, 46 };
    const size_t count = (size_t)sheet->width * sheet->height;
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++) {
            sheet->rgb[3 * i + c] = night[c];
        }
    }
}

struct span {
    /* Source pixels that one target pixel covers, at least one: `begin` is the index of the first
     * pixel, and `end` is the index of the last pixel plus 1. */
    uint32_t begin, end;
};

static struct span span_under(uint32_t index, uint32_t count, uint32_t source)
{
    const uint32_t begin = (uint32_t)((uint64_t)index * source / count);
    const uint32_t end = (uint32_t)((uint64_t)(index + 1) * source / count);
    return (struct span){ begin, end > begin ? end : begin + 1 };
}

static void average(const uint8_t *rgb, uint32_t width, struct span x, struct span y,
                    uint8_t out[3])
{
    uint32_t sum[3] = { 0 };
    const uint32_t count = (x.end - x.begin) * (y.end - y.begin);
    for (uint32_t row = y.begin; row < y.end; row++) {
        const uint8_t *pixel = rgb + ((size_t)row * width + x.begin) * 3;
        for (uint32_t column = x.begin; column < x.end; column++, pixel += 3) {
            for (int c = 0; c < 3; c++) {
                sum[c] += pixel[c];
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        out[c] = (uint8_t)((sum[c] + count / 2) / count);
    }
}

void demo_sheet_put(struct contact_sheet *sheet, uint32_t index, const uint8_t *rgb, uint32_t width,
                    uint32_t height)
{
    CORE_ASSERT(index < SHEET_PICTURES);
    CORE_ASSERT(sheet->rgb);
    const uint32_t left =
        SHEET_MARGIN + index % SHEET_COLUMNS * (SHEET_PICTURE_WIDTH + SHEET_MARGIN);
    const uint32_t top =
        SHEET_MARGIN + index / SHEET_COLUMNS * (sheet->picture_height + SHEET_MARGIN);
    for (uint32_t y = 0; y < sheet->picture_height; y++) {
        uint8_t *out = sheet->rgb + ((size_t)(top + y) * sheet->width + left) * 3;
        const struct span rows = span_under(y, sheet->picture_height, height);
        for (uint32_t x = 0; x < SHEET_PICTURE_WIDTH; x++, out += 3) {
            average(rgb, width, span_under(x, SHEET_PICTURE_WIDTH, width), rows, out);
        }
    }
}
