/* system_health.c -- checks the system's health on a separate thread; see system_health.h. */
#include "platform/system_health.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/magic.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/statvfs.h>
#include <time.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/panic.h"
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

static bool path_in(const struct system_health *machine, const char *name, char out[PATH_SIZE])
{
    CORE_ASSERT(name);
    const int length = snprintf(out, PATH_SIZE, "%s/%s", machine->data, name);
    return length > 0 && (unsigned)length < PATH_SIZE;
}

/* Returns the result that the script check-data wrote during the current boot, or KEEPS_UNKNOWN if
 * there is no result. */
static uint8_t keeps_as_checked(const struct system_health *machine)
{
    char line[16] = "";
    file_first_line(machine->checked ? machine->checked : SYSTEM_HEALTH_CHECK_PATH, line,
                    sizeof line);
    return strncmp(line, "kept:", 5) == 0       ? KEEPS_PROVEN
           : strncmp(line, "not kept:", 9) == 0 ? KEEPS_NOT
                                                : KEEPS_UNKNOWN;
}

static uint8_t keeps_of(const struct system_health *machine)
{
    struct statfs about;
    if (!has_folder(machine) || statfs(machine->data, &about) != 0) {
        return KEEPS_NOWHERE;
    }
    if (about.f_type == TMPFS_MAGIC || about.f_type == RAMFS_MAGIC) {
        return KEEPS_MEMORY;
    }
    const uint8_t checked = keeps_as_checked(machine);
    return checked != KEEPS_UNKNOWN ? checked : (uint8_t)KEEPS_FOLDER;
}

static uint32_t room_of(const struct system_health *machine)
{
    struct statvfs about;
    if (!has_folder(machine) || statvfs(machine->data, &about) != 0) {
        return 0;
    }
    const uint64_t mib = (uint64_t)about.f_bavail * about.f_frsize / MIB;
    return mib < UINT32_MAX ? (uint32_t)mib : UINT32_MAX;
}

/* ---- Backup and clock ---------------------------------------------------------------------- */

static int64_t seconds_on(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (int64_t)now.tv_sec;
}

/* Updates the age of the backup. The civil clock is read only when the program starts with an
 * existing backup file. Afterwards the monotonic clock measures the age, because the civil clock
 * may jump. A change of the civil clock therefore does not affect the age of a backup that this
 * program made. */
static void look_at_backup(struct system_health *machine, struct scene_machine *out)
{
    char path[PATH_SIZE];
    struct stat about;
    out->has_backup = has_folder(machine) &&
                      path_in(machine, STORAGE_FILE STORAGE_BACKUP_SUFFIX, path) &&
                      stat(path, &about) == 0;
    if (!out->has_backup) {
        machine->backup.inode = 0;
        return;
    }
    const int64_t now_s = seconds_on(CLOCK_MONOTONIC);
    if (machine->backup.inode != about.st_ino ||
        machine->backup.mtime_s != (int64_t)about.st_mtim.tv_sec ||
        machine->backup.mtime_ns != about.st_mtim.tv_nsec) {
        const int64_t age_s = seconds_on(CLOCK_REALTIME) - (int64_t)about.st_mtim.tv_sec;
        machine->backup.inode = about.st_ino;
        machine->backup.mtime_s = (int64_t)about.st_mtim.tv_sec;
        machine->backup.mtime_ns = about.st_mtim.tv_nsec;
        machine->backup_s = now_s - (machine->has_begun || age_s < 0 ? 0 : age_s);
    }
    const int64_t age_min = (now_s - machine->backup_s) / 60;
    out->backup_min = age_min < UINT32_MAX ? (uint32_t)age_min : UINT32_MAX;
}

/* Returns the newest modification time of the store's files in seconds, or 0 if there is no file. A
 * modification time in the future means that the system clock was set back. */
static int64_t newest_file_s(const struct system_health *machine)
{
    static const char *const names[] = { STORAGE_FILE, STORAGE_FILE STORAGE_BACKUP_SUFFIX };
    char path[PATH_SIZE];
    struct stat about;
    int64_t newest_s = 0;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (path_in(machine, names[i], path) && stat(path, &about) == 0 &&
            about.st_mtim.tv_sec > newest_s) {
            newest_s = (int64_t)about.st_mtim.tv_sec;
        }
    }
    return newest_s;
}

/* ---- Quarantined files --------------------------------------------------------------------- */

enum system_health_quarantine system_health_quarantine_of(const char *file)
{
    CORE_ASSERT(file);
    static const struct {
        const char *start;
        enum system_health_quarantine aside;
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
            return names[i].aside;
        }
    }
    return SYSTEM_HEALTH_QUARANTINE_NONE;
}

static bool seen_path(const char *folder, const char *file, char out[PATH_SIZE])
{
    const int length = snprintf(out, PATH_SIZE, "%s/%s" STORAGE_SEEN_SUFFIX, folder, file);
    return length > 0 && (unsigned)length < PATH_SIZE;
}

bool system_health_is_seen(const char *folder, const char *file)
{
    char path[PATH_SIZE];
    return seen_path(folder, file, path) && access(path, F_OK) == 0;
}

/* Creates the empty marker of an acknowledged file. The marker is not synced. If a power cut loses
 * the marker, the operator is asked to acknowledge the file again. */
static int system_health_create_mark(const char *folder, const char *file)
{
    char path[PATH_SIZE];
    const int fd = seen_path(folder, file, path) ? file_handle(path, O_WRONLY | O_CREAT, 0644) : -1;
    return fd < 0 ? -errno : close(fd) != 0 ? -errno : 0;
}

/* Returns the number of quarantined files that are not acknowledged. If `marks` is true, also marks
 * these files as acknowledged. */
static uint32_t walk_aside(const struct system_health *machine, bool marks, int *error)
{
    DIR *const folder = has_folder(machine) ? opendir(machine->data) : NULL;
    const struct dirent *entry;
    uint32_t count = 0;
    while (folder && count < SYSTEM_HEALTH_QUARANTINE_MAX && (entry = readdir(folder)) != NULL) {
        if (system_health_quarantine_of(entry->d_name) == SYSTEM_HEALTH_QUARANTINE_NONE ||
            system_health_is_seen(machine->data, entry->d_name)) {
            continue;
        }
        const int result = marks ? system_health_create_mark(machine->data, entry->d_name) : 0;
        *error = result != 0 ? result : *error;
        count++;
    }
    if (folder) {
        closedir(folder);
    }
    return count;
}

int system_health_mark_seen(const struct system_health *machine)
{
    int error = 0;
    walk_aside(machine, true, &error);
    return error;
}

/* ---- Panics -------------------------------------------------------------------------------- */

static void look_at_panics(const struct system_health *machine, struct scene_machine *out)
{
    struct panics panics = { 0 };
    const int folder =
        has_folder(machine) ? open(machine->data, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (folder >= 0) {
        panics_read(&panics, folder);
        close(folder);
    }
    out->panics = panics.total;
    out->left_out = panics.left_boot == panics_boot() ? (uint8_t)panics.left : LEFT_NOTHING;
}

/* ---- One check ----------------------------------------------------------------------------- */

void system_health_sample(struct system_health *machine, struct scene_machine *out)
{
    CORE_ASSERT(out);
    const char *heat = machine->heat ? machine->heat : "/sys/class/thermal";
    int ignored = 0;
    if (!machine->has_begun) {
        machine->written_s = has_folder(machine) ? newest_file_s(machine) : 0;
    }
    out->keeps = keeps_of(machine);
    out->room_mib = room_of(machine);
    look_at_backup(machine, out);
    out->is_clock_back =
        machine->written_s > seconds_on(CLOCK_REALTIME) + SYSTEM_HEALTH_CLOCK_SLACK_S;
    const int32_t margin_mdeg = thermal_read(heat);
    out->has_heat = margin_mdeg != THERMAL_UNKNOWN_MDEG;
    out->heat_margin_c = out->has_heat ? margin_mdeg / 1000 : 0;
    out->aside = walk_aside(machine, false, &ignored);
    look_at_panics(machine, out);
    out->has_looked = 1;
    machine->has_begun = true;
}

/* ---- Thread -------------------------------------------------------------------------------- */

/* Waits up to SYSTEM_HEALTH_PERIOD_S on the monotonic clock. If the wait used the civil clock and
 * this clock were set back by years, the wait would take years. */
static void wait_a_while(struct system_health *machine)
{
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += SYSTEM_HEALTH_PERIOD_S;
    while (!machine->ends && !machine->acknowledges &&
           pthread_cond_timedwait(&machine->bell, &machine->lock, &until) == 0) {
    }
}

static void *system_health_thread(void *self)
{
    struct system_health *machine = self;
    struct scene_machine look = { 0 };
    pthread_mutex_lock(&machine->lock);
    while (!machine->ends) {
        const bool marks = machine->acknowledges;
        machine->acknowledges = false;
        pthread_mutex_unlock(&machine->lock);
        if (marks) {
            system_health_mark_seen(machine);
        }
        system_health_sample(machine, &look);
        pthread_mutex_lock(&machine->lock);
        machine->newest = look;
        wait_a_while(machine);
    }
    pthread_mutex_unlock(&machine->lock);
    return NULL;
}

/* Starts the health monitor's thread with all signals blocked except the fatal signals, because the
 * main thread handles the signals that end the kiosk. */
static bool start_thread(struct system_health *machine)
{
    sigset_t all, before;
    sigfillset(&all);
    panic_leave_open(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const bool runs = pthread_create(&machine->thread, NULL, system_health_thread, machine) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return runs;
}

void system_health_start(struct system_health *machine)
{
    if (machine->runs) {
        return;
    }
    pthread_condattr_t monotonic;
    pthread_condattr_init(&monotonic);
    pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
    pthread_mutex_init(&machine->lock, NULL);
    pthread_cond_init(&machine->bell, &monotonic);
    pthread_condattr_destroy(&monotonic);
    machine->ends = machine->acknowledges = false;
    machine->runs = start_thread(machine);
}

void system_health_stop(struct system_health *machine)
{
    if (!machine->runs) {
        return;
    }
    pthread_mutex_lock(&machine->lock);
    machine->ends = true;
    pthread_cond_signal(&machine->bell);
    pthread_mutex_unlock(&machine->lock);
    pthread_join(machine->thread, NULL);
    pthread_mutex_destroy(&machine->lock);
    pthread_cond_destroy(&machine->bell);
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

bool system_health_acknowledge(struct system_health *machine)
{
    if (!machine->runs || pthread_mutex_trylock(&machine->lock) != 0) {
        return !machine->runs;
    }
    machine->acknowledges = true;
    pthread_cond_signal(&machine->bell);
    pthread_mutex_unlock(&machine->lock);
    return true;
}
