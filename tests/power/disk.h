/* disk.h -- simulates the possible contents of a disk after a power cut: all synced data and any
 * part of the unsynced data.
 *
 * Bytes of a file are durable when the file is synced after the write. Until then each sector of
 * 512 bytes is on the disk or not, independent of the order of the writes. If a file grew, a
 * missing sector contains zeros or old data. A new, changed or deleted name is durable when its
 * folder is synced. Until then the disk has all name operations up to a random moment, because
 * journaling file systems keep their order.
 *
 * A failed sync behaves as in the page cache of Linux. None, half or all of the unsynced writes
 * reach the disk. The other data can be read until the system stops, but no later sync writes
 * it. */
#ifndef KINGYO_TESTS_POWER_DISK_H
#define KINGYO_TESTS_POWER_DISK_H

#include <stdint.h>

#include "tests/power/tape.h"

#define DISK_SECTOR 512u
#define DISK_NAMES_MAX 64u

enum disk_luck {
    DISK_ALL = 0, /* All unsynced data is on the disk, as if only the program died. */
    DISK_NONE,    /* No unsynced data is on the disk. */
    DISK_TORN,    /* All unsynced data is on the disk, but only some sectors of the last write. */
    DISK_SOME,    /* Each unsynced sector is on the disk with probability one half. */
    DISK_FEW,     /* Each unsynced sector is on the disk with probability one eighth. */
    DISK_MOST,    /* Each unsynced sector is on the disk with probability seven eighths. */
    DISK_DIRTY,   /* As DISK_SOME, but missing sectors of a grown file contain old data. */
    DISK_LUCK_COUNT,
};

struct disk_file {
    uint8_t *bytes;
    size_t size, room;
};

struct disk {
    const struct tape *tape;
    struct disk_file *files; /* Durable content of the files, indexed by file number from 1. */
    uint32_t file_room;
    struct {
        char name[TAPE_NAME_SIZE];
        uint32_t file;
    } names[DISK_NAMES_MAX];
    /* Operations that may be lost in a power cut, because no sync has made them durable. The
     * operations are in time order. */
    size_t *pending;
    size_t pending_count, pending_room;
};

/* Opens a disk with an empty folder. disk_step() reads the recorded file operations from `tape`
 * (tape.h), which the caller must keep. */
void disk_open(struct disk *disk, const struct tape *tape);

/* Adds a file that exists before the first operation. Files are numbered in the order of these
 * calls. */
void disk_put(struct disk *disk, const char *name, const uint8_t *bytes, size_t size);

/* Adds all files in `folder`. Writes their names to `names`, which tape_begin() needs if a new tape
 * records in this folder. Returns the number of files. */
uint32_t disk_put_folder(struct disk *disk, const char *folder,
                         char names[DISK_NAMES_MAX][TAPE_NAME_SIZE]);

/* Returns the bytes of the file at `path`, or null. The caller frees them. */
uint8_t *disk_read(const char *path, size_t *size);

/* Applies operation number `op` of the tape, which is the recorded list of file operations, to the
 * disk. */
void disk_step(struct disk *disk, size_t op);

/* Empties `folder` and writes the files there that a power cut at this moment leaves. Equal seeds
 * give equal files. Returns the number of files. */
uint32_t disk_cut(const struct disk *disk, enum disk_luck luck, uint64_t seed, const char *folder);

/* Frees the memory of the disk. */
void disk_close(struct disk *disk);

#endif
