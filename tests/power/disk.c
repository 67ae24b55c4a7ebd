/* disk.c -- applies recorded file operations to a simulated disk, and tracks which of them are not
 * durable yet. */
#include "tests/power/disk.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/rng.h"
#include "tests/power/disk_parts.h"

static uint32_t disk_draw(size_t op, uint32_t what)
{
    return rng_u32((struct rng_key){ (uint32_t)op, what, 7u, RNG_TEST }) >> 8;
}

void disk_need(const void *got)
{
    if (!got) {
        fprintf(stderr, "power: no memory\n");
        abort();
    }
}

void disk_grow(struct disk_file *file, size_t size)
{
    if (size > file->room) {
        file->room = 2 * size;
        file->bytes = realloc(file->bytes, file->room);
        disk_need(file->bytes);
    }
    if (size > file->size) {
        memset(file->bytes + file->size, 0, size - file->size);
        file->size = size;
    }
}

static struct disk_file *file_at(struct disk *disk, uint32_t number)
{
    if (number >= disk->file_room) {
        const uint32_t room = 2u * number + 16u;
        disk->files = realloc(disk->files, room * sizeof *disk->files);
        disk_need(disk->files);
        memset(disk->files + disk->file_room, 0, (room - disk->file_room) * sizeof *disk->files);
        disk->file_room = room;
    }
    return &disk->files[number];
}

/* ---- File names ----------------------------------------------------------------------------- */

static void set_name(struct disk *disk, const char *name, uint32_t file)
{
    uint32_t at = DISK_NAMES_MAX;
    for (uint32_t i = 0; i < DISK_NAMES_MAX; i++) {
        const int is_it = disk->names[i].file && strcmp(disk->names[i].name, name) == 0;
        at = is_it || (at == DISK_NAMES_MAX && !disk->names[i].file) ? i : at;
        if (is_it) {
            break;
        }
    }
    if (at == DISK_NAMES_MAX) {
        fprintf(stderr, "power: more than %u names\n", DISK_NAMES_MAX);
        abort();
    }
    snprintf(disk->names[at].name, TAPE_NAME_SIZE, "%s", name);
    disk->names[at].file = file;
}

bool disk_is_of_names(const struct tape_op *op)
{
    return op->kind == TAPE_CREATE || op->kind == TAPE_RENAME || op->kind == TAPE_UNLINK;
}

void disk_apply_names(struct disk *disk, const struct tape_op *op)
{
    if (op->kind == TAPE_RENAME) {
        set_name(disk, op->to, op->file);
    }
    set_name(disk, op->name, op->kind == TAPE_CREATE ? op->file : 0);
}

/* ---- File contents -------------------------------------------------------------------------- */

bool disk_is_of_bytes(const struct tape_op *op)
{
    return op->kind == TAPE_WRITE || op->kind == TAPE_TRUNCATE;
}

void disk_apply_bytes(const struct tape *tape, const struct tape_op *op, struct disk_file *file)
{
    if (op->kind == TAPE_TRUNCATE) {
        disk_grow(file, op->offset);
        file->size = op->offset;
        return;
    }
    disk_grow(file, op->offset + op->size);
    memcpy(file->bytes + op->offset, tape->bytes + op->at, op->size);
}

/* ---- Replaying the tape --------------------------------------------------------------------- */

void disk_open(struct disk *disk, const struct tape *tape)
{
    *disk = (struct disk){ .tape = tape };
}

void disk_put(struct disk *disk, const char *name, const uint8_t *bytes, size_t size)
{
    uint32_t number = 1;
    while (number < disk->file_room && disk->files[number].room) {
        number++;
    }
    struct disk_file *file = file_at(disk, number);
    disk_grow(file, size + 1u);
    memcpy(file->bytes, bytes, size);
    file->size = size;
    set_name(disk, name, number);
}

uint8_t *disk_read(const char *path, size_t *size)
{
    struct stat about;
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    uint8_t *bytes = NULL;
    if (fd >= 0 && fstat(fd, &about) == 0) {
        *size = (size_t)about.st_size;
        bytes = malloc(*size + 1u);
    }
    if (bytes && read(fd, bytes, *size) != (ssize_t)*size) {
        free(bytes);
        bytes = NULL;
    }
    if (fd >= 0) {
        close(fd);
    }
    return bytes;
}

uint32_t disk_put_folder(struct disk *disk, const char *folder,
                         char names[DISK_NAMES_MAX][TAPE_NAME_SIZE])
{
    uint32_t count = 0;
    char path[512];
    DIR *dir = opendir(folder);
    for (struct dirent *entry = dir ? readdir(dir) : NULL; entry; entry = readdir(dir)) {
        size_t size = 0;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        uint8_t *bytes =
            entry->d_name[0] != '.' && count < DISK_NAMES_MAX ? disk_read(path, &size) : NULL;
        if (bytes) {
            snprintf(names[count++], TAPE_NAME_SIZE, "%.63s", entry->d_name);
            disk_put(disk, entry->d_name, bytes, size);
            free(bytes);
        }
    }
    if (dir) {
        closedir(dir);
    }
    return count;
}

static bool is_in(const struct tape_op *op, const char *folder)
{
    const char *slash = strchr(op->name, '/');
    const size_t length = slash ? (size_t)(slash - op->name) : 0;
    return strlen(folder) == length && strncmp(op->name, folder, length) == 0;
}

/* Applies a failed sync of a file. None, a random half, or all of the unsynced writes reach the
 * disk. The other writes are lost, because Linux then treats their pages as clean. */
static void lose(struct disk *disk, size_t index)
{
    const struct tape_op *sync = &disk->tape->ops[index];
    const uint32_t luck = disk_draw(index, 0) % 3u;
    size_t left = 0;
    for (size_t i = 0; i < disk->pending_count; i++) {
        const size_t at = disk->pending[i];
        const struct tape_op *op = &disk->tape->ops[at];
        if (!disk_is_of_bytes(op) || op->file != sync->file) {
            disk->pending[left++] = at;
        } else if (luck == 2u || (luck == 1u && disk_draw(index, (uint32_t)at) % 2u)) {
            disk_apply_bytes(disk->tape, op, file_at(disk, op->file));
        }
    }
    disk->pending_count = left;
}

/* Applies a successful sync of a file or a folder. All pending operations on it become durable and
 * are no longer pending. */
static void make_safe(struct disk *disk, const struct tape_op *sync)
{
    size_t left = 0;
    for (size_t i = 0; i < disk->pending_count; i++) {
        const struct tape_op *op = &disk->tape->ops[disk->pending[i]];
        if (sync->kind == TAPE_SYNC_FOLDER && disk_is_of_names(op) && is_in(op, sync->name)) {
            disk_apply_names(disk, op);
        } else if (sync->kind == TAPE_SYNC && disk_is_of_bytes(op) && op->file == sync->file) {
            disk_apply_bytes(disk->tape, op, file_at(disk, op->file));
        } else {
            disk->pending[left++] = disk->pending[i];
        }
    }
    disk->pending_count = left;
}

void disk_step(struct disk *disk, size_t index)
{
    const struct tape_op *op = &disk->tape->ops[index];
    file_at(disk, op->file);
    if (op->kind == TAPE_SYNC || op->kind == TAPE_SYNC_FOLDER) {
        make_safe(disk, op);
    } else if (op->kind == TAPE_SYNC_FAILED) {
        lose(disk, index);
    } else if (disk_is_of_names(op) || disk_is_of_bytes(op)) {
        if (disk->pending_count == disk->pending_room) {
            disk->pending_room = disk->pending_room ? 2 * disk->pending_room : 256;
            disk->pending = realloc(disk->pending, disk->pending_room * sizeof *disk->pending);
            disk_need(disk->pending);
        }
        disk->pending[disk->pending_count++] = index;
    }
}

void disk_close(struct disk *disk)
{
    for (uint32_t i = 0; i < disk->file_room; i++) {
        free(disk->files[i].bytes);
    }
    free(disk->files);
    free(disk->pending);
    *disk = (struct disk){ 0 };
}
