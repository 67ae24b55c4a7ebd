/* replay_initial_state.c -- serializes the initial state and the growth lab's catalog, and
 * compresses runs of zeros. The tables of the core's structs (core/game/game_fields.h) give the
 * members, and one function serves both directions.
 *
 * In the compressed form, a byte n < 128 is followed by n + 1 literal bytes. A byte n >= 128
 * represents n - 126 zeros. */
#include "platform/replay/replay.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game_fields.h"
#include "platform/replay/replay_format.h"

#define PLAIN_MAX 128u
#define ZEROS_MIN 2u
#define ZEROS_MAX 129u

/* Maximum size in bytes of all serialized fields before compression. In the worst case, compression
 * adds one byte for each PLAIN_MAX bytes, so the compressed size is less than
 * REPLAY_INITIAL_STATE_MAX. */
#define FIELDS_MAX (REPLAY_INITIAL_STATE_MAX / 4u * 3u)
_Static_assert(sizeof(struct persistent_state) + sizeof(struct game_session) + 256u <= FIELDS_MAX,
               "the fields are no more than they hold");

/* ---- Fields of the initial state ------------------------------------------------------------- */

/* Serializes the members of `object` in their order in memory. Members that are listed with
 * FIELD_LATER() or FIELD_SINCE() do not exist in recordings of older formats. */
static void walk_fields(struct replay_serializer *walk, const struct field_table *table,
                        void *object)
{
    struct field_cursor cursor = field_begin(table, object, true);
    const uint8_t *at = NULL;
    for (const struct field *field; (field = field_next(&cursor, &at)) != NULL;) {
        if (field->form != FORM_SKIPPED && field->since <= walk->version) {
            const size_t offset = (size_t)(at - (const uint8_t *)object);
            replay_serialize_bytes(walk, (uint8_t *)object + offset, field->size);
        }
    }
}
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "numbers of a board are those of a file");

/* Returns the number of settings in recordings of format `version`. Newer settings follow the older
 * settings. */
static uint32_t count_settings(uint32_t version)
{
    uint32_t count = SETTING_COUNT;
    while (count > 0 && settings_entry(count - 1u)->since > version) {
        count--;
    }
    return count;
}

static void walk_memory(struct replay_serializer *walk, struct persistent_state *memory)
{
    walk_fields(walk, &ledger_start_fields, &memory->ledger);
    const uint32_t setting_count = count_settings(walk->version);
    for (uint32_t id = 0; id < setting_count; id++) { /* A setting is stored as the difference from
                                                         its default. */
        const uint32_t standard = (uint32_t)settings_entry(id)->standard;
        uint32_t away = (uint32_t)memory->settings.value[id] - standard;
        replay_serialize_u32(walk, &away);
        memory->settings.value[id] = (int32_t)(away + standard);
    }
    walk_fields(walk, &audits_fields, &memory->audits);
    walk_fields(walk, &ranking_fields, &memory->ranking);
    struct rank_row *easier = &memory->ranking.row[MODE_COUNT][0][0];
    for (uint32_t i = 0; i < RANK_EASIER_ROWS && walk->version >= 9u; i++) {
        walk_fields(walk, &rank_row_fields, &easier[i]);
    }
}

/* Clears the fields of the ledger and of its balances that did not exist in format `version`. The
 * bytes of these fields were padding in that format. */
static void clear_later_fields(struct ledger *ledger, uint32_t version)
{
    ledger->store_came_late = version < 9u ? 0u : ledger->store_came_late;
    if (version > 7u) {
        return;
    }
    struct balance *const balances[] = { &ledger->balance, &ledger->committed };
    for (uint32_t i = 0; i < LEDGER_RING + 2u; i++) {
        struct balance *balance = i < LEDGER_RING ? &ledger->after[i] : balances[i - LEDGER_RING];
        balance->returned = 0;
        balance->tickets = 0;
    }
}

/* Serializes `edit`, the settings whose values the ledger has logged. Older formats lack the last
 * settings, whose defaults are 0. */
static void walk_settings_edit(struct replay_serializer *walk, struct settings_edit *edit)
{
    const size_t size = count_settings(walk->version) * sizeof edit->logged.value[0];
    replay_serialize_bytes(walk, &edit->logged, size);
    replay_serialize_bytes(walk, &edit->turn_tick, sizeof *edit - sizeof edit->logged);
}
_Static_assert(offsetof(struct settings_edit, turn_tick) == sizeof(struct settings),
               "the last logged setting precedes the other members");

/* Serializes the game session. Its ledger, credit and settings are copied as they are in memory,
 * because they contain only integers and have the same layout on every supported board. */
static void walk_session(struct replay_serializer *walk, struct game_session *session)
{
    const bool is_7 = walk->version == 7u;
    replay_serialize_bytes(walk, session, offsetof(struct game_session, ledger));
    replay_serialize_bytes(walk, &session->ledger, sizeof session->ledger);
    replay_serialize_bytes(walk, &session->credit,
                           is_7 ? offsetof(struct credit, stand_id) : sizeof session->credit);
    replay_serialize_bytes(walk, &session->health_log,
                           is_7 ? offsetof(struct health_log, away_ticks)
                                : sizeof session->health_log);
    clear_later_fields(&session->ledger, walk->version);
    walk_settings_edit(walk, &session->settings_edit);
    if (!is_7) {
        replay_serialize_bytes(walk, &session->language, sizeof session->language);
    }
}

/* Serializes config->rules: the format version whose rules the recorded game follows (0 means the
 * current rules). A recording may have a newer format than its rules, because an older recording is
 * rewritten when the operator's PIN is removed from it (platform/kiosk/recorder/pin_sweep.h). */
static void walk_rules(struct replay_serializer *walk, struct core_config *config)
{
    if (walk->version == 7u) {
        config->rules = 7u;
        return;
    }
    replay_serialize_u8(walk, &config->rules);
    if (walk->version == 8u) {
        /* In format 8, the byte is 1 for the rules of format 7 and 0 for the rules of format 8. */
        walk->bad |= config->rules > 1u;
        config->rules = config->rules == 1u ? 7u : 8u;
    }
    const bool is_own = config->rules == 0 && walk->version < REPLAY_VERSION;
    config->rules = is_own ? (uint8_t)walk->version : config->rules;
    walk->bad |= config->rules != 0 && (config->rules < 7u || config->rules >= REPLAY_VERSION);
}

static void walk_config(struct replay_serializer *walk, struct core_config *config)
{
    walk_fields(walk, &core_config_fields, config);
    walk_memory(walk, &config->persistent);
    walk_session(walk, &config->session);
    walk_rules(walk, config);
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

static size_t pack(const uint8_t *bytes, size_t size, uint8_t *out)
{
    size_t at = 0, used = 0;
    while (at < size) {
        const size_t zeros = run_of_zeros(bytes + at, size - at);
        size_t others = 0; /* `others` is the number of literal bytes before the next run of at
                              least ZEROS_MIN zeros. */
        while (zeros < ZEROS_MIN && at + others < size && others < PLAIN_MAX &&
               run_of_zeros(bytes + at + others, size - at - others) < ZEROS_MIN) {
            others++;
        }
        out[used++] = (uint8_t)(others > 0 ? others - 1u : zeros - ZEROS_MIN + PLAIN_MAX);
        memcpy(out + used, bytes + at, others);
        used += others;
        at += others > 0 ? others : zeros;
    }
    CORE_ASSERT(at == size);
    return used;
}

/* Decompresses `size` bytes to `out`. Returns the decompressed size, or 0 if it would be more than
 * `max` or if the data end within a series of literal bytes. */
static size_t unpack(const uint8_t *bytes, size_t size, uint8_t *out, size_t max)
{
    size_t at = 0, count = 0;
    while (at < size) {
        const uint8_t head = bytes[at++];
        const bool is_plain = head < PLAIN_MAX;
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
    CORE_ASSERT(at == size && count <= max);
    return count;
}

/* ---- Encoding and decoding ----------------------------------------------------------------- */

size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX])
{
    /* The serializer needs a non-const pointer because it also reads. Therefore a copy of the
     * configuration is serialized. */
    struct core_config copy = *config;
    uint8_t fields[FIELDS_MAX];
    struct replay_serializer walk = { .out = fields,
                                      .size = sizeof fields,
                                      .version = REPLAY_VERSION };
    walk_config(&walk, &copy);
    CORE_ASSERT(!walk.bad);
    return pack(fields, walk.at, out);
}

bool replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                 uint32_t version)
{
    CORE_ASSERT(version >= REPLAY_VERSION_MIN && version <= REPLAY_VERSION);
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

/* ---- Catalog of the growth lab ------------------------------------------------------------- */

static void walk_book(struct replay_serializer *walk, struct lab_book *book)
{
    replay_serialize_u8(walk, &book->card_count);
    replay_serialize_u8(walk, &book->refused);
    replay_serialize_bytes(walk, book->has_edit, sizeof book->has_edit);
    for (uint32_t i = 0; i < book->card_count && i < SPECIES_EXTRA_MAX; i++) {
        walk_fields(walk, &species_card_fields, &book->cards[i]);
    }
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        if (book->has_edit[i]) {
            walk_fields(walk, &lab_edit_fields, &book->edits[i]);
        }
    }
}

size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX])
{
    /* The serializer needs a non-const pointer because it also reads. Therefore a copy of the
     * catalog is serialized. */
    struct lab_book copy = *book;
    struct replay_serializer walk = { .out = out, .size = REPLAY_CATALOG_MAX };
    uint32_t edits = 0;
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        edits += book->has_edit[i] != 0;
    }
    if (book->card_count == 0 && book->refused == 0 && edits == 0) {
        return 0;
    }
    walk_book(&walk, &copy);
    return walk.bad ? 0 : walk.at;
}

bool replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size)
{
    struct replay_serializer walk = { .in = bytes, .size = size };
    *book = (struct lab_book){ 0 };
    walk_book(&walk, book);
    if (walk.bad || walk.at != size || !lab_book_is_valid(book)) {
        *book = (struct lab_book){ 0 };
        return false;
    }
    return true;
}
