/* tape.c -- replaces the file functions of libc by functions that record their calls.
 *
 * These functions are defined in the test program, so the dynamic linker also resolves the calls of
 * shared libraries to them. Each function passes its call directly to the kernel. */
#include "tests/power/tape.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define FD_MAX 256

static pthread_mutex_t pencil = PTHREAD_MUTEX_INITIALIZER;
static struct tape *running;
static char watched[256];
static size_t watched_size;
static atomic_uint sync_us;
static int loses_syncs;
static atomic_int is_dead;
int (*tape_other_write)(const void *bytes, size_t size);
static atomic_int refusal;
/* File number of each open descriptor. 0 means a file outside the recorded folder. */
static uint32_t file_of_fd[FD_MAX];
static uint8_t is_folder[FD_MAX]; /* 1 for a descriptor of the recorded folder, and 2 for a
                                     descriptor of a subfolder. */
static char folder_name[FD_MAX][TAPE_NAME_SIZE];
/* 1 for a descriptor of the index (-shm file) of SQLite's write-ahead log. Writes to this file are
 * not recorded, because SQLite rebuilds the file after a power cut. The file still uses disk space,
 * so its writes may fail. */
static uint8_t is_index[FD_MAX];

/* ---- Appending operations to the recording -------------------------------------------------- */

static void need(const void *got)
{
    if (!got) {
        static const char words[] = "power: no memory\n";
        syscall(SYS_write, 2, words, sizeof words - 1);
        abort();
    }
}

static struct tape_op *add(enum tape_kind kind, uint32_t file)
{
    if (running->count == running->room) {
        running->room = running->room ? 2 * running->room : 4096;
        running->ops = realloc(running->ops, running->room * sizeof *running->ops);
        need(running->ops);
    }
    struct tape_op *op = &running->ops[running->count++];
    *op = (struct tape_op){ .kind = (uint8_t)kind, .file = file };
    return op;
}

static size_t add_bytes(const void *bytes, size_t size)
{
    while (running->used + size > running->bytes_room) {
        running->bytes_room = running->bytes_room ? 2 * running->bytes_room : 1u << 20;
        running->bytes = realloc(running->bytes, running->bytes_room);
        need(running->bytes);
    }
    memcpy(running->bytes + running->used, bytes, size);
    running->used += size;
    return running->used - size;
}

/* ---- File names ----------------------------------------------------------------------------- */

/* Returns the name of `path` relative to the recorded folder. Returns null if `path` is outside
 * this folder. */
static const char *own_name(const char *path)
{
    if (!running || strncmp(path, watched, watched_size) != 0 || path[watched_size] != '/') {
        return NULL;
    }
    const char *name = path + watched_size + 1;
    const char *slash = strchr(name, '/');
    return *name && !(slash && strchr(slash + 1, '/')) && !strstr(name, "-shm") ? name : NULL;
}

static uint32_t *find(const char *name)
{
    for (uint32_t i = 0; i < TAPE_NAMES_MAX; i++) {
        if (running->names[i].file && strcmp(running->names[i].name, name) == 0) {
            return &running->names[i].file;
        }
    }
    return NULL;
}

static void enter(const char *name, uint32_t file)
{
    uint32_t *there = find(name);
    for (uint32_t i = 0; !there && i < TAPE_NAMES_MAX; i++) {
        if (!running->names[i].file) {
            snprintf(running->names[i].name, TAPE_NAME_SIZE, "%s", name);
            there = &running->names[i].file;
        }
    }
    need(there);
    *there = file;
}

static uint32_t note_file(const char *name, int is_new)
{
    uint32_t *there = find(name);
    if (there && !is_new) {
        return *there;
    }
    struct tape_op *op = add(TAPE_CREATE, ++running->files);
    snprintf(op->name, TAPE_NAME_SIZE, "%s", name);
    enter(name, running->files);
    return running->files;
}

void tape_begin(struct tape *tape, const char *folder, const char (*first)[TAPE_NAME_SIZE],
                uint32_t first_count)
{
    memset(tape->names, 0, sizeof tape->names);
    tape->count = tape->used = 0;
    tape->files = first_count;
    tape_resume(tape, folder);
    for (uint32_t i = 0; i < first_count; i++) {
        enter(first[i], i + 1u);
    }
}

void tape_resume(struct tape *tape, const char *folder)
{
    memset(file_of_fd, 0, sizeof file_of_fd);
    memset(is_folder, 0, sizeof is_folder);
    memset(is_index, 0, sizeof is_index);
    snprintf(watched, sizeof watched, "%s", folder);
    watched_size = strlen(watched);
    running = tape;
}

void tape_mark(enum tape_kind kind, uint32_t id)
{
    pthread_mutex_lock(&pencil);
    if (running) {
        add(kind, 0)->offset = id;
    }
    pthread_mutex_unlock(&pencil);
}

void tape_end(void)
{
    pthread_mutex_lock(&pencil);
    running = NULL;
    pthread_mutex_unlock(&pencil);
}

void tape_free(struct tape *tape)
{
    free(tape->ops);
    free(tape->bytes);
    *tape = (struct tape){ 0 };
}

void tape_sync_us(uint32_t us)
{
    atomic_store(&sync_us, us);
}

/* ---- Replaced functions of libc ------------------------------------------------------------- */

static uint32_t file_of(int fd)
{
    return running && fd >= 0 && fd < FD_MAX ? file_of_fd[fd] : 0;
}

/* Returns 1 if `fd` is the index (-shm file) of a write-ahead log. Writes to the index are not
 * recorded, but they may fail according to a plan. */
static bool is_log_index(int fd)
{
    return running && fd >= 0 && fd < FD_MAX && is_index[fd];
}

static int open_file(const char *path, int flags, mode_t mode)
{
    struct stat before;
    pthread_mutex_lock(&pencil);
    const char *name = own_name(path);
    const int was_there = syscall(SYS_newfstatat, AT_FDCWD, path, &before, 0) == 0;
    if (name && !was_there && flags & O_CREAT && atomic_load(&is_dead)) {
        pthread_mutex_unlock(&pencil);
        errno = EIO;
        return -1;
    }
    const int fd = (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
    if (running && fd >= 0 && fd < FD_MAX) {
        const int writes = (flags & (O_RDWR | O_WRONLY)) != 0;
        file_of_fd[fd] = name && writes ? note_file(name, !was_there) : 0;
        is_folder[fd] = strcmp(path, watched) == 0 ? 1u : name && flags & O_DIRECTORY ? 2u : 0u;
        snprintf(folder_name[fd], TAPE_NAME_SIZE, "%.63s", is_folder[fd] == 2u ? name : "");
        is_index[fd] = strncmp(path, watched, watched_size) == 0 && strstr(path, "-shm") != NULL;
        if (file_of_fd[fd] && was_there && flags & O_TRUNC) {
            add(TAPE_TRUNCATE, file_of_fd[fd]);
        }
    }
    pthread_mutex_unlock(&pencil);
    return fd;
}

#define OPEN_AS(name)                                                                              \
    int name(const char *path, int flags, ...);                                                    \
    int name(const char *path, int flags, ...)                                                     \
    {                                                                                              \
        va_list rest;                                                                              \
        va_start(rest, flags);                                                                     \
        const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;                            \
        va_end(rest);                                                                              \
        return open_file(path, flags, mode);                                                       \
    }
#pragma GCC diagnostic ignored "-Wredundant-decls"
OPEN_AS(open)
OPEN_AS(open64)

/* Defines openat() and its variants. Absolute paths are recorded as by open(). Paths relative to an
 * open folder are only passed to the kernel. */
#define OPENAT_AS(name)                                                                            \
    int name(int folder, const char *path, int flags, ...);                                        \
    int name(int folder, const char *path, int flags, ...)                                         \
    {                                                                                              \
        va_list rest;                                                                              \
        va_start(rest, flags);                                                                     \
        const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;                            \
        va_end(rest);                                                                              \
        return folder == AT_FDCWD ? open_file(path, flags, mode)                                   \
                                  : (int)syscall(SYS_openat, folder, path, flags, mode);           \
    }
OPENAT_AS(openat)
OPENAT_AS(openat64)

static void note_write(int fd, const void *bytes, ssize_t done, uint64_t offset)
{
    const uint32_t file = file_of(fd);
    if (file && done > 0) {
        const size_t at = add_bytes(bytes, (size_t)done);
        struct tape_op *op = add(TAPE_WRITE, file);
        op->size = (uint32_t)done;
        op->offset = offset;
        op->at = at;
    }
}

/* Returns the errno with which a call must fail, or 0. A call fails if a plan requires it, and
 * always after a simulated SIGKILL (tape_set_dead()). */
int tape_planned_errno(enum fault_call call)
{
    pthread_mutex_lock(&pencil);
    const int error = atomic_load(&is_dead) ? EIO : fault_strikes(call);
    pthread_mutex_unlock(&pencil);
    errno = error ? error : errno;
    return error;
}

static bool is_refused(int fd)
{
    const int mood = atomic_load(&refusal);
    const int takes_room = running && fd >= 0 && fd < FD_MAX && is_index[fd] && mood == ENOSPC;
    const int error = file_of(fd) || takes_room ? mood : 0;
    errno = error ? error : errno;
    return error != 0;
}

static ssize_t write_at(int fd, const void *bytes, size_t size, off_t offset)
{
    if (is_refused(fd)) {
        return -1;
    }
    /* A failing write may have written a part of its data. Here this is half of the data, rounded
     * down to units of 512 bytes. */
    const int error = file_of(fd) || is_log_index(fd) ? tape_planned_errno(FAULT_PWRITE) : 0;
    const size_t reached = !error ? size : atomic_load(&is_dead) ? 0u : size / 1024u * 512u;
    pthread_mutex_lock(&pencil);
    const ssize_t done = reached || !error ? syscall(SYS_pwrite64, fd, bytes, reached, offset) : 0;
    note_write(fd, bytes, done, (uint64_t)offset);
    pthread_mutex_unlock(&pencil);
    errno = error ? error : errno;
    return error ? -1 : done;
}

ssize_t pwrite(int fd, const void *bytes, size_t size, off_t offset)
{
    return write_at(fd, bytes, size, offset);
}

ssize_t pwrite64(int fd, const void *bytes, size_t size, off64_t offset)
{
    return write_at(fd, bytes, size, offset);
}

ssize_t write(int fd, const void *bytes, size_t size)
{
    if (!file_of(fd)) {
        const int error = running && tape_other_write ? tape_other_write(bytes, size) : 0;
        errno = error ? error : errno;
        return error ? -1 : syscall(SYS_write, fd, bytes, size);
    }
    if (is_refused(fd) || tape_planned_errno(FAULT_WRITE)) {
        return -1;
    }
    pthread_mutex_lock(&pencil);
    const off_t offset = syscall(SYS_lseek, fd, 0, SEEK_CUR);
    const ssize_t done = syscall(SYS_write, fd, bytes, size);
    note_write(fd, bytes, done, (uint64_t)offset);
    pthread_mutex_unlock(&pencil);
    return done;
}

static int cut_file(int fd, off_t size)
{
    if ((file_of(fd) || is_log_index(fd)) && tape_planned_errno(FAULT_FTRUNCATE)) {
        return -1;
    }
    pthread_mutex_lock(&pencil);
    const int result = (int)syscall(SYS_ftruncate, fd, size);
    if (file_of(fd) && result == 0) {
        add(TAPE_TRUNCATE, file_of(fd))->offset = (uint64_t)size;
    }
    pthread_mutex_unlock(&pencil);
    return result;
}

int ftruncate(int fd, off_t size)
{
    return cut_file(fd, size);
}

int ftruncate64(int fd, off64_t size)
{
    return cut_file(fd, size);
}

void tape_fail_writes(int error)
{
    atomic_store(&refusal, error);
}

void tape_ignore_syncs(void)
{
    loses_syncs = 1;
}

void tape_set_dead(int is_dead_now)
{
    atomic_store(&is_dead, is_dead_now);
}

/* Records a successful sync, or a failed sync of a file. A failed sync of a folder is not recorded,
 * because its name operations stay pending, and a later sync can still make them durable. */
static int note_sync(int fd, enum fault_call call)
{
    int error = 0;
    if (running && !loses_syncs && fd >= 0 && fd < FD_MAX && (file_of_fd[fd] || is_folder[fd])) {
        const struct timespec time = { .tv_nsec = 1000L * atomic_load(&sync_us) };
        nanosleep(&time, NULL);
        error = tape_planned_errno(call);
        pthread_mutex_lock(&pencil);
        if (!error && is_folder[fd]) {
            memcpy(add(TAPE_SYNC_FOLDER, 0)->name, folder_name[fd], TAPE_NAME_SIZE);
        } else if (!is_folder[fd] && !atomic_load(&is_dead)) {
            add(error ? TAPE_SYNC_FAILED : TAPE_SYNC, file_of_fd[fd]);
        }
        pthread_mutex_unlock(&pencil);
    }
    return error ? -1 : 0;
}

int fsync(int fd)
{
    return note_sync(fd, FAULT_FSYNC);
}

int fdatasync(int fd)
{
    return note_sync(fd, FAULT_FDATASYNC);
}

int unlink(const char *path)
{
    pthread_mutex_lock(&pencil);
    const char *name = own_name(path);
    const int is_refused_now = name && atomic_load(&is_dead);
    const int result = is_refused_now ? -1 : (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
    if (name && result == 0) {
        snprintf(add(TAPE_UNLINK, 0)->name, TAPE_NAME_SIZE, "%s", name);
        *find(name) = 0;
    }
    pthread_mutex_unlock(&pencil);
    errno = is_refused_now ? EIO : errno;
    return result;
}

static int note_rename(const char *from, const char *to, unsigned flags)
{
    if (own_name(to) && tape_planned_errno(FAULT_RENAME)) {
        return -1;
    }
    pthread_mutex_lock(&pencil);
    const char *old = own_name(from), *new = own_name(to);
    const int result = (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, flags);
    if (old && new && result == 0) {
        struct tape_op *op = add(TAPE_RENAME, *find(old));
        snprintf(op->name, TAPE_NAME_SIZE, "%s", old);
        snprintf(op->to, TAPE_NAME_SIZE, "%s", new);
        enter(new, op->file);
        *find(old) = 0;
    }
    pthread_mutex_unlock(&pencil);
    return result;
}

int rename(const char *from, const char *to)
{
    return note_rename(from, to, 0);
}

/* Kingyo calls renameat2() only with paths that do not depend on the folders. */
int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags)
{
    (void)from_folder, (void)to_folder;
    return note_rename(from, to, flags);
}
