/* disk_cut.c -- computes the files that a power cut leaves on the simulated disk (disk.h). */
#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/rng.h"
#include "platform/store/graph_file.h"
#include "tests/power/disk_parts.h"

struct cut {
    const struct disk *disk;
    enum disk_luck luck;
    uint64_t seed;
    uint32_t draw;
    size_t last_write; /* Index of the last write on the tape that no sync has made durable. */
};

static uint32_t draw(struct cut *cut)
{
    return rng_u32((struct rng_key){ (uint32_t)cut->seed, cut->draw++, (uint32_t)(cut->seed >> 32),
                                     RNG_TEST });
}

/* Returns a random number from 0 to 7. */
static uint32_t eighth(struct cut *cut)
{
    return draw(cut) >> 29;
}

static int survives(struct cut *cut, size_t op)
{
    switch (cut->luck) {
    case DISK_ALL:
        return 1;
    case DISK_NONE:
        return 0;
    case DISK_TORN:
        return op != cut->last_write || eighth(cut) < 4;
    case DISK_FEW:
        return eighth(cut) < 1;
    case DISK_MOST:
        return eighth(cut) < 7;
    default:
        return eighth(cut) < 4;
    }
}

/* Applies a write to those sectors that survive the power cut. If the write begins within a sector,
 * it changes only a part of that sector. */
static void cut_write(struct cut *cut, size_t index, struct disk_file *file)
{
    const struct tape_op *op = &cut->disk->tape->ops[index];
    const uint8_t *bytes = cut->disk->tape->bytes + op->at;
    for (uint64_t at = op->offset; at < op->offset + op->size;) {
        const uint64_t sector_end = (at / DISK_SECTOR + 1u) * DISK_SECTOR;
        const uint64_t op_end = op->offset + op->size;
        const uint64_t end = op_end < sector_end ? op_end : sector_end;
        if (survives(cut, index)) {
            disk_grow(file, end);
            memcpy(file->bytes + at, bytes + (at - op->offset), end - at);
        } else if (cut->luck == DISK_DIRTY && end > file->size) {
            const size_t from = file->size > at ? file->size : (size_t)at;
            disk_grow(file, end);
            memset(file->bytes + from, (int)(0x51u + 29u * eighth(cut)), end - from);
        }
        at = end;
    }
}

static void cut_file(struct cut *cut, uint32_t number, struct disk_file *out)
{
    const struct disk *disk = cut->disk;
    const struct disk_file *safe = &disk->files[number];
    out->size = 0;
    disk_grow(out, safe->size);
    if (safe->size) {
        memcpy(out->bytes, safe->bytes, safe->size);
    }
    for (size_t i = 0; i < disk->pending_count; i++) {
        const struct tape_op *op = &disk->tape->ops[disk->pending[i]];
        if (op->file != number || !disk_is_of_bytes(op)) {
            continue;
        }
        if (op->kind == TAPE_WRITE) {
            cut_write(cut, disk->pending[i], out);
        } else if (survives(cut, disk->pending[i])) {
            disk_apply_bytes(disk->tape, op, out);
        }
    }
}

/* Applies all durable names. Also applies a random number of the pending name operations, beginning
 * with the oldest one. */
static void cut_names(struct cut *cut, struct disk *names)
{
    const struct disk *disk = cut->disk;
    size_t pending = 0;
    for (size_t i = 0; i < disk->pending_count; i++) {
        pending += (size_t)disk_is_of_names(&disk->tape->ops[disk->pending[i]]);
    }
    size_t there = cut->luck == DISK_NONE ? 0 : pending;
    if (cut->luck > DISK_TORN && pending > 0) {
        there = draw(cut) % (pending + 1u);
    }
    memcpy(names->names, disk->names, sizeof names->names);
    for (size_t i = 0; i < disk->pending_count && there > 0; i++) {
        const struct tape_op *op = &disk->tape->ops[disk->pending[i]];
        if (disk_is_of_names(op)) {
            disk_apply_names(names, op);
            there--;
        }
    }
}

/* Removes the files in a folder. Returns 0 if no such folder exists. */
static int empty(const char *folder)
{
    char path[512];
    DIR *dir = opendir(folder);
    if (!dir) {
        return 0;
    }
    for (struct dirent *entry = readdir(dir); entry; entry = readdir(dir)) {
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (entry->d_name[0] != '.') {
            unlink(path);
        }
    }
    closedir(dir);
    return 1;
}

/* If `name` contains a slash, creates the subfolder that it names. */
static void make_folder(const char *folder, const char *name)
{
    char path[512];
    const char *slash = strchr(name, '/');
    if (slash) {
        snprintf(path, sizeof path, "%s/%.*s", folder, (int)(slash - name), name);
        mkdir(path, 0755);
    }
}

static void write_out(const char *folder, const char *name, const struct disk_file *file)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    make_folder(folder, name);
    const int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (fd < 0 || write(fd, file->bytes, file->size) != (ssize_t)file->size) {
        fprintf(stderr, "power: %s: cannot write\n", path);
        abort();
    }
    close(fd);
}

uint32_t disk_cut(const struct disk *disk, enum disk_luck luck, uint64_t seed, const char *folder)
{
    static struct disk names;
    static struct disk_file file;
    struct cut cut = { .disk = disk, .luck = luck, .seed = seed, .last_write = SIZE_MAX };
    for (size_t i = 0; i < disk->pending_count; i++) {
        const struct tape_op *op = &disk->tape->ops[disk->pending[i]];
        cut.last_write = op->kind == TAPE_WRITE ? disk->pending[i] : cut.last_write;
    }
    uint32_t count = 0;
    cut_names(&cut, &names);
    char graphs[512];
    snprintf(graphs, sizeof graphs, "%s/" GRAPH_FILE_FOLDER, folder);
    empty(graphs);
    disk_need(empty(folder) ? &cut : NULL);
    for (uint32_t i = 0; i < DISK_NAMES_MAX; i++) {
        if (names.names[i].file) {
            cut_file(&cut, names.names[i].file, &file);
            write_out(folder, names.names[i].name, &file);
            count++;
        }
    }
    return count;
}
