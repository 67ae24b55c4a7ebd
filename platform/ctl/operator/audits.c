/* audits.c -- the command `kingyoctl audits`.
 *
 * The command prints the operator's audit counters, for example coins and rounds, as a table or as
 * JSON. */
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/rules.h"
#include "platform/ctl/operator/books.h"
#include "platform/os/json.h"

static const char name[] = "audits";
#define HOURS 24u
#define DAYS 7u

/* ---- Output as a table ----------------------------------------------------------------------- */

static void print_named(const struct audits *audits, uint32_t begin, uint32_t end)
{
    char key[AUDIT_NAME_SIZE];
    CORE_ASSERT(begin <= end && end <= AUDIT_COUNT);
    for (uint32_t id = begin; id < end; id++) {
        audits_name(id, key);
        printf("  %-20s %10u\n", key, audits->count[id]);
    }
}

/* Prints a row with the mean value `sum` / `count` and its unit, or with "-" if `count` is 0. */
static void print_mean(const char *what, uint32_t sum, uint32_t count, const char *unit)
{
    if (count == 0) {
        printf("  %-20s %10s\n", what, "-");
    } else {
        printf("  %-20s %10.1f %s\n", what, (double)sum / count, unit);
    }
}

static void audits_print_text(const struct persistent_state *memory)
{
    const struct audits *audits = &memory->audits;
    printf("%u entries, start %u; in the machine: paid credits %u, service credits %u,"
           " units %u, tickets owed %u\n",
           memory->ledger.last_id, memory->ledger.boots, memory->ledger.balance.paid,
           memory->ledger.balance.service, memory->ledger.balance.units,
           memory->ledger.balance.tickets);
    puts("\nmoney");
    print_named(audits, 0, AUDIT_PLAYS_PAID);
    print_named(audits, AUDIT_TICKETS_OUT, AUDIT_TICKETS_OUT + 1u);
    puts("\nplay");
    print_named(audits, AUDIT_PLAYS_PAID, AUDIT_PLAYS);
    print_named(audits, AUDIT_ROUNDS_EASIER, AUDIT_COUNT);
    printf("  %-20s %10u\n", "rounds-master", audits_rounds_at(audits->count, LEVEL_MASTER));
    uint32_t plays = 0;
    for (uint32_t i = 0; i < MODE_COUNT * AUDIT_GRADES; i++) {
        plays += audits->count[AUDIT_PLAYS + i];
    }
    print_mean("fish a player", audits->count[AUDIT_CAUGHT], audits->count[AUDIT_PLAYERS], "");
    print_mean("time a round", audits->count[AUDIT_PLAY_S], plays, "s");
    print_mean("a paper's life", audits->count[AUDIT_PAPER_LIFE_S],
               audits->count[AUDIT_PAPERS_TORN], "s");
    printf("\nrounds by paper");
    for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
        printf("%s No. %u", grade == 0 ? "        " : "    ", grade + SHEET_GRADE_MIN);
    }
    putchar('\n');
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        printf("  %-17s", rules_of((uint8_t)mode)->name);
        for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
            printf(" %9u", audits->count[AUDIT_PLAYS + mode * AUDIT_GRADES + grade]);
        }
        putchar('\n');
    }
    static const char *const days[DAYS] = { "Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun" };
    puts("\nrounds by hour");
    for (uint32_t hour = 0; hour < HOURS; hour++) {
        printf("%s%02u:%6u%s", hour % 6u == 0 ? "  " : "   ", hour,
               audits->count[AUDIT_HOUR + hour], hour % 6u == 5u ? "\n" : "");
    }
    puts("\nrounds by weekday");
    for (uint32_t day = 0; day < DAYS; day++) {
        printf("  %s%6u", days[day], audits->count[AUDIT_WEEKDAY + day]);
    }
    putchar('\n');
    puts("\nmachine");
    print_named(audits, AUDIT_BOOTS, AUDIT_TICKETS_OUT);
}

/* ---- Output as JSON -------------------------------------------------------------------------- */

static void print_json(const struct persistent_state *memory)
{
    const struct ledger_start *ledger = &memory->ledger;
    struct json json = { .file = stdout };
    char key[AUDIT_NAME_SIZE];
    json_print(&json,
               "{entries: %u, start: %u, paid: %u, service: %u, units: %u, tickets_owed: %u,"
               "\n audits: {",
               ledger->last_id, ledger->boots, ledger->balance.paid, ledger->balance.service,
               ledger->balance.units, ledger->balance.tickets);
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        audits_name(id, key);
        json_line(&json, 2);
        json_value(&json, key, "%u", memory->audits.count[id]);
    }
    json_line(&json, 2);
    json_value(&json, "rounds-master", "%u", audits_rounds_at(memory->audits.count, LEVEL_MASTER));
    json_print(&json, "\n }}");
    json_end(&json);
}

static enum exit_code audits_run(int argc, const char *const *argv)
{
    struct books_words words = { 0 };
    struct ledger_file file;
    enum exit_code code = ctl_options(name, &books_options, 0, &words, argc, argv);
    code = code == EXIT_OK ? books_open(name, &words, &file) : code;
    if (code == EXIT_OK) {
        (words.as_json ? print_json : audits_print_text)(&file.content.memory);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_audits = {
    .name = name,
    .summary = "the operator's audits: what was earned, played and broken",
    .usage = "  kingyoctl audits [--data DIR] [--json]\n",
    .options = &books_options,
    .run = audits_run,
};
