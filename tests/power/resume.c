/* resume.c -- opens the store after a power cut, continues to play, and checks the ledger entries
 * that are added. */
#include "tests/power/resume.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "platform/store/storage.h"
#include "tests/power/hour.h"

#define FRAMES (30u * 60u)
#define FRAMES_MAX (20u * FRAMES)

static struct hour morning;
static struct storage store;

static int refuse(char why[LEDGER_TOTALS_WHY_SIZE], const char *what)
{
    snprintf(why, LEDGER_TOTALS_WHY_SIZE, "played on: %.180s", what);
    return -1;
}

static uint32_t credits(const struct balance *balance)
{
    return balance->paid + balance->service;
}

static bool is_reported_back(const struct ledger_totals *before, const struct ledger_entry *entry)
{
    const uint8_t open = before->balance.open, kind = open & PAYMENT_KIND_MASK;
    const uint32_t count =
        !(open & PAYMENT_SPENT) && (kind == PAYMENT_PAID || kind == PAYMENT_SERVICE);
    return entry->kind == LEDGER_REFUND && entry->detail == REFUND_RESTART &&
           entry->count == count && credits(&entry->balance) == credits(&before->balance) + count;
}

/* Returns 1 if `entry` ends the interrupted round without a refund, as required if its credit was
 * already spent (PAYMENT_SPENT). The entry must then have the catch and the tickets that were
 * stored for the round. */
static bool is_kept(const struct ledger_totals *before, const struct ledger_entry *entry)
{
    return (before->balance.open & PAYMENT_SPENT) && before->stand.value >> 16 != 0 &&
           entry->kind == LEDGER_ROUND && entry->detail == ROUND_CUT_OFF &&
           entry->round.caught == (before->stand.count & 255u) &&
           entry->value == (before->stand.value & 0xffff) &&
           entry->balance.tickets == before->balance.tickets + entry->value &&
           credits(&entry->balance) == credits(&before->balance);
}

/* Checks the first ledger entries after the power cut. The first one records the start of the
 * kiosk. If a round was running at the time of the cut, the second one ends or refunds this
 * round. */
static int opens_well(const struct ledger_totals *before, uint32_t last_id,
                      char why[LEDGER_TOTALS_WHY_SIZE])
{
    const struct ledger_entry *boot = &morning.entries[last_id + 1u], *end = boot + 1;
    const int was_open = before->balance.open != PAYMENT_NONE;
    if (boot->kind != LEDGER_BOOT || credits(&boot->balance) != credits(&before->balance)) {
        return refuse(why, "the start is not the first entry, or changed the balance");
    }
    if (was_open && (end->balance.open != PAYMENT_NONE ||
                     (!is_kept(before, end) && !is_reported_back(before, end)))) {
        return refuse(why, "the round that was open was neither refunded nor kept, or not once");
    }
    uint32_t ends = 0;
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        const struct ledger_entry *entry = &morning.entries[id];
        ends += (entry->kind == LEDGER_REFUND && entry->detail == REFUND_RESTART) ||
                (entry->kind == LEDGER_ROUND && entry->detail == ROUND_CUT_OFF);
    }
    return ends == (uint32_t)was_open ? 0 : refuse(why, "what was open ended twice");
}

/* Returns the number of tickets that the entries after `last_id` moved to the dispenser. */
static uint32_t tickets_out(uint32_t last_id)
{
    uint32_t out = 0;
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        out += morning.entries[id].kind == LEDGER_TICKET;
    }
    return out;
}

/* Checks that all tickets that were owed before the cut are dispensed. New rounds may have added
 * further tickets. */
static int pays_tickets(const struct ledger_totals *before, uint32_t last_id,
                        char why[LEDGER_TOTALS_WHY_SIZE])
{
    const uint32_t out = tickets_out(last_id);
    uint32_t owed = before->balance.tickets;
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        const struct ledger_entry *entry = &morning.entries[id];
        owed += entry->kind == LEDGER_ROUND ? (uint32_t)entry->value : 0u;
    }
    /* Balance of tickets in the newest entry that the store has accepted. The core may already have
     * newer entries. */
    const uint32_t left = morning.entries[morning.kept_id].balance.tickets;
    if (out >= before->balance.tickets && out + left == owed) {
        return 0;
    }
    char text[120];
    snprintf(text, sizeof text, "%u tickets came out and %u are left, but %u were owed", out, left,
             owed);
    return refuse(why, text);
}

/* Plays for half a minute of game time, which is long enough to dispense the owed tickets. A ticket
 * is dispensed only after the thread of the store has committed its ledger entry. The frames run
 * faster than real time, so a commit may be late. In this case the function plays on, and sleeps
 * after each frame, until the tickets are dispensed. */
static int play(const char *folder, const struct ledger_totals *before, uint32_t last_id,
                char why[LEDGER_TOTALS_WHY_SIZE])
{
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    if (device.ledger.ops->open(device.ledger.self) != HAL_OK ||
        hour_open(&morning, 1000u + last_id, device) != 0) {
        return refuse(why, device.ledger.ops->describe(device.ledger.self));
    }
    for (uint32_t i = 0;
         i < FRAMES || (i < FRAMES_MAX && tickets_out(last_id) < before->balance.tickets); i++) {
        hour_frame(&morning, device);
        if (i >= FRAMES) {
            usleep(1000);
        }
    }
    return device.ledger.ops->close(device.ledger.self) == 0
               ? 0
               : refuse(why, "entries were not written");
}

int resume_play(const char *folder, const struct ledger_totals *before, uint32_t last_id,
                char why[LEDGER_TOTALS_WHY_SIZE])
{
    struct ledger_totals totals = *before;
    struct persistent_state memory;
    struct ledger_totals_file file;
    char path[300];
    if (play(folder, before, last_id, why) != 0 || opens_well(before, last_id, why) != 0 ||
        pays_tickets(before, last_id, why) != 0) {
        return -1;
    }
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        ledger_totals_add(&totals, &morning.entries[id]);
    }
    memset(&memory, 0, sizeof memory);
    settings_reset(&memory.settings);
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    if (device.ledger.ops->open(device.ledger.self) != HAL_OK) {
        return refuse(why, device.ledger.ops->describe(device.ledger.self));
    }
    device.ledger.ops->load(device.ledger.self, &memory);
    device.ledger.ops->close(device.ledger.self);
    snprintf(path, sizeof path, "%.250s/" STORAGE_FILE, folder);
    if (memory.ledger.last_id != morning.kept_id || ledger_totals_read(path, 0, &file) != 0) {
        return refuse(why, "its entries are not there");
    }
    return ledger_totals_agree(&totals, &memory, &file, why);
}
