/* hid_watch.c -- the live output of `kingyoctl hid watch`.
 *
 * On a terminal, the command redraws a view of the latest values. Otherwise, the command prints one
 * row for each value. */
#include "platform/ctl/devices/hid_watch.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "platform/ctl/devices/hid_file.h"
#include "platform/ctl/devices/hid_live.h"
#include "platform/ctl/devices/hid_nodes.h"
#include "platform/ctl/devices/hid_rows.h"
#include "platform/ctl/devices/hid_source.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"

/* Timeout of one wait in ms. The timeout limits the delay after Ctrl-C, and lets the displayed
 * report rate drop when no report arrives. */
#define WAIT_MS 50
/* Minimum time between two redraws in ns, which gives 20 redraws per second. */
#define PICTURE_NS 50000000ull

/* Terminal escape codes. SCREEN_BEGIN selects the alternate screen and hides the cursor. */
#define SCREEN_BEGIN "\x1b[?1049h\x1b[?25l"
#define SCREEN_HOME "\x1b[H"
#define LINE_REST "\x1b[K"
#define SCREEN_REST "\x1b[J"
#define SCREEN_END "\x1b[?25h\x1b[?1049l"

/* State of `kingyoctl hid watch` for one device. */
struct watch {
    struct hid_descriptor descriptor;
    struct hid_source source;
    struct hid_live live;
    char id[HID_ID_SIZE];
    uint8_t on_terminal;
    uint64_t begin_ns, picture_ns;
};

static volatile sig_atomic_t is_stopped;

static void stop(int signal_number)
{
    (void)signal_number;
    is_stopped = 1;
}

static uint64_t hid_watch_now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

/* ---- List of devices ------------------------------------------------------------------------- */

static enum exit_code list(void)
{
    static struct hid_node nodes[HID_NODES_MAX];
    const uint32_t count = hid_nodes_list("", nodes);
    puts("node\tvendor:product\tbus\tdriver\taccess\tname");
    for (uint32_t i = 0; i < count; i++) {
        const struct hid_node *node = &nodes[i];
        printf("/dev/hidraw%u\t%04x:%04x\t%s\t%s\t%s\t%s\n", node->number, node->vendor,
               node->product, hid_node_bus(node), node->driver[0] ? node->driver : "-",
               node->open_errno ? strerror(node->open_errno) : "ok", node->name);
    }
    if (count == 0) {
        print_error("kingyoctl hid: no HID device is plugged in that has a /dev/hidraw node");
    }
    return EXIT_OK;
}

/* ---- Reports of one device ------------------------------------------------------------------- */

static void print_report(struct watch *watch, struct hid_report report, uint64_t time_ns)
{
    char seq[16], tail[40];
    snprintf(seq, sizeof seq, "%u", watch->live.report_count + watch->live.refused_count);
    snprintf(tail, sizeof tail, "\t%.3f\n", (double)(time_ns - watch->begin_ns) / 1e6);
    hid_rows_values(&watch->descriptor, watch->id, seq, report, tail);
    fflush(stdout);
}

static char *picture(const struct watch *watch)
{
    static char text[HID_LIVE_TEXT];
    struct winsize size = { .ws_row = 24, .ws_col = 80 };
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    hid_live_picture(&watch->live, size.ws_col, size.ws_row > 1 ? size.ws_row - 1u : 1u, text);
    return text;
}

static void hid_watch_draw(struct watch *watch, uint64_t time_ns)
{
    if (time_ns - watch->picture_ns < PICTURE_NS) {
        return;
    }
    watch->picture_ns = time_ns;
    char *text = picture(watch);
    fputs(SCREEN_HOME, stdout);
    for (char *rest = text, *line; (line = strsep(&rest, "\n")) && rest;) {
        printf("%s" LINE_REST "\n", line);
    }
    fputs(SCREEN_REST, stdout);
    fflush(stdout);
}

static void hid_watch_add_report(struct watch *watch, struct hid_report report)
{
    const uint64_t time_ns = hid_watch_now_ns();
    if (!watch->on_terminal) {
        print_report(watch, report, time_ns);
    }
    hid_live_report(&watch->live, report, time_ns);
}

static enum exit_code hid_watch_loop(struct watch *watch, uint32_t seconds)
{
    enum exit_code code = EXIT_OK;
    const uint64_t end_ns = seconds ? watch->begin_ns + seconds * 1000000000ull : UINT64_MAX;
    for (;;) {
        struct hid_report report;
        const enum hid_pull pull = hid_source_pull(&watch->source, WAIT_MS, &report, &code);
        if (pull == HID_PULL_REPORT) {
            hid_watch_add_report(watch, report);
        }
        const uint64_t time_ns = hid_watch_now_ns();
        hid_live_time(&watch->live, time_ns);
        if (watch->on_terminal) {
            hid_watch_draw(watch, time_ns);
        }
        if (pull == HID_PULL_END || is_stopped || ferror(stdout) || time_ns >= end_ns) {
            return code;
        }
    }
}

/* Installs signal handlers that stop the view, so that the normal exit path restores the
 * terminal. */
static void hear_signals(void)
{
    const struct sigaction action = { .sa_handler = stop };
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
}

static enum exit_code watch_one(const struct hid_watch_options *options)
{
    static struct watch watch;
    hear_signals();
    const enum exit_code code =
        hid_source_open(&watch.source, options->path, &watch.descriptor, options->descriptor_path);
    if (code != EXIT_OK) {
        return code;
    }
    hid_file_id(options->descriptor_path ? options->descriptor_path : options->path, watch.id);
    hid_live_begin(&watch.live, &watch.descriptor, options->path);
    watch.on_terminal = isatty(STDOUT_FILENO) != 0;
    watch.begin_ns = hid_watch_now_ns();
    fputs(watch.on_terminal ? SCREEN_BEGIN : HID_VALUE_HEADER "\ttime_ms\n", stdout);
    const enum exit_code end = hid_watch_loop(&watch, options->seconds);
    if (watch.on_terminal) { /* The last view is printed once more on the normal screen, where the
                                view stays visible. */
        printf(SCREEN_END "%s", picture(&watch));
    }
    fflush(stdout);
    hid_source_close(&watch.source);
    return end;
}

enum exit_code hid_watch(const struct hid_watch_options *options)
{
    if (!options->path) {
        return options->descriptor_path || options->seconds
                   ? ctl_usage("hid", "watch: a DEVICE is missing; without options it lists them")
                   : list();
    }
    return watch_one(options);
}
