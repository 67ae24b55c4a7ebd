/* week.c -- runs a week of a festival with the real frame loop, core and store, and checks that
 * memory does not grow.
 *
 * Usage: week [HOURS]. The program simulates HOURS hours (default 168) as fast as possible.
 *
 * From 10 to 21 o'clock players insert coins, play and enter names. At night nobody plays. The tank
 * has one fish, and the number of caught fish is set directly, because swimming is not under test.
 * Every six hours, the program prints the memory in use by the program and by SQLite, the memory
 * obtained from the system, and the size of the store.
 *
 * Returns exit status 1 if the memory in use grew after the first quarter, if a tick was dropped,
 * or if a coin is missing from the store. */
#include <malloc.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/rng.h"
#include "core/game/phases.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/os/number.h"
#include "platform/os/panic.h"
#include "platform/store/storage.h"

#define HOURS 168u
#define FRAMES_PER_HOUR (3600u * 60u)
#define SIXTY_FRAMES_NS 1000000000ull
#define LINE_HOURS 6u
#define OPEN_HOUR 10u
#define CLOSE_HOUR 21u
/* Allowed growth of the memory in use, in bytes. The allowance is for a line of text that a library
 * may be reading at the moment of the measurement. */
#define GROWTH_MAX (4 * 1024)
/* Limit of SQLite's memory in bytes. The limit has room for the page cache of the store (1,024
 * KiB), the page cache of the backup (256 KiB), the statements and the schema. */
#define SQLITE_MAX (1536u * 1024u)

/* Number of bytes that the C library adds to each allocated block. */
#define PIECE_HEAD sizeof(size_t)

static struct kiosk kiosk;
static struct storage store;
static struct hal hal;
static struct clock_sim clock_of_week;
static uint32_t coins;

/* ---- Simulated visitors --------------------------------------------------------------------- */

static uint32_t hour_of_day(void)
{
    return (uint32_t)(clock_of_week.now_ns / SIXTY_FRAMES_NS / 3600u) % 24u;
}

static bool is_open(void)
{
    return hour_of_day() >= OPEN_HOUR && hour_of_day() < CLOSE_HOUR;
}

static int happens(uint32_t what, uint32_t seconds)
{
    const struct rng_key key = { 11, (uint32_t)kiosk.frames, what, RNG_TEST };
    return is_open() && rng_u32(key) % (seconds * 60u) == 0;
}

static int crowd_poll(void *self, struct button_sample *out)
{
    (void)self;
    *out = (struct button_sample){ 0 };
    if (happens(1, 8) && !kiosk.output.coin_lockout) {
        out->coin_count[0] = 1;
        coins++;
    }
    out->pressed = (happens(2, 3) ? (uint32_t)INPUT_START : 0u) |
                   (happens(3, 600) ? (uint32_t)INPUT_SERVICE : 0u) |
                   (happens(4, 7200) ? (uint32_t)INPUT_TEST : 0u);
    return HAL_OK;
}

static const char *crowd_describe(void *self)
{
    (void)self;
    return "a crowd";
}

static int poi_open(void *self)
{
    (void)self;
    return HAL_OK;
}

/* Moves the poi in a circle over the water during the opening hours. */
static int poi_poll(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    const float turn = (float)(kiosk.frames % 628u) * 0.01f;
    if (max == 0 || !is_open()) {
        return 0;
    }
    *out = (struct poi_sample){
        .time_ns = clock_of_week.now_ns,
        .was_stamped = 1,
        .has_wrist = 1,
        .target.position_m = v3(0.15f * f_cos(turn), 0.06f, 0.1f * f_sin(turn)),
    };
    return 1;
}

static int poi_set_force(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_OK;
}

static void poi_set_view(void *self, const struct view *view,
                         const struct display_settings *display_settings, bool scoops)
{
    (void)self;
    (void)view;
    (void)display_settings;
    (void)scoops;
}

static struct hal broad_phase(const char *folder)
{
    static const struct hal_buttons_ops buttons = { .poll = crowd_poll,
                                                    .describe = crowd_describe };
    static const struct hal_poi_ops hand = { .open = poi_open,
                                             .poll = poi_poll,
                                             .set_force = poi_set_force,
                                             .set_view = poi_set_view,
                                             .describe = crowd_describe };
    struct hal all = null_hal(NULL);
    store = (struct storage){ .dir = folder };
    all.clock = sim_clock_device(&clock_of_week);
    all.storage = storage_device(&store);
    all.buttons = (struct hal_buttons){ .ops = &buttons };
    all.poi[0] = (struct hal_poi){ .ops = &hand };
    return all;
}

static void land_fish(void)
{
    if (kiosk.core.game.phase == PHASE_ROUND && happens(5, 4)) {
        const struct catch_result caught[POI_MAX] = { { .landed = 1, .bowled = 1 } };
        game_score(kiosk.core.game.player, &kiosk.core.game.album, &kiosk.core.game,
                   &kiosk.core.world, caught, false, &kiosk.output);
    }
}

/* ---- Measuring memory ----------------------------------------------------------------------- */

struct sample {
    size_t ours, sqlites, resident, file;
};

static size_t file_size(const char *name)
{
    char path[600];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", store.dir, name);
    return stat(path, &about) == 0 ? (size_t)about.st_size : 0;
}

static size_t resident_size(void)
{
    unsigned long pages = 0, resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%lu %lu", &pages, &resident) != 2) {
        resident = 0;
    }
    if (file) {
        fclose(file);
    }
    return resident * (size_t)sysconf(_SC_PAGESIZE);
}

/* Allocates memory for SQLite. These functions replace SQLite's allocator, because SQLite's own
 * counter omits the overhead of its blocks. They count the size that the C library really uses. */
static void *piece_take(int size)
{
    return malloc((size_t)size);
}

static void *piece_resize(void *piece, int size)
{
    return realloc(piece, (size_t)size);
}

static int piece_size(void *piece)
{
    return piece ? (int)malloc_usable_size(piece) : 0;
}

static int piece_round(int size)
{
    return (size + 7) & ~7;
}

static int pieces_begin(void *self)
{
    (void)self;
    return SQLITE_OK;
}

static void pieces_end(void *self)
{
    (void)self;
}

static int count_pieces(void)
{
    const sqlite3_mem_methods methods = {
        .xMalloc = piece_take,
        .xFree = free,
        .xRealloc = piece_resize,
        .xSize = piece_size,
        .xRoundup = piece_round,
        .xInit = pieces_begin,
        .xShutdown = pieces_end,
    };
    return sqlite3_config(SQLITE_CONFIG_MALLOC, &methods);
}

static size_t sqlites_size(void)
{
    sqlite3_int64 pieces = 0, most = 0;
    sqlite3_status64(SQLITE_STATUS_MALLOC_COUNT, &pieces, &most, 0);
    return (size_t)sqlite3_memory_used() + (size_t)pieces * PIECE_HEAD;
}

static struct sample take_sample(void)
{
    return (struct sample){
        .ours = mallinfo2().uordblks,
        .sqlites = sqlites_size(),
        .resident = resident_size(),
        .file = file_size(STORAGE_FILE),
    };
}

static void print_sample(uint32_t hour, const struct sample *sample)
{
    const struct audits *audits = &kiosk.core.game.accounts.audits;
    const uint32_t *count = audits->count;
    printf("  %4u h %7u %7u %7u %9.1f %9.1f %9.1f %9.1f %8llu\n", hour, count[AUDIT_COINS_1],
           count[AUDIT_PLAYS_PAID] + count[AUDIT_PLAYS_SERVICE],
           kiosk.core.game.accounts.ledger.last_id, (double)sample->ours / 1024.0,
           (double)sample->sqlites / 1024.0, (double)sample->resident / 1048576.0,
           (double)sample->file / 1024.0, (unsigned long long)kiosk.pace.dropped);
    fflush(stdout);
}

/* ---- Playing the week ----------------------------------------------------------------------- */

/* Waits until at most LEDGER_RING / 2 entries are not yet committed. The wait is needed because the
 * store's thread writes in real time, whereas the simulation runs several hundred times as fast. */
static void wait_for_store(void)
{
    const struct ledger *ledger = &kiosk.core.game.accounts.ledger;
    while (ledger->last_id - hal.storage.ledger.ops->committed_id(hal.storage.ledger.self) >
           LEDGER_RING / 2u) {
        nanosleep(&(struct timespec){ .tv_nsec = 100000 }, NULL);
    }
}

static void pass_hour(void)
{
    for (uint32_t i = 0; i < FRAMES_PER_HOUR; i++) {
        clock_of_week.now_ns += SIXTY_FRAMES_NS / 60u;
        kiosk_frame(&kiosk, &hal);
        land_fish();
        wait_for_store();
    }
}

static int open_week(const char *folder)
{
    struct kiosk_config config = { .core = { .seed = 3 } };
    clock_of_week.now_ns = SIXTY_FRAMES_NS * 3600u * (OPEN_HOUR - 1u);
    hal = broad_phase(folder);
    if (hal.storage.ledger.ops->open(hal.storage.ledger.self) != HAL_OK) {
        fprintf(stderr, "week: %s\n", hal.storage.ledger.ops->describe(hal.storage.ledger.self));
        return -1;
    }
    settings_reset(&config.core.persistent.settings);
    config.core.persistent.settings.value[SET_PLAY] = PLAY_PAID;
    config.core.persistent.settings.value[SET_MODES] = 1 << MODE_FESTIVAL;
    config.core.persistent.settings.value[SET_ROUND_S] = 60;
    config.core.persistent.settings.value[SET_FISH] = 1;
    config_apply_settings(&config.core, &config.core.persistent.settings);
    return kiosk_init(&kiosk, &hal, &config) == CORE_OK ? 0 : -1;
}

static int holds_all(const char *folder)
{
    static struct persistent_state memory;
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    if (device.ledger.ops->open(device.ledger.self) != HAL_OK) {
        return 0;
    }
    device.ledger.ops->load(device.ledger.self, &memory);
    device.ledger.ops->close(device.ledger.self);
    printf("  %u coins fell, %u are in the store\n", coins, memory.audits.count[AUDIT_COINS_1]);
    return coins > 0 && memory.audits.count[AUDIT_COINS_1] == coins;
}

/* Prints how much the memory in use has grown. SQLite's memory may grow up to a limit, until its
 * page cache is full. All other memory must not grow. */
static int print_growth(const struct sample *first, const struct sample *last, uint32_t since_hour)
{
    const double own = ((double)last->ours - (double)last->sqlites) -
                       ((double)first->ours - (double)first->sqlites);
    const int grew = own > (double)GROWTH_MAX || last->sqlites > SQLITE_MAX;
    printf("  memory in use %s: without SQLite %+.1f KiB since hour %u; SQLite has %.1f of at most "
           "%.1f KiB\n",
           grew ? "grew" : "did not grow", own / 1024.0, since_hour, (double)last->sqlites / 1024.0,
           (double)SQLITE_MAX / 1024.0);
    return grew;
}

static int run(const char *folder, uint32_t hours)
{
    struct sample first = { 0 }, last = { 0 };
    if (open_week(folder) != 0) {
        return 1;
    }
    printf("week: %u hours; in use by our program and its libraries, SQLite's of that, resident, "
           "the store's file\n  %6s %7s %7s %7s %9s %9s %9s %9s %8s\n",
           hours, "", "coins", "rounds", "entries", "KiB", "KiB", "MiB", "KiB", "dropped");
    for (uint32_t hour = 1; hour <= hours; hour++) {
        pass_hour();
        last = take_sample();
        if (hour == (hours + 3u) / 4u) {
            first = last;
        }
        if (hour % LINE_HOURS == 0 || hour == hours) {
            print_sample(hour, &last);
        }
    }
    const uint64_t dropped = kiosk.pace.dropped;
    const uint32_t unwritten = kiosk_close_store(&kiosk, &hal);
    const int holds = holds_all(folder);
    const int grew = print_growth(&first, &last, (hours + 3u) / 4u);
    printf("  %llu ticks dropped, %u unwritten\n", (unsigned long long)dropped, unwritten);
    return grew || dropped > 0 || unwritten > 0 || !holds;
}

/* Starts the program again without the C library's per-thread caches, because freed blocks in these
 * caches would count as memory in use. A new start is needed, because the C library reads the
 * setting before main(). */
static void begin_bare(char **argv)
{
    static const char name[] = "GLIBC_TUNABLES";
    static const char bare[] = "glibc.malloc.tcache_count=0";
    const char *now = getenv(name);
    if (!now || strcmp(now, bare) != 0) {
        setenv(name, bare, 1);
        execv("/proc/self/exe", argv);
    }
}

int main(int argc, char **argv)
{
    uint32_t hours = HOURS;
    char folder[] = "/tmp/kingyo-week-XXXXXX", command[64];
    if (argc > 2 || (argc == 2 && !number_parse(argv[1], 4, 1000, &hours))) {
        fprintf(stderr, "usage: week [HOURS, 4 to 1000]\n");
        return 2;
    }
    begin_bare(argv);
    if (!mkdtemp(folder)) {
        fprintf(stderr, "week: cannot make a folder in /tmp\n");
        return 74;
    }
    panic_prepare(NULL, NULL);
    if (count_pieces() != SQLITE_OK) {
        fprintf(stderr, "week: SQLite does not let its memory be counted\n");
        return 1;
    }
    const int code = run(folder, hours);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command) != 0 || code != 0;
}
