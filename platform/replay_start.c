/* replay_start.c -- serializes the initial state with one function for both directions, and
 * compresses runs of zeros.
 *
 * In the compressed form, a byte n < 128 precedes n + 1 literal bytes, and a byte n >= 128 stands
 * for n - 126 zeros. */
#include "platform/replay_start.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/ledger_range.h"
#include "platform/replay.h"
#include "platform/replay_walk.h"

#define PLAIN_MAX 128u
#define ZEROS_MIN 2u
#define ZEROS_MAX 129u

/* Largest size of all serialized fields. Compression adds at most one byte for each PLAIN_MAX
 * bytes. */
#define FIELDS_MAX (REPLAY_START_MAX / 2u)
_Static_assert(sizeof(struct memory) + sizeof(struct chapter) + 256u <= FIELDS_MAX,
               "the fields are no more than they hold");

/* ---- The fields ----------------------------------------------------------------------------- */

static void walk_purse(struct replay_walk *walk, struct purse *purse)
{
    walk_u32(walk, &purse->units);
    walk_u32(walk, &purse->bonus_units);
    walk_u32(walk, &purse->paid);
    walk_u32(walk, &purse->service);
    walk_u32(walk, &purse->untold);
    walk_u8(walk, &purse->open);
    if (walk->version > 7u) {
        walk_u8(walk, &purse->returned);
        walk_u16(walk, &purse->tickets);
    }
}
_Static_assert(sizeof(struct purse) == 24, "the walk knows all of a purse");

static void walk_ledger(struct replay_walk *walk, struct ledger_start *ledger)
{
    walk_u32(walk, &ledger->last_id);
    walk_u32(walk, &ledger->boots);
    walk_purse(walk, &ledger->purse);
    if (walk->version > 7u) {
        uint32_t value = (uint32_t)ledger->stand.value;
        walk_u32(walk, &ledger->stand.count);
        walk_u32(walk, &value);
        walk_u8(walk, &ledger->stand.detail);
        ledger->stand.value = (int32_t)value;
    }
}
_Static_assert(sizeof(struct ledger_start) == 44, "the walk knows all of it");

/* Stores each setting as the difference from its default. */
static void walk_settings(struct replay_walk *walk, struct settings *settings)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const uint32_t standard = (uint32_t)setting_of(id)->standard;
        uint32_t away = (uint32_t)settings->value[id] - standard;
        walk_u32(walk, &away);
        settings->value[id] = (int32_t)(away + standard);
    }
}

static void walk_row(struct replay_walk *walk, struct rank_row *row)
{
    walk_u32(walk, &row->caught);
    walk_u32(walk, &row->round_id);
    walk_u16(walk, &row->day);
    walk_u8(walk, &row->seat);
    walk_bytes(walk, row->name, sizeof row->name);
    walk->bad |= row->seat >= POI_MAX || row->name[sizeof row->name - 1u] != '\0';
}
_Static_assert(sizeof(struct rank_row) == 44, "the walk knows all of a row");

static void walk_ranking(struct replay_walk *walk, struct ranking *ranking)
{
    walk_u32(walk, &ranking->boot);
    walk_u16(walk, &ranking->day);
    walk_u16(walk, &ranking->week);
    walk_u32(walk, &ranking->week_boot);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint32_t i = 0; i < RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            walk_row(walk, &ranking->row[mode][i / RANK_ROWS][i % RANK_ROWS]);
        }
    }
}

static void walk_memory(struct replay_walk *walk, struct memory *memory)
{
    walk_ledger(walk, &memory->ledger);
    walk_settings(walk, &memory->settings);
    const uint32_t audit_count = walk->version > 7u ? AUDIT_COUNT : AUDIT_FORMAT_7_COUNT;
    for (uint32_t id = 0; id < audit_count; id++) {
        walk_u32(walk, &memory->audits.count[id]);
    }
    walk_ranking(walk, &memory->ranking);
}

/* Clears the bytes that are padding in the balances of format 7. */
static void clear_later_fields(struct ledger *ledger)
{
    struct purse *const purses[] = { &ledger->purse, &ledger->kept };
    for (uint32_t i = 0; i < LEDGER_RING + 2u; i++) {
        struct purse *purse = i < LEDGER_RING ? &ledger->after[i] : purses[i - LEDGER_RING];
        purse->returned = 0;
        purse->tickets = 0;
    }
}

/* Serializes the session. Ledger, credit and settings are copied as in memory: integers only, with
 * the same layout on every supported board. */
static void walk_chapter(struct replay_walk *walk, struct chapter *chapter)
{
    walk_u32(walk, &chapter->tick);
    walk_u32(walk, &chapter->order_count);
    walk_u32(walk, &chapter->edit_save_id);
    walk_u32(walk, &chapter->edit_saved_id);
    const int is_7 = walk->version == 7u;
    walk_bytes(walk, &chapter->ledger, sizeof chapter->ledger);
    walk_bytes(walk, &chapter->credit,
               is_7 ? offsetof(struct credit, stand_id) : sizeof chapter->credit);
    walk_bytes(walk, &chapter->upkeep,
               is_7 ? offsetof(struct upkeep, away_ticks) : sizeof chapter->upkeep);
    if (is_7) {
        clear_later_fields(&chapter->ledger);
    }
    walk_bytes(walk, &chapter->adjust, sizeof chapter->adjust);
    if (walk->version == 7u) {
        chapter->language = (struct language_choice){ 0 };
        return;
    }
    walk_u32(walk, &chapter->language.chosen);
    walk_u32(walk, &chapter->language.until_tick);
}
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes of a board are those of a file");

/* Serializes the rule version. The rules of format 7 stay in force for games that began with
 * them. */
static void walk_rules(struct replay_walk *walk, uint8_t *rules_7)
{
    if (walk->version == 7u) {
        *rules_7 = 1;
        return;
    }
    walk_u8(walk, rules_7);
    walk->bad |= *rules_7 > 1u;
}

static void walk_config(struct replay_walk *walk, struct core_config *config)
{
    walk_u32(walk, &config->seed);
    walk_u8(walk, &config->preset);
    walk_u32(walk, &config->fish_count);
    walk_u8(walk, &config->language);
    walk_u32(walk, &config->round_s);
    walk_u8(walk, &config->modes);
    walk_u8(walk, &config->grade);
    walk_u8(walk, &config->players);
    walk_u8(walk, &config->credit_coins);
    walk_u8(walk, &config->ticket_fish);
    walk_memory(walk, &config->memory);
    walk_chapter(walk, &config->chapter);
    walk_rules(walk, &config->rules_7);
}

/* ---- Packing -------------------------------------------------------------------------------- */

static size_t run_of_zeros(const uint8_t *bytes, size_t size)
{
    size_t count = 0;
    while (count < size && count < ZEROS_MAX && bytes[count] == 0) {
        count++;
    }
    return count;
}

/* Returns the length up to the next run of zeros that is worth a byte of its own. */
static size_t run_of_others(const uint8_t *bytes, size_t size)
{
    size_t count = 0;
    while (count < size && count < PLAIN_MAX &&
           run_of_zeros(bytes + count, size - count) < ZEROS_MIN) {
        count++;
    }
    return count;
}

static size_t pack(const uint8_t *bytes, size_t size, uint8_t *out)
{
    size_t at = 0, used = 0;
    while (at < size) {
        const size_t zeros = run_of_zeros(bytes + at, size - at);
        const size_t others = zeros < ZEROS_MIN ? run_of_others(bytes + at, size - at) : 0;
        out[used++] = (uint8_t)(others > 0 ? others - 1u : zeros - ZEROS_MIN + PLAIN_MAX);
        memcpy(out + used, bytes + at, others);
        used += others;
        at += others > 0 ? others : zeros;
    }
    return used;
}

/* Returns the decompressed size, or 0 if the size is more than `max` or the data ends inside a
 * run. */
static size_t unpack(const uint8_t *bytes, size_t size, uint8_t *out, size_t max)
{
    size_t at = 0, count = 0;
    while (at < size) {
        const uint8_t head = bytes[at++];
        const int is_plain = head < PLAIN_MAX;
        const size_t run = is_plain ? head + 1u : head - PLAIN_MAX + ZEROS_MIN;
        if (count + run > max || (is_plain && at + run > size)) {
            return 0;
        }
        if (is_plain) {
            memcpy(out + count, bytes + at, run);
            at += run;
        } else {
            memset(out + count, 0, run);
        }
        count += run;
    }
    return count;
}

/* ---- Encode and decode ----------------------------------------------------------------------- */

size_t replay_start_encode(const struct core_config *config, uint8_t out[REPLAY_START_MAX])
{
    struct core_config copy = *config; /* Copy, because the serializer takes a non-const pointer. */
    uint8_t fields[FIELDS_MAX];
    struct replay_walk walk = { .out = fields, .size = sizeof fields, .version = REPLAY_VERSION };
    walk_config(&walk, &copy);
    CORE_ASSERT(!walk.bad);
    return pack(fields, walk.at, out);
}

int replay_start_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                        uint32_t version)
{
    uint8_t fields[FIELDS_MAX];
    config->memory = (struct memory){ 0 };
    config->chapter = (struct chapter){ 0 };
    struct replay_walk walk = { .in = fields,
                                .size = unpack(bytes, size, fields, FIELDS_MAX),
                                .version = version };
    walk_config(&walk, config);
    return !walk.bad && ledger_memory_is_good(&config->memory) &&
           ledger_chapter_is_good(&config->chapter) && walk.at == walk.size;
}
