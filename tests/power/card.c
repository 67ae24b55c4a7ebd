/* card.c -- tests that a slow, full or read-only SD card does not disturb the player.
 *
 * Usage: card [SECONDS]
 *
 * Runs the real frame loop, core and store in real time at 60 frames per second. Coins are inserted
 * and rounds begin, while the simulated card goes through several fault modes of SECONDS each
 * (default 6). For each mode, the program prints the longest frame, the dropped ticks, and the
 * times at which the coin slot closed and opened again. The number of entries that are still queued
 * is printed too. Returns exit status 1 if a tick was dropped, or if an accepted coin is not in the
 * store at the end. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/os/clock.h"
#include "platform/os/number.h"
#include "platform/os/panic.h"
#include "platform/store/storage.h"
#include "tests/power/tape.h"

#define FRAME_NS 16666667ull
#define S_NS 1000000000ull
#define EVENTS_MAX 1024u
#define COIN_EACH_NS (S_NS * 7u / 10u)

struct card_state {
    const char *name;
    uint32_t sync_us;
    int error;
};

static const struct card_state card_states[] = {
    { "good, 5 ms a sync", 5000, 0 }, { "slow, 200 ms a sync", 200000, 0 },
    { "full", 5000, ENOSPC },         { "good again", 5000, 0 },
    { "read-only", 5000, EROFS },     { "good again", 5000, 0 },
};
#define STATE_COUNT (sizeof card_states / sizeof card_states[0])

static struct kiosk kiosk;
static struct storage store;
static struct tape tape;
static struct hal hal;
static struct buttons_sim buttons;
static struct pointer_sim poi;
static struct button_event events[EVENTS_MAX];

/* Fills the script of button events with a coin every 0.7 s and a press of START from time to time.
 * A coin of the script is inserted only while the coin slot is open. */
static void fill_script(uint64_t begin_ns, uint64_t length_ns)
{
    uint32_t count = 0;
    for (uint64_t at_ns = 0; at_ns < length_ns && count < EVENTS_MAX; at_ns += COIN_EACH_NS) {
        struct button_event *event = &events[count++];
        event->time_ns = begin_ns + at_ns;
        event->coin_count[0] = 1;
        event->pressed = count % 6u == 0 ? INPUT_START : 0u;
        event->released = INPUT_START;
    }
    buttons =
        (struct buttons_sim){ .clock = clock_device(), .events = events, .event_count = count };
}

static int open_kiosk(const char *folder, uint32_t state_s)
{
    struct kiosk_config config = { .core = { .seed = 3, .round_s = 10 },
                                   .stopwatch = clock_device() };
    const struct hal_clock clock = clock_device();
    store = (struct storage){ .dir = folder };
    hal = null_hal(NULL);
    hal.clock = clock;
    hal.storage = storage_device(&store);
    fill_script(clock.ops->now_ns(clock.self) + S_NS, STATE_COUNT * state_s * S_NS);
    hal.buttons = sim_buttons_device(&buttons);
    pointer_sim_init(&poi, clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    hal.poi[0] = pointer_sim_devices(&poi).poi;
    if (hal.storage.ledger.ops->open(hal.storage.ledger.self) != HAL_OK) {
        fprintf(stderr, "card: %s\n", hal.storage.ledger.ops->describe(hal.storage.ledger.self));
        return -1;
    }
    settings_reset(&config.core.persistent.settings);
    config.core.persistent.settings.value[SET_PLAY] = PLAY_PAID;
    config.core.persistent.settings.value[SET_MODES] = 1 << MODE_FESTIVAL;
    config.core.persistent.settings.value[SET_ROUND_S] = 10;
    config_apply_settings(&config.core, &config.core.persistent.settings);
    return kiosk_init(&kiosk, &hal, &config) == CORE_OK ? 0 : -1;
}

struct seen {
    uint64_t longest_ns, dropped;
    /* Seconds from the start of the fault mode until the coin slot first closed, and until it
     * opened again. A value below 0 means that this did not happen. */
    double closed_s, open_s;
    uint32_t waiting_max, coins;
};

static void frame(struct seen *seen, uint64_t begin_ns, uint64_t *due_ns)
{
    const struct hal_clock clock = clock_device();
    const uint64_t start_ns = clock.ops->now_ns(clock.self);
    const uint8_t was_closed = kiosk.output.coin_lockout;
    kiosk_frame(&kiosk, &hal);
    const uint64_t end_ns = clock.ops->now_ns(clock.self);
    const uint32_t waiting =
        kiosk.core.game.accounts.ledger.last_id - kiosk.core.game.accounts.ledger.saved_id;
    seen->longest_ns = end_ns - start_ns > seen->longest_ns ? end_ns - start_ns : seen->longest_ns;
    seen->waiting_max = waiting > seen->waiting_max ? waiting : seen->waiting_max;
    if (kiosk.output.coin_lockout && !was_closed && seen->closed_s < 0.0) {
        seen->closed_s = (double)(end_ns - begin_ns) / (double)S_NS;
    } else if (!kiosk.output.coin_lockout && was_closed && seen->open_s < 0.0) {
        seen->open_s = (double)(end_ns - begin_ns) / (double)S_NS;
    }
    *due_ns += FRAME_NS;
    *due_ns = *due_ns < end_ns ? end_ns : *due_ns;
    clock_sleep_until(*due_ns);
}

static struct seen watch(const struct card_state *card_state, uint32_t state_s)
{
    const struct hal_clock clock = clock_device();
    const uint64_t begin_ns = clock.ops->now_ns(clock.self), dropped = kiosk.pace.dropped;
    const uint32_t coins = kiosk.core.game.accounts.audits.count[AUDIT_COINS_1];
    struct seen seen = { .closed_s = -1.0, .open_s = -1.0 };
    uint64_t due_ns = begin_ns;
    tape_sync_us(card_state->sync_us);
    tape_fail_writes(card_state->error);
    while (due_ns < begin_ns + state_s * S_NS) {
        frame(&seen, begin_ns, &due_ns);
    }
    seen.dropped = kiosk.pace.dropped - dropped;
    seen.coins = kiosk.core.game.accounts.audits.count[AUDIT_COINS_1] - coins;
    return seen;
}

static void print_time(double seconds)
{
    if (seconds < 0.0) {
        printf("%9s", "-");
    } else {
        printf("%7.2f s", seconds);
    }
}

static void print_row(const struct card_state *card_state, const struct seen *seen)
{
    printf("  %-22s %6.2f ms %8llu %6u %8u", card_state->name, (double)seen->longest_ns / 1e6,
           (unsigned long long)seen->dropped, seen->coins, seen->waiting_max);
    print_time(seen->closed_s);
    print_time(seen->open_s);
    printf("\n");
    fflush(stdout);
}

/* Opens the store again, as a restarted kiosk does. Returns 1 if the loaded state contains all
 * coins. */
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
    const uint32_t is = memory.audits.count[AUDIT_COINS_1];
    const uint32_t should = kiosk.core.game.accounts.audits.count[AUDIT_COINS_1];
    printf("  %u coins were taken, %u are in the store; entry %u of %u\n", should, is,
           memory.ledger.last_id, kiosk.core.game.accounts.ledger.last_id);
    return should > 0 && is == should &&
           memory.ledger.last_id == kiosk.core.game.accounts.ledger.last_id;
}

static int run(const char *folder, uint32_t state_s)
{
    uint64_t dropped = 0;
    tape_begin(&tape, folder, NULL, 0);
    if (open_kiosk(folder, state_s) != 0) {
        return 1;
    }
    printf("card: %u s each; the slot as the frame loop sees it\n"
           "  %-22s %9s %8s %6s %8s %9s %9s\n",
           state_s, "the card", "longest", "dropped", "coins", "waiting", "closed", "open");
    for (size_t i = 0; i < STATE_COUNT; i++) {
        const struct seen seen = watch(&card_states[i], state_s);
        print_row(&card_states[i], &seen);
        dropped += seen.dropped;
    }
    kiosk_close_store(&kiosk, &hal);
    tape_end();
    const int holds = holds_all(folder);
    printf("  %llu ticks dropped\n", (unsigned long long)dropped);
    return dropped > 0 || !holds;
}

int main(int argc, char **argv)
{
    uint32_t state_s = 6;
    char folder[] = "/tmp/kingyo-card-XXXXXX", command[64];
    if (argc > 2 || (argc == 2 && !number_parse(argv[1], 2, 100, &state_s))) {
        fprintf(stderr, "usage: card [SECONDS, 2 to 100]\n");
        return 2;
    }
    if (!mkdtemp(folder)) {
        fprintf(stderr, "card: %s: %s\n", folder, strerror(errno));
        return 74;
    }
    panic_prepare(NULL, NULL);
    const int code = run(folder, state_s);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    if (system(command) != 0) {
        fprintf(stderr, "card: %s: cannot be removed\n", folder);
    }
    tape_free(&tape);
    return code;
}
