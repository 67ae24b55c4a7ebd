/* hid_book.c -- the mapping store in memory, and the thread that writes its files. */
#include "drivers/hid_book.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "drivers/hid_book_file.h"
#include "drivers/hid_book_text.h"

#define FOLDER "pois"
#define SUFFIX ".poi"

struct complaints {
    void (*complain)(void *self, const char *line);
    void *self;
    uint32_t count;
};

static void complain(struct complaints *to, const char *path, int line, const char *what)
{
    char text[HID_BOOK_PATH_SIZE + 256u + HAL_TEXT_SIZE + 32u], number[16] = "";
    if (line > 0) {
        snprintf(number, sizeof number, ":%d", line);
    }
    snprintf(text, sizeof text, "%s%s: %s", path, number, what);
    to->count++;
    if (to->complain) {
        to->complain(to->self, text);
    }
}

/* ---- Reading the files ---------------------------------------------------------------------- */

static struct hid_book_entry *entry_of(struct hid_book *book, uint16_t vendor, uint16_t product,
                                       const char *serial)
{
    for (uint32_t i = 0; i < book->count; i++) {
        struct hid_book_entry *entry = &book->entry[i];
        if (entry->vendor == vendor && entry->product == product &&
            strcmp(entry->serial, serial) == 0) {
            return entry;
        }
    }
    return NULL;
}

static void read_entry(struct hid_book *book, const char *path, struct complaints *to)
{
    char text[HID_BOOK_TEXT_SIZE], why[HAL_TEXT_SIZE];
    struct hid_book_entry entry;
    const int error = hid_book_file_read(path, text);
    const int bad_line = error ? 0 : hid_book_read(&entry, text, why);
    if (error || bad_line) {
        complain(to, path, bad_line, error ? strerror(error) : why);
        return;
    }
    struct hid_book_entry *known = entry_of(book, entry.vendor, entry.product, entry.serial);
    if (known) {
        *known = entry;
    } else if (book->count < HID_BOOK_MAX) {
        book->entry[book->count++] = entry;
    } else {
        complain(to, path, 0, "more learned controllers than the book holds");
    }
}

static int is_ours(const char *name)
{
    const size_t length = strlen(name), suffix = sizeof SUFFIX - 1u;
    return length > suffix && strcmp(name + length - suffix, SUFFIX) == 0;
}

static void read_folder(struct hid_book *book, struct complaints *to)
{
    char path[HID_BOOK_PATH_SIZE + 256u];
    DIR *folder = opendir(book->folder);
    const struct dirent *file;
    if (!folder) {
        if (errno != ENOENT) {
            complain(to, book->folder, 0, strerror(errno));
        }
        return;
    }
    while ((file = readdir(folder)) != NULL) {
        if (is_ours(file->d_name)) {
            snprintf(path, sizeof path, "%s/%s", book->folder, file->d_name);
            read_entry(book, path, to);
        }
    }
    closedir(folder);
}

/* ---- Writer thread -------------------------------------------------------------------------- */

static int do_job(const char *folder, const struct hid_book_job *job)
{
    int error = 0;
    if (mkdir(folder, 0755) != 0 && errno != EEXIST) {
        return errno;
    }
    if (job->text[0]) {
        error = hid_book_file_replace(job->path, job->text);
    } else if (unlink(job->path) != 0 && errno != ENOENT) {
        error = errno;
    }
    return error ? error : hid_book_file_sync(folder);
}

static void say_failed(const struct complaints *to, const struct hid_book_job *job, int error)
{
    char text[HID_BOOK_PATH_SIZE + HAL_TEXT_SIZE];
    snprintf(text, sizeof text, "%s: %s; what was %s holds until the kiosk ends", job->path,
             strerror(error), job->text[0] ? "learned" : "forgotten");
    if (to->complain) {
        to->complain(to->self, text);
    }
}

static void *write_down(void *self)
{
    struct hid_book *book = self;
    pthread_mutex_lock(&book->lock);
    while (!book->stops || book->has_job) {
        if (!book->has_job) {
            pthread_cond_wait(&book->changed, &book->lock);
            continue;
        }
        /* `job` is not changed before has_job is cleared. */
        const struct hid_book_job job = book->job;
        const struct complaints to = { .complain = book->tell, .self = book->tell_self };
        pthread_mutex_unlock(&book->lock);
        const int error = do_job(book->folder, &job);
        if (error) {
            say_failed(&to, &job, error);
        }
        pthread_mutex_lock(&book->lock);
        book->has_job = 0;
        book->written_count += !error;
        book->failed_count += error != 0;
        book->last_failed = error != 0;
    }
    pthread_mutex_unlock(&book->lock);
    return NULL;
}

int hid_book_written(struct hid_book *book)
{
    pthread_mutex_lock(&book->lock);
    const int result = book->has_job       ? HAL_ERR_BUSY
                       : book->last_failed ? HAL_ERR_IO
                                           : HAL_OK;
    pthread_mutex_unlock(&book->lock);
    return result;
}

void hid_book_tell(struct hid_book *book, void (*tell)(void *self, const char *line), void *self)
{
    pthread_mutex_lock(&book->lock);
    book->tell = tell;
    book->tell_self = self;
    pthread_mutex_unlock(&book->lock);
}

/* Passes a write, or with `forget` a deletion, to the writer thread. Must only be called while
 * no job is pending. */
static int give_job(struct hid_book *book, const struct hid_book_entry *entry, int forget)
{
    char name[HID_BOOK_NAME_SIZE];
    if (!book->has_thread) {
        return book->folder[0] ? HAL_ERR_IO : HAL_OK;
    }
    hid_book_name(entry, name);
    pthread_mutex_lock(&book->lock);
    const int length =
        snprintf(book->job.path, sizeof book->job.path, "%s/%s", book->folder, name);
    book->job.text[0] = '\0';
    const int error = (size_t)length >= sizeof book->job.path ||
                      (!forget && hid_book_write(entry, book->job.text) != 0);
    book->has_job = !error;
    pthread_cond_signal(&book->changed);
    pthread_mutex_unlock(&book->lock);
    return error ? HAL_ERR_IO : HAL_OK;
}

/* ---- Public functions ----------------------------------------------------------------------- */

uint32_t hid_book_open(struct hid_book *book, const char *data,
                       void (*complain_to)(void *self, const char *line), void *self)
{
    struct complaints to = { .complain = complain_to, .self = self };
    memset(book, 0, sizeof *book);
    pthread_mutex_init(&book->lock, NULL);
    pthread_cond_init(&book->changed, NULL);
    if (!data) {
        return 0;
    }
    const int length = snprintf(book->folder, sizeof book->folder, "%s/" FOLDER, data);
    if ((size_t)length >= sizeof book->folder) {
        complain(&to, data, 0, "a path too long to keep learned controllers in");
        return to.count;
    }
    read_folder(book, &to);
    book->has_thread = pthread_create(&book->thread, NULL, write_down, book) == 0;
    if (!book->has_thread) {
        complain(&to, book->folder, 0, "no thread to write with: what is learned is not kept");
    }
    return to.count;
}

const struct hid_map *hid_book_find(const struct hid_book *book,
                                    const struct hid_identity *identity)
{
    for (uint32_t i = 0; i < book->count; i++) {
        const struct hid_book_entry *entry = &book->entry[i];
        if (entry->vendor == identity->vendor && entry->product == identity->product &&
            strcmp(entry->serial, identity->serial) == 0) {
            return &entry->map;
        }
    }
    return NULL;
}

int hid_book_keep(struct hid_book *book, const struct hid_identity *identity,
                  const struct hid_map *map)
{
    if (hid_book_written(book) == HAL_ERR_BUSY) {
        return HAL_ERR_BUSY;
    }
    struct hid_book_entry *entry =
        entry_of(book, identity->vendor, identity->product, identity->serial);
    if (!entry) {
        if (book->count == HID_BOOK_MAX) {
            return HAL_ERR_IO;
        }
        entry = &book->entry[book->count++];
        *entry = (struct hid_book_entry){ .vendor = identity->vendor,
                                          .product = identity->product };
        memcpy(entry->serial, identity->serial, sizeof entry->serial);
    }
    entry->map = *map;
    return give_job(book, entry, 0);
}

int hid_book_forget(struct hid_book *book, const struct hid_identity *identity)
{
    if (hid_book_written(book) == HAL_ERR_BUSY) {
        return HAL_ERR_BUSY;
    }
    struct hid_book_entry *entry =
        entry_of(book, identity->vendor, identity->product, identity->serial);
    if (!entry) {
        return HAL_OK;
    }
    const int result = give_job(book, entry, 1);
    *entry = book->entry[--book->count];
    return result;
}

static void choose(void *self, const struct hid_face *face,
                   const struct hid_descriptor *descriptor, struct hid_map *out)
{
    const struct hid_book *book = self;
    const struct hid_map *learned = hid_book_find(book, &face->identity);
    if (learned && hid_map_is_sound(learned, descriptor)) {
        *out = *learned;
    } else {
        hid_map_choose(out, &face->identity, descriptor);
    }
}

struct hid_mapper hid_book_mapper(struct hid_book *book)
{
    return (struct hid_mapper){ .choose = choose, .self = book };
}

void hid_book_close(struct hid_book *book)
{
    if (book->has_thread) {
        pthread_mutex_lock(&book->lock);
        book->stops = 1;
        pthread_cond_signal(&book->changed);
        pthread_mutex_unlock(&book->lock);
        pthread_join(book->thread, NULL);
        book->has_thread = 0;
    }
    pthread_cond_destroy(&book->changed);
    pthread_mutex_destroy(&book->lock);
}
