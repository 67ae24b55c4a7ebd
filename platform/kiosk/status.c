/* status.c -- collects the status report, formats it as JSON and writes it on a separate thread;
 * see status.h. */
#include "platform/kiosk/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/os/json.h"
#include "platform/os/log.h"
#include "platform/os/thread.h"
#include "platform/panics.h"

/* ---- Making the report --------------------------------------------------------------------- */

void status_devices(const struct hal *hal, struct status_device devices[STATUS_DEVICES_MAX])
{
    CORE_ASSERT(hal->display.ops && hal->storage.ledger.ops);
    const struct status_device last[] = {
        { "buttons", hal->buttons.ops->describe(hal->buttons.self) },
        { "switches", hal->switches.ops->describe(hal->switches.self) },
        { "usb", hal->controllers.ops->describe(hal->controllers.self) },
        { "sound", hal->audio.ops->describe(hal->audio.self) },
        { "store", hal->storage.ledger.ops->describe(hal->storage.ledger.self) },
        { "watchdog", hal->watchdog.ops->describe(hal->watchdog.self) },
    };
    struct status_device *next = devices;
    *next++ = (struct status_device){ "display", hal->display.ops->describe(hal->display.self) };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        *next++ = (struct status_device){ "poi", hal->poi[i].ops->describe(hal->poi[i].self) };
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        *next++ = (struct status_device){ "fan", hal->fan[i].ops->describe(hal->fan[i].self) };
    }
    _Static_assert(sizeof last / sizeof last[0] == STATUS_DEVICES_MAX - 1u - POI_MAX - SHADE_MAX,
                   "the list has the display, the pois, the fans and the devices of `last`");
    memcpy(next, last, sizeof last);
}

/* Fills the report with the state of a kiosk, except written_ms and pid. */
static void take_report(struct status_report *report, const struct kiosk *kiosk,
                        const struct hal *hal)
{
    const struct core *core = &kiosk->core;
    *report = (struct status_report){
        .up_s = kiosk->output.tick / CORE_TICK_HZ,
        .boot = core->config.persistent.ledger.boots,
        .phase = kiosk->output.phase,
        .players = core->config.players,
        .balance = core_status(core).balance,
        .tickets_out = core_audits(core)->count[AUDIT_TICKETS_OUT],
        .entry_id = kiosk->output.entry_id,
        .saved_id = kiosk->input.record_saved_id,
        .store_well = kiosk->input.store_well,
        .has_picture = kiosk->display_retry_ns == 0,
        .frames = kiosk->frames,
        .dropped_ticks = kiosk->pace.dropped,
        .ticks = kiosk->output.tick,
        .frame_median_ns = frame_timing_quantile_ns(&kiosk->frame_time, 0.5),
        .frame_p99_ns = frame_timing_quantile_ns(&kiosk->frame_time, 0.99),
        .faults = kiosk->faults,
        .float_resets = kiosk->float_resets,
        .buttons_missing = kiosk->lines.missing,
        .day = kiosk->input.day,
        .minute = kiosk->input.minute,
        .files_refused = kiosk->config.notes ? kiosk->config.notes->refused_count : 0u,
        .machine = kiosk->machine,
    };
    struct status_device devices[STATUS_DEVICES_MAX];
    status_devices(hal, devices);
    for (uint32_t i = 0; i < STATUS_DEVICES_MAX; i++) {
        if (devices[i].text && devices[i].text[0]) {
            report->device[report->device_count].part = devices[i].part;
            snprintf(report->device[report->device_count++].text, HAL_TEXT_SIZE, "%s",
                     devices[i].text);
        }
    }
}

/* ---- Writing the file ---------------------------------------------------------------------- */

static void *status_thread(void *self)
{
    struct status *status = self;
    struct status_report report; /* Copy of the report for the status file's thread, because the
                                    frame loop overwrites status->report. */
    pthread_setname_np(pthread_self(), "status");
    pthread_mutex_lock(&status->mutex);
    while (!status->stop) {
        if (!status->is_fresh) {
            pthread_cond_wait(&status->changed, &status->mutex);
            continue;
        }
        report = status->report;
        status->is_fresh = false;
        pthread_mutex_unlock(&status->mutex);
        report.written_ms = clock_ns(CLOCK_BOOTTIME) / NS_PER_MS;
        report.pid = (uint32_t)getpid();
        /* The file is in a memory file system and needs no sync. */
        const int error = file_replace(status->path, status->text,
                                       status_format(&report, status->text), FILE_REPLACE_PUBLIC);
        if (error && atomic_fetch_add(&status->failed, 1) == 0) {
            log_print(LOG_LEVEL_ERROR, "%s: cannot write: %s", status->path, strerror(-error));
        }
        pthread_mutex_lock(&status->mutex);
    }
    pthread_mutex_unlock(&status->mutex);
    return NULL;
}

/* ---- Functions for the frame loop ---------------------------------------------------------- */

void status_begin(struct status *status, const char *folder)
{
    memset(status, 0, sizeof *status);
    if (!folder || folder[0] != '/' || strlen(folder) + sizeof STATUS_FILE + 8u > PATH_MAX) {
        return;
    }
    snprintf(status->path, sizeof status->path, "%.*s/" STATUS_FILE, PATH_MAX - 32, folder);
    pthread_mutex_init(&status->mutex, NULL);
    pthread_cond_init(&status->changed, NULL);
    status->runs = thread_start(&status->thread, status_thread, status) == 0;
}

void status_update(struct status *status, const struct kiosk *kiosk, const struct hal *hal,
                   uint64_t now_ns)
{
    CORE_ASSERT(!status->runs || status->path[0]);
    const bool has_changed = kiosk->input.store_well != status->reported_well;
    if (!status->runs || (now_ns < status->next_ns && !has_changed)) {
        return;
    }
    status->next_ns = now_ns + STATUS_PERIOD_NS;
    take_report(&status->draft, kiosk, hal);
    if (pthread_mutex_trylock(&status->mutex) == 0) {
        status->report = status->draft;
        status->is_fresh = true;
        status->reported_well = status->draft.store_well;
        pthread_cond_signal(&status->changed);
        pthread_mutex_unlock(&status->mutex);
    }
}

void status_end(struct status *status)
{
    if (!status->runs) {
        return;
    }
    pthread_mutex_lock(&status->mutex);
    status->stop = true;
    pthread_cond_signal(&status->changed);
    pthread_mutex_unlock(&status->mutex);
    pthread_join(status->thread, NULL);
    pthread_mutex_destroy(&status->mutex);
    pthread_cond_destroy(&status->changed);
    unlink(status->path);
    status->runs = false;
}

/* ---- JSON text ----------------------------------------------------------------------------- */

static const char *const phase_names[] = {
    [PHASE_ATTRACT] = "attract",   [PHASE_READY] = "ready",        [PHASE_ROUND] = "round",
    [PHASE_RESULT] = "result",     [PHASE_MODE_SELECT] = "choose", [PHASE_LAB] = "lab",
    [PHASE_ALBUM] = "album",       [PHASE_MENU] = "menu",          [PHASE_NAME] = "name",
    [PHASE_LEADERBOARD] = "board",
};
static const char *const keeps_names[] = {
    [KEEPS_UNKNOWN] = "unknown", [KEEPS_PROVEN] = "proven", [KEEPS_FOLDER] = "folder",
    [KEEPS_MEMORY] = "memory",   [KEEPS_NOT] = "not",       [KEEPS_NOWHERE] = "nowhere",
};
static const char *const watch_names[] = {
    [WATCH_NONE] = "none", [WATCH_NO_LIMIT] = "no-limit", [WATCH_OK] = "fed", [WATCH_FAIL] = "deaf"
};

#define NAME_OF(names, value, other) name_of(names, sizeof(names) / sizeof(names)[0], value, other)

/* Returns the name of `value` in the table `names`, or `other` if the table has no name for the
 * value. */
static const char *name_of(const char *const *names, size_t count, uint8_t value, const char *other)
{
    return value < count && names[value] ? names[value] : other;
}

static void put_stall(struct json *json, const struct status_report *report)
{
    const struct balance *balance = &report->balance;
    json_print(json,
               "{\n  version: %s,\n  pid: %u,\n  written_ms: %llu,\n  up_s: %u,\n  boot: %u,"
               "\n  phase: %s,\n  players: %u,",
               KINGYO_VERSION, report->pid, (unsigned long long)report->written_ms, report->up_s,
               report->boot, NAME_OF(phase_names, report->phase, "other"), report->players);
    json_print(json,
               "\n  credits: {paid: %u, service: %u, units: %u, untold: %u, round_open: %hhd},"
               "\n  tickets: {owed: %u, dispensed: %u},"
               "\n  store: {well: %hhd, entry_id: %u, saved_id: %u, waiting: %u},",
               balance->paid, balance->service, balance->units, balance->unlogged,
               (bool)(balance->open != PAYMENT_NONE), balance->tickets, report->tickets_out,
               report->store_well, report->entry_id, report->saved_id,
               report->entry_id - report->saved_id);
}

static void put_figures(struct json *json, const struct status_report *report)
{
    const struct kiosk_faults *faults = &report->faults;
    json_print(json,
               "\n  frames: {count: %llu, median_ms: %.1f, p99_ms: %.1f, shown: %hhd},"
               "\n  ticks: {count: %u, dropped: %llu},",
               (unsigned long long)report->frames, (double)report->frame_median_ns * 1e-6,
               (double)report->frame_p99_ns * 1e-6, report->has_picture, report->ticks,
               (unsigned long long)report->dropped_ticks);
    json_print(json,
               "\n  faults: {poi: %u, fan: %u, display: %u, sound: %u, store: %u, buttons: %u,"
               " switches: %u, buttons_missing: %d, float: %u},",
               faults->poi, faults->shade, faults->display, faults->audio, faults->storage,
               faults->buttons, faults->switches, __builtin_popcount(report->buttons_missing),
               report->float_resets);
}

/* Writes the values that the operator's menu shows on the page "ready for opening". Unknown numbers
 * are written as null. */
static void put_machine(struct json *json, const struct status_report *report)
{
    const struct scene_machine *machine = &report->machine;
    json_print(json,
               "\n  machine: {data: %s, backup_min: %.0f, free_mib: %.0f, heat_margin_c: %.0f,"
               " watchdog: %s, clock_day: %.0f, clock_minute: %.0f, clock_went_back: %hhd},",
               NAME_OF(keeps_names, machine->keeps, "unknown"),
               machine->has_backup ? (double)machine->backup_min : (double)NAN,
               machine->is_checked ? (double)machine->room_mib : (double)NAN,
               machine->has_heat ? (double)machine->heat_margin_c : (double)NAN,
               NAME_OF(watch_names, machine->watch, "none"),
               report->day != 0 ? (double)report->day : (double)NAN,
               report->day != 0 ? (double)report->minute : (double)NAN, machine->is_clock_back);
    json_print(json,
               "\n  files: {refused: %u, set_aside: %u, replays_missed: %u},"
               "\n  panics: {count: %u, left_out: %s},",
               report->files_refused, machine->quarantined, machine->missed, machine->panics,
               panics_left_name(machine->left_out));
}

size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX])
{
    struct json json = { .buffer = out, .size = STATUS_TEXT_MAX };
    put_stall(&json, report);
    put_figures(&json, report);
    put_machine(&json, report);
    json_print(&json, "\n  devices: [");
    for (uint32_t i = 0; i < report->device_count; i++) {
        json_print(&json, "\n    {part: %s, text: %s}", report->device[i].part,
                   report->device[i].text);
    }
    json_print(&json, "\n  ]\n}");
    json_end(&json);
    return json.used;
}
