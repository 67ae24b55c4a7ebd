/* hid_mapping_store.c -- implements the mapping store: the list of mappings in memory, the small
 * files, which are replaced atomically, and the thread that writes the files. */
#include "drivers/hid/hid_mapping_store.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_mapping.h"
#include "platform/os/file.h"
#include "platform/os/thread.h"

/* ---- Files ----------------------------------------------------------------------------------- */

int hid_mapping_store_file_read(const char *path, char text[HID_MAPPING_STORE_TEXT_SIZE])
{
    const int fd = file_handle(path, O_RDONLY, 0);
    FILE *file = fd < 0 ? NULL : fdopen(fd, "r");
    if (!file) {
        const int error = errno;
        if (fd >= 0) {
            close(fd);
        }
        return error == EISDIR ? ENOTSUP : error;
    }
    const size_t used = fread(text, 1, HID_MAPPING_STORE_TEXT_SIZE, file);
    const int error = ferror(file) ? errno : used == HID_MAPPING_STORE_TEXT_SIZE ? EFBIG : 0;
    fclose(file);
    text[used < HID_MAPPING_STORE_TEXT_SIZE ? used : 0u] = '\0';
    return error;
}

#define FOLDER "pois"
#define SUFFIX ".poi"

struct load_errors {
    void (*log_error)(void *self, const char *line);
    void *self;
    uint32_t count;
};

static void add_load_error(struct load_errors *to, const char *path, int line, const char *what)
{
    char text[HID_MAPPING_STORE_PATH_SIZE + 256u + HAL_TEXT_SIZE + 32u], number[16] = "";
    if (line > 0) {
        snprintf(number, sizeof number, ":%d", line);
    }
    snprintf(text, sizeof text, "%s%s: %s", path, number, what);
    to->count++;
    if (to->log_error) {
        to->log_error(to->self, text);
    }
}

/* ---- Reading of the files ------------------------------------------------------------------- */

/* Returns the index of the entry with this vendor, product and serial number, or store->count if
 * there is none. */
static uint32_t find_entry(const struct hid_mapping_store *store, uint16_t vendor, uint16_t product,
                           const char *serial)
{
    CORE_ASSERT(store->count <= HID_MAPPING_STORE_MAX);
    for (uint32_t i = 0; i < store->count; i++) {
        const struct hid_mapping_store_entry *entry = &store->entry[i];
        if (entry->vendor == vendor && entry->product == product &&
            strcmp(entry->serial, serial) == 0) {
            return i;
        }
    }
    return store->count;
}

static void read_entry(struct hid_mapping_store *store, const char *path, struct load_errors *to)
{
    CORE_ASSERT(store->count <= HID_MAPPING_STORE_MAX);
    char text[HID_MAPPING_STORE_TEXT_SIZE], why[HAL_TEXT_SIZE];
    struct hid_mapping_store_entry entry;
    const int error = hid_mapping_store_file_read(path, text);
    const int bad_line = error ? 0 : hid_mapping_store_read(&entry, text, why);
    if (error || bad_line) {
        add_load_error(to, path, bad_line, error ? strerror(error) : why);
        return;
    }
    const uint32_t index = find_entry(store, entry.vendor, entry.product, entry.serial);
    if (index == HID_MAPPING_STORE_MAX) {
        add_load_error(to, path, 0,
                       "the mapping store is full: delete files of unused controllers");
        return;
    }
    store->entry[index] = entry;
    store->count += index == store->count;
}

static void read_folder(struct hid_mapping_store *store, struct load_errors *to)
{
    char path[HID_MAPPING_STORE_PATH_SIZE + 256u];
    DIR *folder = opendir(store->folder);
    const struct dirent *file;
    if (!folder) {
        if (errno != ENOENT) {
            add_load_error(to, store->folder, 0, strerror(errno));
        }
        return;
    }
    while ((file = readdir(folder)) != NULL) {
        const size_t length = strlen(file->d_name), suffix = sizeof SUFFIX - 1u;
        if (length > suffix && strcmp(file->d_name + length - suffix, SUFFIX) == 0) {
            snprintf(path, sizeof path, "%s/%s", store->folder, file->d_name);
            read_entry(store, path, to);
        }
    }
    closedir(folder);
}

/* ---- Writer thread -------------------------------------------------------------------------- */

static int do_job(const char *folder, const struct hid_mapping_store_job *job)
{
    CORE_ASSERT(memchr(job->path, 0, sizeof job->path));
    if (mkdir(folder, 0755) != 0 && errno != EEXIST) {
        return errno;
    }
    if (job->text[0]) {
        return -file_replace(job->path, job->text, strlen(job->text), FILE_REPLACE_DURABLE);
    }
    return unlink(job->path) != 0 && errno != ENOENT ? errno : -file_sync_parent(job->path);
}

static void *write_jobs(void *self)
{
    struct hid_mapping_store *store = self;
    pthread_mutex_lock(&store->lock);
    while (!store->stops || store->has_job) {
        if (!store->has_job) {
            pthread_cond_wait(&store->changed, &store->lock);
            continue;
        }
        /* No other thread changes `job` until the writer thread sets has_job to false. */
        const struct hid_mapping_store_job job = store->job;
        void (*const report)(void *self, const char *line) = store->report;
        void *const report_self = store->report_self;
        pthread_mutex_unlock(&store->lock);
        const int error = do_job(store->folder, &job);
        if (error) {
            char text[HID_MAPPING_STORE_PATH_SIZE + HAL_TEXT_SIZE];
            snprintf(text, sizeof text, "%s: %s; the change (%s) is lost when the kiosk ends",
                     job.path, strerror(error),
                     job.text[0] ? "learned mapping" : "deleted mapping");
            if (report) {
                report(report_self, text);
            }
        }
        pthread_mutex_lock(&store->lock);
        store->has_job = false;
        store->written_count += !error;
        store->failed_count += error != 0;
        store->last_failed = error != 0;
    }
    pthread_mutex_unlock(&store->lock);
    return NULL;
}

int hid_mapping_store_result(struct hid_mapping_store *store)
{
    pthread_mutex_lock(&store->lock);
    const int result = store->has_job ? HAL_ERR_BUSY : store->last_failed ? HAL_ERR_IO : HAL_OK;
    pthread_mutex_unlock(&store->lock);
    return result;
}

void hid_mapping_store_set_error_sink(struct hid_mapping_store *store,
                                      void (*report)(void *self, const char *line), void *self)
{
    pthread_mutex_lock(&store->lock);
    store->report = report;
    store->report_self = self;
    pthread_mutex_unlock(&store->lock);
}

/* Passes a job to the writer thread: deletes the file if `forget` is true, otherwise writes it.
 * Must only be called while no job is pending. Returns HAL_OK, or HAL_ERR_IO if the job is
 * impossible. */
static int submit_job(struct hid_mapping_store *store, const struct hid_mapping_store_entry *entry,
                      bool forget)
{
    char name[HID_MAPPING_STORE_NAME_SIZE];
    CORE_ASSERT(!store->has_job);
    if (!store->has_thread) {
        return store->folder[0] ? HAL_ERR_IO : HAL_OK;
    }
    hid_mapping_store_name(entry, name);
    pthread_mutex_lock(&store->lock);
    const int length =
        snprintf(store->job.path, sizeof store->job.path, "%s/%s", store->folder, name);
    store->job.text[0] = '\0';
    const bool error = (size_t)length >= sizeof store->job.path ||
                       (!forget && hid_mapping_store_write(entry, store->job.text) != 0);
    store->has_job = !error;
    pthread_cond_signal(&store->changed);
    pthread_mutex_unlock(&store->lock);
    return error ? HAL_ERR_IO : HAL_OK;
}

/* ---- Public functions ----------------------------------------------------------------------- */

uint32_t hid_mapping_store_open(struct hid_mapping_store *store, const char *data,
                                void (*log_error)(void *self, const char *line), void *self)
{
    struct load_errors to = { .log_error = log_error, .self = self };
    memset(store, 0, sizeof *store);
    pthread_mutex_init(&store->lock, NULL);
    pthread_cond_init(&store->changed, NULL);
    if (!data) {
        return 0;
    }
    const int length = snprintf(store->folder, sizeof store->folder, "%s/" FOLDER, data);
    if ((size_t)length >= sizeof store->folder) {
        add_load_error(&to, data, 0, "the path is too long for storing learned controllers");
        return to.count;
    }
    read_folder(store, &to);
    store->has_thread = thread_start(&store->thread, write_jobs, store) == 0;
    if (!store->has_thread) {
        add_load_error(&to, store->folder, 0,
                       "the writer thread cannot start: learned controllers are not stored");
    }
    return to.count;
}

const struct hid_mapping *hid_mapping_store_find(const struct hid_mapping_store *store,
                                                 const struct hid_identity *identity)
{
    const uint32_t index = find_entry(store, identity->vendor, identity->product, identity->serial);
    return index < store->count ? &store->entry[index].map : NULL;
}

int hid_mapping_store_put(struct hid_mapping_store *store, const struct hid_identity *identity,
                          const struct hid_mapping *map)
{
    CORE_ASSERT(map->count <= HID_BINDING_MAX);
    CORE_ASSERT(memchr(identity->serial, 0, sizeof identity->serial));
    if (hid_mapping_store_result(store) == HAL_ERR_BUSY) {
        return HAL_ERR_BUSY;
    }
    const uint32_t index = find_entry(store, identity->vendor, identity->product, identity->serial);
    if (index == HID_MAPPING_STORE_MAX) {
        return HAL_ERR_IO;
    }
    struct hid_mapping_store_entry *entry = &store->entry[index];
    if (index == store->count) {
        store->count++;
        *entry = (struct hid_mapping_store_entry){ .vendor = identity->vendor,
                                                   .product = identity->product };
        memcpy(entry->serial, identity->serial, sizeof entry->serial);
    }
    entry->map = *map;
    return submit_job(store, entry, false);
}

int hid_mapping_store_forget(struct hid_mapping_store *store, const struct hid_identity *identity)
{
    if (hid_mapping_store_result(store) == HAL_ERR_BUSY) {
        return HAL_ERR_BUSY;
    }
    const uint32_t index = find_entry(store, identity->vendor, identity->product, identity->serial);
    if (index == store->count) {
        return HAL_OK;
    }
    struct hid_mapping_store_entry *entry = &store->entry[index];
    const int result = submit_job(store, entry, true);
    *entry = store->entry[--store->count];
    return result;
}

static void hid_mapping_store_select(void *self, const struct hid_device_info *face,
                                     const struct hid_descriptor *descriptor,
                                     struct hid_mapping *out)
{
    const struct hid_mapping_store *store = self;
    const struct hid_mapping *learned = hid_mapping_store_find(store, &face->identity);
    if (learned && hid_mapping_is_sound(learned, descriptor)) {
        *out = *learned;
    } else {
        hid_mapping_choose(out, &face->identity, descriptor);
    }
}

struct hid_mapper hid_mapping_store_mapper(struct hid_mapping_store *store)
{
    return (struct hid_mapper){ .choose = hid_mapping_store_select, .self = store };
}

void hid_mapping_store_close(struct hid_mapping_store *store)
{
    if (store->has_thread) {
        pthread_mutex_lock(&store->lock);
        store->stops = true;
        pthread_cond_signal(&store->changed);
        pthread_mutex_unlock(&store->lock);
        pthread_join(store->thread, NULL);
        store->has_thread = false;
    }
    pthread_cond_destroy(&store->changed);
    pthread_mutex_destroy(&store->lock);
}
