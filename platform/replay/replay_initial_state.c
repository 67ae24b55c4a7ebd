/* replay_initial_state.c -- serializes the initial state and compresses runs of zeros. One function
 * per structure both reads and writes.
 *
 * In the compressed form, a byte n < 128 is followed by n + 1 literal bytes. A byte n >= 128
 * represents n - 126 zeros. */
#include "platform/replay/replay_initial_state.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/accounting/ledger_range.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_serializer.h"

#define PLAIN_MAX 128u
#define ZEROS_MIN 2u
#define ZEROS_MAX 129u

/* Maximum size of all serialized fields in bytes. Compression adds at most one byte for each
 * PLAIN_MAX bytes. */
#define FIELDS_MAX (REPLAY_INITIAL_STATE_MAX / 2u)
_Static_assert(sizeof(struct persistent_state) + sizeof(struct game_session) + 256u <= FIELDS_MAX,
               "the fields are no more than they hold");

/* ---- Fields -------------------------------------------------------------------------------- */

static void walk_purse(struct replay_serializer *walk, struct balance *balance)
{
    replay_serialize_u32(walk, &balance->units);
    replay_serialize_u32(walk, &balance->bonus_units);
    replay_serialize_u32(walk, &balance->paid);
    replay_serialize_u32(walk, &balance->service);
    replay_serialize_u32(walk, &balance->unlogged);
    replay_serialize_u8(walk, &balance->open);
    if (walk->version > 7u) {
        replay_serialize_u8(walk, &balance->returned);
        replay_serialize_u16(walk, &balance->tickets);
    }
}
_Static_assert(sizeof(struct balance) == 24, "the walk knows all of a purse");

static void walk_ledger(struct replay_serializer *walk, struct ledger_start *ledger)
{
    replay_serialize_u32(walk, &ledger->last_id);
    replay_serialize_u32(walk, &ledger->boots);
    walk_purse(walk, &ledger->balance);
    if (walk->version > 7u) {
        uint32_t value = (uint32_t)ledger->stand.value;
        replay_serialize_u32(walk, &ledger->stand.count);
        replay_serialize_u32(walk, &value);
        replay_serialize_u8(walk, &ledger->stand.detail);
        ledger->stand.value = (int32_t)value;
    }
}
_Static_assert(sizeof(struct ledger_start) == 44, "the walk knows all of it");

/* Serializes each setting as the difference from its default. */
static void walk_settings(struct replay_serializer *walk, struct settings *settings)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const uint32_t standard = (uint32_t)settings_entry(id)->standard;
        uint32_t away = (uint32_t)settings->value[id] - standard;
        replay_serialize_u32(walk, &away);
        settings->value[id] = (int32_t)(away + standard);
    }
}

static void walk_row(struct replay_serializer *walk, struct rank_row *row)
{
    replay_serialize_u32(walk, &row->caught);
    replay_serialize_u32(walk, &row->round_id);
    replay_serialize_u16(walk, &row->day);
    replay_serialize_u8(walk, &row->seat);
    replay_serialize_bytes(walk, row->name, sizeof row->name);
    walk->bad |= row->seat >= POI_MAX || row->name[sizeof row->name - 1u] != '\0';
}
_Static_assert(sizeof(struct rank_row) == 44, "the walk knows all of a row");

static void walk_ranking(struct replay_serializer *walk, struct ranking *ranking)
{
    replay_serialize_u32(walk, &ranking->boot);
    replay_serialize_u16(walk, &ranking->day);
    replay_serialize_u16(walk, &ranking->week);
    replay_serialize_u32(walk, &ranking->week_boot);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint32_t i = 0; i < RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            walk_row(walk, &ranking->row[mode][i / RANK_ROWS][i % RANK_ROWS]);
        }
    }
}

static void walk_memory(struct replay_serializer *walk, struct persistent_state *memory)
{
    walk_ledger(walk, &memory->ledger);
    walk_settings(walk, &memory->settings);
    const uint32_t audit_count = walk->version > 7u ? AUDIT_COUNT : AUDIT_FORMAT_7_COUNT;
    for (uint32_t id = 0; id < audit_count; id++) {
        replay_serialize_u32(walk, &memory->audits.count[id]);
    }
    walk_ranking(walk, &memory->ranking);
}

/* Clears the fields that did not exist in the balances of format 7. The bytes of these fields were
 * padding in format 7. */
static void clear_later_fields(struct ledger *ledger)
{
    struct balance *const purses[] = { &ledger->balance, &ledger->committed };
    for (uint32_t i = 0; i < LEDGER_RING + 2u; i++) {
        struct balance *balance = i < LEDGER_RING ? &ledger->after[i] : purses[i - LEDGER_RING];
        balance->returned = 0;
        balance->tickets = 0;
    }
}

/* Serializes the session. Ledger, credit and settings are copied as they are in memory, because
 * they contain only integers and have the same layout on every supported board. */
static void walk_chapter(struct replay_serializer *walk, struct game_session *session)
{
    replay_serialize_u32(walk, &session->tick);
    replay_serialize_u32(walk, &session->command_count);
    replay_serialize_u32(walk, &session->edit_save_id);
    replay_serialize_u32(walk, &session->edit_saved_id);
    const int is_7 = walk->version == 7u;
    replay_serialize_bytes(walk, &session->ledger, sizeof session->ledger);
    replay_serialize_bytes(walk, &session->credit,
                           is_7 ? offsetof(struct credit, stand_id) : sizeof session->credit);
    replay_serialize_bytes(walk, &session->health_log,
                           is_7 ? offsetof(struct health_log, away_ticks)
                                : sizeof session->health_log);
    if (is_7) {
        clear_later_fields(&session->ledger);
    }
    replay_serialize_bytes(walk, &session->settings_edit, sizeof session->settings_edit);
    if (walk->version == 7u) {
        session->language = (struct language_choice){ 0 };
        return;
    }
    replay_serialize_u32(walk, &session->language.chosen);
    replay_serialize_u32(walk, &session->language.until_tick);
}
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes of a board are those of a file");

/* Serializes the rule version. A recording of format 7 sets rules_7, because its game is simulated
 * under the rules of format 7. */
static void walk_rules(struct replay_serializer *walk, uint8_t *rules_7)
{
    if (walk->version == 7u) {
        *rules_7 = 1;
        return;
    }
    replay_serialize_u8(walk, rules_7);
    walk->bad |= *rules_7 > 1u;
}

static void walk_config(struct replay_serializer *walk, struct core_config *config)
{
    replay_serialize_u32(walk, &config->seed);
    replay_serialize_u8(walk, &config->preset);
    replay_serialize_u32(walk, &config->fish_count);
    replay_serialize_u8(walk, &config->language);
    replay_serialize_u32(walk, &config->round_s);
    replay_serialize_u8(walk, &config->modes);
    replay_serialize_u8(walk, &config->grade);
    replay_serialize_u8(walk, &config->players);
    replay_serialize_u8(walk, &config->credit_coins);
    replay_serialize_u8(walk, &config->ticket_fish);
    walk_memory(walk, &config->persistent);
    walk_chapter(walk, &config->session);
    walk_rules(walk, &config->rules_7);
}

/* ---- Compression --------------------------------------------------------------------------- */

static size_t run_of_zeros(const uint8_t *bytes, size_t size)
{
    size_t count = 0;
    while (count < size && count < ZEROS_MAX && bytes[count] == 0) {
        count++;
    }
    return count;
}

/* Returns the number of literal bytes before the next run of at least ZEROS_MIN zeros. */
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

/* Decompresses `size` bytes to `out`. Returns the decompressed size. Returns 0 if this size is more
 * than `max`, or if the data end inside a run. */
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

/* ---- Encoding and decoding ----------------------------------------------------------------- */

size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX])
{
    struct core_config copy = *config; /* The copy is needed because the serializer takes a
                                          non-const pointer. */
    uint8_t fields[FIELDS_MAX];
    struct replay_serializer walk = { .out = fields,
                                      .size = sizeof fields,
                                      .version = REPLAY_VERSION };
    walk_config(&walk, &copy);
    CORE_ASSERT(!walk.bad);
    return pack(fields, walk.at, out);
}

int replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                uint32_t version)
{
    uint8_t fields[FIELDS_MAX];
    config->persistent = (struct persistent_state){ 0 };
    config->session = (struct game_session){ 0 };
    struct replay_serializer walk = { .in = fields,
                                      .size = unpack(bytes, size, fields, FIELDS_MAX),
                                      .version = version };
    walk_config(&walk, config);
    return !walk.bad && ledger_state_is_valid(&config->persistent) &&
           ledger_session_is_valid(&config->session) && walk.at == walk.size;
}
