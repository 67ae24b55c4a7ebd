/* run_interactive.c -- opens the devices of the board, runs the frame loop and closes the devices;
 * see run_common.h. */
#include "platform/kiosk/run_common.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/tank/preset.h"
#include "platform/board.h"
#include "platform/kiosk/board_report.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/os/print.h"
#include "platform/thermal.h"

#define SHOT_TICKS (5u * CORE_TICK_HZ)

static double quantile_ms(const struct frame_timing *timing, double share)
{
    return (double)frame_timing_quantile_ns(timing, share) * 1e-6;
}

/* Closes the store, then prints the statistics, which include entries that could not be written.
 * Returns EXIT_IO if entries or edits are lost, otherwise EXIT_OK. */
static enum exit_code print_end(struct run_common *session, enum kiosk_end end)
{
    struct kiosk *kiosk = &session->kiosk;
    const uint32_t lost = kiosk_close_store(kiosk, &session->hal);
    if (end == KIOSK_DISPLAY_LOST) {
        log_print(LOG_LEVEL_ERROR, "the display was lost after %u s: %s",
                  kiosk->output.tick / CORE_TICK_HZ,
                  session->hal.display.ops->describe(session->hal.display.self));
    }
    printf("%llu frames, median %.1f ms, p99 %.1f ms; %u ticks, %llu dropped; device faults %u\n",
           (unsigned long long)kiosk->frames, quantile_ms(&kiosk->frame_time, 0.5),
           quantile_ms(&kiosk->frame_time, 0.99), kiosk->output.tick,
           (unsigned long long)kiosk->pace.dropped, kiosk_fault_count(&kiosk->faults));
    /* Prints the duration of a frame, from the first device poll to the end of the buffer swap.
     * Also prints the core's share of this duration. */
    const struct frame_timing *work = &kiosk->work_time;
    const double share = work->sum_ns > 0 ? (double)kiosk->core_ns / (double)work->sum_ns : 0.0;
    printf("a frame's work: median %.1f ms, p99 %.1f ms, the core %.1f %% of it\n",
           quantile_ms(work, 0.5), quantile_ms(work, 0.99), 100.0 * share);
    /* Prints the latency of controller reports, if a poi has time-stamped reports. */
    const struct frame_timing *wait = &kiosk->report_wait;
    if (wait->count > 0) {
        printf("%llu reports of pois, from arrival to the tick that used them: median %.1f ms, "
               "p99 %.1f ms\n",
               (unsigned long long)wait->count, quantile_ms(wait, 0.5), quantile_ms(wait, 0.99));
    }
    if (lost > 0) {
        const struct hal_storage *storage = &session->hal.storage;
        log_print(LOG_LEVEL_ERROR, "%u entries or graphs could not be written (%s)", lost,
                  storage->ledger.ops->describe(storage->ledger.self));
    }
    return lost > 0 ? EXIT_IO : EXIT_OK;
}

/* Returns the first exit code that is not EXIT_OK, in the order store, recording, display. Returns
 * EXIT_OK if all exit codes are EXIT_OK. */
static enum exit_code end_play(struct run_common *session, enum kiosk_end end)
{
    const enum exit_code store_code = print_end(session, end);
    const enum exit_code code = run_common_end(session);
    const enum exit_code ended = end == KIOSK_FLOAT          ? run_common_print_float()
                                 : end == KIOSK_DISPLAY_LOST ? EXIT_NOT_SO
                                                             : EXIT_OK;
    return store_code != EXIT_OK ? store_code : code != EXIT_OK ? code : ended;
}

/* Ends the program inside the display call. After the connection to the display is lost, Xlib and
 * the threads of the software renderer are not usable. Therefore the function must not return into
 * the code of Xlib or of the renderer. */
static void on_display_lost(void *self)
{
    struct run_common *session = self;
    const enum exit_code code = end_play(session, KIOSK_DISPLAY_LOST);
    board_release_store(&session->hal);
    fflush(NULL);
    _exit((int)code);
}

/* Returns the time since power on in milliseconds, including sleep. */
static uint64_t since_power_on_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_BOOTTIME, &now);
    return (uint64_t)now.tv_sec * 1000u + (uint64_t)now.tv_nsec / 1000000u;
}

/* Gives the self-test an empty data folder, so that its rounds do not enter the books. The folder
 * is in the folder of temporary files, which the system empties. */
static void use_temporary_data(struct options *options)
{
    const char *folder = getenv("TMPDIR");
    snprintf(options->data, sizeof options->data, "%s/kingyo-selftest-XXXXXX",
             folder && folder[0] ? folder : "/tmp");
    if (!mkdtemp(options->data)) {
        options->data[0] = '\0';
    }
}

static void print_board_report(const struct run_common *session)
{
    const struct kiosk *kiosk = &session->kiosk;
    const struct board_report report = {
        .root = "",
        .display = session->hal.display.ops->describe(session->hal.display.self),
        .seconds = session->options.selftest_s,
        .fish = core_status(&kiosk->core).fish_count,
        .players = kiosk->core.config.players,
        .first_picture_ms = session->first_picture_ms,
        .frames = kiosk->frames,
        .dropped_ticks = kiosk->pace.dropped,
        .faults = kiosk_fault_count(&kiosk->faults),
        .frame_time = &kiosk->frame_time,
        .work_time = &kiosk->work_time,
        .margin_begin_mdeg = session->margin_begin_mdeg,
        .margin_end_mdeg = thermal_read(THERMAL_ROOT),
    };
    board_report_print(&report, stdout);
    fflush(stdout);
}

bool run_interactive_waits_for_screen(void)
{
    const char *socket = getenv("NOTIFY_SOCKET");
    return socket && socket[0];
}

bool run_interactive_open(struct run_common *session)
{
    struct options *options = &session->options;
    struct display_events events;
    if (options->selftest_s > 0) {
        use_temporary_data(options);
    } else if (!options->data[0]) {
        file_default_data(options->data);
    }
    /* The data folder must exist before panic_evidence_open(). If the folder cannot be created, the
     * store reports the reason later. */
    file_make_folder(options->data);
    panic_evidence_open(&session->evidence, options->data, &session->sessions,
                        &session->kiosk.core);
    /* Keys act as buttons and coins by default on a desktop but not in a service, because a
     * stranger may plug a keyboard into a cabinet. */
    const uint8_t automatic = getenv("NOTIFY_SOCKET") ? BOARD_KEYBOARD_OFF : BOARD_KEYBOARD_ON;
    const struct board_options board = {
        .poi = options->poi,
        .keyboard = options->keyboard == BOARD_KEYBOARD_AUTO ? automatic : options->keyboard,
        .usb_count = options->usb_count,
        .usb = (const char(*)[BOARD_USB_SIZE])options->usb,
        .line_count = options->line_count,
        .line = (const char(*)[BOARD_LINE_SIZE])options->line,
        .full_screen = options->width == 0,
        .waits_for_screen = run_interactive_waits_for_screen(),
        .width = options->width,
        .height = options->height,
        .detail = options->detail,
        .data_dir = options->data[0] ? options->data : NULL,
        .view = tank_preset(options->tank)->view,
        .on_display_lost = on_display_lost,
        .on_display_lost_self = session,
        .library = &session->library,
        .on_refused = run_common_note_refused,
        .on_refused_self = session,
    };
    board_open(&session->hal, &board);
    const struct hal_display *display = &session->hal.display;
    if (display->ops->poll(display->self, &events) == HAL_ERR_ABSENT) {
        board_close(&session->hal);
        return false;
    }
    return true;
}

/* Takes a picture if one is due (option --shots). `shots` is the number of pictures so far. Returns
 * the new number. After the first failure the number is UINT32_MAX and no more pictures are taken,
 * so that the error is reported only once. */
static uint32_t take_due_shot(struct run_common *session, uint32_t shots)
{
    char path[OPTIONS_PATH_MAX + 32];
    struct hal_image image;
    if (!session->options.shots[0] || shots == UINT32_MAX ||
        session->kiosk.output.tick < (shots + 1) * SHOT_TICKS) {
        return shots;
    }
    snprintf(path, sizeof path, "%s/shot-%04u.png", session->options.shots, shots + 1);
    return run_common_shot(session, path, &image) ? UINT32_MAX : shots + 1;
}

static enum kiosk_end run_interactive_loop(struct run_common *session)
{
    const struct hal_clock clock = clock_device();
    enum kiosk_end end = KIOSK_RUNS;
    struct frame_pacer_sleep rest = { 0 };
    uint32_t shots = 0;
    bool was_away = false, is_float_reported = false;
    const uint64_t due_ns = hal_now_ns(clock) + session->options.selftest_s * NS_PER_S;
    session->margin_begin_mdeg = thermal_read(THERMAL_ROOT);
    while (end == KIOSK_RUNS && !*session->stop) {
        const uint64_t begin_ns = hal_now_ns(clock);
        if (session->options.selftest_s > 0 && begin_ns >= due_ns) {
            print_board_report(session);
            break;
        }
        end = kiosk_frame(&session->kiosk, &session->hal);
        session->first_picture_ms =
            session->first_picture_ms ? session->first_picture_ms : since_power_on_ms();
        panic_evidence_note_frame(&session->evidence);
        /* Reports once when the display is lost and once when the display is back. */
        const struct hal_display *display = &session->hal.display;
        const bool is_away = session->kiosk.display_retry_ns > 0;
        if (is_away != was_away) {
            print_error("kingyo: %s%s", is_away ? "the kiosk continues without a picture: " : "",
                        display->ops->describe(display->self));
            was_away = is_away;
        }
        /* Reports a changed floating-point control register only once, because a library that
         * changes the register does so in each frame. */
        if (session->kiosk.float_resets > 0 && !is_float_reported) {
            log_print(LOG_LEVEL_WARNING,
                      "a library changed how this thread computes (denormal numbers or "
                      "rounding): it is set back before each frame");
            is_float_reported = true;
        }
        shots = take_due_shot(session, shots);
        status_update(&session->status, &session->kiosk, &session->hal, begin_ns);
        const uint64_t end_ns = hal_now_ns(clock);
        const uint64_t rest_ns = frame_pacer_sleep_ns(&rest, end_ns - begin_ns);
        if (rest_ns > 0) {
            clock_sleep_until(end_ns + rest_ns);
        }
    }
    return end;
}

enum exit_code run_interactive_run(struct run_common *session)
{
    const struct options *options = &session->options;
    const struct hal_storage *storage = &session->hal.storage;
    struct kiosk_config config = {
        .core = {
            .seed = options->has_seed ? options->seed : (uint32_t)time(NULL),
            .preset = options->tank,
        },
        .stopwatch = clock_device(),
    };
    struct settings *settings = &config.core.persistent.settings;
    options_first(options, settings);
    storage->ledger.ops->load(storage->ledger.self, &config.core.persistent);
    options_last(options, settings);
    settings_hide_pin(settings, config.core.seed);
    config_apply_settings(&config.core, settings);
    for (uint32_t i = 0; i < config.core.players; i++) {
        config.bot[i] = options->poi == BOARD_POI_BOT;
    }
    enum exit_code code = run_common_begin(session, &config);
    if (code != EXIT_OK) {
        board_close(&session->hal);
        return code;
    }
    printf("Kingyo %s\n", KINGYO_VERSION);
    struct status_device devices[STATUS_DEVICES_MAX];
    status_devices(&session->hal, devices);
    for (uint32_t i = 0; i < STATUS_DEVICES_MAX; i++) {
        if (devices[i].text && devices[i].text[0]) {
            print_line(stdout, "  %-9s %s", devices[i].part, devices[i].text);
        }
    }
    /* Prints the player slots that have no controller. */
    char text[HAL_TEXT_SIZE] = "";
    for (uint32_t i = 1; i < session->kiosk.core.config.players; i++) {
        if (!session->kiosk.config.bot[i] && session->kiosk.samplers[i].link == POI_SOURCE_ABSENT) {
            const size_t length = strlen(text);
            snprintf(text + length, sizeof text - length, "%s%u", length ? ", " : "", i + 1u);
        }
    }
    if (text[0]) {
        printf("  %-9s no controller for player %s\n", "players", text);
    }
    run_common_print_library(session);
    fflush(stdout);
    status_begin(&session->status, getenv("RUNTIME_DIRECTORY"));
    const enum kiosk_end end = run_interactive_loop(session);
    status_end(&session->status);
    code = end_play(session, end);
    board_close(&session->hal);
    return code;
}
