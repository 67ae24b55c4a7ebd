/* status.c -- collects the status report, formats it as JSON and writes it on a separate thread;
 * see status.h. */
#include "platform/kiosk/status.h"

#include <stdarg.h>
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
    const bool has_changed = kiosk->input.store_well != status->told_well;
    if (!status->runs || (now_ns < status->next_ns && !has_changed)) {
        return;
    }
    status->next_ns = now_ns + STATUS_PERIOD_NS;
    take_report(&status->draft, kiosk, hal);
    if (pthread_mutex_trylock(&status->mutex) == 0) {
        status->report = status->draft;
        status->is_fresh = true;
        status->told_well = status->draft.store_well;
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
    [WATCH_NONE] = "none", [WATCH_NO_LIMIT] = "no-limit", [WATCH_FED] = "fed", [WATCH_DEAF] = "deaf"
};

#define NAME_OF(names, value, other) name_of(names, sizeof(names) / sizeof(names)[0], value, other)

/* Returns the name of `value`, or `other` if the table has no name for the value. */
static const char *name_of(const char *const *names, size_t count, uint8_t value, const char *other)
{
    return value < count && names[value] ? names[value] : other;
}

/* Begins a new line for the next member of the report. Returns `json`. */
static struct json *member(struct json *json)
{
    json_line(json, 2);
    return json;
}

static void put_stall(struct json *json, const struct status_report *report)
{
    const struct balance *balance = &report->balance;
    json_text(member(json), "version", KINGYO_VERSION);
    json_value(member(json), "pid", "%u", report->pid);
    json_value(member(json), "written_ms", "%llu", (unsigned long long)report->written_ms);
    json_value(member(json), "up_s", "%u", report->up_s);
    json_value(member(json), "boot", "%u", report->boot);
    json_text(member(json), "phase", NAME_OF(phase_names, report->phase, "other"));
    json_value(member(json), "players", "%u", report->players);
    json_open(member(json), "credits", '{');
    json_value(json, "paid", "%u", balance->paid);
    json_value(json, "service", "%u", balance->service);
    json_value(json, "units", "%u", balance->units);
    json_value(json, "untold", "%u", balance->unlogged);
    json_bool(json, "round_open", balance->open != PAYMENT_NONE);
    json_close(json, '}');
    json_open(member(json), "tickets", '{');
    json_value(json, "owed", "%u", balance->tickets);
    json_value(json, "dispensed", "%u", report->tickets_out);
    json_close(json, '}');
    json_open(member(json), "store", '{');
    json_bool(json, "well", report->store_well);
    json_value(json, "entry_id", "%u", report->entry_id);
    json_value(json, "saved_id", "%u", report->saved_id);
    json_value(json, "waiting", "%u", report->entry_id - report->saved_id);
    json_close(json, '}');
}

static void put_figures(struct json *json, const struct status_report *report)
{
    const struct kiosk_faults *faults = &report->faults;
    json_open(member(json), "frames", '{');
    json_value(json, "count", "%llu", (unsigned long long)report->frames);
    json_value(json, "median_ms", "%.1f", (double)report->frame_median_ns * 1e-6);
    json_value(json, "p99_ms", "%.1f", (double)report->frame_p99_ns * 1e-6);
    json_close(json, '}');
    json_open(member(json), "ticks", '{');
    json_value(json, "count", "%u", report->ticks);
    json_value(json, "dropped", "%llu", (unsigned long long)report->dropped_ticks);
    json_close(json, '}');
    json_open(member(json), "faults", '{');
    json_value(json, "poi", "%u", faults->poi);
    json_value(json, "fan", "%u", faults->shade);
    json_value(json, "display", "%u", faults->display);
    json_value(json, "sound", "%u", faults->audio);
    json_value(json, "store", "%u", faults->storage);
    json_value(json, "buttons", "%u", faults->buttons);
    json_value(json, "switches", "%u", faults->switches);
    json_value(json, "buttons_missing", "%d", __builtin_popcount(report->buttons_missing));
    json_value(json, "float", "%u", report->float_resets);
    json_close(json, '}');
}

/* Writes the JSON member `name` with a number, or with null if the number is not known. */
static void put_known(struct json *json, const char *name, bool is_known, int64_t value)
{
    if (is_known) {
        json_value(json, name, "%lld", (long long)value);
    } else {
        json_value(json, name, "null");
    }
}

/* Writes the values that the operator's menu shows on the page "ready for opening". */
static void put_machine(struct json *json, const struct status_report *report)
{
    const struct scene_machine *machine = &report->machine;
    json_open(member(json), "machine", '{');
    json_text(json, "data", NAME_OF(keeps_names, machine->keeps, "unknown"));
    put_known(json, "backup_min", machine->has_backup, machine->backup_min);
    put_known(json, "free_mib", machine->has_looked, machine->room_mib);
    put_known(json, "heat_margin_c", machine->has_heat, machine->heat_margin_c);
    json_text(json, "watchdog", NAME_OF(watch_names, machine->watch, "none"));
    put_known(json, "clock_day", report->day != 0, report->day);
    put_known(json, "clock_minute", report->day != 0, report->minute);
    json_bool(json, "clock_went_back", machine->is_clock_back);
    json_close(json, '}');
    json_open(member(json), "files", '{');
    json_value(json, "refused", "%u", report->files_refused);
    json_value(json, "set_aside", "%u", machine->aside);
    json_value(json, "replays_missed", "%u", machine->missed);
    json_close(json, '}');
    json_open(member(json), "panics", '{');
    json_value(json, "count", "%u", machine->panics);
    json_text(json, "left_out", panics_left_name(machine->left_out));
    json_close(json, '}');
}

size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX])
{
    struct json json = { .buffer = out, .size = STATUS_TEXT_MAX };
    json_open(&json, NULL, '{');
    put_stall(&json, report);
    put_figures(&json, report);
    put_machine(&json, report);
    json_open(member(&json), "devices", '[');
    for (uint32_t i = 0; i < report->device_count; i++) {
        json_line(&json, 4);
        json_open(&json, NULL, '{');
        json_text(&json, "part", report->device[i].part);
        json_text(&json, "text", report->device[i].text);
        json_close(&json, '}');
    }
    json_close(member(&json), ']');
    json_line(&json, 0);
    json_close(&json, '}');
    json_end(&json);
    return json.used;
}
