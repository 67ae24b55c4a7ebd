/* test_file_notes.c -- Tests the list of the data folder's files on the operator's screen.
 *
 * The list shows which files are used, which files were rejected, and why. */
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

#include "core/game/menu/menu_pages.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/run_common.h"
#include "platform/store/graph_file.h"
#include "tests/unit/support/menu_tag.h"

#define FRAME_NS 16666667ull

static struct operator_notes notes;

/* ---- Tests of the list alone ---------------------------------------------------------------- */

static int empty(void **state)
{
    (void)state;
    memset(&notes, 0, sizeof notes);
    return 0;
}

static void expect_row(uint32_t row, enum scene_file_state state, const char *name,
                       const char *words)
{
    const struct scene_file file = operator_notes_row(&notes, row);
    assert_int_equal(file.state, state);
    assert_string_equal(file.name, name);
    assert_string_equal(file.words, words);
}

static void test_rejected_files_are_listed_first_and_each_kind_in_order(void **state)
{
    (void)state;
    operator_notes_add(&notes, FILE_USED, "a", "one");
    operator_notes_add(&notes, FILE_REFUSED, "b", "two");
    operator_notes_add(&notes, FILE_USED, "c", "three");
    operator_notes_add(&notes, FILE_REFUSED, "d", "four");
    assert_int_equal(operator_view_file_count(&notes), 1 + 4);
    expect_row(0, FILE_REFUSED, "b", "two");
    expect_row(1, FILE_REFUSED, "d", "four");
    expect_row(2, FILE_USED, "a", "one");
    expect_row(3, FILE_USED, "c", "three");
    expect_row(4, FILE_UNKNOWN, "", "");
}

static void test_a_warning_is_split_at_its_first_colon_and_space(void **state)
{
    (void)state;
    operator_notes_refused(&notes, "/data", "/data/pois/x.poi:3: role: unknown");
    operator_notes_refused(&notes, "/data", "/database/x: why");
    operator_notes_refused(&notes, "", "/etc/kingyo.conf:7: wrong");
    operator_notes_refused(&notes, "/data", "no reason");
    expect_row(0, FILE_REFUSED, "pois/x.poi:3", "role: unknown");
    expect_row(1, FILE_REFUSED, "/database/x", "why");
    expect_row(2, FILE_REFUSED, "/etc/kingyo.conf:7", "wrong");
    expect_row(3, FILE_REFUSED, "", "no reason");
}

static void test_long_names_keep_their_end_and_long_reasons_their_beginning(void **state)
{
    char line[2048], words[SCENE_LINE_SIZE];
    (void)state;
    memset(line, 'p', sizeof line);
    memcpy(line + 1500, "/end.kfish: ", 12);
    line[sizeof line - 1u] = 0;
    operator_notes_refused(&notes, "", line + 600);
    const struct scene_file file = operator_notes_row(&notes, 0);
    assert_int_equal(strlen(file.name), SCENE_FILE_SIZE - 1u);
    assert_memory_equal(file.name, "...p", 4);
    assert_string_equal(file.name + SCENE_FILE_SIZE - 1u - 10u, "/end.kfish");
    memset(words, 'p', sizeof words);
    words[sizeof words - 1u] = 0;
    assert_string_equal(file.words, words);
}

static void test_a_full_list_counts_the_rest_in_its_last_row(void **state)
{
    char name[16];
    (void)state;
    for (uint32_t i = 0; i < OPERATOR_NOTES_MAX + 3u; i++) {
        const uint32_t kept = i < OPERATOR_NOTES_MAX ? i : OPERATOR_NOTES_MAX;
        assert_int_equal(operator_view_file_count(&notes), 1 + kept + (i > OPERATOR_NOTES_MAX));
        snprintf(name, sizeof name, "%u", i);
        operator_notes_add(&notes, i % 2u ? FILE_USED : FILE_REFUSED, name, "");
    }
    expect_row(OPERATOR_NOTES_MAX, FILE_REFUSED, "...", "3 more lines, and no room for them");
    expect_row(OPERATOR_NOTES_MAX + 1u, FILE_UNKNOWN, "", "");
    expect_row(0, FILE_REFUSED, "0", "");
    expect_row(OPERATOR_NOTES_MAX - 1u, FILE_USED, "251", "");
}

/* ---- Tests of the list in the menu of a kiosk ----------------------------------------------- */

static struct rig {
    struct clock_sim clock;
    struct display_sim display;
    struct storage_sim storage;
    struct button_sample buttons;
    struct run_common session;
    char data[64];
} rig;

static int poll_buttons(void *self, struct button_sample *out)
{
    (void)self;
    *out = rig.buttons;
    rig.buttons = (struct button_sample){ 0 };
    return HAL_OK;
}

static const char *describe_buttons(void *self)
{
    (void)self;
    return "buttons";
}

static void put(const char *folder, const char *file, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", rig.data, folder);
    mkdir(path, 0755);
    snprintf(path, sizeof path, "%s/%s/%s", rig.data, folder, file);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
}

static int set_up(void **state)
{
    static const struct hal_buttons_ops buttons = { poll_buttons, describe_buttons };
    (void)state;
    memset(&rig, 0, sizeof rig);
    snprintf(rig.data, sizeof rig.data, "/tmp/kingyo-notes-XXXXXX");
    assert_non_null(mkdtemp(rig.data));
    struct hal *hal = &rig.session.hal;
    *hal = null_hal(NULL);
    hal->clock = sim_clock_device(&rig.clock);
    hal->display = sim_display_device(&rig.display);
    hal->buttons = (struct hal_buttons){ .ops = &buttons };
    hal->storage = storage_sim_device(&rig.storage);
    snprintf(rig.session.options.data, sizeof rig.session.options.data, "%s", rig.data);
    return 0;
}

static int tear_down(void **state)
{
    char command[96];
    (void)state;
    system_health_stop(&rig.session.machine);
    snprintf(command, sizeof command, "rm -rf '%s'", rig.data);
    return system(command);
}

static void push(uint32_t button)
{
    rig.buttons.pressed = button;
    for (uint32_t i = 0; i < 10u; i++) {
        rig.clock.now_ns += FRAME_NS;
        assert_int_equal(kiosk_frame(&rig.session.kiosk, &rig.session.hal), KIOSK_RUNS);
    }
}

/* Presses SERVICE until the menu item that leads to `page` is selected. Then opens the page with
 * TEST. */
static void take(uint8_t page)
{
    for (uint32_t i = 0; rig.display.scene.menu.tag != menu_tag_of(page) && i < MENU_TAG_MAX; i++) {
        push(INPUT_SERVICE);
    }
    push(INPUT_TEST);
}

/* Starts the kiosk and opens the files page of the menu. */
static const struct scene_file *look(void)
{
    struct kiosk_config config = { .core = { .seed = 5, .fish_count = 8, .round_s = 10 } };
    assert_int_equal(run_common_begin(&rig.session, &config), EXIT_OK);
    push(INPUT_TEST);
    take(MENU_UPKEEP);
    take(MENU_FILES);
    assert_int_equal(rig.display.scene.menu.page, MENU_FILES);
    return rig.display.scene.devices.file;
}

static void test_a_rejected_species_file_is_listed_with_its_reason(void **state)
{
    (void)state;
    put("species", "bad.kfish", "nonsense");
    const struct scene_file *file = look();
    assert_int_equal(rig.display.scene.menu.controllers.file_count, 2);
    assert_int_equal(file[1].state, FILE_REFUSED);
    assert_string_equal(file[1].name, "species/bad.kfish");
    assert_string_equal(file[1].words, rig.session.library.lines[0].why);
    assert_non_null(strstr(file[1].words, "magic"));
    assert_int_equal(file[2].state, FILE_UNKNOWN);
}

static void test_a_file_in_place_of_the_species_folder_is_named_once(void **state)
{
    (void)state;
    put(".", "species", "no folder");
    const struct scene_file *file = look();
    assert_int_equal(file[1].state, FILE_REFUSED);
    assert_string_equal(file[1].name, "species");
    assert_string_equal(file[1].words, "Not a directory");
}

static void test_valid_species_files_are_listed_after_the_rejected_ones(void **state)
{
    static struct species_slot slot;
    char path[128], why[VALIDATE_WHY_SIZE];
    (void)state;
    put("species", "zz.kfish", "nonsense");
    put("graphs", "wakin.graph", "kingyo-graph 1\n");
    pack_copy(&species_wakin, &slot);
    snprintf(slot.species.card.id, SPECIES_NAME_SIZE, "funa");
    snprintf(path, sizeof path, "%s/species/a.kfish", rig.data);
    assert_int_equal(pack_write(path, &slot, why), PACK_OK);
    const struct scene_file *file = look();
    assert_int_equal(rig.display.scene.menu.controllers.file_count, 4);
    assert_string_equal(file[1].name, "species/zz.kfish");
    assert_memory_equal(file[2].name, "graphs/wakin.graph:", 19);
    assert_int_equal(file[2].state, FILE_REFUSED);
    assert_true(strlen(file[2].words) > 0);
    assert_int_equal(file[3].state, FILE_USED);
    assert_string_equal(file[3].name, "species/a.kfish");
    assert_string_equal(file[3].words, "funa");
}

static void test_a_stored_graph_is_listed_as_used(void **state)
{
    const struct species_card *card = &species_wakin.card;
    struct graph_edit_record record = { .id = 1, .key_count = card->key_count };
    (void)state;
    memcpy(record.species, card->id, sizeof record.species);
    lab_edit_template(&record.edit, card, TEMPLATE_SIMULTANEOUS);
    assert_int_equal(graph_file_write(rig.data, &record), 0);
    const struct scene_file *file = look();
    assert_int_equal(file[1].state, FILE_USED);
    assert_string_equal(file[1].name, "graphs/wakin.graph");
}

static void test_the_first_file_row_is_the_current_store_status(void **state)
{
    (void)state;
    const struct scene_file *file = look();
    assert_int_equal(file[0].state, FILE_USED);
    assert_string_equal(file[0].words, "simulated store");
    rig.storage.edit_failed = 1;
    push(0);
    assert_int_equal(file[0].state, FILE_REFUSED);
}

static void test_warnings_from_before_the_kiosk_started_are_listed(void **state)
{
    char line[128];
    (void)state;
    run_common_note_refused(&rig.session, "kingyo.conf:3: grade: wrong value");
    snprintf(line, sizeof line, "%s/usb.txt:2: no such word", rig.data);
    run_common_note_refused(&rig.session, line);
    const struct scene_file *file = look();
    assert_string_equal(file[1].name, "kingyo.conf:3");
    assert_string_equal(file[2].name, "usb.txt:2");
    assert_string_equal(file[2].words, "no such word");
}

/* The folder contains more files than one page of the list can show. The page therefore has the
 * menu item MORE, which shows the next rows. */
static void test_the_more_tag_shows_the_next_file_rows(void **state)
{
    char file_name[32];
    (void)state;
    for (uint32_t i = 0; i < 7u; i++) {
        snprintf(file_name, sizeof file_name, "%u.kfish", i);
        put("species", file_name, "nonsense");
    }
    const struct scene_file *file = look();
    assert_int_equal(rig.display.scene.menu.tag, FILES_MORE);
    push(INPUT_TEST);
    assert_int_equal(rig.display.scene.menu.file_first, menu_files_shown(0));
    assert_string_equal(file[0].name, "species/4.kfish");
    assert_string_equal(file[2].name, "species/6.kfish");
    assert_int_equal(file[3].state, FILE_UNKNOWN);
}

static void until_first_is(const struct scene_file *file, uint8_t state)
{
    for (uint32_t i = 0; i < 300u && file[1].state != state; i++) {
        usleep(10000);
        push(0);
    }
    assert_int_equal(file[1].state, state);
}

/* The operator acknowledges a quarantined database with the menu item SEEN. The row of the database
 * stays on the page, but the warning must not return, even after a restart. */
static void test_a_quarantined_database_is_reported_until_acknowledged(void **state)
{
    (void)state;
    put(".", "kingyo.db.damaged-1", "nonsense");
    put(".", "kingyo.db.damaged-1-wal", "its journal");
    const struct scene_file *file = look();
    const struct scene_devices *devices = &rig.display.scene.devices;
    for (uint32_t i = 0; i < 300u && devices->machine.quarantined == 0; i++) {
        usleep(10000);
        push(0);
    }
    assert_int_equal(devices->machine.quarantined, 1);
    assert_int_equal(devices->files_refused, 0);
    assert_int_equal(file[1].state, FILE_ASIDE);
    assert_string_equal(file[1].name, "kingyo.db.damaged-1");
    assert_int_equal(file[2].state, FILE_UNKNOWN);
    push(INPUT_SERVICE);
    assert_int_equal(rig.display.scene.menu.tag, FILES_SEEN);
    push(INPUT_TEST);
    until_first_is(file, FILE_SEEN);
    system_health_stop(&rig.session.machine);
    rig.session.notes = (struct operator_notes){ 0 };
    look();
    until_first_is(file, FILE_SEEN);
    assert_int_equal(devices->machine.quarantined, 0);
}

#define ON_THE_SCREEN(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_rejected_files_are_listed_first_and_each_kind_in_order, empty),
        cmocka_unit_test_setup(test_a_warning_is_split_at_its_first_colon_and_space, empty),
        cmocka_unit_test_setup(test_long_names_keep_their_end_and_long_reasons_their_beginning,
                               empty),
        cmocka_unit_test_setup(test_a_full_list_counts_the_rest_in_its_last_row, empty),
        ON_THE_SCREEN(test_a_rejected_species_file_is_listed_with_its_reason),
        ON_THE_SCREEN(test_a_file_in_place_of_the_species_folder_is_named_once),
        ON_THE_SCREEN(test_valid_species_files_are_listed_after_the_rejected_ones),
        ON_THE_SCREEN(test_a_stored_graph_is_listed_as_used),
        ON_THE_SCREEN(test_the_first_file_row_is_the_current_store_status),
        ON_THE_SCREEN(test_warnings_from_before_the_kiosk_started_are_listed),
        ON_THE_SCREEN(test_the_more_tag_shows_the_next_file_rows),
        ON_THE_SCREEN(test_a_quarantined_database_is_reported_until_acknowledged),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
