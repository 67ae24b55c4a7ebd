/* status.h -- writes the kiosk's state to a JSON file for monitoring tools.
 *
 * The frame loop makes a report once per second, and immediately when the store fails or recovers.
 * The frame loop copies the report and never blocks. A separate thread writes the file atomically,
 * by renaming a temporary file. If no folder is configured, there is no file and no thread. */
#pragma once

#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/hal.h"
#include "platform/kiosk/kiosk.h"

#define STATUS_FILE "status.json"
#define STATUS_PERIOD_NS 1000000000ull
/* Size of the file's text in bytes. The size is enough for all numbers and for all device texts,
 * even if each character is escaped (6 bytes). */
#define STATUS_TEXT_MAX 24576u
/* Number of devices: one display, the pois, the fans and six other devices. */
#define STATUS_DEVICES_MAX (7u + POI_MAX + SHADE_MAX)

/* One status report. A structure of zeros is the report of a kiosk that has just started. */
struct status_report {
    /* Time at which the report was made, in milliseconds since power-on, including sleep. A
     * monitoring tool detects an outdated file by this field. */
    uint64_t written_ms;
    uint32_t pid;
    uint32_t up_s;
    uint32_t boot; /* Number of program starts that the store counted. 0 means no store. */
    uint8_t phase; /* Phase of the game (enum scene_phase). */
    uint8_t players;
    struct balance balance;
    /* Tickets that were sent to the dispenser, as counted in the audits. */
    uint32_t tickets_out;
    /* Id of the newest ledger entry, and id of the newest entry on disk. */
    uint32_t entry_id, saved_id;
    bool store_well;
    bool has_picture; /* False while the kiosk has no display. */
    uint64_t frames, dropped_ticks;
    uint32_t ticks;
    uint64_t frame_median_ns, frame_p99_ns;
    struct kiosk_faults faults;
    /* Number of frames at whose start the kiosk had to restore the floating-point control register;
     * see struct kiosk. */
    uint32_t float_resets;
    uint32_t buttons_missing;
    /* Date and time in the units of struct input. A day of 0 means that the clock was never set. */
    uint16_t day, minute;
    uint32_t files_refused; /* Number of rejected files; see struct scene_devices. */
    struct scene_machine machine;
    uint32_t device_count;
    struct {
        /* Name of the device type, a static string: "display", "poi" and so on. */
        const char *part;
        char text[HAL_TEXT_SIZE];
    } device[STATUS_DEVICES_MAX];
};

/* Writes the report as JSON text with a terminating zero. Returns the length in bytes. The text
 * always fits. */
size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX]);

/* Name of the device type, a static string, and the describe() text of a device. */
struct status_device {
    const char *part, *text;
};

/* Writes the texts of all devices to `devices`. A text may be null or empty. The texts are valid
 * until the devices are used again. */
void status_devices(const struct hal *hal, struct status_device devices[STATUS_DEVICES_MAX]);

struct status {
    pthread_t thread;
    /* Protects `report`, `is_fresh` and `stop`. The frame loop uses trylock only. */
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    struct status_report report;
    bool is_fresh; /* True if `report` is not written to the file yet. */
    bool stop;
    /* Number of failed writes of the status file. Only the first failure is logged. */
    atomic_uint failed;

    bool runs;        /* True if the status file's thread exists. */
    uint64_t next_ns; /* Time of the next report. */
    /* Value of `store_well` in the last report that was passed to the status file's thread. */
    bool reported_well;
    struct status_report draft;
    char text[STATUS_TEXT_MAX];
    char path[PATH_MAX];
};

/* Starts the thread that writes `folder`/status.json. If `folder` is null or empty, or if no thread
 * can be created, there is no file and the other functions have no effect. */
void status_begin(struct status *status, const char *folder);

/* Makes a report if one second has passed after the previous report. Call once per frame. `now_ns`
 * is the time on the frame loop's clock. Never blocks: while the status file's thread holds the
 * lock, the report of the current second is skipped. A change of `store_well` is reported
 * immediately. */
void status_update(struct status *status, const struct kiosk *kiosk, const struct hal *hal,
                   uint64_t now_ns);

/* Stops the status file's thread and deletes the file, because a closed kiosk has no status. */
void status_end(struct status *status);
