/* disk.h -- simulates what a disk may contain after a power cut: all synced data, and any part of
 * the unsynced data.
 *
 * The bytes of a file are durable when the file is synced after the write. Until then, each sector
 * of 512 bytes is on the disk or not, independent of the order of the writes. If the file grew, a
 * missing sector contains zeros or old data. A new, changed or deleted name is durable when its
 * folder is synced. Until then, the disk has all name operations up to a random moment, because
 * journaling file systems keep the order of these operations.
 *
 * A failed sync behaves as in the page cache of Linux. None, half or all of the unsynced writes
 * reach the disk. The other data can be read until the system stops, but no later sync writes
 * them. */
#ifndef KINGYO_TESTS_POWER_DISK_H
#define KINGYO_TESTS_POWER_DISK_H

#include <stdint.h>

#include "tests/power/tape.h"

#define DISK_SECTOR 512u
#define DISK_NAMES_MAX 64u

enum disk_luck {
    DISK_ALL = 0, /* After the cut, the disk has all unsynced data, as if only the program had
                     died. */
    DISK_NONE,    /* After the cut, the disk has no unsynced data. */
    DISK_TORN,    /* After the cut, the disk has all unsynced data except some sectors of the last
                     write. */
    DISK_SOME,    /* After the cut, the disk has each unsynced sector with a probability of 1/2. */
    DISK_FEW,     /* After the cut, the disk has each unsynced sector with a probability of 1/8. */
    DISK_MOST,    /* After the cut, the disk has each unsynced sector with a probability of 7/8. */
    /* After the cut, the disk has each unsynced sector with a probability of 1/2. The missing
     * sectors of a file that grew contain old data instead of zeros. */
    DISK_DIRTY,
    DISK_LUCK_COUNT,
};

struct disk_file {
    uint8_t *bytes;
    size_t size, room;
};

struct disk {
    const struct tape *tape;
    struct disk_file *files; /* Durable contents of the files by file number, from 1. */
    uint32_t file_room;
    struct {
        char name[TAPE_NAME_SIZE];
        uint32_t file;
    } names[DISK_NAMES_MAX];
    /* Indices of the operations that a power cut may lose, in time order, because no sync has made
     * them durable. */
    size_t *pending;
    size_t pending_count, pending_room;
};

/* Initializes `disk` with an empty folder. disk_step() reads the recorded file operations from
 * `tape`, which the caller must keep. */
void disk_open(struct disk *disk, const struct tape *tape);

/* Adds a file that exists before the first recorded operation. The files are numbered in the order
 * of these calls. */
void disk_put(struct disk *disk, const char *name, const uint8_t *bytes, size_t size);

/* Adds all files in `folder` and writes their names to `names`. A new tape that records this folder
 * needs these names in tape_begin(). Returns the number of files. */
uint32_t disk_put_folder(struct disk *disk, const char *folder,
                         char names[DISK_NAMES_MAX][TAPE_NAME_SIZE]);

/* Returns the bytes of the file at `path`, or null if the file cannot be read. Writes the number of
 * bytes to `size`. The caller frees the bytes. */
uint8_t *disk_read(const char *path, size_t *size);

/* Applies operation number `op` of the tape to the disk. The tape is the recorded list of file
 * operations. */
void disk_step(struct disk *disk, size_t op);

/* Writes the files to `folder` that a power cut at this moment leaves, after removing all files in
 * the folder. Equal seeds give equal files. Returns the number of files. */
uint32_t disk_cut(const struct disk *disk, enum disk_luck luck, uint64_t seed, const char *folder);

/* Frees all memory that the simulated disk has allocated. */
void disk_close(struct disk *disk);

#endif
