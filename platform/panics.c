/* panics.c -- stores the count of panics in fixed little-endian fields, followed by a
 * checksum. */
#include "platform/panics.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "platform/os/log.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/replay/replay_format.h"

#define MAGIC "KGPANIC1"
enum {
    AT_TOTAL = 8,
    AT_LEFT = 12,
    AT_LEFT_BOOT = 16,
    AT_EARLY = 24,
    AT_COUNT = 28,
    AT_RECENT = 32,
    RECENT_SIZE = 12,
    AT_ATTEMPT = AT_RECENT + RECENT_SIZE * (int)PANICS_RECENT,
    AT_SUM = 72
};
_Static_assert(AT_ATTEMPT + 4 <= AT_SUM && AT_SUM + 8 == PANICS_SIZE,
               "all fields have their place");

/* ---- Boot id and uptime -------------------------------------------------------------------- */

uint64_t panics_boot(void)
{
    char id[64];
    const int file = open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
    const ssize_t size = file >= 0 ? read(file, id, sizeof id) : 0;
    if (file >= 0) {
        close(file);
    }
    return hash_bytes(HASH_START, id, size > 0 ? (size_t)size : 0);
}

uint32_t panics_up_s(void)
{
    return (uint32_t)(clock_ns(CLOCK_BOOTTIME) / NS_PER_S);
}

/* ---- Counting panics and leaving out stored data ------------------------------------------- */

void panics_add(struct panics *panics, uint64_t boot, uint32_t up_s, uint32_t run_s, bool had_frame)
{
    CORE_ASSERT(panics->count <= PANICS_RECENT);
    if (had_frame && (panics->left_boot != boot || run_s >= PANICS_WITHIN_S)) {
        panics->left = LEFT_NOTHING;
    }
    panics->total += panics->total < UINT32_MAX;
    panics->is_early = !had_frame;
    panics->count += panics->count < PANICS_RECENT;
    memmove(&panics->recent[1], &panics->recent[0],
            sizeof panics->recent - sizeof panics->recent[0]);
    panics->recent[0].boot = boot;
    panics->recent[0].up_s = up_s;
}

bool panics_is_due(const struct panics *panics)
{
    CORE_ASSERT(panics->count <= PANICS_RECENT);
    bool is_due = panics->count == PANICS_RECENT;
    for (uint32_t i = 0; i < panics->count; i++) {
        is_due = is_due && panics->recent[i].boot == panics->recent[0].boot &&
                 panics->recent[0].up_s - panics->recent[i].up_s <= PANICS_WITHIN_S;
    }
    return panics->is_early || is_due;
}

enum panics_left panics_try(struct panics *panics)
{
    CORE_ASSERT(panics->left < LEFT_COUNT);
    panics->attempt = panics->left + (panics->left < LEFT_NAMES);
    return (enum panics_left)panics->attempt;
}

void panics_set_left_out(struct panics *panics, uint64_t boot)
{
    panics->left = panics->attempt;
    panics->left_boot = boot;
    panics_clear(panics);
}

void panics_clear(struct panics *panics)
{
    panics->is_early = false;
    panics->attempt = panics->count = 0;
    memset(panics->recent, 0, sizeof panics->recent);
}

const char *panics_left_name(uint32_t left)
{
    static const char *const names[LEFT_COUNT] = { "nothing", "settings", "settings and replays",
                                                   "settings, replays and names" };
    return names[left < LEFT_COUNT ? left : 0];
}

/* ---- Reading and writing the file ---------------------------------------------------------- */

/* Returns a descriptor of a regular file, or a negative errno. */
static int open_file(int folder, int flags)
{
    const int file = file_handle_at(folder, PANICS_FILE, flags, 0600);
    if (file < 0) {
        /* One reason for the failure is that the name belongs to a link, a socket, a FIFO or a
         * folder. */
        return errno == ELOOP || errno == EISDIR ? -ENOTSUP : -errno;
    }
    return file;
}

static bool parse(struct panics *panics, const uint8_t bytes[PANICS_SIZE])
{
    const uint32_t early = replay_get_u32(bytes + AT_EARLY);
    *panics = (struct panics){
        .total = replay_get_u32(bytes + AT_TOTAL),
        .left = replay_get_u32(bytes + AT_LEFT),
        .left_boot = replay_get_u64(bytes + AT_LEFT_BOOT),
        .is_early = early == 1,
        .count = replay_get_u32(bytes + AT_COUNT),
        .attempt = replay_get_u32(bytes + AT_ATTEMPT),
    };
    for (uint32_t i = 0; i < PANICS_RECENT; i++) {
        panics->recent[i].boot = replay_get_u64(bytes + AT_RECENT + i * RECENT_SIZE);
        panics->recent[i].up_s = replay_get_u32(bytes + AT_RECENT + i * RECENT_SIZE + 8u);
    }
    return memcmp(bytes, MAGIC, 8) == 0 && panics->left < LEFT_COUNT && early <= 1 &&
           panics->count <= PANICS_RECENT && panics->attempt < LEFT_COUNT &&
           replay_get_u64(bytes + AT_SUM) == hash_bytes(HASH_START, bytes, AT_SUM);
}

/* Renames a link, FIFO, folder, socket or device with the name PANICS_FILE, so that a new file with
 * this name can be created. Returns true if such an object was renamed. */
static bool quarantine_strange(int folder)
{
    char name[40];
    struct stat about;
    if (fstatat(folder, PANICS_FILE, &about, AT_SYMLINK_NOFOLLOW) != 0 || S_ISREG(about.st_mode)) {
        return false;
    }
    for (unsigned number = 1; number <= PANICS_OTHER_MAX; number++) {
        snprintf(name, sizeof name, PANICS_FILE ".other-%u", number);
        if (fstatat(folder, name, &about, AT_SYMLINK_NOFOLLOW) != 0) {
            if (errno != ENOENT || renameat(folder, PANICS_FILE, folder, name) != 0) {
                return false;
            }
            fsync(folder);
            log_print(LOG_LEVEL_WARNING,
                      PANICS_FILE " in the data folder: is not a regular file, and was renamed to"
                                  " %s; panics are counted from zero",
                      name);
            return true;
        }
    }
    return false;
}

const char *panics_error(int error)
{
    return error == -EBADMSG   ? "is not a count of panics"
           : error == -ENOTSUP ? "is not a regular file, and cannot be renamed"
                               : strerror(-error);
}

int panics_read(struct panics *panics, int folder)
{
    CORE_ASSERT(folder >= 0);
    uint8_t bytes[PANICS_SIZE + 1u];
    *panics = (struct panics){ 0 };
    const int file = open_file(folder, O_RDONLY);
    if (file < 0) {
        return file == -ENOENT || quarantine_strange(folder) ? 0 : file;
    }
    const ssize_t size = read(file, bytes, sizeof bytes);
    const int error = size < 0 ? -errno : 0;
    close(file);
    if (!error && size == PANICS_SIZE && parse(panics, bytes)) {
        return 0;
    }
    *panics = (struct panics){ 0 };
    return error ? error : -EBADMSG;
}

int panics_write(const struct panics *panics, int folder)
{
    CORE_ASSERT(panics->count <= PANICS_RECENT && panics->left < LEFT_COUNT && folder >= 0);
    uint8_t bytes[PANICS_SIZE] = { 0 };
    memcpy(bytes, MAGIC, 8);
    replay_put_u32(bytes + AT_TOTAL, panics->total);
    replay_put_u32(bytes + AT_LEFT, panics->left);
    replay_put_u64(bytes + AT_LEFT_BOOT, panics->left_boot);
    replay_put_u32(bytes + AT_EARLY, panics->is_early);
    replay_put_u32(bytes + AT_COUNT, panics->count);
    replay_put_u32(bytes + AT_ATTEMPT, panics->attempt);
    for (uint32_t i = 0; i < PANICS_RECENT; i++) {
        replay_put_u64(bytes + AT_RECENT + i * RECENT_SIZE, panics->recent[i].boot);
        replay_put_u32(bytes + AT_RECENT + i * RECENT_SIZE + 8u, panics->recent[i].up_s);
    }
    replay_put_u64(bytes + AT_SUM, hash_bytes(HASH_START, bytes, AT_SUM));
    const int file = open_file(folder, O_WRONLY | O_CREAT);
    if (file < 0) {
        return file;
    }
    int error = file_write(file, bytes, sizeof bytes);
    if (!error && (ftruncate(file, PANICS_SIZE) != 0 || fsync(file) != 0)) {
        error = -errno;
    }
    close(file);
    return error;
}
