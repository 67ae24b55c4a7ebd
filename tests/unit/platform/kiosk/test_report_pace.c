/* test_report_pace.c -- Tests two values that the operator's menu shows: the report rate of a
 * controller, and the longest gap between two reports. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/null.h"
#include "platform/kiosk/operator_view.h"

#define MS_NS 1000000ull
#define SECOND_NS 1000000000ull
#define BEGIN_NS (7u * SECOND_NS)

/* A simulated controller, which delivers one report in each poll while `due` is set. */
static struct {
    struct poi_sampler hand;
    uint64_t now_ns;
    int due, is_stamped;
} rig;

static int open_now(void *self)
{
    (void)self;
    return HAL_OK;
}

static int poll_due(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    assert_true(max > 0);
    if (!rig.due) {
        return 0;
    }
    *out = (struct poi_sample){ .time_ns = rig.now_ns, .was_stamped = (uint8_t)rig.is_stamped };
    return 1;
}

static const struct hal_poi_ops ops = { .open = open_now, .poll = poll_due };
static const struct hal_poi device = { .ops = &ops };

static void frame(uint64_t now_ns, int due)
{
    rig.now_ns = now_ns;
    rig.due = due;
    assert_int_equal(sampler_poi_sample(&rig.hand, &device, now_ns), 0);
    sampler_path_end(&rig.hand.path);
}

static int setup(void **state)
{
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.is_stamped = 1;
    assert_int_equal(sampler_poi_open(&rig.hand, &device, BEGIN_NS), 0);
    frame(BEGIN_NS, 0); /* The measurement of the first second begins with this frame. */
    return 0;
}

static void test_the_report_rate_covers_exactly_one_second(void **state)
{
    (void)state;
    for (uint64_t ms = 10; ms < 1000; ms += 10) {
        frame(BEGIN_NS + ms * MS_NS, 1);
    }
    frame(BEGIN_NS + SECOND_NS - 1u, 0);
    assert_int_equal(rig.hand.pace.shown_count, 0); /* The shown rate is not updated before the end
                                                       of the second. */
    frame(BEGIN_NS + SECOND_NS, 0);
    assert_int_equal(rig.hand.pace.shown_count, 99);
    assert_int_equal(rig.hand.pace.shown_gap_ns, 10u * MS_NS);
}

static void test_the_report_rate_restarts_at_zero_each_second(void **state)
{
    (void)state;
    for (uint64_t ms = 4; ms <= 1000; ms += 4) {
        frame(BEGIN_NS + ms * MS_NS, 1);
    }
    for (uint64_t ms = 1050; ms < 2000; ms += 50) {
        frame(BEGIN_NS + ms * MS_NS, 1);
    }
    frame(BEGIN_NS + 2u * SECOND_NS, 0);
    assert_int_equal(rig.hand.pace.shown_count, 20); /* The last second has 19 reports after its
                                                        start and one exactly at its start. */
    assert_int_equal(rig.hand.pace.shown_gap_ns, 50u * MS_NS);
}

static void test_a_lasting_silence_is_shown_as_the_longest_gap(void **state)
{
    (void)state;
    frame(BEGIN_NS + 100u * MS_NS, 1);
    frame(BEGIN_NS + 110u * MS_NS, 1);
    frame(BEGIN_NS + SECOND_NS, 0);
    assert_int_equal(rig.hand.pace.shown_count, 2);
    assert_int_equal(rig.hand.pace.shown_gap_ns, 890u * MS_NS);
    frame(BEGIN_NS + 2u * SECOND_NS, 0);
    assert_int_equal(rig.hand.pace.shown_count, 0);
    assert_int_equal(rig.hand.pace.shown_gap_ns, 1890u * MS_NS);
}

static void test_generated_samples_are_not_counted_as_reports(void **state)
{
    (void)state;
    rig.is_stamped = 0;
    frame(BEGIN_NS + 100u * MS_NS, 1);
    frame(BEGIN_NS + SECOND_NS, 0);
    assert_int_equal(rig.hand.pace.shown_count, 0);
    assert_int_equal(rig.hand.pace.shown_gap_ns, 0);
}

static void test_the_files_page_has_a_row_for_the_store_and_one_for_each_note(void **state)
{
    static struct operator_notes notes;
    (void)state;
    assert_int_equal(operator_view_file_count(NULL), 1);
    assert_int_equal(operator_view_file_count(&notes), 1);
    operator_notes_add(&notes, FILE_USED, "koi.kfish", "");
    operator_notes_add(&notes, FILE_REFUSED, "pois/x.poi", "no map");
    assert_int_equal(operator_view_file_count(&notes), 3);
}

static void test_the_files_page_shows_the_store_and_then_the_notes(void **state)
{
    static struct operator_notes notes;
    const struct hal hal = null_hal(NULL);
    static struct scene scene;
    static struct input input;
    static struct poi_sampler samplers[POI_MAX];
    static struct operator_view_lines lines;
    static struct scene_machine machine;
    (void)state;
    operator_notes_add(&notes, FILE_USED, "koi.kfish", "a koi");
    scene.phase = PHASE_MENU;
    operator_view_fill(&scene, &hal,
                       &(struct operator_view){ .notes = &notes,
                                                .input = &input,
                                                .samplers = samplers,
                                                .lines = &lines,
                                                .machine = &machine });
    assert_string_equal(scene.devices.file[0].words,
                        hal.storage.ledger.ops->describe(hal.storage.ledger.self));
    assert_string_equal(scene.devices.file[1].name, "koi.kfish");
    assert_int_equal(scene.devices.file[2].state, FILE_UNKNOWN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_the_report_rate_covers_exactly_one_second, setup),
        cmocka_unit_test_setup(test_the_report_rate_restarts_at_zero_each_second, setup),
        cmocka_unit_test_setup(test_a_lasting_silence_is_shown_as_the_longest_gap, setup),
        cmocka_unit_test_setup(test_generated_samples_are_not_counted_as_reports, setup),
        cmocka_unit_test(test_the_files_page_has_a_row_for_the_store_and_one_for_each_note),
        cmocka_unit_test(test_the_files_page_shows_the_store_and_then_the_notes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
