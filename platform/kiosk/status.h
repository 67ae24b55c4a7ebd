/* status.h -- writes the kiosk's state to a JSON file for monitoring tools.
 *
 * The frame loop makes a report once a second, and at once when the store fails or recovers. The
 * report is copied, so that the frame loop never blocks. A separate thread writes the file
 * atomically, by renaming a temporary file. Without a configured folder there is neither a file nor
 * a thread. */
#ifndef KINGYO_PLATFORM_KIOSK_STATUS_H
#define KINGYO_PLATFORM_KIOSK_STATUS_H

#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/hal.h"
#include "platform/kiosk/kiosk.h"

#define STATUS_FILE "status.json"
#define STATUS_PERIOD_NS 1000000000ull
/* Enough for every device's text with each character escaped (6 bytes), and the numbers. */
#define STATUS_TEXT_MAX 24576u
#define STATUS_DEVICES_MAX (10u + POI_MAX + SHADE_MAX)

/* One report. Zero is a kiosk that has just started. */
struct status_report {
    uint64_t written_ms; /* Time since power-on in ms, including sleep, to detect an outdated
                            file. */
    uint32_t pid;
    uint32_t up_s;
    uint32_t boot; /* Starts counted by the store; 0: no store. */
    uint8_t phase; /* enum scene_phase */
    uint8_t players;
    struct balance balance;
    uint32_t tickets_out;        /* Tickets passed to the dispenser, as counted in the audits. */
    uint32_t entry_id, saved_id; /* Newest entry of the ledger, and newest entry on disk. */
    uint8_t store_well;
    uint64_t frames, dropped_ticks;
    uint32_t ticks;
    uint64_t frame_median_ns, frame_p99_ns;
    struct kiosk_faults faults;
    uint32_t float_resets; /* As in struct kiosk. */
    uint32_t buttons_missing;
    uint16_t day, minute;   /* Date and time as in struct input; day 0: the clock was never set. */
    uint32_t files_refused; /* As in struct scene_devices. */
    struct scene_machine machine;
    uint32_t device_count;
    struct {
        const char *part; /* "display", "poi", ...; static. */
        char text[HAL_TEXT_SIZE];
    } device[STATUS_DEVICES_MAX];
};

/* Writes the file's text with a terminating zero. Returns its length, which always fits. */
size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX]);

/* Fills the report from a kiosk, except written_ms and pid. */
void status_take(struct status_report *report, const struct kiosk *kiosk, const struct hal *hal);

struct status {
    pthread_t thread;
    pthread_mutex_t mutex; /* Protects the fields below it; the frame loop only tries to lock it. */
    pthread_cond_t changed;
    struct status_report report;
    uint8_t is_fresh; /* 1: `report` is not written yet. */
    uint8_t stop;
    atomic_uint failed; /* Writes that failed; the first one is reported. */

    uint8_t runs;
    uint64_t next_ns;  /* Time of the next report. */
    uint8_t told_well; /* `store_well` in the last report that the thread got. */
    struct status_report draft;
    char text[STATUS_TEXT_MAX];
    char path[PATH_MAX], part[PATH_MAX];
};

/* Starts to maintain `folder`/status.json. With a null or empty folder, or if no thread can be
 * created, there is no file and the other functions have no effect. */
void status_begin(struct status *status, const char *folder);

/* Makes a report if one is due. Call once a frame; `now_ns` is on the frame loop's clock. Never
 * blocks: while the thread holds the lock, this second's report is skipped. A change of
 * `store_well` is reported at once. */
void status_update(struct status *status, const struct kiosk *kiosk, const struct hal *hal,
                   uint64_t now_ns);

/* Stops the thread and deletes the file, because a closed kiosk has no status. */
void status_end(struct status *status);

#endif
