/* disk.h -- what may lie on a disk when the power goes: all that was synced, and of the rest
 * anything.
 *
 * A file's bytes are safe once it was synced after they were written. Until then each sector of 512
 * bytes is there or not, whatever came before or after it; where a file grew, what is not there is
 * zeros or old dirt. Names (new, changed, gone) are safe once the folder was synced; until then
 * those up to some moment are there, since journalling file systems keep them in their order.
 *
 * A sync that fails takes the page cache's side of Linux: what was written since the last sync
 * counts as clean, reads back as long as the system runs, and no later sync writes it. None, half
 * or all of its sectors have reached the disk. */
#ifndef KINGYO_TESTS_POWER_DISK_H
#define KINGYO_TESTS_POWER_DISK_H

#include <stdint.h>

#include "tests/power/tape.h"

#define DISK_SECTOR 512u
#define DISK_NAMES_MAX 64u

enum disk_luck {
    DISK_ALL = 0, /* All of what was not synced is there: only the program died. */
    DISK_NONE,    /* Nothing of it is. */
    DISK_TORN,    /* All, but of the last write only some sectors. */
    DISK_SOME,    /* Each sector by chance, one in two. */
    DISK_FEW,     /* One in eight ... */
    DISK_MOST,    /* ... or seven in eight. */
    DISK_DIRTY,   /* As DISK_SOME, and where a file grew there is dirt. */
    DISK_LUCK_COUNT,
};

struct disk_file {
    uint8_t *bytes;
    size_t size, room;
};

struct disk {
    const struct tape *tape;
    struct disk_file *files; /* As they are when all else is lost; by number, from 1. */
    uint32_t file_room;
    struct { char name[TAPE_NAME_SIZE]; uint32_t file; } names[DISK_NAMES_MAX];
    size_t *pending;         /* Ops that no sync has made safe, in their order. */
    size_t pending_count, pending_room;
};

/* An empty folder. `tape` is read as disk_step() goes through it. */
void disk_open(struct disk *disk, const struct tape *tape);

/* A file that is there from the beginning; they are numbered as they come. */
void disk_put(struct disk *disk, const char *name, const uint8_t *bytes, size_t size);

/* All that is in `folder`; its names, for a tape that will go on from it. Returns how many. */
uint32_t disk_put_folder(struct disk *disk, const char *folder,
                         char names[DISK_NAMES_MAX][TAPE_NAME_SIZE]);

/* A file's bytes, to be freed, or null. */
uint8_t *disk_read(const char *path, size_t *size);

/* The next op happens. */
void disk_step(struct disk *disk, size_t op);

/* Empties `folder` and writes there what is left when the power goes now. Equal seeds, equal
 * luck. Returns how many files there are. */
uint32_t disk_cut(const struct disk *disk, enum disk_luck luck, uint64_t seed, const char *folder);

void disk_close(struct disk *disk);

#endif
