/* status.c -- collects the status report and writes it on a separate thread; see status.h. */
#include "platform/kiosk/status.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "platform/os/file.h"
#include "platform/os/log.h"

#define NS_PER_MS 1000000ull

/* ---- Making the report --------------------------------------------------------------------- */

static void take_device(struct status_report *report, const char *part, const char *text)
{
    assert(report->device_count < STATUS_DEVICES_MAX);
    if (text && text[0]) {
        report->device[report->device_count].part = part;
        snprintf(report->device[report->device_count++].text, HAL_TEXT_SIZE, "%s", text);
    }
}

static void take_devices(struct status_report *report, const struct hal *hal)
{
    report->device_count = 0;
    take_device(report, "display", hal->display.ops->describe(hal->display.self));
    for (uint32_t i = 0; i < POI_MAX; i++) {
        take_device(report, "poi", hal->poi[i].ops->describe(hal->poi[i].self));
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        take_device(report, "fan", hal->fan[i].ops->describe(hal->fan[i].self));
    }
    take_device(report, "buttons", hal->buttons.ops->describe(hal->buttons.self));
    take_device(report, "switches", hal->switches.ops->describe(hal->switches.self));
    take_device(report, "usb", hal->controllers.ops->describe(hal->controllers.self));
    take_device(report, "sound", hal->audio.ops->describe(hal->audio.self));
    take_device(report, "store", hal->storage.ledger.ops->describe(hal->storage.ledger.self));
    take_device(report, "watchdog", hal->watchdog.ops->describe(hal->watchdog.self));
}

void status_take(struct status_report *report, const struct kiosk *kiosk, const struct hal *hal)
{
    const struct core *core = &kiosk->core;
    report->up_s = kiosk->output.tick / CORE_TICK_HZ;
    report->boot = core->config.persistent.ledger.boots;
    report->phase = kiosk->output.phase;
    report->players = core->config.players;
    report->balance = core->game.accounts.ledger.balance;
    report->tickets_out = core->game.accounts.audits.count[AUDIT_TICKETS_OUT];
    report->entry_id = kiosk->output.entry_id;
    report->saved_id = kiosk->input.record_saved_id;
    report->store_well = kiosk->input.store_well;
    report->frames = kiosk->frames;
    report->dropped_ticks = kiosk->pace.dropped;
    report->ticks = kiosk->output.tick;
    report->frame_median_ns = timing_quantile_ns(&kiosk->frame_time, 0.5);
    report->frame_p99_ns = timing_quantile_ns(&kiosk->frame_time, 0.99);
    report->faults = kiosk->faults;
    report->float_resets = kiosk->float_resets;
    report->buttons_missing = kiosk->lines.missing;
    report->day = kiosk->input.day;
    report->minute = kiosk->input.minute;
    report->files_refused = kiosk->config.notes ? kiosk->config.notes->refused_count : 0u;
    report->machine = kiosk->machine;
    take_devices(report, hal);
}

/* ---- Writing the file ---------------------------------------------------------------------- */

static uint64_t since_power_on_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_BOOTTIME, &now);
    return (uint64_t)now.tv_sec * 1000u + (uint64_t)now.tv_nsec / NS_PER_MS;
}

static void write_report(struct status *status, struct status_report *report)
{
    report->written_ms = since_power_on_ms();
    report->pid = (uint32_t)getpid();
    /* The file is in a memory file system and needs no sync. */
    const int error = file_replace(status->path, status->text, status_format(report, status->text),
                                   FILE_REPLACE_PUBLIC);
    if (error && atomic_fetch_add(&status->failed, 1) == 0) {
        log_print(LOG_LEVEL_ERROR, "%s: cannot write: %s", status->path, strerror(-error));
    }
}

static void *status_thread(void *self)
{
    struct status *status = self;
    struct status_report report; /* Copy for the status file's thread, because the frame loop
                                    overwrites status->report. */
    pthread_setname_np(pthread_self(), "status");
    pthread_mutex_lock(&status->mutex);
    while (!status->stop) {
        if (!status->is_fresh) {
            pthread_cond_wait(&status->changed, &status->mutex);
            continue;
        }
        report = status->report;
        status->is_fresh = 0;
        pthread_mutex_unlock(&status->mutex);
        write_report(status, &report);
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
    status->runs = pthread_create(&status->thread, NULL, status_thread, status) == 0;
}

void status_update(struct status *status, const struct kiosk *kiosk, const struct hal *hal,
                   uint64_t now_ns)
{
    const int has_changed = kiosk->input.store_well != status->told_well;
    if (!status->runs || (now_ns < status->next_ns && !has_changed)) {
        return;
    }
    status->next_ns = now_ns + STATUS_PERIOD_NS;
    status_take(&status->draft, kiosk, hal);
    if (pthread_mutex_trylock(&status->mutex) == 0) {
        status->report = status->draft;
        status->is_fresh = 1;
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
    status->stop = 1;
    pthread_cond_signal(&status->changed);
    pthread_mutex_unlock(&status->mutex);
    pthread_join(status->thread, NULL);
    pthread_mutex_destroy(&status->mutex);
    pthread_cond_destroy(&status->changed);
    unlink(status->path);
    status->runs = 0;
}
