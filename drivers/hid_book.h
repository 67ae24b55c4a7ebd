/* hid_book.h -- what was learned of controllers, kept for each vendor:product:serial.
 *
 * A file each in the data folder's pois/, written whole or not at all, by a thread of its own: a
 * slow card stops no frame. What is in the book plays at once; that it is on the card follows. A
 * file that cannot be read is one line of complaint, and never the start. */
#ifndef KINGYO_DRIVERS_HID_BOOK_H
#define KINGYO_DRIVERS_HID_BOOK_H

#include <pthread.h>
#include <stdint.h>

#include "drivers/hid_book_text.h"
#include "drivers/poi_hid.h"

#define HID_BOOK_MAX 64u         /* Controllers; a stall has four. When full, no more is learned. */
#define HID_BOOK_PATH_SIZE 1024u

/* What the thread has to do. */
struct hid_book_job {
    char path[HID_BOOK_PATH_SIZE];
    char text[HID_BOOK_TEXT_SIZE]; /* "": the file is to go. */
};

struct hid_book {
    char folder[HID_BOOK_PATH_SIZE]; /* "": nothing is kept beyond this run. */
    uint32_t count;
    struct hid_book_entry entry[HID_BOOK_MAX];

    pthread_t thread;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    uint8_t has_thread, has_job, stops; /* The rest is under `lock`. */
    struct hid_book_job job;
    uint8_t last_failed;             /* The last job that was done; ... */
    uint32_t written_count, failed_count; /* ... and all of them. */
    void (*tell)(void *self, const char *line);
    void *tell_self;
};

/* Reads `data`/pois (null: nothing is kept) and starts the thread. Complaints go to `complain`, a
 * line each, "FILE:LINE: what"; null: to nobody. Returns how many there were. */
uint32_t hid_book_open(struct hid_book *book, const char *data,
                       void (*complain)(void *self, const char *line), void *self);

/* What was learned of such a controller, or null. */
const struct hid_map *hid_book_find(const struct hid_book *book,
                                    const struct hid_identity *identity);

/* Keeps or forgets it. HAL_ERR_BUSY: the last one is still being written, ask again next frame;
 * HAL_ERR_IO: the book is full, or nobody is there to write. */
int hid_book_keep(struct hid_book *book, const struct hid_identity *identity,
                  const struct hid_map *map);
int hid_book_forget(struct hid_book *book, const struct hid_identity *identity);

/* A map for whoever asks: the learned one if it fits the descriptor, else hid_map_choose()'s. */
struct hid_mapper hid_book_mapper(struct hid_book *book);

/* What cannot be written is told from now on, one line, on the book's thread. Null: to nobody. */
void hid_book_tell(struct hid_book *book, void (*tell)(void *self, const char *line), void *self);

/* What became of the last keep() or forget(): HAL_ERR_BUSY while it is being written, HAL_OK,
 * HAL_ERR_IO when it could not be: it holds for this run alone. */
int hid_book_written(struct hid_book *book);

/* Waits until all is on the card, and ends the thread. */
void hid_book_close(struct hid_book *book);

#endif
