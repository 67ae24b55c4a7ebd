/* test_graph_file.c -- Tests the files in which the growth lab stores edited morph graphs. A graph
 * must be restored bit for bit. Otherwise the error must be reported in one line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/os/file.h"
#include "platform/store/graph_file.h"
#include "platform/store/storage.h"

static const struct species_card *card; /* Description of the species wakin (a goldfish). */
static char folder[64];
static struct lab_book book;
static char reported[512];
static uint32_t reported_count;

static void tell(void *context, const char *line)
{
    assert_ptr_equal(context, &book);
    snprintf(reported, sizeof reported, "%s", line);
    reported_count++;
}

static const struct graph_file_warn warn = { tell, &book };

static int setup(void **state)
{
    (void)state;
    card = &species_table[0]->card;
    snprintf(folder, sizeof folder, "/tmp/kingyo-edit-XXXXXX");
    assert_non_null(mkdtemp(folder));
    memset(&book, 0, sizeof book);
    reported[0] = 0;
    reported_count = 0;
    return 0;
}

static int teardown(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}

/* Returns a morph graph with numbers of many digits, so that a rounding error would be detected. */
static struct graph_edit_record drawn(void)
{
    struct graph_edit_record record = { .id = 3, .key_count = card->key_count };
    memcpy(record.species, card->id, sizeof record.species);
    lab_edit_template(&record.edit, card, TEMPLATE_SIMULTANEOUS);
    lab_edit_add(&record.edit, card->key_count, 0.1f);
    lab_edit_weigh(&record.edit, card->key_count, 2, 1, 0.7654321f);
    lab_edit_size(&record.edit, card, 1, 0.0123456789f);
    lab_edit_size_move(&record.edit, card, 1, 0.3333333f);
    return record;
}

static int parse(const char *text, struct lab_edit *edit, char why[GRAPH_FILE_WHY_SIZE])
{
    return graph_file_parse(text, strlen(text), card, edit, why);
}

static void test_a_graph_is_read_bit_for_bit(void **state)
{
    (void)state;
    const struct graph_edit_record record = drawn();
    char text[GRAPH_FILE_TEXT_MAX], why[GRAPH_FILE_WHY_SIZE];
    struct lab_edit back;
    const size_t size = graph_file_format(&record, text);
    assert_in_range(size, 1, GRAPH_FILE_TEXT_MAX - 1u);
    if (!graph_file_parse(text, size, card, &back, why)) {
        fail_msg("%s in\n%s", why, text);
    }
    assert_memory_equal(&back, &record.edit, sizeof back);
}

/* Formats the largest morph graph: every knot has the weights of eight key shapes, and each number
 * has the maximum number of digits. */
static void test_the_longest_graph_fits_its_text_buffer(void **state)
{
    (void)state;
    struct graph_edit_record record = { .key_count = MORPH_KEY_MAX,
                                        .species = "abcdefghijklmnopqrstuvw",
                                        .edit = { .template_id = TEMPLATE_SIMULTANEOUS } };
    record.edit.graph.knot_count = record.edit.scale_knot_count = GRAPH_KNOT_MAX;
    for (uint32_t i = 0; i < GRAPH_KNOT_MAX; i++) {
        record.edit.graph.knots[i].progress = 1.23456789e-20f;
        record.edit.scale_knots[i] = (struct scale_knot){ 1.23456789e-20f, 1.23456789e-20f };
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            record.edit.graph.knots[i].weight[key] = 1.23456789e-20f;
        }
    }
    char text[GRAPH_FILE_TEXT_MAX];
    const size_t size = graph_file_format(&record, text);
    assert_true(size < GRAPH_FILE_TEXT_MAX);
    assert_memory_equal(text + size - 4, "end\n", 4);
}

static void test_a_stored_graph_is_loaded_at_the_next_start(void **state)
{
    (void)state;
    const struct graph_edit_record record = drawn();
    assert_int_equal(graph_file_write(folder, &record), 0);
    graph_file_load(folder, &book, warn);
    assert_int_equal(reported_count, 0);
    assert_int_equal(book.has_edit[0], 1);
    assert_memory_equal(&book.edits[0], &record.edit, sizeof record.edit);
    assert_true(lab_book_is_valid(&book));
}

static void test_resetting_a_graph_to_the_species_default_deletes_its_file(void **state)
{
    (void)state;
    struct graph_edit_record record = drawn();
    assert_int_equal(graph_file_write(folder, &record), 0);
    record.is_own = 1;
    assert_int_equal(graph_file_write(folder, &record), 0);
    /* The first reset has deleted the file. A second reset must not fail. */
    assert_int_equal(graph_file_write(folder, &record), 0);
    graph_file_load(folder, &book, warn);
    assert_int_equal(book.has_edit[0], 0);
    assert_int_equal(reported_count, 0);
}

static void put_file(const char *text, size_t size)
{
    char path[256];
    snprintf(path, sizeof path, "%s/" GRAPH_FILE_FOLDER, folder);
    mkdir(path, 0755);
    snprintf(path, sizeof path, "%s/" GRAPH_FILE_FOLDER "/%s" GRAPH_FILE_SUFFIX, folder, card->id);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, size, file), size);
    fclose(file);
}

static void test_an_invalid_graph_file_is_reported_and_the_species_keeps_its_default(void **state)
{
    (void)state;
    put_file("kingyo-graph 1\nspecies wakin\nnonsense\n", 39);
    graph_file_load(folder, &book, warn);
    assert_int_equal(reported_count, 1);
    assert_non_null(strstr(reported, "graphs/wakin.graph:3: wakin has "));
    assert_int_equal(book.has_edit[0], 0);
    static char huge[3u * GRAPH_FILE_TEXT_MAX];
    memset(huge, '#', sizeof huge);
    put_file(huge, sizeof huge);
    graph_file_load(folder, &book, warn);
    assert_int_equal(reported_count, 2);
    assert_non_null(strstr(reported, "longer than any graph"));
}

/* Writes the first lines of a graph of the species wakin, and then `body`. */
static void begin_graph(char *text, size_t size, const char *body)
{
    snprintf(text, size,
             "kingyo-graph 1\nspecies wakin\nkeys %u\ntemplate own\nline straight\nsolved 0\n%s",
             card->key_count, body);
}

#define ENDS "knot 0 1 0 0 0 0\nknot 1 0 0 0 0 1\n"

static void test_each_graph_error_is_reported_with_its_line(void **state)
{
    (void)state;
    char why[GRAPH_FILE_WHY_SIZE];
    struct lab_edit edit;
    static const struct {
        const char *body, *reason;
    } mistakes[] = {
        { "", "6: the file ends without 'end'" },
        { "knot 0 1 0 0 0 0\nend\n", "8: fewer than 2 knots" },
        { "knot 0 1 0 0 0 0\nknot 1 0 0 0 0 0.5\nend\n", "8: knot 2: its weights do not sum to 1" },
        { "knot 0 1 0 0 0 0\nknot 1 2 0 0 0 -1\nend\n", "8: knot 2: a weight is negative" },
        { "knot 0 1 0 0 0 0\nknot 0 0 0 0 0 1\nend\n", "8: knot 2: its progress does not rise" },
        { "knot 0.1 1 0 0 0 0\nknot 1 0 0 0 0 1\nend\n", "7: knot 1: the first knot is not at 0" },
        { "knot 0 1 0 0 0\n", "7: expected 6 numbers" },
        { "knot 0 1 0 0 0 0 0\n", "7: more than 6 numbers" },
        { "knot 0 1 0 0 0 nan\n", "7: expected 6 numbers" },
        { "knots 0 1 0 0 0 0\n", "7: expected 'knot', 'scale' or 'end'" },
        { ENDS "scale 0 0.01\nend\n", "9: scale knot 1: they do not rise from 0 to 1" },
        { ENDS "scale 0 0.01\n\nscale 0.9 1\nend\n", "11: scale knot 2: they do not rise" },
        { ENDS "scale 0 1\nscale 0.4 1\nscale 0.4 1\nscale 1 2\nend\n", "11: scale knot 3: they" },
        { ENDS "scale 0 1\nscale 1 99\nend\n", "10: scale knot 2: not of 0.2 mm to 20 m" },
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        char text[600];
        begin_graph(text, sizeof text, mistakes[i].body);
        assert_int_equal(parse(text, &edit, why), 0);
        if (strstr(why, mistakes[i].reason) == NULL) {
            fail_msg("'%s' is reported as '%s'", mistakes[i].body, why);
        }
    }
}

static void test_a_solved_graph_shows_each_key(void **state)
{
    (void)state;
    char text[600], expected[160], why[GRAPH_FILE_WHY_SIZE];
    struct lab_edit edit;
    begin_graph(text, sizeof text, ENDS "end\n");
    assert_int_equal(parse(text, &edit, why), 1);
    strstr(text, "solved 0")[7] = '1';
    /* The graph is now marked as computed (solved). For such a graph it is an error that the second
     * key shape has nearly no weight at any age. */
    assert_int_equal(parse(text, &edit, why), 0);
    snprintf(expected, sizeof expected, "the key '%s' is hardly seen", card->key_names[1]);
    assert_non_null(strstr(why, expected));
}

static void test_a_long_comment_is_accepted_and_a_zero_byte_is_not(void **state)
{
    (void)state;
    char text[600], why[GRAPH_FILE_WHY_SIZE];
    struct lab_edit edit;
    begin_graph(text, sizeof text, ENDS "end\n");
    const size_t size = strlen(text);
    assert_int_equal(graph_file_parse(text, size, card, &edit, why), 1);
    /* A comment may be longer than any other line. */
    char commented[sizeof text + 1000u];
    snprintf(commented, sizeof commented, "#%0999d\n%s", 0, text);
    assert_int_equal(parse(commented, &edit, why), 1);
    text[size - 5u] = 0; /* Puts a zero byte in the place of a newline. */
    assert_int_equal(graph_file_parse(text, size, card, &edit, why), 0);
    assert_non_null(strstr(why, "8: not a text"));
}

static void test_each_error_of_the_first_lines_is_reported(void **state)
{
    (void)state;
    char why[GRAPH_FILE_WHY_SIZE];
    struct lab_edit edit;
    assert_int_equal(parse("", &edit, why), 0);
    assert_string_equal(why, "1: the file ends without 'end'");
    assert_int_equal(parse("kingyo-graph 1\n", &edit, why), 0);
    assert_string_equal(why, "1: the file ends without 'end'");
    assert_int_equal(graph_file_parse("kingyo-graph 1\nspec\0es", 21, card, &edit, why), 0);
    assert_string_equal(why, "2: not a text");
    assert_int_equal(parse("kingyo-graph 2\n", &edit, why), 0);
    assert_non_null(strstr(why, "1: not a graph of version 1"));
    assert_int_equal(parse("kingyo-graph 1\nspecies funa\n", &edit, why), 0);
    assert_non_null(strstr(why, "2: not of the species wakin"));
}

/* Changes a random byte of the file, and sometimes truncates the file. The parser must then return
 * a valid graph. Otherwise it must return a reason and leave `edit` unchanged. */
static void test_an_altered_graph_file_is_rejected_unless_valid(void **state)
{
    (void)state;
    const struct graph_edit_record record = drawn();
    char good[GRAPH_FILE_TEXT_MAX], text[GRAPH_FILE_TEXT_MAX], why[GRAPH_FILE_WHY_SIZE];
    const size_t size = graph_file_format(&record, good);
    uint32_t refused = 0;
    for (uint32_t i = 0; i < 4000; i++) {
        struct lab_edit edit = { .template_id = 99 };
        memcpy(text, good, size);
        const uint32_t bits = rng_u32((struct rng_key){ 1, i, 0, RNG_TEST });
        text[bits % size] = (char)(bits >> 24);
        const uint32_t end = rng_u32((struct rng_key){ 2, i, 0, RNG_TEST });
        const size_t cut = i % 3u == 0 ? end % size : size;
        if (graph_file_parse(text, cut, card, &edit, why)) {
            assert_true(lab_edit_is_valid(&edit, card));
        } else {
            refused++;
            assert_int_equal(edit.template_id, 99);
            assert_true(why[0] != 0);
        }
    }
    assert_in_range(refused, 2000, 4000);
}

static void test_the_store_writes_a_graph_in_its_own_thread(void **state)
{
    (void)state;
    static struct storage storage;
    memset(&storage, 0, sizeof storage);
    storage.dir = folder;
    const struct hal_storage device = storage_device(&storage);
    struct graph_edit_record record = drawn();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.edits.ops->store(device.edits.self, &record), HAL_OK);
    /* The second request has the same id, so it must have no effect. */
    assert_int_equal(device.edits.ops->store(device.edits.self, &record), HAL_OK);
    for (uint32_t i = 0; i < 500 && device.edits.ops->stored_id(device.edits.self) != record.id;
         i++) {
        usleep(10000);
    }
    assert_int_equal(device.edits.ops->stored_id(device.edits.self), record.id);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    graph_file_load(folder, &book, warn);
    assert_memory_equal(&book.edits[0], &record.edit, sizeof record.edit);
}

/* Another kiosk has locked the data folder, so this kiosk does not open the database and cannot
 * store rounds. A morph graph is stored in a text file, which must be written all the same. */
static void test_a_graph_is_stored_without_a_database(void **state)
{
    (void)state;
    static struct storage storage;
    memset(&storage, 0, sizeof storage);
    storage.dir = folder;
    const int hold = file_lock_folder(folder); /* This lock simulates another kiosk that uses the
                                                  folder. */
    assert_true(hold >= 0);
    const struct hal_storage device = storage_device(&storage);
    const struct graph_edit_record record = drawn();
    const struct ledger_entry round = { .id = 1, .kind = LEDGER_ROUND, .round = { .id = 1 } };
    assert_int_equal(device.edits.ops->has_failed(device.edits.self), 1);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_ERR_IO);
    assert_int_equal(device.ledger.ops->append(device.ledger.self, &round), HAL_ERR_ABSENT);
    assert_int_equal(device.edits.ops->has_failed(device.edits.self), 0);
    assert_int_equal(device.edits.ops->store(device.edits.self, &record), HAL_OK);
    for (uint32_t i = 0; i < 500 && device.edits.ops->stored_id(device.edits.self) != record.id;
         i++) {
        usleep(10000);
    }
    assert_int_equal(device.edits.ops->stored_id(device.edits.self), record.id);
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self), "nothing is kept"));
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(device.edits.ops->has_failed(device.edits.self), 1);
    graph_file_load(folder, &book, warn);
    assert_memory_equal(&book.edits[0], &record.edit, sizeof record.edit);
    close(hold);
}

/* Stores more morph graphs than the queue can hold. While the queue is full, store() returns
 * HAL_ERR_BUSY, and the test retries. */
static void test_queued_graphs_are_written_in_order(void **state)
{
    (void)state;
    static struct storage storage;
    memset(&storage, 0, sizeof storage);
    storage.dir = folder;
    const struct hal_storage device = storage_device(&storage);
    struct graph_edit_record record = drawn();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    for (uint32_t i = 0; i < 3u * STORAGE_EDITS_MAX; i++) {
        record.id = 1u + i;
        record.edit.graph.knots[1].progress = 0.05f + 0.005f * (float)i;
        for (int busy = 0; device.edits.ops->store(device.edits.self, &record) == HAL_ERR_BUSY;
             busy++) {
            assert_true(busy < 500);
            usleep(10000);
        }
    }
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    assert_int_equal(device.edits.ops->stored_id(device.edits.self), record.id);
    graph_file_load(folder, &book, warn);
    assert_memory_equal(&book.edits[0], &record.edit, sizeof record.edit);
}

static void test_a_failed_graph_write_is_reported_and_counted(void **state)
{
    (void)state;
    static struct storage storage;
    char path[128];
    memset(&storage, 0, sizeof storage);
    storage.dir = folder;
    snprintf(path, sizeof path, "%s/" GRAPH_FILE_FOLDER, folder);
    /* Creates a regular file at the path of the folder for morph graphs, so that no graph can be
     * written. */
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fclose(file);
    const struct hal_storage device = storage_device(&storage);
    const struct graph_edit_record record = drawn();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.edits.ops->store(device.edits.self, &record), HAL_OK);
    for (uint32_t i = 0; i < 500 && device.ledger.ops->failed_count(device.ledger.self) == 0; i++) {
        usleep(10000);
    }
    assert_true(device.ledger.ops->failed_count(device.ledger.self) > 0);
    assert_int_equal(device.edits.ops->has_failed(device.edits.self), 1);
    assert_int_equal(device.edits.ops->stored_id(device.edits.self), 0);
    assert_non_null(
        strstr(device.ledger.ops->describe(device.ledger.self), "graph was not written"));
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 1);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
    const struct CMUnitTest tests[] = {
        TEST(test_a_graph_is_read_bit_for_bit),
        TEST(test_the_longest_graph_fits_its_text_buffer),
        TEST(test_a_stored_graph_is_loaded_at_the_next_start),
        TEST(test_resetting_a_graph_to_the_species_default_deletes_its_file),
        TEST(test_an_invalid_graph_file_is_reported_and_the_species_keeps_its_default),
        TEST(test_each_graph_error_is_reported_with_its_line),
        TEST(test_a_solved_graph_shows_each_key),
        TEST(test_a_long_comment_is_accepted_and_a_zero_byte_is_not),
        TEST(test_each_error_of_the_first_lines_is_reported),
        TEST(test_an_altered_graph_file_is_rejected_unless_valid),
        TEST(test_the_store_writes_a_graph_in_its_own_thread),
        TEST(test_a_graph_is_stored_without_a_database),
        TEST(test_queued_graphs_are_written_in_order),
        TEST(test_a_failed_graph_write_is_reported_and_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
