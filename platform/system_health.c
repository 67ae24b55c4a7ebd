/* system_health.c -- checks the system's health on a separate thread; see system_health.h. */
#include "platform/system_health.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/magic.h>
#include <stdio.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/statvfs.h>
#include <time.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/os/thread.h"
#include "platform/panics.h"
#include "platform/store/storage.h"
#include "platform/thermal.h"

#define PATH_SIZE 1200u
#define MIB 1048576u

/* ---- Data folder --------------------------------------------------------------------------- */

static bool has_folder(const struct system_health *machine)
{
    return machine->data && machine->data[0];
}

/* Writes the path of the file `name` with `suffix` in `folder`. Returns false if the path is too
 * long. */
static bool path_in(const char *folder, const char *name, const char *suffix, char out[PATH_SIZE])
{
    CORE_ASSERT(name);
    const int length = snprintf(out, PATH_SIZE, "%s/%s%s", folder, name, suffix);
    return length > 0 && (unsigned)length < PATH_SIZE;
}

/* Returns a value of enum scene_keeps: whether files in the data folder survive a restart of the
 * machine. If the script check-data has written its result since the boot, that result is
 * returned. */
static uint8_t persistence_of(const struct system_health *machine)
{
    char line[16] = "";
    struct statfs about;
    if (!has_folder(machine) || statfs(machine->data, &about) != 0) {
        return KEEPS_NOWHERE;
    }
    /* The type has a sign on a 32-bit machine. */
    const uint32_t type = (uint32_t)about.f_type;
    if (type == TMPFS_MAGIC || type == RAMFS_MAGIC) {
        return KEEPS_MEMORY;
    }
    file_first_line(machine->checked ? machine->checked : SYSTEM_HEALTH_CHECK_PATH, line,
                    sizeof line);
    return strncmp(line, "kept:", 5) == 0       ? KEEPS_PROVEN
           : strncmp(line, "not kept:", 9) == 0 ? KEEPS_NOT
                                                : KEEPS_FOLDER;
}

/* ---- Backup and clock ---------------------------------------------------------------------- */

static int64_t seconds_on(clockid_t clock)
{
    return (int64_t)(clock_ns(clock) / NS_PER_S);
}

/* Updates the age of the database's backup. The civil clock is used only for a backup file that
 * exists when the program starts. Otherwise the monotonic clock measures the age, because the civil
 * clock may jump. */
static void update_backup_age(struct system_health *machine, struct scene_machine *out)
{
    char path[PATH_SIZE];
    struct stat about;
    out->has_backup = has_folder(machine) &&
                      path_in(machine->data, STORAGE_FILE, STORAGE_BACKUP_SUFFIX, path) &&
                      stat(path, &about) == 0;
    if (!out->has_backup) {
        machine->backup.inode = 0;
        return;
    }
    const int64_t now_s = seconds_on(CLOCK_MONOTONIC);
    if (machine->backup.inode != about.st_ino ||
        machine->backup.modified.tv_sec != about.st_mtim.tv_sec ||
        machine->backup.modified.tv_nsec != about.st_mtim.tv_nsec) {
        const int64_t age_s = seconds_on(CLOCK_REALTIME) - (int64_t)about.st_mtim.tv_sec;
        machine->backup.inode = about.st_ino;
        machine->backup.modified = about.st_mtim;
        machine->backup_s = now_s - (machine->has_begun || age_s < 0 ? 0 : age_s);
    }
    const int64_t age_min = (now_s - machine->backup_s) / 60;
    out->backup_min = age_min < UINT32_MAX ? (uint32_t)age_min : UINT32_MAX;
}

/* ---- Quarantined files --------------------------------------------------------------------- */

enum system_health_quarantine system_health_quarantine_of(const char *file)
{
    CORE_ASSERT(file);
    static const struct {
        const char *start;
        enum system_health_quarantine kind;
    } names[] = {
        { STORAGE_FILE STORAGE_QUARANTINE_SUFFIX, SYSTEM_HEALTH_QUARANTINE_DAMAGED },
        { STORAGE_FILE STORAGE_MISSING_SUFFIX, SYSTEM_HEALTH_QUARANTINE_MISSING },
        { STORAGE_FILE STORAGE_LEFT_SUFFIX, SYSTEM_HEALTH_QUARANTINE_LEFT },
        { STORAGE_FILE "-wal" STORAGE_OTHER_SUFFIX, SYSTEM_HEALTH_QUARANTINE_OTHER },
        { STORAGE_FILE "-shm" STORAGE_OTHER_SUFFIX, SYSTEM_HEALTH_QUARANTINE_OTHER },
        { STORAGE_FILE "-journal" STORAGE_OTHER_SUFFIX, SYSTEM_HEALTH_QUARANTINE_OTHER },
        { STORAGE_FILE STORAGE_MIRROR_SUFFIX STORAGE_OTHER_SUFFIX, SYSTEM_HEALTH_QUARANTINE_OTHER },
        { STORAGE_FILE STORAGE_BACKUP_SUFFIX STORAGE_OTHER_SUFFIX, SYSTEM_HEALTH_QUARANTINE_OTHER },
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const size_t length = strlen(names[i].start);
        const char *number = file + length;
        if (strncmp(file, names[i].start, length) == 0 && number[0] != '\0' &&
            number[strspn(number, "0123456789")] == '\0') {
            return names[i].kind;
        }
    }
    return SYSTEM_HEALTH_QUARANTINE_NONE;
}

bool system_health_is_seen(const char *folder, const char *file)
{
    char path[PATH_SIZE];
    return path_in(folder, file, STORAGE_SEEN_SUFFIX, path) && access(path, F_OK) == 0;
}

/* Returns the number of quarantined files that the operator has not acknowledged. If `marks` is
 * true, also acknowledges each of these files by creating an empty marker file. Marker files are
 * not synced: if a power cut deletes a marker, the operator only has to acknowledge the file
 * again. */
static uint32_t count_quarantined(const struct system_health *machine, bool marks, int *error)
{
    char path[PATH_SIZE];
    DIR *const folder = has_folder(machine) ? opendir(machine->data) : NULL;
    const struct dirent *entry;
    uint32_t count = 0;
    while (folder && count < SYSTEM_HEALTH_QUARANTINE_MAX && (entry = readdir(folder)) != NULL) {
        if (system_health_quarantine_of(entry->d_name) == SYSTEM_HEALTH_QUARANTINE_NONE ||
            system_health_is_seen(machine->data, entry->d_name)) {
            continue;
        }
        count++;
        if (marks) {
            const int fd = path_in(machine->data, entry->d_name, STORAGE_SEEN_SUFFIX, path)
                               ? file_handle(path, O_WRONLY | O_CREAT, 0644)
                               : -1;
            *error = fd < 0 || close(fd) != 0 ? -errno : *error;
        }
    }
    if (folder) {
        closedir(folder);
    }
    return count;
}

int system_health_mark_seen(const struct system_health *machine)
{
    int error = 0;
    count_quarantined(machine, true, &error);
    return error;
}

/* ---- One check ----------------------------------------------------------------------------- */

void system_health_sample(struct system_health *machine, struct scene_machine *out)
{
    CORE_ASSERT(out);
    static const char *const suffixes[] = { "", STORAGE_BACKUP_SUFFIX };
    char path[PATH_SIZE];
    struct stat about;
    struct statvfs disk;
    int ignored = 0;
    /* The loop finds the newest modification time of the store's files. If it is in the future, the
     * system clock was set back. */
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0] && !machine->has_begun; i++) {
        if (has_folder(machine) && path_in(machine->data, STORAGE_FILE, suffixes[i], path) &&
            stat(path, &about) == 0 && about.st_mtim.tv_sec > machine->written_s) {
            machine->written_s = (int64_t)about.st_mtim.tv_sec;
        }
    }
    out->keeps = persistence_of(machine);
    const bool has_disk = has_folder(machine) && statvfs(machine->data, &disk) == 0;
    const uint64_t mib = has_disk ? (uint64_t)disk.f_bavail * disk.f_frsize / MIB : 0;
    out->room_mib = mib < UINT32_MAX ? (uint32_t)mib : UINT32_MAX;
    update_backup_age(machine, out);
    out->is_clock_back =
        machine->written_s > seconds_on(CLOCK_REALTIME) + SYSTEM_HEALTH_CLOCK_SLACK_S;
    const int32_t margin_mdeg = thermal_read(machine->heat ? machine->heat : THERMAL_ROOT);
    out->has_heat = margin_mdeg != THERMAL_UNKNOWN_MDEG;
    out->heat_margin_c = out->has_heat ? margin_mdeg / 1000 : 0;
    out->quarantined = count_quarantined(machine, false, &ignored);
    struct panics panics = { 0 };
    const int folder =
        has_folder(machine) ? open(machine->data, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (folder >= 0) {
        panics_read(&panics, folder);
        close(folder);
    }
    out->panics = panics.total;
    out->left_out = panics.left_boot == panics_boot() ? (uint8_t)panics.left : LEFT_NOTHING;
    out->is_checked = 1;
    machine->has_begun = true;
}

/* ---- Thread -------------------------------------------------------------------------------- */

static void *system_health_thread(void *self)
{
    struct system_health *machine = self;
    struct scene_machine look = { 0 };
    eventfd_t count;
    while (!atomic_load(&machine->ends)) {
        if (atomic_exchange(&machine->acknowledges, false)) {
            system_health_mark_seen(machine);
        }
        system_health_sample(machine, &look);
        pthread_mutex_lock(&machine->lock);
        machine->newest = look;
        pthread_mutex_unlock(&machine->lock);
        if (thread_wait(machine->wake_fd, SYSTEM_HEALTH_PERIOD_S)) {
            eventfd_read(machine->wake_fd, &count);
        }
    }
    return NULL;
}

void system_health_start(struct system_health *machine)
{
    if (machine->runs) {
        return;
    }
    machine->wake_fd = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (machine->wake_fd < 0) {
        return;
    }
    atomic_store(&machine->ends, false);
    atomic_store(&machine->acknowledges, false);
    pthread_mutex_init(&machine->lock, NULL);
    machine->runs = thread_start(&machine->thread, system_health_thread, machine) == 0;
    if (!machine->runs) {
        close(machine->wake_fd);
        pthread_mutex_destroy(&machine->lock);
    }
}

void system_health_stop(struct system_health *machine)
{
    if (!machine->runs) {
        return;
    }
    atomic_store(&machine->ends, true);
    eventfd_write(machine->wake_fd, 1);
    pthread_join(machine->thread, NULL);
    pthread_mutex_destroy(&machine->lock);
    close(machine->wake_fd);
    machine->runs = false;
}

/* ---- Functions for the frame loop ---------------------------------------------------------- */

void system_health_read(struct system_health *machine, struct scene_machine *out)
{
    CORE_ASSERT(out);
    if (machine->runs && pthread_mutex_trylock(&machine->lock) == 0) {
        const struct scene_machine before = *out;
        *out = machine->newest;
        out->watch = before.watch;
        out->missed = before.missed;
        pthread_mutex_unlock(&machine->lock);
    }
}

void system_health_acknowledge(struct system_health *machine)
{
    if (machine->runs) {
        atomic_store(&machine->acknowledges, true);
        eventfd_write(machine->wake_fd, 1);
    }
}
