/* witness.c -- prints the data that a kiosk had committed before it lost power, as its recording
 * shows them.
 *
 * Usage: witness RECORDING
 *
 * Runs the core on the recorded inputs (twin.h) and prints three kinds of lines:
 *
 * start LAST_ID BOOT UNITS PAID SERVICE OPEN: the state that the kiosk loaded at its start.
 *
 * entry ID BOOT TICK KIND DETAIL COUNT VALUE UNITS BONUS PAID SERVICE UNTOLD OPEN: a ledger entry.
 *
 * end TICKS ACKNOWLEDGED_ID NEWEST_ID COINS: the end of the recording.
 *
 * The kiosk writes the recording once a second, so the acknowledgements of the last second are
 * missing. Exit code 0 means success, and 65 that another core wrote the recording. */
#include <stdio.h>

#include "platform/store/sqlite/ledger_file.h"
#include "tests/vm/twin.h"

static struct replay_reader reader;
static struct core core;
/* The reader, the core and the output are static, because their size is some megabytes. */
static struct output output;

/* Prints the balance in the columns of the database, of which `open` contains three fields. */
static void print_balance(const struct balance *balance)
{
    const uint32_t open = balance->open | (uint32_t)balance->returned << LEDGER_RETURNED_SHIFT |
                          (uint32_t)balance->tickets << LEDGER_TICKETS_SHIFT;
    printf(" %u %u %u %u %u %u\n", balance->units, balance->bonus_units, balance->paid,
           balance->service, balance->unlogged, open);
}

static void print_entries(uint32_t from_id)
{
    for (uint32_t id = from_id + 1; id <= output.entry_id; id++) {
        const struct ledger_entry *entry = &output.entries[id % LEDGER_RING];
        printf("entry %u %u %u %u %u %u %d", entry->id, entry->boot, entry->tick, entry->kind,
               entry->detail, entry->count, entry->value);
        print_balance(&entry->balance);
    }
}

static uint32_t sum_of_coins(const struct input *input)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < COIN_LINE_COUNT; i++) {
        sum += input->coin_count[i];
    }
    return sum;
}

int main(int argc, char **argv)
{
    struct input input = { 0 };
    uint32_t coins = 0;
    if (argc != 2) {
        fprintf(stderr, "usage: witness RECORDING\n");
        return 2;
    }
    if (replay_open(&reader, argv[1]) || core_init(&core, &reader.header.config) != CORE_OK) {
        fprintf(stderr, "witness: %s: %s\n", argv[1], reader.problem.text);
        return 65;
    }
    const struct ledger_start *start = &reader.header.config.persistent.ledger;
    printf("start %u %u", start->last_id, start->boots);
    print_balance(&start->balance);
    output.entry_id = start->last_id;
    while (replay_next(&reader, &input) == 1) {
        const uint32_t before = output.entry_id;
        twin_tick(&core, &input, &output);
        if (reader.has_digest && (uint32_t)core_hash_quick(&core) != reader.digest) {
            fprintf(stderr, "witness: tick %u is not the kiosk's\n", reader.tick);
            return 65;
        }
        print_entries(before);
        coins += sum_of_coins(&input);
    }
    printf("end %u %u %u %u\n", reader.tick, core.game.accounts.ledger.saved_id, output.entry_id,
           coins);
    return 0;
}
