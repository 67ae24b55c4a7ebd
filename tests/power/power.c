/* power.c -- cuts the power after every write and sync of a simulated hour, and checks the
 * remaining files.
 *
 * Usage: power [--cuts N] [--trials N] [--seed N] [--frames N] [--folder DIR] [--jobs N]
 * [--lose-syncs 1] [--journal "MODE SYNC"]
 *
 * The hour (hour.h) is played once with the real core and store, and its file operations are
 * recorded (tape.h). The power is then cut after each operation in several ways (disk.h), N cuts in
 * total. The store opens the remaining files, and its state must be the sum of all entries up to a
 * valid last entry (ledger_totals.h). One opening in 149 is also cut at each of its own file
 * operations. After one cut in 100 the test continues to play (resume.h). Finally N trials with
 * failing file calls are played (trials.h).
 *
 * With --lose-syncs no sync reaches the disk or fails, so that the test must find losses and too
 * few failed calls. Returns exit status 1 if any check fails. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "platform/os/number.h"
#include "platform/os/panic.h"
#include "platform/store/storage.h"
#include "tests/power/cutter.h"
#include "tests/power/hour.h"
#include "tests/power/trials.h"
#include "tests/power/tape.h"

#define FRAMES_AN_HOUR (3600u * 60u)
/* Duration of a simulated sync in us. The hour runs much faster than real time, so 200 us stand for
 * some tenths of a second on a slow card. */
#define SYNC_US 200u
#define JOBS_MAX 16u
/* Number of trials in a full run, and the number of calls of each kind that must fail in such a
 * run. In a shorter run, at least one call of each kind must fail in every second trial. */
#define TRIALS_FULL 600u
#define FAILED_CALLS_MIN 1000u
#define PATH_SIZE 300u

struct plan {
    uint32_t cuts, trials, seed, frames, jobs, lose_syncs;
    char folder[200];
    const char *journal; /* Journal mode of SQLite. Null means the default of the store. */
};

static struct hour hour;
static struct tape tape;
static struct ledger_totals *totals; /* totals[n] has the totals of the ledger entries 1 to n. */
static struct storage store;

/* ---- Playing the hour ----------------------------------------------------------------------- */

static int play(const struct plan *plan, const char *folder)
{
    tape_begin(&tape, folder, NULL, 0);
    tape_sync_us(SYNC_US);
    store = (struct storage){ .dir = folder, .how.journal = plan->journal };
    const struct hal_storage device = storage_device(&store);
    if (device.ledger.ops->open(device.ledger.self) != HAL_OK ||
        hour_open(&hour, plan->seed, device) != 0) {
        fprintf(stderr, "power: %s\n", device.ledger.ops->describe(device.ledger.self));
        return -1;
    }
    for (uint32_t i = 0; i < plan->frames; i++) {
        hour_frame(&hour, device);
    }
    const uint32_t unwritten = device.ledger.ops->close(device.ledger.self);
    tape_end();
    if (unwritten > 0) {
        fprintf(stderr, "power: %u entries were not written at the end\n", unwritten);
    }
    return unwritten > 0 ? -1 : 0;
}

static int add_up(void)
{
    totals = calloc(hour.kept_id + 1u, sizeof *totals);
    if (!totals) {
        return -1;
    }
    ledger_totals_open(&totals[0]);
    for (uint32_t id = 1; id <= hour.kept_id; id++) {
        totals[id] = totals[id - 1u];
        ledger_totals_add(&totals[id], &hour.entries[id]);
    }
    return 0;
}

/* Checks that no file operation is missing on the tape. The recorded operations, applied to an
 * empty disk, must give the same files as the run. Otherwise all later checks would be
 * meaningless. */
static bool tape_is_whole(const char *folder, const char *copy)
{
    struct disk disk, is, should;
    static char names[DISK_NAMES_MAX][TAPE_NAME_SIZE], others[DISK_NAMES_MAX][TAPE_NAME_SIZE];
    disk_open(&disk, &tape);
    for (size_t op = 0; op < tape.count; op++) {
        disk_step(&disk, op);
    }
    disk_cut(&disk, DISK_ALL, 0, copy);
    disk_open(&is, &tape);
    disk_open(&should, &tape);
    const uint32_t count = disk_put_folder(&is, copy, names);
    int whole = disk_put_folder(&should, folder, others) == count;
    for (uint32_t i = 0; i < count && whole; i++) {
        char a[PATH_SIZE], b[PATH_SIZE];
        size_t a_size = 0, b_size = 0;
        snprintf(a, sizeof a, "%s/%.*s", copy, (int)TAPE_NAME_SIZE - 1, names[i]);
        snprintf(b, sizeof b, "%s/%.*s", folder, (int)TAPE_NAME_SIZE - 1, names[i]);
        uint8_t *left = disk_read(a, &a_size), *right = disk_read(b, &b_size);
        whole = left && right && a_size == b_size && memcmp(left, right, a_size) == 0;
        free(left);
        free(right);
    }
    disk_close(&disk);
    disk_close(&is);
    disk_close(&should);
    return whole;
}

/* ---- Messages ------------------------------------------------------------------------------- */

static void print_hour(const struct plan *plan)
{
    uint32_t writes = 0, syncs = 0, points = 0;
    for (size_t i = 0; i < tape.count; i++) {
        writes += tape.ops[i].kind == TAPE_WRITE;
        syncs += tape.ops[i].kind == TAPE_SYNC || tape.ops[i].kind == TAPE_SYNC_FOLDER;
        points += (uint32_t)cutter_is_point(&tape.ops[i]);
    }
    printf("power: %u minutes of a festival: %u coins, %u SERVICE, %u rounds, %u tickets, "
           "%u entries\n",
           plan->frames / 3600u, hour.coins, hour.services, hour.rounds, hour.output.tickets,
           hour.kept_id);
    printf("       %u file operations, of them %u writes (%.1f MB) and %u syncs\n", points, writes,
           (double)tape.used / 1e6, syncs);
}

static int print_result(const struct tally *sum, double seconds)
{
    static const char *const luck[DISK_LUCK_COUNT] = {
        "all there",           "nothing there",  "last write torn", "half of the sectors",
        "one sector in eight", "seven in eight", "half, and dirt",
    };
    printf("  of what was not synced      cuts\n");
    for (uint32_t i = 0; i < DISK_LUCK_COUNT; i++) {
        printf("    %-22s %7llu\n", luck[i], (unsigned long long)sum->by_luck[i]);
    }
    printf("    %-22s %7llu\n", "in the opening after", (unsigned long long)sum->second_cuts);
    printf("  %llu cuts in %.0f s: %llu lost, %llu never handed over, %llu with other sums, "
           "%llu unopenable, %llu replays lost; in %llu more was kept than promised\n",
           (unsigned long long)(sum->cuts + sum->second_cuts), seconds,
           (unsigned long long)sum->lost, (unsigned long long)sum->ghosts,
           (unsigned long long)sum->differing, (unsigned long long)sum->unopenable,
           (unsigned long long)sum->replays_lost, (unsigned long long)sum->ahead);
    printf(
        "  after %llu of them the kiosk ran for another half minute, and then started once more\n",
        (unsigned long long)sum->mornings);
    printf("  in %llu cuts one ticket had left the ledger and not begun to come out\n",
           (unsigned long long)sum->tickets_missing);
    if (sum->first[0]) {
        printf("  the first: %s\n", sum->first);
    }
    return sum->lost || sum->ghosts || sum->differing || sum->unopenable || sum->replays_lost ||
           sum->cuts == 0;
}

/* Checks that enough calls of each kind have failed. Otherwise the faults were not injected, and a
 * result without losses would prove nothing. Returns 0. If there were too few calls, prints a line
 * for each kind and returns 1. */
static int check_failed_calls(const struct trials_tally *sum)
{
    const uint64_t least = sum->trials >= TRIALS_FULL ? FAILED_CALLS_MIN : sum->trials / 2u;
    int has_few = 0;
    for (uint32_t i = 0; i < FAULT_CALL_COUNT; i++) {
        if (sum->failed[i] < least) {
            printf("  too few failed calls: %llu %s, expected at least %llu\n",
                   (unsigned long long)sum->failed[i], fault_names[i], (unsigned long long)least);
            has_few = 1;
        }
    }
    return has_few;
}

static int print_trials(const struct trials_tally *sum, double seconds)
{
    const struct tally *cuts = &sum->cuts;
    printf("  in %llu trials of failing calls (%llu ended by SIGKILL, %llu starts refused)\n"
           "  calls that failed:",
           (unsigned long long)sum->trials, (unsigned long long)sum->kills,
           (unsigned long long)sum->refused_starts);
    for (uint32_t i = 0; i < FAULT_CALL_COUNT; i++) {
        printf(" %llu %s%s", (unsigned long long)sum->failed[i], fault_names[i],
               i + 1u < FAULT_CALL_COUNT ? "," : "\n");
    }
    printf("  %llu cuts in these trials in %.0f s: %llu lost, %llu doubled, %llu unopenable, "
           "%llu with other sums, %llu replays lost, %llu graphs lost\n",
           (unsigned long long)cuts->cuts, seconds, (unsigned long long)cuts->lost,
           (unsigned long long)cuts->ghosts, (unsigned long long)cuts->unopenable,
           (unsigned long long)cuts->differing, (unsigned long long)cuts->replays_lost,
           (unsigned long long)cuts->edits_lost);
    if (cuts->first[0]) {
        printf("  the first: %s\n", cuts->first);
    }
    return check_failed_calls(sum) || cuts->lost || cuts->ghosts || cuts->unopenable ||
           cuts->differing || cuts->replays_lost || cuts->edits_lost || cuts->cuts == 0;
}

static int run_trials(const struct plan *plan)
{
    const time_t begin = time(NULL);
    struct trials_tally sum = { 0 };
    const struct trials trials = { plan->folder, plan->trials, plan->seed, plan->jobs };
    if (trials_run(&trials, &sum) != 0) {
        fprintf(stderr, "power: a worker died\n");
        return 1;
    }
    return print_trials(&sum, difftime(time(NULL), begin));
}

static int read_plan(struct plan *plan, int argc, char **argv)
{
    *plan = (struct plan){ .cuts = 50000,
                           .seed = 1,
                           .frames = FRAMES_AN_HOUR,
                           .jobs = (uint32_t)sysconf(_SC_NPROCESSORS_ONLN),
                           .folder = "/dev/shm" };
    int good = 1;
    for (int i = 1; i + 1 < argc; i += 2) {
        uint32_t *out = strcmp(argv[i], "--cuts") == 0         ? &plan->cuts
                        : strcmp(argv[i], "--trials") == 0     ? &plan->trials
                        : strcmp(argv[i], "--seed") == 0       ? &plan->seed
                        : strcmp(argv[i], "--frames") == 0     ? &plan->frames
                        : strcmp(argv[i], "--jobs") == 0       ? &plan->jobs
                        : strcmp(argv[i], "--lose-syncs") == 0 ? &plan->lose_syncs
                                                               : NULL;
        if (strcmp(argv[i], "--journal") == 0) {
            plan->journal = argv[i + 1];
        } else if (strcmp(argv[i], "--folder") == 0) {
            snprintf(plan->folder, sizeof plan->folder, "%s", argv[i + 1]);
        } else {
            const uint32_t least = out == &plan->cuts ? 0u : 1u;
            good &= out && number_parse(argv[i + 1], least, UINT32_MAX / 2u, out);
        }
    }
    plan->jobs = plan->jobs > JOBS_MAX ? JOBS_MAX : plan->jobs;
    return good && argc % 2 == 1 ? 0 : -1;
}

static int run_hour(const struct plan *plan)
{
    char folder[PATH_SIZE], copy[PATH_SIZE];
    const time_t begin = time(NULL);
    snprintf(copy, sizeof copy, "%.280s/copy", plan->folder);
    snprintf(folder, sizeof folder, "%.280s/hour", plan->folder);
    mkdir(folder, 0755);
    mkdir(copy, 0755);
    if (play(plan, folder) != 0 || add_up() != 0) {
        return 1;
    }
    print_hour(plan);
    if (!tape_is_whole(folder, copy)) {
        fprintf(stderr, "power: the tape does not tell all that happened to the files\n");
        return 1;
    }
    uint32_t points = 0;
    for (size_t i = 0; i < tape.count; i++) {
        points += (uint32_t)cutter_is_point(&tape.ops[i]);
    }
    struct tally sum = { 0 };
    const struct cutter cutter = { &tape,        totals,
                                   plan->folder, (plan->cuts + points - 1u) / points,
                                   plan->seed,   plan->jobs };
    if (cutter_run(&cutter, &sum) != 0) {
        fprintf(stderr, "power: a worker died\n");
        return 1;
    }
    return print_result(&sum, difftime(time(NULL), begin));
}

static int run(struct plan *plan)
{
    char folder[PATH_SIZE];
    snprintf(folder, sizeof folder, "%.180s/kingyo-power-XXXXXX", plan->folder);
    if (!mkdtemp(folder)) {
        fprintf(stderr, "power: %s: cannot make a folder there\n", plan->folder);
        return 74;
    }
    snprintf(plan->folder, sizeof plan->folder, "%.190s", folder);
    const int code = plan->cuts > 0 ? run_hour(plan) : 0;
    return code == 0 && plan->trials > 0 ? run_trials(plan) : code;
}

static void remove_folder(const char *folder)
{
    char command[PATH_SIZE + 16];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (strstr(folder, "/kingyo-power-") && system(command) != 0) {
        fprintf(stderr, "power: %s: cannot be removed\n", folder);
    }
}

int main(int argc, char **argv)
{
    struct plan plan;
    if (read_plan(&plan, argc, argv) != 0) {
        fprintf(stderr, "usage: power [--cuts N] [--trials N] [--seed N] [--frames N] "
                        "[--folder DIR] [--jobs N] [--lose-syncs 1] [--journal \"MODE SYNC\"]\n");
        return 2;
    }
    panic_prepare(NULL, NULL);
    if (plan.lose_syncs) {
        tape_ignore_syncs();
    }
    const int code = run(&plan);
    remove_folder(plan.folder);
    return code;
}
