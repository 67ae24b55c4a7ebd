/* test_core_hash.c -- checks that the core's hash depends on every member of the state except
 * scratch memory.
 *
 * For each struct, the core has a table of its members, and the hash reads only the members in
 * these tables. A test therefore checks that no table lacks a member: between two listed members,
 * only padding for alignment is allowed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/game_fields.h"
#include "core/poi/poi_fields.h"
#include "core/tank/tank_fields.h"

static struct core core, twin;

/* Tables that core_hash() reads, each with an object that it describes. */
static const struct root {
    const struct field_table *table;
    void *object;
} roots[] = {
    { &core_config_fields, &core.config },
    { &ledger_start_fields, &core.config.persistent.ledger },
    { &ranking_fields, &core.config.persistent.ranking },
    { &game_session_fields, &core.config.session },
    { &settings_edit_fields, &core.config.session.settings_edit },
    { &lab_book_fields, &core.config.book },
    { &game_fields, &core.game },
    { &ranking_fields, &core.game.accounts.ranking },
    { &settings_edit_fields, &core.game.settings_edit },
    { &lab_saved_fields, &core.game.lab },
    { &audits_fields, &core.config.persistent.audits },
    { &audits_fields, &core.game.accounts.audits },
    { &poi_fields, &core.world.poi[0] },
    { &poi_fields, &core.world.poi[3] },
    { &bowl_fields, &core.world.bowl[0] },
    { &bowl_fields, &core.world.bowl[3] },
    { &tank_fields, &core.world.tank },
    { &settings_fields, &core.config.persistent.settings },
};
#define ROOT_COUNT (sizeof roots / sizeof roots[0])

/* Members that core_hash() reads without a table. Their bytes are encoded in the same way as in a
 * recording. */
#define PART(place) { #place, &core.place, sizeof core.place }
static const struct part {
    const char *name;
    void *at;
    size_t size;
} parts[] = {
    PART(game.tick),
    PART(game.settings_edit.logged),
    PART(config.session.settings_edit.logged),
    PART(config.session.language.chosen),
    PART(config.session.language.until_tick),
    PART(config.persistent.ranking.row[MODE_COUNT][0][0].caught),
    PART(game.accounts.ranking.row[RANK_BOARD_COUNT - 1u][2][9].name),
};

static int setup(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 7, .fish_count = 12 };
    static struct output output;
    const struct input input = { 0 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    for (uint32_t i = 0; i < 100; i++) {
        core_tick(&core, &input, &output);
    }
    /* Marks two elements as used in each of the arrays of carried fish, loads and near pairs, so
     * that the hash includes them. */
    core.world.poi[0].carried_count = 2;
    core.world.poi[0].load_count = 2;
    core.world.tank.broad_phase.near_count = 2;
    return 0;
}

static size_t align_up(size_t offset, size_t align)
{
    return (offset + align - 1u) / align * align;
}

/* Checks that the members of a table have no gaps between them in memory. The table lists its
 * members in the order of the hash, so this function searches it in the order of memory. */
static void check_members(const struct field_table *table)
{
    uint32_t end = 0, align_max = 1;
    uint32_t listed = 0;
    for (uint32_t i = 0; i < table->count; i++) {
        listed += table->fields[i].form != FORM_AGAIN;
    }
    for (uint32_t found = 0; found < listed; found++) {
        const struct field *next = NULL;
        for (uint32_t i = 0; i < table->count; i++) {
            const struct field *field = &table->fields[i];
            if (field->form != FORM_AGAIN && field->offset >= end &&
                (!next || field->offset < next->offset)) {
                next = field;
            }
        }
        if (!next || next->offset != align_up(end, next->align)) {
            fail_msg("a member of %s before offset %u is not listed, or listed twice", table->name,
                     next ? next->offset : table->size);
        }
        if (next->table && next->size % next->table->size != 0) {
            fail_msg("%s.%s has the table of another struct", table->name, next->name);
        }
        end = next->offset + next->size;
        align_max = next->align > align_max ? next->align : align_max;
    }
    if (align_up(end, align_max) != table->size) {
        fail_msg("a member of %s after offset %u is not listed", table->name, end);
    }
}

/* Skips lab_saved_fields, because this table lists only a part of struct lab. The complete table of
 * struct lab belongs to the tables of the game. */
static void test_every_member_is_in_the_tables_of_the_core(void **state)
{
    (void)state;
    for (size_t r = 0; r < ROOT_COUNT; r++) {
        const struct field_table *open[32] = { roots[r].table };
        for (size_t at = 0, count = 1; at < count; at++) {
            if (open[at] != &lab_saved_fields) {
                check_members(open[at]);
            }
            for (uint32_t i = 0; i < open[at]->count; i++) {
                const struct field_table *inner = open[at]->fields[i].table;
                int is_known = inner == NULL;
                for (size_t k = 0; k < count; k++) {
                    is_known |= open[k] == inner;
                }
                if (!is_known) {
                    assert_true(count < sizeof open / sizeof open[0]);
                    open[count++] = inner;
                }
            }
        }
    }
}

/* Computes the hash of an object by its table, or of the whole core if `table` is null. Returns 1
 * if the hash was written. Returns 0 if an assertion of the core failed because the state is
 * invalid. */
static int hash_if_valid(const struct field_table *table, const void *object, uint64_t *hash)
{
    if (setjmp(global_expect_assert_env) != 0) {
        global_expecting_assert = 0;
        return 0;
    }
    global_expecting_assert = 1;
    *hash = table ? field_hash(HASH_START, table, object) : core_hash(&core);
    global_expecting_assert = 0;
    return 1;
}

/* Flips one bit of a byte and requires that the hash changes. Uses the lowest bit for which the
 * state stays valid. If no such bit exists, the check passes, because the core reads the byte. */
static void flip(const char *name, uint8_t *byte, uint64_t before)
{
    for (uint32_t bit = 0; bit < 8u; bit++) {
        uint64_t after = before;
        *byte ^= (uint8_t)(1u << bit);
        const int is_valid = hash_if_valid(NULL, NULL, &after);
        *byte ^= (uint8_t)(1u << bit);
        if (is_valid) {
            if (after == before) {
                fail_msg("the hash does not depend on %s", name);
            }
            return;
        }
    }
}

static void flip_ends(const char *name, uint8_t *bytes, size_t size, uint64_t before)
{
    flip(name, bytes, before);
    flip(name, bytes + size / 2u, before);
    flip(name, bytes + size - 1u, before);
}

/* Returns the size in bytes of the used elements of an array member of `object`. */
static size_t used_size(const struct field *field, const uint8_t *object)
{
    uint32_t used = field->count;
    if (field->count_offset != FIELD_ALL_USED) {
        memcpy(&used, object + field->count_offset, sizeof used);
    }
    return (size_t)used * field->unit;
}

/* Computes the hash of the whole core only for a few bytes, because it is much slower than the hash
 * of the changed object. */
static void test_the_hash_depends_on_every_member_of_the_tables(void **state)
{
    (void)state;
    const uint64_t before = core_hash(&core);
    for (size_t r = 0; r < ROOT_COUNT; r++) {
        uint8_t *object = roots[r].object;
        const uint64_t alone = field_hash(HASH_START, roots[r].table, object);
        struct field_cursor cursor = field_begin(roots[r].table, object, true);
        const uint8_t *at = NULL;
        uint8_t *last = NULL;
        for (const struct field *field; (field = field_next(&cursor, &at)) != NULL;) {
            const size_t size = used_size(field, cursor.level[cursor.depth - 1u].object);
            const size_t changed[] = { 0, size / 2u, size - 1u };
            for (uint32_t i = 0; i < 3u && field->form != FORM_SKIPPED; i++) {
                last = object + (at - object) + changed[i];
                *last ^= 1u;
                uint64_t after = alone;
                if (hash_if_valid(roots[r].table, object, &after) && after == alone) {
                    fail_msg("the hash does not depend on %s", field->name);
                }
                *last ^= 1u;
            }
        }
        flip(roots[r].table->name, last, before);
    }
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        flip_ends(parts[i].name, parts[i].at, parts[i].size, before);
    }
    assert_true(core_hash(&core) == before);
}

static void test_the_hash_depends_on_the_element_counts(void **state)
{
    (void)state;
    uint32_t *const counts[] = { &core.world.poi[0].carried_count, &core.world.poi[0].load_count,
                                 &core.world.tank.fish_count,
                                 &core.world.tank.broad_phase.near_count };
    const uint64_t before = core_hash(&core);
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        (*counts[i])--;
        assert_true(core_hash(&core) != before);
        (*counts[i])++;
    }
}

/* Overwrites the scratch memory, which is not part of the hash, and checks that the state develops
 * in the same way. Otherwise two states with equal hashes could differ later. */
static void test_overwritten_scratch_memory_does_not_change_the_hash(void **state)
{
    (void)state;
    static struct output output;
    const struct input input = { .pressed = INPUT_START };
    core.world.poi[0].carried_count = core.world.poi[0].load_count = 0;
    core.world.tank.broad_phase.near_count = 0;
    twin = core;
    /* In a tick with this number all fish update their perception, which overwrites the scratch
     * memory. */
    assert_int_equal(core.game.tick % BROAD_PHASE_UPDATE_TICKS, 0);
    memset(&twin.world.tank.broad_phase, 0x5a, sizeof twin.world.tank.broad_phase);
    memset(&twin.world.tank.solver, 0x5a, sizeof twin.world.tank.solver);
    memset(&twin.world.tear_clip, 0x5a, sizeof twin.world.tear_clip);
    memset(&twin.world.near_miss, 0x5a, sizeof twin.world.near_miss);
    for (uint32_t i = 0; i < 100; i++) {
        core_tick(&core, &input, &output);
        core_tick(&twin, &input, &output);
    }
    assert_true(core_hash(&core) == core_hash(&twin));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_every_member_is_in_the_tables_of_the_core, setup),
        cmocka_unit_test_setup(test_the_hash_depends_on_every_member_of_the_tables, setup),
        cmocka_unit_test_setup(test_the_hash_depends_on_the_element_counts, setup),
        cmocka_unit_test_setup(test_overwritten_scratch_memory_does_not_change_the_hash, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
