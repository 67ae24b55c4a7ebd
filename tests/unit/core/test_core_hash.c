/* test_core_hash.c -- the core's hash sees every simulated field, and nothing that is scratch.
 *
 * Each table of hashed_fields.h names a struct's members in order. One that leaves a member out
 * fails: between two listed members there may be no more than the padding that alignment asks
 * for. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "tests/unit/support/hashed_fields.h"

static struct core core, twin;

struct table {
    const struct field *fields;
    size_t count;
    size_t size; /* Of the struct. */
    void *at;    /* The one whose members are changed. */
};

#define TABLE(type, list, place) { list, sizeof list / sizeof list[0], sizeof(struct type), place }

static const struct table tables[] = {
    TABLE(core, core_fields, &core),
    TABLE(core_config, config_fields, &core.config),
    TABLE(game, game_fields, &core.game),
    TABLE(accounts, accounts_fields, &core.game.accounts),
    TABLE(world, world_fields, &core.world),
    TABLE(lab_book, book_fields, &core.config.book),
    TABLE(species_card, card_fields, &core.config.book.cards[0]),
    TABLE(species_card, card_fields, &core.config.book.cards[SPECIES_EXTRA_MAX - 1u]),
    TABLE(graph, graph_fields, &core.config.book.cards[0].curves[0]),
    TABLE(graph, graph_fields, &core.config.book.cards[0].curves[MORPH_CURVE_MAX - 1u]),
    TABLE(lab_edit, edit_fields, &core.config.book.edits[0]),
    TABLE(graph, graph_fields, &core.config.book.edits[SPECIES_MAX - 1u].graph),
    TABLE(lab, lab_fields, &core.game.lab),
    TABLE(lab_edit, edit_fields, &core.game.lab.edit),
    TABLE(lab_edit, edit_fields, &core.game.lab.edits[SPECIES_MAX - 1u]),
    TABLE(graph, graph_fields, &core.game.lab.edit.graph),
    TABLE(graph, graph_fields, &core.game.lab.edits[0].graph),
    TABLE(menu, menu_fields, &core.game.menu),
    TABLE(calibrate, calibrate_fields, &core.game.menu.calibrate),
    TABLE(calibration_said, calibration_said_fields, &core.game.menu.calibrate.said),
    TABLE(self_test, self_test_fields, &core.game.menu.self),
    TABLE(settings_edit, adjust_fields, &core.game.settings_edit),
    TABLE(persistent_state, memory_fields, &core.config.persistent),
    TABLE(ledger_start, ledger_start_fields, &core.config.persistent.ledger),
    TABLE(balance, purse_fields, &core.config.persistent.ledger.balance),
    TABLE(ledger_stand, stand_fields, &core.config.persistent.ledger.stand),
    TABLE(ledger_stand, stand_fields, &core.game.accounts.credit.stand),
    TABLE(game_session, chapter_fields, &core.config.session),
    TABLE(language_choice, language_choice_fields, &core.config.session.language),
    TABLE(ledger, ledger_fields, &core.config.session.ledger),
    TABLE(credit, credit_fields, &core.config.session.credit),
    TABLE(balance, purse_fields, &core.config.session.ledger.balance),
    TABLE(ledger, ledger_fields, &core.game.accounts.ledger),
    TABLE(balance, purse_fields, &core.game.accounts.ledger.committed),
    TABLE(balance, purse_fields, &core.game.accounts.ledger.after[0]),
    TABLE(balance, purse_fields, &core.game.accounts.ledger.after[LEDGER_RING - 1u]),
    TABLE(balance, purse_fields, &core.game.accounts.ledger.balance),
    TABLE(ranking, ranking_fields, &core.game.accounts.ranking),
    TABLE(name, name_fields, &core.game.name),
    TABLE(rank_row, rank_row_fields, &core.game.accounts.ranking.row[2][2][9]),
    TABLE(rank_row, rank_row_fields, &core.config.persistent.ranking.row[0][0][0]),
    TABLE(credit, credit_fields, &core.game.accounts.credit),
    TABLE(pending_coins, untold_fields, &core.game.accounts.credit.pending_coins[0]),
    TABLE(pending_coins, untold_fields,
          &core.game.accounts.credit.pending_coins[COIN_LINE_COUNT - 1u]),
    TABLE(health_log, upkeep_fields, &core.game.health_log),
    TABLE(health_log, upkeep_fields, &core.config.session.health_log),
    TABLE(album, album_fields, &core.game.album),
    TABLE(album_fish, album_fish_fields, &core.game.album.fish[0]),
    TABLE(album_fish, album_fish_fields, &core.game.album.fish[ALBUM_FISH_MAX - 1u]),
    TABLE(player, player_fields, &core.game.player[0]),
    TABLE(player, player_fields, &core.game.player[3]),
    TABLE(input_validation, trust_fields, &core.game.validation[0]),
    TABLE(input_validation, trust_fields, &core.game.validation[3]),
    TABLE(hints, hints_fields, &core.game.hints),
    TABLE(bot, bot_fields, &core.game.bot[0]),
    TABLE(technique, technique_fields, &core.game.bot[0].technique),
    TABLE(snapshot, look_fields, &core.game.bot[0].known),
    TABLE(snapshot, look_fields, &core.game.bot[3].seen),
    TABLE(snapshot_fish, look_fish_fields, &core.game.bot[0].known.prey),
    TABLE(snapshot_fish, look_fish_fields, &core.game.bot[0].seen.near[SNAPSHOT_NEAR_MAX - 1u]),
    TABLE(snapshot_paper, look_paper_fields, &core.game.bot[0].known.paper),
    TABLE(vision_poi, sight_poi_fields, &core.game.bot[0].known.poi),
    TABLE(vision_bowl, sight_bowl_fields, &core.game.bot[0].known.bowl),
    TABLE(bot, bot_fields, &core.game.bot[3]),
    TABLE(poi, poi_fields, &core.world.poi[0]),
    TABLE(poi, poi_fields, &core.world.poi[3]),
    TABLE(carried_fish, rider_fields, &core.world.poi[0].carried_fish[1]),
    TABLE(sheet_load, load_fields, &core.world.poi[0].loads[1]),
    TABLE(sheet, sheet_fields, &core.world.poi[0].sheet),
    TABLE(sheet, sheet_fields, &core.world.poi[3].sheet),
    TABLE(bowl, bowl_fields, &core.world.bowl[0]),
    TABLE(bowl, bowl_fields, &core.world.bowl[3]),
    TABLE(tank, tank_fields, &core.world.tank),
    TABLE(water, water_fields, &core.world.tank.water),
    TABLE(shade, shade_fields, &core.world.tank.shade[0]),
    TABLE(shade, shade_fields, &core.world.tank.shade[TANK_SHADE_MAX - 1u]),
    TABLE(shade_cast, cast_fields, &core.world.tank.shade[1].cast),
    TABLE(oxygen, oxygen_fields, &core.world.tank.oxygen),
    TABLE(fish, fish_fields, &core.world.tank.fish[0]),
    TABLE(fish, fish_fields, &core.world.tank.fish[11]),
};
#define TABLE_COUNT (sizeof tables / sizeof tables[0])

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
    core.world.poi[0].carried_count = 2; /* As if two fish lay on it. */
    core.world.poi[0].load_count = 2;
    return 0;
}

static size_t align_up(size_t offset, size_t align)
{
    return (offset + align - 1u) / align * align;
}

static void test_every_member_is_in_its_table(void **state)
{
    (void)state;
    for (size_t t = 0; t < TABLE_COUNT; t++) {
        size_t end = 0;
        size_t align_max = 1;
        for (size_t i = 0; i < tables[t].count; i++) {
            const struct field *field = &tables[t].fields[i];
            if (field->offset != align_up(end, field->align)) {
                fail_msg("a member before %s is not listed", field->name);
            }
            end = field->offset + field->size;
            align_max = field->align > align_max ? field->align : align_max;
        }
        if (align_up(end, align_max) != tables[t].size) {
            fail_msg("a member after %s is not listed", tables[t].fields[tables[t].count - 1].name);
        }
    }
}

/* Returns 1 and writes the hash of the core, or returns 0 if an assertion refuses the state. */
static int hash_if_valid(uint64_t *hash)
{
    if (setjmp(global_expect_assert_env) != 0) {
        global_expecting_assert = 0;
        return 0;
    }
    global_expecting_assert = 1;
    *hash = core_hash(&core);
    global_expecting_assert = 0;
    return 1;
}

/* Changes one bit of the byte, the lowest one that leaves a valid state. The hash must then change.
 * If every changed bit is refused by an assertion, the hash sees the byte. */
static void flip(const char *name, uint8_t *byte, uint64_t before)
{
    for (uint32_t bit = 0; bit < 8u; bit++) {
        uint64_t after = before;
        *byte ^= (uint8_t)(1u << bit);
        const int is_valid = hash_if_valid(&after);
        *byte ^= (uint8_t)(1u << bit);
        if (is_valid) {
            if (after == before) {
                fail_msg("the hash does not see %s", name);
            }
            return;
        }
    }
}

static void test_the_hash_sees_the_first_and_the_last_byte_of_every_member(void **state)
{
    (void)state;
    const uint64_t before = core_hash(&core);
    for (size_t t = 0; t < TABLE_COUNT; t++) {
        for (size_t i = 0; i < tables[t].count; i++) {
            const struct field *field = &tables[t].fields[i];
            uint8_t *bytes = (uint8_t *)tables[t].at + field->offset;
            if (!field->skipped) {
                flip(field->name, bytes, before);
                flip(field->name, bytes + field->size / 2u, before);
                flip(field->name, bytes + field->size - 1u, before);
            }
        }
    }
    assert_true(core_hash(&core) == before);
}

static void test_the_hash_sees_how_many_there_are(void **state)
{
    (void)state;
    uint32_t *const counts[] = { &core.world.poi[0].carried_count, &core.world.poi[0].load_count,
                                 &core.world.tank.fish_count };
    const uint64_t before = core_hash(&core);
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        (*counts[i])--;
        assert_true(core_hash(&core) != before);
        (*counts[i])++;
    }
}

/* A look's findings hold for some ticks, so they are state. */
static void test_the_hash_sees_what_the_fish_last_saw(void **state)
{
    (void)state;
    struct broad_phase *broad_phase = &core.world.tank.broad_phase;
    broad_phase->near_count = 2;
    broad_phase->contact[1] = (struct contact){ 1, 2, 0.001f };
    const uint64_t before = core_hash(&core);
    flip("contact.a", (uint8_t *)&broad_phase->contact[1].a, before);
    flip("contact.b", (uint8_t *)&broad_phase->contact[1].b, before);
    flip("contact.gap_m", (uint8_t *)&broad_phase->contact[1].gap_m, before);
    flip("way_m", (uint8_t *)&broad_phase->way_m[11], before);
    flip("reach_m", (uint8_t *)&broad_phase->reach_m[11], before);
    broad_phase->near_count = 1;
    assert_true(core_hash(&core) != before);
}

/* What no hash covers must not matter: else two equal hashes could part later. */
static void test_scratch_that_is_overwritten_changes_nothing(void **state)
{
    (void)state;
    static struct output output;
    const struct input input = { .pressed = INPUT_START };
    core.world.poi[0].carried_count = core.world.poi[0].load_count = 0;
    twin = core;
    assert_int_equal(core.game.tick % BROAD_PHASE_UPDATE_TICKS, 0); /* All look anew. */
    memset(&twin.world.tank.broad_phase, 0x5a, sizeof twin.world.tank.broad_phase);
    memset(&twin.world.tank.solver, 0x5a, sizeof twin.world.tank.solver);
    for (uint32_t i = 0; i < 100; i++) {
        core_tick(&core, &input, &output);
        core_tick(&twin, &input, &output);
    }
    assert_true(core_hash(&core) == core_hash(&twin));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_every_member_is_in_its_table, setup),
        cmocka_unit_test_setup(test_the_hash_sees_the_first_and_the_last_byte_of_every_member,
                               setup),
        cmocka_unit_test_setup(test_the_hash_sees_how_many_there_are, setup),
        cmocka_unit_test_setup(test_the_hash_sees_what_the_fish_last_saw, setup),
        cmocka_unit_test_setup(test_scratch_that_is_overwritten_changes_nothing, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
