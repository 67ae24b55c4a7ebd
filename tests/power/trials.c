/* trials.c -- simulates kiosks whose file calls fail, and cuts the power at random operations. A
 * trial is a sequence of runs of such a kiosk on the same files (trials.h). */
#include "tests/power/trials.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/rng.h"
#include "platform/store/graph_file.h"
#include "platform/store/storage.h"
#include "tests/power/disk.h"
#include "tests/power/hour.h"

#define PATH_SIZE 300u
#define PARTS_MAX 3u
#define FRAMES 600u /* Number of frames in one run of the kiosk: ten seconds. */
/* Factor by which events are more frequent, so that each run writes many entries. */
#define HASTE 16u
#define STARTS_MAX 3u /* Largest number of attempts to open the store at the start of a run. */
#define CUTS_A_PART 6u
/* Length of totals[], which has the totals after each ledger entry. This limits the number of
 * entries in one trial of a kiosk. */
#define TOTALS_MAX 1024u

static struct hour hour;
static struct tape tape;
static struct storage store;
static struct ledger_totals totals[TOTALS_MAX];

/* A trial of a simulated kiosk: a sequence of runs (parts) on the same files. The struct also
 * contains the state of the process that simulates this trial. */
struct trial {
    const struct trials *trials;
    struct trials_tally *tally;
    uint64_t seed;
    uint32_t draws;
    char folder[PATH_SIZE], cut[PATH_SIZE];
    struct disk disk;
    size_t stepped; /* Number of recorded file operations that were applied to the simulated
                       disk. */
    /* Data that the store had reported as committed within the first `stepped` operations. */
    struct promise promise;
    uint32_t edit_number;
};

static uint32_t draw(struct trial *trial)
{
    return rng_u32((struct rng_key){ (uint32_t)trial->seed, trial->draws++,
                                     (uint32_t)(trial->seed >> 32), RNG_TEST }) >>
           8;
}

/* ---- Simulating a trial ---------------------------------------------------------------------- */

static void plan_faults(struct trial *trial)
{
    struct fault_plan plans[FAULT_PLANS_MAX];
    const uint32_t count = 1u + draw(trial) % FAULT_PLANS_MAX;
    for (uint32_t i = 0; i < count; i++) {
        plans[i] = fault_draw(trial->seed, trial->draws++);
    }
    fault_begin(plans, count);
}

/* Adds the entries after `known` to the totals, which already contain the entries up to `known`. A
 * restarted kiosk may use the same ids again. The new entries then replace the old ones. */
static void add_up(uint32_t known)
{
    for (uint32_t id = known + 1u; id <= hour.kept_id && id < TOTALS_MAX; id++) {
        totals[id] = totals[id - 1u];
        ledger_totals_add(&totals[id], &hour.entries[id]);
    }
}

/* Starts a part, which is one run of the kiosk: opens the store and the game. All loaded entries
 * count as committed, because the kiosk shows their credits to the player. */
static int begin_part(struct trial *trial, struct hal_storage device)
{
    if (device.ledger.ops->open(device.ledger.self) != HAL_OK ||
        hour_open(&hour, (uint32_t)trial->seed + trial->draws, device) != 0) {
        trial->tally->refused_starts++;
        return -1;
    }
    hour.haste = HASTE;
    hour.edit_each_s = 1;
    hour.edit_first = hour.edit_number = hour.edit_acked = trial->edit_number;
    if (device.ledger.ops->is_healthy(device.ledger.self)) {
        tape_mark(TAPE_ACKED, hour.kept_id);
    }
    return 0;
}

/* Plays a part, which is one run of the kiosk. The store has no thread of its own here
 * (`without_thread`). The function therefore calls storage_work() when there is new data, and once
 * a second. */
static void play(struct trial *trial, struct hal_storage device)
{
    for (uint32_t i = 0; i < FRAMES && hour.kept_id < TOTALS_MAX - 64u; i++) {
        const unsigned pushed = store.pushed + store.edits_pushed;
        hour_frame(&hour, device);
        if (i % 60u == 0 || pushed != store.pushed + store.edits_pushed) {
            store.retry_due_ms = 0;
            storage_work(&store);
        }
    }
    trial->edit_number = hour.edit_number;
}

/* Runs a part, which is one run of the kiosk. The run ends with a simulated SIGKILL or with the
 * close of the store, in which file calls may fail too. */
static void run_part(struct trial *trial)
{
    int plays = -1;
    for (uint32_t i = 0; plays != 0 && i < STARTS_MAX; i++) {
        store = (struct storage){ .dir = trial->folder, .without_thread = true };
        const struct hal_storage device = storage_device(&store);
        plays = begin_part(trial, device);
        if (plays == 0) {
            const uint32_t known = hour.kept_id;
            play(trial, device);
            add_up(known);
        }
        const int is_killed = draw(trial) % 2u == 0;
        trial->tally->kills += (uint64_t)is_killed;
        tape_set_dead(is_killed);
        device.ledger.ops->close(device.ledger.self);
        tape_set_dead(0);
    }
}

/* ---- Simulating power cuts ------------------------------------------------------------------- */

/* Checks that the file of the morph graph contains the newest committed graph, or a later graph
 * that was passed to the store. */
static void check_graph(struct trial *trial, const char *where)
{
    char path[PATH_SIZE + 40u], text[GRAPH_FILE_TEXT_MAX], why[80];
    size_t size = 0;
    int is_there = 0;
    snprintf(path, sizeof path, "%s/" GRAPH_FILE_FOLDER "/wakin" GRAPH_FILE_SUFFIX, trial->cut);
    uint8_t *found = disk_read(path, &size);
    const struct promise *promise = &trial->promise;
    for (uint32_t i = promise->edit_acked; found && i <= promise->edit_kept && !is_there; i++) {
        const struct graph_edit_record edit = hour_edit(i);
        is_there = graph_file_format(&edit, text) == size && memcmp(text, found, size) == 0;
    }
    free(found);
    if (!is_there && promise->edit_acked > 0) {
        snprintf(why, sizeof why, "graph %u is not there, nor a later one", promise->edit_acked);
        tally_complain(&trial->tally->cuts, &trial->tally->cuts.edits_lost, where, why);
    }
}

static void step_to(struct trial *trial, size_t op)
{
    for (; trial->stepped <= op; trial->stepped++) {
        disk_step(&trial->disk, trial->stepped);
        cutter_update_promise(&trial->promise, &tape.ops[trial->stepped]);
    }
}

static void cut_at(struct trial *trial, size_t op)
{
    const struct cutter cutter = { .tape = &tape, .totals = totals, .folder = trial->folder };
    struct tally *tally = &trial->tally->cuts;
    const enum disk_luck luck = (enum disk_luck)(draw(trial) % DISK_LUCK_COUNT);
    char where[120];
    snprintf(where, sizeof where, "trial %llu, op %zu of %zu, luck %u",
             (unsigned long long)(trial->seed & UINT32_MAX), op, tape.count, luck);
    disk_cut(&trial->disk, luck, draw(trial), trial->cut);
    tally->cuts++;
    tally->by_luck[luck]++;
    check_graph(trial, where);
    cutter_check(&cutter, tally, trial->cut, &trial->promise, where);
}

/* Simulates power cuts in the last part, which is one run of the kiosk. The power is cut at random
 * file operations in time order, and after the last operation. */
static void cut_part(struct trial *trial)
{
    const size_t begin = trial->stepped, count = tape.count - begin;
    for (uint32_t i = 1; count > 0 && i <= CUTS_A_PART; i++) {
        const size_t from = begin + count * (i - 1u) / CUTS_A_PART;
        const size_t to = begin + count * i / CUTS_A_PART;
        if (to > from) {
            const size_t op = i == CUTS_A_PART ? to - 1u : from + draw(trial) % (to - from);
            step_to(trial, op);
            cut_at(trial, op);
        }
    }
}

/* ---- Simulating all trials ------------------------------------------------------------------- */

static void empty(const char *folder)
{
    static const struct tape nothing;
    struct disk none;
    disk_open(&none, &nothing);
    disk_cut(&none, DISK_NONE, 0, folder);
    disk_close(&none);
}

/* Simulates the trial of one kiosk, which has 1 to PARTS_MAX runs (parts). After each run,
 * cut_part() simulates power cuts and checks the files, and no file operations are recorded
 * meanwhile. */
static void run_trial(struct trial *trial)
{
    struct tape *const own = &tape;
    empty(trial->folder);
    disk_open(&trial->disk, own);
    trial->stepped = 0;
    trial->promise = (struct promise){ 0 };
    ledger_totals_open(&totals[0]);
    tape_begin(own, trial->folder, NULL, 0);
    const uint32_t parts = 1u + draw(trial) % PARTS_MAX;
    for (uint32_t part = 0; part < parts; part++) {
        plan_faults(trial);
        run_part(trial);
        fault_begin(NULL, 0);
        tape_end();
        cut_part(trial);
        tape_resume(own, trial->folder);
    }
    tape_end();
    disk_close(&trial->disk);
    trial->tally->trials++;
}

static void work(const struct trials *trials, uint32_t job, struct trials_tally *tally)
{
    struct trial trial = { .trials = trials, .tally = tally };
    snprintf(trial.folder, PATH_SIZE, "%s/trial-%u", trials->folder, job);
    snprintf(trial.cut, PATH_SIZE, "%s/trial-%u-cut", trials->folder, job);
    mkdir(trial.folder, 0755);
    mkdir(trial.cut, 0755);
    for (uint32_t number = job; number < trials->count; number += trials->jobs) {
        trial.seed = (uint64_t)trials->seed << 32 | number;
        trial.draws = trial.edit_number = 0;
        run_trial(&trial);
    }
    memcpy(tally->failed, fault_failed, sizeof tally->failed);
}

static void add(struct trials_tally *sum, const struct trials_tally *part)
{
    tally_add(&sum->cuts, &part->cuts);
    sum->trials += part->trials;
    sum->kills += part->kills;
    sum->refused_starts += part->refused_starts;
    for (uint32_t i = 0; i < FAULT_CALL_COUNT; i++) {
        sum->failed[i] += part->failed[i];
    }
}

int trials_run(const struct trials *trials, struct trials_tally *sum)
{
    struct trials_tally *tallies = mmap(NULL, trials->jobs * sizeof *tallies,
                                        PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (tallies == MAP_FAILED) {
        return -1;
    }
    int failed = 0, status = 0;
    for (uint32_t job = 0; job < trials->jobs; job++) {
        const pid_t pid = fork();
        failed |= pid < 0;
        if (pid == 0) {
            work(trials, job, &tallies[job]);
            _exit(0);
        }
    }
    while (wait(&status) > 0) {
        failed |= status != 0;
    }
    for (uint32_t job = 0; job < trials->jobs; job++) {
        add(sum, &tallies[job]);
    }
    munmap(tallies, trials->jobs * sizeof *tallies);
    return failed ? -1 : 0;
}
