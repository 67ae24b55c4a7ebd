/* cutter.c -- simulates power cuts. After each cut, opens the store on the files that are left, and
 * checks the loaded state. */
#include "tests/power/cutter.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "platform/store/storage.h"
#include "tests/power/disk.h"
#include "tests/power/resume.h"

/* After one of SECOND_EACH cuts, the power is cut a second time while the store recovers.
 * SECOND_EACH is prime, so that after enough cuts each kind of first cut (enum disk_luck) is
 * followed by a second cut. */
#define SECOND_EACH 149u
#define GO_ON_EACH 100u
#define PATH_SIZE 300u

static struct storage store;

/* ---- Simulating one power cut --------------------------------------------------------------- */

void tally_complain(struct tally *tally, uint64_t *count, const char *where, const char *why)
{
    (*count)++;
    if (!tally->first[0]) {
        snprintf(tally->first, sizeof tally->first, "%s: %s", where, why);
    }
}

/* Opens the store in `folder` and loads its state, as the kiosk does when it starts. */
static int wake(const char *folder, struct persistent_state *memory,
                char why[LEDGER_TOTALS_WHY_SIZE])
{
    memset(memory, 0, sizeof *memory);
    settings_reset(&memory->settings);
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    int result = device.ledger.ops->open(device.ledger.self);
    if (result == HAL_OK) {
        result = device.ledger.ops->load(device.ledger.self, memory);
    }
    snprintf(why, LEDGER_TOTALS_WHY_SIZE, "%s", device.ledger.ops->describe(device.ledger.self));
    const int is_fresh = atomic_load(&store.quarantined) != 0;
    device.ledger.ops->close(device.ledger.self);
    return result == HAL_OK && !is_fresh ? 0 : -1;
}

/* Returns 1 if the round is on a leaderboard. Only such a round must have a replay, because the
 * store may delete all other replays. */
static bool is_ranked(const struct ranking *ranking, uint32_t round_id)
{
    for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
        if (ranking_place(ranking, MODE_FESTIVAL, (enum rank_period)period, round_id, 0) <
            RANK_ROWS) {
            return true;
        }
    }
    return false;
}

/* Compares the ticket counts of the ledger and the dispenser. The ledger must have removed each
 * ticket whose dispenser pulse has begun, and at most one ticket more. */
static int tickets_differ(const struct persistent_state *memory, const struct promise *promise,
                          struct tally *tally, char why[LEDGER_TOTALS_WHY_SIZE])
{
    const uint32_t out = memory->audits.count[AUDIT_TICKETS_OUT];
    snprintf(why, LEDGER_TOTALS_WHY_SIZE, "%u tickets began to come out, and %u left the ledger",
             promise->tickets, out);
    tally->tickets_missing += out == promise->tickets + 1u;
    return out == promise->tickets || out == promise->tickets + 1u ? 0 : -1;
}

void cutter_check(const struct cutter *cutter, struct tally *tally, const char *folder,
                  const struct promise *promise, const char *where)
{
    static struct persistent_state memory;
    struct ledger_totals_file file;
    char why[LEDGER_TOTALS_WHY_SIZE], path[PATH_SIZE];
    if (wake(folder, &memory, why) != 0) {
        tally_complain(tally, &tally->unopenable, where, why);
        return;
    }
    const uint32_t last = memory.ledger.last_id;
    snprintf(path, sizeof path, "%s/" STORAGE_FILE, folder);
    snprintf(why, sizeof why, "entry %u is the last, %u was promised, %u was handed over", last,
             promise->acked, promise->kept);
    tally->ahead += last > promise->acked;
    if (last < promise->acked) {
        tally_complain(tally, &tally->lost, where, why);
    } else if (last > promise->kept) {
        tally_complain(tally, &tally->ghosts, where, why);
    } else if (ledger_totals_read(path, promise->replay, &file) != 0) {
        tally_complain(tally, &tally->unopenable, where, "another program cannot read it");
    } else if (ledger_totals_agree(&cutter->totals[last], &memory, &file, why) != 0) {
        tally_complain(tally, &tally->differing, where, why);
    } else if (tickets_differ(&memory, promise, tally, why) != 0) {
        tally_complain(tally, &tally->differing, where, why);
    } else if (promise->replay != 0 && !file.has_replay &&
               is_ranked(&memory.ranking, promise->replay)) {
        tally_complain(tally, &tally->replays_lost, where,
                       "a replay that was promised is not there");
    } else if (tally->cuts % GO_ON_EACH == 0) {
        tally->mornings++;
        if (resume_play(folder, &cutter->totals[last], last, why) != 0) {
            tally_complain(tally, &tally->differing, where, why);
        }
    }
}

/* The store opens the files that a first power cut has left. This function cuts the power a second
 * time after each file operation that the store makes meanwhile. */
static void cut_again(const struct cutter *cutter, struct tally *tally, const char *folder,
                      const char *folder_2, const struct promise *promise, const char *where)
{
    static char names[DISK_NAMES_MAX][TAPE_NAME_SIZE];
    static struct tape second;
    struct disk disk;
    struct persistent_state memory;
    char why[LEDGER_TOTALS_WHY_SIZE], place[120];
    disk_open(&disk, &second);
    const uint32_t count = disk_put_folder(&disk, folder, names);
    tape_begin(&second, folder, (const char(*)[TAPE_NAME_SIZE])names, count);
    tape_sync_us(0);
    const int woke = wake(folder, &memory, why);
    tape_end();
    for (size_t op = 0; woke == 0 && op < second.count; op++) {
        disk_step(&disk, op);
        snprintf(place, sizeof place, "%.80s, and again at op %zu", where, op);
        disk_cut(&disk, (enum disk_luck)((op + tally->cuts) % DISK_LUCK_COUNT), op, folder_2);
        cutter_check(cutter, tally, folder_2, promise, place);
        tally->second_cuts++;
    }
    disk_close(&disk);
}

/* ---- Simulating all power cuts -------------------------------------------------------------- */

bool cutter_is_point(const struct tape_op *op)
{
    return op->kind < TAPE_KEPT;
}

void cutter_update_promise(struct promise *promise, const struct tape_op *op)
{
    if (op->kind == TAPE_KEPT) {
        promise->kept = (uint32_t)op->offset;
    } else if (op->kind == TAPE_ACKED) {
        promise->acked = (uint32_t)op->offset;
    } else if (op->kind == TAPE_REPLAY_ACKED) {
        promise->replay = (uint32_t)op->offset;
    } else if (op->kind == TAPE_TICKET) {
        promise->tickets = (uint32_t)op->offset;
    } else if (op->kind == TAPE_EDIT_KEPT) {
        promise->edit_kept = (uint32_t)op->offset;
    } else if (op->kind == TAPE_EDIT_ACKED) {
        promise->edit_acked = (uint32_t)op->offset;
    }
}

/* Two working folders of a process that simulates cuts: one for the first cut, and one for a second
 * cut. */
struct bench {
    char folder[PATH_SIZE], folder_2[PATH_SIZE];
};

static void cut_once(const struct cutter *cutter, const struct disk *disk, size_t op, uint32_t way,
                     const struct promise *promise, const struct bench *bench, struct tally *tally)
{
    const enum disk_luck luck = (enum disk_luck)(way % DISK_LUCK_COUNT);
    const uint64_t seed = (uint64_t)op << 20 | (uint64_t)way << 8 | cutter->seed % 251u;
    char where[120];
    snprintf(where, sizeof where, "op %zu, way %u", op, way);
    disk_cut(disk, luck, seed, bench->folder);
    if (tally->cuts++ % SECOND_EACH == 0) {
        cut_again(cutter, tally, bench->folder, bench->folder_2, promise, where);
        disk_cut(disk, luck, seed, bench->folder);
    }
    tally->by_luck[luck]++;
    cutter_check(cutter, tally, bench->folder, promise, where);
}

/* Simulates the cuts of one of the parallel jobs. Every job applies all file operations of the
 * tape, but makes only its own part of the cuts. */
static void work(const struct cutter *cutter, uint32_t job, struct tally *tally)
{
    struct disk disk;
    struct bench bench;
    struct promise promise = { 0 };
    snprintf(bench.folder, PATH_SIZE, "%s/cut-%u", cutter->folder, job);
    snprintf(bench.folder_2, PATH_SIZE, "%s/cut-%u-2", cutter->folder, job);
    mkdir(bench.folder, 0755);
    mkdir(bench.folder_2, 0755);
    disk_open(&disk, cutter->tape);
    for (size_t op = 0; op < cutter->tape->count; op++) {
        const struct tape_op *what = &cutter->tape->ops[op];
        disk_step(&disk, op);
        cutter_update_promise(&promise, what);
        for (uint32_t way = 0; way < cutter->ways; way++) {
            if (cutter_is_point(what) && (op + way) % cutter->jobs == job) {
                cut_once(cutter, &disk, op, way, &promise, &bench, tally);
            }
        }
        tally->done = op + 1u;
    }
    disk_close(&disk);
}

void tally_add(struct tally *sum, const struct tally *part)
{
    sum->cuts += part->cuts;
    sum->second_cuts += part->second_cuts;
    for (uint32_t i = 0; i < DISK_LUCK_COUNT; i++) {
        sum->by_luck[i] += part->by_luck[i];
    }
    sum->unopenable += part->unopenable;
    sum->lost += part->lost;
    sum->ghosts += part->ghosts;
    sum->differing += part->differing;
    sum->replays_lost += part->replays_lost;
    sum->edits_lost += part->edits_lost;
    sum->ahead += part->ahead;
    sum->mornings += part->mornings;
    sum->tickets_missing += part->tickets_missing;
    sum->done += part->done;
    if (!sum->first[0]) {
        memcpy(sum->first, part->first, sizeof sum->first);
    }
}

static void show_progress(const struct cutter *cutter, const struct tally *tallies)
{
    struct tally sum = { 0 };
    for (uint32_t i = 0; i < cutter->jobs; i++) {
        tally_add(&sum, &tallies[i]);
    }
    fprintf(stderr, "  %3.0f %%  %llu cuts, %llu of them in the opening after one\r",
            100.0 * (double)sum.done / ((double)cutter->tape->count * cutter->jobs),
            (unsigned long long)(sum.cuts + sum.second_cuts), (unsigned long long)sum.second_cuts);
}

int cutter_run(const struct cutter *cutter, struct tally *sum)
{
    struct tally *tallies = mmap(NULL, cutter->jobs * sizeof *tallies, PROT_READ | PROT_WRITE,
                                 MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (tallies == MAP_FAILED) {
        return -1;
    }
    int failed = 0;
    for (uint32_t job = 0; job < cutter->jobs; job++) {
        if (fork() == 0) {
            work(cutter, job, &tallies[job]);
            _exit(0);
        }
    }
    for (uint32_t left = cutter->jobs; left > 0;) {
        int status = 0;
        const pid_t pid = waitpid(-1, &status, isatty(2) ? WNOHANG : 0);
        left -= pid > 0;
        failed |= pid > 0 && status != 0;
        if (isatty(2)) {
            show_progress(cutter, tallies);
            nanosleep(&(struct timespec){ .tv_nsec = 200000000 }, NULL);
        }
    }
    for (uint32_t job = 0; job < cutter->jobs; job++) {
        tally_add(sum, &tallies[job]);
    }
    return failed ? -1 : 0;
}
