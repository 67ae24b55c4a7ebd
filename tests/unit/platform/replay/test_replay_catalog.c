/* test_replay_catalog.c -- Tests the catalog in a recording. The catalog contains the species that
 * were loaded from files, and the morph graphs that were edited in the growth lab. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/game/game_fields.h"
#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "platform/kiosk/recorder/replayer.h"

static struct lab_book book, back;
static struct core core;
static struct recorder recorder;
static struct replayer replayer;
static uint8_t bytes[REPLAY_CATALOG_MAX];

/* Fills the largest possible catalog: eight loaded species, and an edited morph graph for every
 * species. */
static void fill(void)
{
    memset(&book, 0, sizeof book);
    book.card_count = SPECIES_EXTRA_MAX;
    book.refused = 3;
    for (uint32_t i = 0; i < SPECIES_EXTRA_MAX; i++) {
        book.cards[i] = species_table[i % species_table_count]->card;
        book.cards[i].id[0] = (char)('a' + i);
    }
    for (uint32_t i = 0; i < lab_book_count(&book); i++) {
        book.has_edit[i] = 1;
        lab_edit_own(&book.edits[i], lab_book_card(&book, i));
        lab_edit_template(&book.edits[i], lab_book_card(&book, i), TEMPLATE_SMOOTH);
        lab_edit_size(&book.edits[i], lab_book_card(&book, i), 1, 0.1234567f);
    }
}

static int setup(void **state)
{
    (void)state;
    fill();
    assert_true(lab_book_is_valid(&book));
    return 0;
}

static void test_the_largest_catalog_is_restored_bit_for_bit(void **state)
{
    (void)state;
    const size_t size = replay_catalog_encode(&book, bytes);
    assert_in_range(size, 20000, REPLAY_CATALOG_MAX);
    assert_int_equal(replay_catalog_decode(&back, bytes, size), 1);
    assert_true(field_hash(HASH_START, &lab_book_fields, &back) ==
                field_hash(HASH_START, &lab_book_fields, &book));
}

static void test_an_empty_catalog_takes_no_bytes(void **state)
{
    (void)state;
    memset(&book, 0, sizeof book);
    assert_int_equal(replay_catalog_encode(&book, bytes), 0);
}

static void test_an_altered_catalog_is_rejected_unless_valid(void **state)
{
    (void)state;
    static uint8_t altered[REPLAY_CATALOG_MAX];
    const size_t size = replay_catalog_encode(&book, bytes);
    uint32_t refused = 0;
    for (uint32_t i = 0; i < 600; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ 3, i, 0, RNG_TEST });
        memcpy(altered, bytes, size);
        altered[bits % size] ^= (uint8_t)(1u << (bits >> 29));
        const size_t cut = i % 4u == 0 ? bits % size : size;
        const int believed = replay_catalog_decode(&back, altered, cut);
        refused += believed == 0;
        assert_true(lab_book_is_valid(&back)); /* After a failed decoding, the catalog must be
                                                  empty, and an empty catalog is valid. */
    }
    assert_true(refused > 150);
}

/* Returns pseudorandom input for the growth lab. The poi moves, dips and presses controls. In some
 * ticks the screen is rotated or a graph is saved. */
static struct input hands(uint32_t tick)
{
    const uint32_t bits = rng_u32((struct rng_key){ 9, tick / 20u, 0, RNG_TEST });
    const float x = (float)(bits & 255u) / 255.0f - 0.5f, z = (float)(bits >> 8 & 255u) / 255.0f;
    return (struct input){
        .upright = bits >> 31 != 0,
        .edit_saved_id = tick / 300u,
        .pressed = tick % 97u == 0 ? INPUT_OK : 0,
        .poi[0] = { .link = POI_SOURCE_LIVE,
                    .has_wrist = 1,
                    .target.position_m =
                        v3(0.85f * x, bits >> 16 & 1u ? -0.02f : 0.04f, 0.55f * (z - 0.5f)) },
    };
}

static void test_a_recording_of_the_lab_verifies(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-book-XXXXXX";
    static struct core_config config;
    static struct output output;
    struct replay_totals totals;
    config = (struct core_config){
        .seed = 4, .fish_count = 12, .modes = 1u << CHOICE_LAB, .book = book
    };
    close(mkstemp(path));
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < 10u * CORE_TICK_HZ; tick++) {
        const struct input input = hands(tick);
        tap.before(tap.self, &input);
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    assert_int_equal(recorder_end(&recorder), 0);
    assert_int_equal(replay_scan(&replayer.reader, path, &totals), 0);
    assert_int_equal(totals.ticks, 10u * CORE_TICK_HZ);
    assert_int_equal(replayer_begin(&replayer, path, &config), 0);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap check = replayer_tap(&replayer);
    struct input input;
    while (source.next(source.self, &input)) {
        core_tick(&core, &input, &output);
        check.tick(check.self, &input, &core);
    }
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_int_equal(replayer.totals.ticks, totals.ticks);
    replayer_end(&replayer);
    unlink(path);
}

static void test_an_altered_catalog_in_a_recording_is_rejected_by_its_checksum(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-book-XXXXXX";
    static struct core_config config;
    struct replay_totals totals;
    config = (struct core_config){ .seed = 4, .fish_count = 12, .book = book };
    const int fd = mkstemp(path);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    assert_int_equal(recorder_end(&recorder), 0);
    assert_int_equal(replay_scan(&replayer.reader, path, &totals), 0);
    assert_int_equal(pwrite(fd, "!", 1, REPLAY_HEADER_SIZE + 4000), 1);
    close(fd);
    assert_int_equal(replay_scan(&replayer.reader, path, &totals), -1);
    assert_string_equal(replayer.reader.problem.text, "its book of species was altered");
    unlink(path);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_the_largest_catalog_is_restored_bit_for_bit),
        TEST(test_an_empty_catalog_takes_no_bytes),
        TEST(test_an_altered_catalog_is_rejected_unless_valid),
        TEST(test_a_recording_of_the_lab_verifies),
        TEST(test_an_altered_catalog_in_a_recording_is_rejected_by_its_checksum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
