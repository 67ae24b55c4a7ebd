/* status.h -- how the stall is, as one JSON file for whoever watches over it.
 *
 * The frame loop gives a report once a second, and at once when the store fails or is well again.
 * The frame loop never waits: it is copied, and a thread of its
 * own writes the file, whole or not at all (a part beside it is renamed). Where nobody names a
 * folder for it there is no file and no thread. */
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
/* Every device's line with each character escaped (6 bytes), and the figures. */
#define STATUS_TEXT_MAX 24576u
#define STATUS_DEVICES_MAX (10u + POI_MAX + SHADE_MAX)

/* What is told. Zero is a stall that just began. */
struct status_report {
    uint64_t written_ms;   /* On the clock since power on, sleep included: whether it is fresh. */
    uint32_t pid;
    uint32_t up_s;
    uint32_t boot;         /* Starts so far, as the store counts; 0: there is none. */
    uint8_t phase;         /* enum scene_phase */
    uint8_t players;
    struct purse purse;
    uint32_t tickets_out;  /* Tickets passed to the dispenser, as the audits count them. */
    uint32_t entry_id, saved_id; /* Newest entry of the ledger, newest on disk. */
    uint8_t store_well;
    uint64_t frames, dropped_ticks;
    uint32_t ticks;
    uint64_t frame_median_ns, frame_p99_ns;
    struct kiosk_faults faults;
    uint32_t float_resets; /* As struct kiosk's. */
    uint32_t buttons_missing;
    uint16_t day, minute;  /* What the clock says, as struct input's; day 0: it was never set. */
    uint32_t files_refused; /* As struct scene_devices has it. */
    struct scene_machine machine;
    uint32_t device_count;
    struct {
        const char *part;  /* "display", "poi", ...; static. */
        char text[HAL_TEXT_SIZE];
    } device[STATUS_DEVICES_MAX];
};

/* The file's text, a zero behind it; its length. It always fits. */
size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX]);

/* What there is to say of a kiosk now, but for written_ms and pid. */
void status_take(struct status_report *report, const struct kiosk *kiosk, const struct hal *hal);

struct status {
    pthread_t thread;
    pthread_mutex_t mutex; /* Of what stands below; the frame loop only tries it. */
    pthread_cond_t changed;
    struct status_report report;
    uint8_t is_fresh;      /* `report` waits to be written. */
    uint8_t stop;
    atomic_uint failed;    /* Writes that failed; the first one is told. */

    uint8_t runs;
    uint64_t next_ns;      /* When the frame loop reports again. */
    uint8_t told_well;     /* `store_well` of the last report that the thread was given. */
    struct status_report draft;
    char text[STATUS_TEXT_MAX];
    char path[PATH_MAX], part[PATH_MAX];
};

/* Begins to keep `folder`/status.json; a null or empty folder, or a thread that the machine does
 * not give: there is no file, and what follows does nothing. */
void status_begin(struct status *status, const char *folder);

/* Called once a frame; `now_ns` is on the frame loop's own clock. Never waits: while the thread
 * writes, this second's report is left out. A change of `store_well` is reported at once. */
void status_tell(struct status *status, const struct kiosk *kiosk, const struct hal *hal,
                 uint64_t now_ns);

/* Ends the thread and takes the file away: a stall that is closed says nothing. */
void status_end(struct status *status);

#endif
