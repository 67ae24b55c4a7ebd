/* test_library.c -- Tests the library, which loads the species files of the data folder. Each file
 * must be loaded in order, or be rejected with a reason. */
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

#include "platform/species/library.h"

static struct library library;
static struct species_slot slot;
static char data[] = "/tmp/kingyo-shelf-XXXXXX";
static char why[VALIDATE_WHY_SIZE];

static const char *path_of(const char *name)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/species/%s", data, name);
    return path;
}

static void put_species(const char *file, const char *id)
{
    pack_copy(&species_wakin, &slot);
    memset(slot.species.card.id, 0, SPECIES_NAME_SIZE);
    snprintf(slot.species.card.id, SPECIES_NAME_SIZE, "%s", id);
    assert_int_equal(pack_write(path_of(file), &slot, why), PACK_OK);
}

static void put_text(const char *file, const char *text)
{
    FILE *out = fopen(path_of(file), "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
}

static int make_folder(void **state)
{
    char folder[64];
    (void)state;
    snprintf(data, sizeof data, "/tmp/kingyo-shelf-XXXXXX");
    assert_non_null(mkdtemp(data));
    snprintf(folder, sizeof folder, "%s/species", data);
    return mkdir(folder, 0755);
}

static int remove_folder(void **state)
{
    char command[96];
    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", data);
    return system(command);
}

static void test_a_missing_folder_is_an_empty_library(void **state)
{
    (void)state;
    library_fill(&library, NULL);
    assert_int_equal(library_count(&library), species_table_count);
    library_fill(&library, "/nowhere");
    assert_int_equal(library_count(&library), species_table_count);
    assert_int_equal(library.line_count, 0);
    assert_ptr_equal(library_species(&library, 0), &species_wakin);
}

static void test_loaded_species_follow_the_built_in_ones_in_file_order(void **state)
{
    (void)state;
    put_species("c.kfish", "third");
    put_species("a.kfish", "first");
    put_species("b.kfish", "second");
    put_text("notes.txt", "not asked for");
    put_text(".hidden.kfish", "nor this");
    library_fill(&library, data);
    assert_int_equal(library.line_count, 3);
    assert_int_equal(library_count(&library), species_table_count + 3);
    const char *const ids[] = { "first", "second", "third" };
    for (uint32_t i = 0; i < 3; i++) {
        assert_string_equal(library_species(&library, species_table_count + i)->card.id, ids[i]);
        assert_int_equal(library.lines[i].slot, i);
        assert_string_equal(library.lines[i].why, "");
    }
}

static void test_an_invalid_file_gives_a_message_and_uses_no_slot(void **state)
{
    (void)state;
    put_text("a.kfish", "");
    put_text("b.kfish", "KFISH");
    put_species("c.kfish", "good");
    assert_int_equal(mkdir(path_of("d.kfish"), 0755), 0);
    /* The FIFO has no writer, but opening it must not block. */
    assert_int_equal(mkfifo(path_of("e.kfish"), 0644), 0);
    assert_int_equal(symlink("/dev/zero", path_of("f.kfish")), 0);
    library_fill(&library, data);
    assert_int_equal(library.line_count, 6);
    assert_int_equal(library.species_count, 1);
    for (uint32_t i = 0; i < 6; i++) {
        assert_int_equal(library.lines[i].slot, i == 2 ? 0 : LIBRARY_SLOT_NONE);
        assert_true((library.lines[i].why[0] == '\0') == (i == 2));
    }
    assert_string_equal(library.lines[0].file, "species/a.kfish");
    assert_string_equal(library.lines[0].why, "magic: the file is not a packed species");
}

static void test_rejected_files_are_reported_in_order(void **state)
{
    (void)state;
    put_text("a.kfish", "");
    put_species("b.kfish", "good");
    put_text("c.kfish", "KFISH");
    library_fill(&library, data);
    library_note_graph(&library, "graphs/wakin.graph:3: wakin has 5 keys");
    library_note_graph(&library, "no reason");
    assert_int_equal(library_fault_count(&library), 3);
    assert_string_equal(library_fault(&library, 0).file, "species/a.kfish");
    assert_string_equal(library_fault(&library, 1).file, "species/c.kfish");
    assert_string_equal(library_fault(&library, 1).why, library.lines[2].why);
    assert_string_equal(library_fault(&library, 2).file, "graphs/wakin.graph:3");
    assert_string_equal(library_fault(&library, 2).why, "wakin has 5 keys");
    library.unread_count = 7;
    assert_int_equal(library_fault_count(&library), 4);
    assert_string_equal(library_fault(&library, 2).why, "7 more files, and no room for them");
    assert_string_equal(library_fault(&library, 3).why, "wakin has 5 keys");
    library_fill(&library, data);
    assert_int_equal(library_fault_count(&library), 2);
}

static void test_a_file_in_place_of_the_species_folder_is_reported(void **state)
{
    (void)state;
    char place[64];
    snprintf(place, sizeof place, "%s/species", data);
    assert_int_equal(rmdir(place), 0);
    /* A regular file is at the path of the folder for species. */
    FILE *out = fopen(place, "w");
    assert_non_null(out);
    fclose(out);
    library_fill(&library, data);
    assert_int_equal(library.line_count, 1);
    assert_string_equal(library.lines[0].file, "species");
    assert_string_equal(library.lines[0].why, "Not a directory");
    assert_int_equal(library.lines[0].slot, LIBRARY_SLOT_NONE);
}

static void test_control_characters_are_removed_from_reported_names(void **state)
{
    (void)state;
    put_text("\033[31m\n.kfish", "");
    library_fill(&library, data);
    assert_int_equal(library.line_count, 1);
    assert_string_equal(library.lines[0].file, "species/?[31m?.kfish");
    assert_string_equal(library.lines[0].why, "magic: the file is not a packed species");
}

static void test_a_duplicate_id_is_rejected(void **state)
{
    (void)state;
    put_species("a.kfish", "wakin");
    put_species("b.kfish", "mine");
    put_species("c.kfish", "mine");
    library_fill(&library, data);
    assert_int_equal(library.species_count, 1);
    assert_string_equal(library.lines[0].why, "id: the species 'wakin' exists already");
    assert_string_equal(library.lines[2].why, "id: the species 'mine' exists already");
}

static void test_species_beyond_the_slots_are_rejected_by_name(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < LIBRARY_LINE_MAX + 5; i++) {
        char file[32], id[32];
        const uint32_t shuffled = i * 11 % (LIBRARY_LINE_MAX + 5);
        snprintf(file, sizeof file, "fish%02u.kfish", shuffled);
        snprintf(id, sizeof id, "fish_%u", shuffled);
        put_species(file, id);
    }
    library_fill(&library, data);
    assert_int_equal(library.species_count, SPECIES_EXTRA_MAX);
    assert_int_equal(library.line_count, LIBRARY_LINE_MAX);
    assert_int_equal(library.unread_count, 5);
    for (uint32_t i = 0; i < LIBRARY_LINE_MAX; i++) {
        char file[32];
        snprintf(file, sizeof file, "species/fish%02u.kfish", i);
        assert_string_equal(library.lines[i].file, file);
        assert_int_equal(library.lines[i].slot, i < SPECIES_EXTRA_MAX ? i : LIBRARY_SLOT_NONE);
    }
    assert_string_equal(library.lines[SPECIES_EXTRA_MAX].why,
                        "8 species are loaded, which is the maximum");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_missing_folder_is_an_empty_library),
        cmocka_unit_test_setup_teardown(test_loaded_species_follow_the_built_in_ones_in_file_order,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_an_invalid_file_gives_a_message_and_uses_no_slot,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_rejected_files_are_reported_in_order, make_folder,
                                        remove_folder),
        cmocka_unit_test_setup_teardown(test_a_file_in_place_of_the_species_folder_is_reported,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_control_characters_are_removed_from_reported_names,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_a_duplicate_id_is_rejected, make_folder,
                                        remove_folder),
        cmocka_unit_test_setup_teardown(test_species_beyond_the_slots_are_rejected_by_name,
                                        make_folder, remove_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
