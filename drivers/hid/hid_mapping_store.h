/* hid_mapping_store.h -- the mapping store: the learned mappings of controllers, one for each
 * vendor:product:serial.
 *
 * Each mapping is a file in the folder pois/ of the data folder. A writer thread replaces each file
 * atomically, so a slow memory card never delays a frame. A new mapping is used from memory
 * immediately, before its file is written. A file that cannot be read causes one error line and
 * never prevents the start of the program. All functions except hid_mapping_store_open() and
 * hid_mapping_store_close() return without waiting for the memory card. */
#pragma once

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "drivers/hid/hid_mapping.h"

/* Largest number of controllers with a stored mapping. At most four controllers play at a time. A
 * full store rejects new mappings. */
#define HID_MAPPING_STORE_MAX 64u
#define HID_MAPPING_STORE_PATH_SIZE 1024u

/* The file operation that is pending for the writer thread. */
struct hid_mapping_store_job {
    char path[HID_MAPPING_STORE_PATH_SIZE];
    /* New content of the file. "" means that the file is deleted. */
    char text[HID_MAPPING_STORE_TEXT_SIZE];
};

struct hid_mapping_store {
    /* Path of the folder pois/. "" means that mappings are kept in memory only. */
    char folder[HID_MAPPING_STORE_PATH_SIZE];
    uint32_t count;
    struct hid_mapping_store_entry entry[HID_MAPPING_STORE_MAX];

    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t changed; /* Signals a change of has_job or stops. */
    /* `lock` protects has_job, stops and all following fields. */
    bool has_thread; /* True while the writer thread exists. */
    bool has_job;    /* True while `job` is pending. */
    bool stops;      /* True if the writer thread must end. */
    struct hid_mapping_store_job job;
    bool last_failed; /* True if the last finished file operation failed. */
    /* Number of file operations that succeeded since hid_mapping_store_open(). */
    uint32_t written_count;
    /* Number of file operations that failed since hid_mapping_store_open(). */
    uint32_t failed_count;
    void (*report)(void *self, const char *line);
    void *report_self;
};

/* Reads the mappings in the folder pois/ of the data folder `data` and starts the writer thread. If
 * `data` is null the mappings are kept in memory only. Each error is passed to `log_error` as one
 * line "FILE:LINE: what"; `log_error` may be null. Returns the number of errors. */
uint32_t hid_mapping_store_open(struct hid_mapping_store *store, const char *data,
                                void (*log_error)(void *self, const char *line), void *self);

/* Returns the learned mapping for the vendor, product and serial number of `identity`, or null if
 * there is none. */
const struct hid_mapping *hid_mapping_store_find(const struct hid_mapping_store *store,
                                                 const struct hid_identity *identity);

/* Stores the mapping of a controller. Returns HAL_OK, or HAL_ERR_BUSY while the previous job is
 * being written. After HAL_ERR_BUSY the caller retries in a later frame. Returns HAL_ERR_IO if
 * the store is full, if the mapping cannot be written as text, or if the writer thread did not
 * start. */
int hid_mapping_store_put(struct hid_mapping_store *store, const struct hid_identity *identity,
                          const struct hid_mapping *map);
/* Deletes the mapping of a controller. Returns HAL_OK, also if there is no such mapping. Returns
 * HAL_ERR_BUSY while the previous job is being written, or HAL_ERR_IO if the writer thread did not
 * start. */
int hid_mapping_store_forget(struct hid_mapping_store *store, const struct hid_identity *identity);

/* Returns a mapper for the decoders. The mapper returns the learned mapping if it is valid for the
 * descriptor, otherwise the mapping of hid_mapping_choose(). */
struct hid_mapper hid_mapping_store_mapper(struct hid_mapping_store *store);

/* Sets the callback for write errors, which receives one line for each error. The callback runs on
 * the writer thread and may be null. */
void hid_mapping_store_set_error_sink(struct hid_mapping_store *store,
                                      void (*report)(void *self, const char *line), void *self);

/* Returns the result of the last hid_mapping_store_put() or hid_mapping_store_forget().
 * HAL_ERR_BUSY means that the job is pending. HAL_OK means that the change is on the memory card.
 * HAL_ERR_IO means that writing failed, so the change is lost when the program ends. */
int hid_mapping_store_result(struct hid_mapping_store *store);

/* Waits until the pending job is finished, and ends the writer thread. */
void hid_mapping_store_close(struct hid_mapping_store *store);

/* Reads a whole file into `text` and appends a terminating 0. Returns 0, or an errno value on an
 * error. Returns EFBIG if the file has HID_MAPPING_STORE_TEXT_SIZE bytes or more. Does not block if
 * `path` is a pipe, but may block on the memory card. Therefore only the program start calls this
 * function. */
int hid_mapping_store_file_read(const char *path, char text[HID_MAPPING_STORE_TEXT_SIZE]);
