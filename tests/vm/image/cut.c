/* cut.c -- computes the content of a disk after a power cut: all flushed data, and a random part of
 * the other writes.
 *
 * Usage: cut LOG DISK SEED [lies | ENTRIES]
 *
 * LOG is the log that QEMU's blklogwrites wrote for a machine that was killed. The log contains
 * each write and flush in order, in the format of the kernel's dm-log-writes. DISK is the disk
 * image from before that machine was switched on. The program changes DISK to the image after the
 * power cut.
 *
 * A write is kept if a flush followed it or if it was a FUA (force unit access) write. Each other
 * write is at random kept, lost, or torn, which means that only some of its 512-byte sectors are
 * kept. The order of the writes has no influence. With `lies`, flushed writes may be lost too, so
 * that a test of durability must fail. With ENTRIES, the power is cut after that many entries of
 * the log. Prints one line with the number of writes of each kind, and the number of entries. Exit
 * code 74 means that a file is missing or that LOG is no such log. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SECTOR 512u
#define MAGIC 0x6a736677736872ull
/* Largest number of writes in a log. A busy kiosk makes some hundred writes per second, so this
 * number is enough for about an hour. */
#define WRITES_MAX (1u << 20)

enum { FLUSH = 1, FUA = 2, DISCARD = 4, MARK = 8 };

struct super { /* Header of the log of disk writes. All fields are little-endian, as on each machine
                  that runs this test. */
    uint64_t magic, version, entries;
    uint32_t sector_size;
} __attribute__((packed));

struct entry {
    uint64_t sector, sectors, flags, mark_size;
};

struct write {
    uint64_t at, to, size; /* Position in the log, position on the disk, and size of the write, in
                              bytes. */
    uint8_t is_zero, is_safe;
};

struct tally {
    unsigned safe, kept, torn, lost, flushes;
};

static struct write writes[WRITES_MAX];
static uint32_t write_count;
static uint64_t luck;
static uint8_t disk_lies;
static uint64_t entry_count, entry_max = UINT64_MAX;

__attribute__((noreturn)) static void fail(const char *path, const char *why)
{
    fprintf(stderr, "cut: %s: %s\n", path, why);
    exit(74);
}

/* Returns the next random number (Steele, Lea, Flood: SplitMix64). */
static uint64_t draw(void)
{
    uint64_t x = luck += 0x9e3779b97f4a7c15ull;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ x >> 27) * 0x94d049bb133111ebull;
    return x ^ x >> 31;
}

/* Counts a flush. Marks all earlier writes as durable, unless the disk is simulated as one that
 * loses flushed writes (`lies`). */
static void flush(struct tally *tally)
{
    static uint32_t flushed; /* Number of writes that earlier flushes have covered. */
    while (flushed < write_count) {
        writes[flushed++].is_safe = !disk_lies;
    }
    tally->flushes++;
}

/* Reads the log up to the first invalid entry. The number of entries in the header is ignored,
 * because QEMU updates it only from time to time. */
static void read_log(const char *path, int log, struct tally *tally)
{
    struct super super;
    struct entry entry;
    if (pread(log, &super, sizeof super, 0) != (ssize_t)sizeof super || super.magic != MAGIC ||
        super.sector_size < SECTOR) {
        fail(path, "no log of blklogwrites");
    }
    const uint64_t unit = super.sector_size;
    uint64_t at = unit;
    while (entry_count < entry_max &&
           pread(log, &entry, sizeof entry, (off_t)at) == (ssize_t)sizeof entry) {
        if (entry.sectors == 0 && entry.flags == 0) {
            break;
        }
        entry_count++;
        if (entry.flags & FLUSH) {
            flush(tally);
        }
        const uint64_t size = entry.sectors * unit;
        if (size > 0 && write_count == WRITES_MAX) {
            fail(path, "too many writes");
        }
        if (size > 0) {
            writes[write_count++] = (struct write){
                .at = at + unit,
                .to = entry.sector * unit,
                .size = size,
                .is_zero = (entry.flags & DISCARD) != 0,
                .is_safe = (entry.flags & FUA) != 0,
            };
        }
        at += unit + (entry.flags & DISCARD ? 0 : size);
    }
}

/* Applies a random part of the sectors of a write to the disk. Each sector is applied with the
 * probability `share` / 256. */
static void put(int log, int disk, const struct write *write, unsigned share)
{
    uint8_t bytes[SECTOR] = { 0 };
    for (uint64_t done = 0; done < write->size; done += SECTOR) {
        if ((draw() & 255u) >= share) {
            continue;
        }
        if (!write->is_zero &&
            pread(log, bytes, SECTOR, (off_t)(write->at + done)) != (ssize_t)SECTOR) {
            return; /* The log ends here, because the machine was killed while it wrote the data of
                       its last entry. */
        }
        if (pwrite(disk, bytes, SECTOR, (off_t)(write->to + done)) != (ssize_t)SECTOR) {
            fail("disk", strerror(errno));
        }
    }
}

static void apply(int log, int disk, struct tally *tally)
{
    for (uint32_t i = 0; i < write_count; i++) {
        const unsigned fate = writes[i].is_safe ? 0 : 1 + (unsigned)(draw() % 3);
        tally->safe += fate == 0;
        tally->kept += fate == 1;
        tally->torn += fate == 2;
        tally->lost += fate == 3;
        if (fate < 3) {
            put(log, disk, &writes[i], fate == 2 ? 128u : 256u);
        }
    }
}

int main(int argc, char **argv)
{
    struct tally tally = { 0 };
    disk_lies = argc == 5 && strcmp(argv[4], "lies") == 0;
    if (argc == 5 && !disk_lies) {
        entry_max = strtoull(argv[4], NULL, 10);
    }
    if (argc != 4 && argc != 5) {
        fprintf(stderr, "usage: cut LOG DISK SEED [lies | ENTRIES]\n");
        return 2;
    }
    const int log = open(argv[1], O_RDONLY | O_CLOEXEC), disk = open(argv[2], O_RDWR | O_CLOEXEC);
    if (log < 0 || disk < 0) {
        fail(argv[log < 0 ? 1 : 2], strerror(errno));
    }
    luck = strtoull(argv[3], NULL, 10);
    read_log(argv[1], log, &tally);
    apply(log, disk, &tally);
    printf(
        "%u writes flushed by %u flushes; of the others %u there, %u torn, %u lost; %llu entries\n",
        tally.safe, tally.flushes, tally.kept, tally.torn, tally.lost,
        (unsigned long long)entry_count);
    return close(disk) == 0 ? 0 : 74;
}
