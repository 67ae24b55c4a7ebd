/* hid_mapping_store.h -- the mapping store: learned controller mappings, one for each
 * vendor:product:serial.
 *
 * Each mapping is a file in the folder pois/ of the data folder. A thread of the store replaces
 * each file atomically, so a slow card never delays a frame. A mapping in memory is used at
 * once, and its file follows. A file that cannot be read causes one complaint and never prevents
 * the start. All functions except hid_mapping_store_open() and hid_mapping_store_close() return
 * without waiting for the card. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_STORE_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_STORE_H

#include <pthread.h>
#include <stdint.h>

#include "drivers/hid/hid_mapping_store_text.h"
#include "drivers/hid/poi_hid.h"

/* Capacity in controllers; four play at most. When the store is full, no more are learned. */
#define HID_MAPPING_STORE_MAX 64u
#define HID_MAPPING_STORE_PATH_SIZE 1024u

/* The file operation that is pending for the writer thread. */
struct hid_mapping_store_job {
    char path[HID_MAPPING_STORE_PATH_SIZE];
    char text[HID_MAPPING_STORE_TEXT_SIZE]; /* New content of the file; "" deletes the file. */
};

struct hid_mapping_store {
    char folder[HID_MAPPING_STORE_PATH_SIZE]; /* Path of pois/; "" keeps mappings in memory only. */
    uint32_t count;
    struct hid_mapping_store_entry entry[HID_MAPPING_STORE_MAX];

    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    /* has_job and stops are protected by `lock`, as are the fields below. */
    uint8_t has_thread, has_job, stops;
    struct hid_mapping_store_job job;
    uint8_t last_failed;                  /* 1 if the last finished job failed. */
    uint32_t written_count, failed_count; /* Jobs that succeeded and failed since the start. */
    void (*tell)(void *self, const char *line);
    void *tell_self;
};

/* Reads the folder pois/ of `data` and starts the writer thread. With `data` null nothing is
 * stored. Each complaint is passed to `complain` as one line "FILE:LINE: what"; `complain` may be
 * null. Returns the number of complaints. */
uint32_t hid_mapping_store_open(struct hid_mapping_store *store, const char *data,
                                void (*complain)(void *self, const char *line), void *self);

/* Returns the learned mapping of this vendor:product:serial, or null. */
const struct hid_mapping *hid_mapping_store_find(const struct hid_mapping_store *store,
                                                 const struct hid_identity *identity);

/* Stores or deletes the mapping of a controller. Returns HAL_ERR_BUSY while the previous job is
 * being written (retry in the next frame). Returns HAL_ERR_IO if the store is full, if the
 * mapping cannot be written as text, or if the writer thread did not start. */
int hid_mapping_store_put(struct hid_mapping_store *store, const struct hid_identity *identity,
                          const struct hid_mapping *map);
int hid_mapping_store_forget(struct hid_mapping_store *store, const struct hid_identity *identity);

/* Returns a mapper for the decoders. The mapper chooses the learned mapping if it fits the
 * descriptor, and otherwise the mapping of hid_mapping_choose(). */
struct hid_mapper hid_mapping_store_mapper(struct hid_mapping_store *store);

/* Sets the callback for write errors, one line each. The callback runs on the writer thread and
 * may be null. */
void hid_mapping_store_set_error_sink(struct hid_mapping_store *store,
                                      void (*tell)(void *self, const char *line), void *self);

/* Returns the result of the last keep() or forget(). HAL_ERR_BUSY means that the job is pending,
 * HAL_OK that the file is on the card. HAL_ERR_IO means that writing failed and the change lasts
 * only until the kiosk ends. */
int hid_mapping_store_result(struct hid_mapping_store *store);

/* Waits until the pending job is on the card, and ends the thread. */
void hid_mapping_store_close(struct hid_mapping_store *store);

#endif
