/* replay_initial_state.c -- serializes the initial state and the growth lab's catalog, and
 * compresses runs of zeros. One function per structure both reads and writes.
 *
 * In the compressed form, a byte n < 128 is followed by n + 1 literal bytes. A byte n >= 128
 * represents n - 126 zeros. */
#include "platform/replay/replay_initial_state.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/accounting/ledger_writer.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_format.h"

#define PLAIN_MAX 128u
#define ZEROS_MIN 2u
#define ZEROS_MAX 129u

/* Maximum size of all serialized fields in bytes. Compression adds at most one byte for each
 * PLAIN_MAX bytes. */
#define FIELDS_MAX (REPLAY_INITIAL_STATE_MAX / 2u)
_Static_assert(sizeof(struct persistent_state) + sizeof(struct game_session) + 256u <= FIELDS_MAX,
               "the fields are no more than they hold");

/* ---- Fields of the initial state ------------------------------------------------------------- */

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

static void walk_memory(struct replay_serializer *walk, struct persistent_state *memory)
{
    walk_ledger(walk, &memory->ledger);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) { /* A setting is stored as the difference from
                                                         its default. */
        const uint32_t standard = (uint32_t)settings_entry(id)->standard;
        uint32_t away = (uint32_t)memory->settings.value[id] - standard;
        replay_serialize_u32(walk, &away);
        memory->settings.value[id] = (int32_t)(away + standard);
    }
    const uint32_t audit_count = walk->version > 7u ? AUDIT_COUNT : AUDIT_FORMAT_7_COUNT;
    for (uint32_t id = 0; id < audit_count; id++) {
        replay_serialize_u32(walk, &memory->audits.count[id]);
    }
    replay_serialize_u32(walk, &memory->ranking.boot);
    replay_serialize_u16(walk, &memory->ranking.day);
    replay_serialize_u16(walk, &memory->ranking.week);
    replay_serialize_u32(walk, &memory->ranking.week_boot);
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        walk_row(walk, &memory->ranking.row[i / (RANK_PERIOD_COUNT * RANK_ROWS)]
                                           [i / RANK_ROWS % RANK_PERIOD_COUNT][i % RANK_ROWS]);
    }
}

/* Clears the fields of the balances that did not exist in format 7. The bytes of these fields were
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
    if (walk->version == 7u) {
        /* The player's game in a recording of format 7 was played under older rules. Therefore the
         * replay also uses the rules of format 7. */
        config->rules_7 = 1;
        return;
    }
    replay_serialize_u8(walk, &config->rules_7);
    walk->bad |= config->rules_7 > 1u;
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
    CORE_ASSERT(at == size && count <= max);
    return count;
}

/* ---- Encoding and decoding ----------------------------------------------------------------- */

size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX])
{
    struct core_config copy = *config; /* The serializer takes a non-const pointer, so a copy of the
                                          configuration is serialized. */
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

static void walk_graph(struct replay_serializer *walk, struct graph *graph)
{
    replay_serialize_u8(walk, &graph->knot_count);
    replay_serialize_u8(walk, &graph->line);
    replay_serialize_u8(walk, &graph->solved);
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        replay_serialize_floats(walk, &graph->knots[i].progress, 1);
        replay_serialize_floats(walk, graph->knots[i].weight, MORPH_KEY_MAX);
    }
}

static void walk_scale(struct replay_serializer *walk, struct scale_knot knots[GRAPH_KNOT_MAX])
{
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        replay_serialize_floats(walk, &knots[i].progress, 1);
        replay_serialize_floats(walk, &knots[i].length_m, 1);
    }
}

static void walk_growth(struct replay_serializer *walk, struct growth *growth)
{
    replay_serialize_floats(walk, &growth->length_inf_m, 1);
    replay_serialize_floats(walk, &growth->k_per_year, 1);
    replay_serialize_floats(walk, &growth->t0_year, 1);
    replay_serialize_floats(walk, &growth->fade_year, 1);
    replay_serialize_u32(walk, &growth->point_count);
    for (uint32_t i = 0; i < GROWTH_POINT_MAX; i++) {
        replay_serialize_floats(walk, &growth->points[i].age_days, 1);
        replay_serialize_floats(walk, &growth->points[i].length_m, 1);
    }
}

static void walk_card(struct replay_serializer *walk, struct species_card *card)
{
    replay_serialize_bytes(walk, card->id, sizeof card->id);
    replay_serialize_u8(walk, &card->key_count);
    replay_serialize_u8(walk, &card->measure);
    replay_serialize_u8(walk, &card->motion);
    replay_serialize_u8(walk, &card->form);
    replay_serialize_bytes(walk, card->thesis_key, sizeof card->thesis_key);
    replay_serialize_u8(walk, &card->thesis_template);
    replay_serialize_bytes(walk, card->key_names, sizeof card->key_names);
    replay_serialize_floats(walk, card->key_age_days, MORPH_KEY_MAX);
    replay_serialize_floats(walk, card->key_length_m, MORPH_KEY_MAX);
    walk_growth(walk, &card->growth);
    replay_serialize_u8(walk, &card->scale_knot_count);
    walk_scale(walk, card->scale_knots);
    replay_serialize_u8(walk, &card->curve_count);
    replay_serialize_bytes(walk, card->curve_names, sizeof card->curve_names);
    for (uint32_t i = 0; i < MORPH_CURVE_MAX; i++) {
        walk_graph(walk, &card->curves[i]);
    }
}

static void walk_book(struct replay_serializer *walk, struct lab_book *book)
{
    replay_serialize_u8(walk, &book->card_count);
    replay_serialize_u8(walk, &book->refused);
    replay_serialize_bytes(walk, book->has_edit, sizeof book->has_edit);
    for (uint32_t i = 0; i < book->card_count && i < SPECIES_EXTRA_MAX; i++) {
        walk_card(walk, &book->cards[i]);
    }
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        if (book->has_edit[i]) {
            replay_serialize_u8(walk, &book->edits[i].template_id);
            replay_serialize_u8(walk, &book->edits[i].scale_knot_count);
            walk_graph(walk, &book->edits[i].graph);
            walk_scale(walk, book->edits[i].scale_knots);
        }
    }
}

size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX])
{
    struct lab_book copy = *book; /* The serializer takes a non-const pointer, so a copy of the
                                     catalog is serialized. */
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

int replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size)
{
    struct replay_serializer walk = { .in = bytes, .size = size };
    *book = (struct lab_book){ 0 };
    walk_book(&walk, book);
    if (walk.bad || walk.at != size || !lab_book_is_valid(book)) {
        *book = (struct lab_book){ 0 };
        return 0;
    }
    return 1;
}
