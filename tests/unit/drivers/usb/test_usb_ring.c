/* test_usb_ring.c -- tests that reports and device descriptions pass completely and in order from
 * one thread to another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <sched.h>
#include <string.h>

#include "drivers/hid/hid_port.h"

#define REPORT_COUNT 200000u
#define POST_COUNT 200000u

static struct hid_port port;

static void wake(void *self)
{
    uint32_t *wakes = self;
    (*wakes)++;
}

static uint32_t wakes;

static struct hid_device_info face_of(uint16_t product)
{
    return (struct hid_device_info){ .identity = { .vendor = 1, .product = product },
                                     .descriptor_size = 1 };
}

/* Initializes the port, attaches a controller and opens the port. */
static void begin(void)
{
    struct hid_device_info face = face_of(1);
    wakes = 0;
    hid_port_init(&port, wake, &wakes);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
}

/* ---- Queue of reports ----------------------------------------------------------------------- */

static void fill_bytes(uint8_t bytes[HID_REPORT_MAX], uint32_t size, uint32_t number)
{
    memset(bytes, (int)(uint8_t)number, size);
    memcpy(bytes, &number, sizeof number);
}

/* Returns the size of report `number`. Successive reports have different sizes, so that a report
 * with the size of an older one would be detected. */
static uint32_t size_of(uint32_t number)
{
    return 4u + number % (HID_REPORT_MAX - 3u);
}

static atomic_int wrote;

/* Writes reports as fast as possible, so that every queue overflows from time to time. */
static void *write_reports(void *self)
{
    uint8_t bytes[HID_REPORT_MAX];
    (void)self;
    for (uint32_t i = 0; i < REPORT_COUNT; i++) {
        const uint32_t pushed = atomic_load(&port.pushed);
        fill_bytes(bytes, size_of(i), i);
        hid_port_report(&port, i, bytes, size_of(i));
        if (atomic_load(&port.pushed) == pushed && i % 64u == 0u) {
            sched_yield();
        }
    }
    atomic_store(&wrote, 1);
    return NULL;
}

static void test_reports_pass_complete_and_in_order_and_the_last_is_never_lost(void **state)
{
    (void)state;
    static struct hid_raw raw;
    uint8_t bytes[HID_REPORT_MAX];
    pthread_t writer;
    uint32_t count = 0, next = 0;
    begin();
    atomic_store(&wrote, 0);
    assert_int_equal(pthread_create(&writer, NULL, write_reports, NULL), 0);
    for (;;) {
        const int is_all = atomic_load(&wrote);
        const int result = hid_port_take(&port, &raw);
        if (result == 0 && is_all) {
            break;
        }
        if (result == 0) {
            sched_yield();
            continue;
        }
        assert_int_equal(result, 1);
        /* Each report was written with its number as the time stamp. */
        assert_true(raw.time_ns >= next);
        next = (uint32_t)raw.time_ns + 1u;
        fill_bytes(bytes, size_of(next - 1u), next - 1u);
        assert_int_equal(raw.size, size_of(next - 1u));
        assert_memory_equal(raw.bytes, bytes, raw.size);
        count++;
    }
    pthread_join(writer, NULL);
    assert_int_equal(next, REPORT_COUNT);
    assert_int_equal(count + atomic_load(&port.lost), REPORT_COUNT);
}

/* Writes a report of one byte with the time stamp `number`, by which next_number() identifies the
 * report. */
static void report(uint32_t number)
{
    const uint8_t byte = 7;
    hid_port_report(&port, number, &byte, 1);
}

/* Takes a report from the queue. Returns its time stamp, or UINT32_MAX if there is no report. */
static uint32_t next_number(void)
{
    struct hid_raw raw;
    const int result = hid_port_take(&port, &raw);
    assert_true(result == 0 || result == 1);
    return result ? (uint32_t)raw.time_ns : UINT32_MAX;
}

static void test_a_full_queue_keeps_the_newest_report_and_counts_lost_ones(void **state)
{
    (void)state;
    begin();
    for (uint32_t i = 0; i < HID_REPORTS_MAX; i++) {
        report(i);
    }
    report(5000);
    assert_int_equal(atomic_load(&port.pushed), HID_REPORTS_MAX);
    assert_int_equal(atomic_load(&port.lost), 0);
    report(5001);
    assert_int_equal(atomic_load(&port.lost), 1);
    for (uint32_t i = 0; i < 10; i++) {
        assert_int_equal(next_number(), i);
    }
    /* The queue has room for report 5002 again. Report 5001 is still stored beside the queue, and
     * must be taken before report 5002. */
    report(5002);
    assert_int_equal(atomic_load(&port.pushed), HID_REPORTS_MAX + 1u);
    for (uint32_t i = 10; i < HID_REPORTS_MAX; i++) {
        assert_int_equal(next_number(), i);
    }
    assert_int_equal(next_number(), 5001);
    assert_int_equal(next_number(), 5002);
    assert_int_equal(next_number(), UINT32_MAX);
    assert_int_equal(atomic_load(&port.lost), 1);
}

/* When the queue is full, the newest report is stored beside the queue. The order of the reports
 * must stay correct even if the port's numbers of reports wrap around from UINT32_MAX to 0. */
static void test_the_report_beside_a_full_queue_stays_in_order_over_a_wrap(void **state)
{
    (void)state;
    begin();
    port.next_number = UINT32_MAX - HID_REPORTS_MAX - 1u;
    /* The counter of the port was set so that the last report of this loop has the number
     * UINT32_MAX. */
    for (uint32_t i = 0; i < HID_REPORTS_MAX + 2u; i++) {
        report(i);
    }
    for (uint32_t i = 0; i < HID_REPORTS_MAX - 1u; i++) {
        assert_int_equal(next_number(), i);
    }
    report(9000); /* After the wrap, the port gives this report the number 0. */
    assert_int_equal(next_number(), HID_REPORTS_MAX - 1u);
    assert_int_equal(next_number(), HID_REPORTS_MAX + 1u);
    assert_int_equal(next_number(), 9000);
}

static void test_queue_counters_can_wrap(void **state)
{
    (void)state;
    begin();
    atomic_store(&port.pushed, UINT32_MAX - 5u);
    atomic_store(&port.taken, UINT32_MAX - 5u);
    for (uint32_t i = 0; i < 3u * HID_REPORTS_MAX; i++) {
        report(i);
        assert_int_equal(next_number(), i);
    }
    assert_int_equal(next_number(), UINT32_MAX);
    assert_int_equal(atomic_load(&port.lost), 0);
}

/* ---- Buffer of the newest value ------------------------------------------------------------- */

static struct {
    struct triple_buffer buffer;
    uint32_t letter[TRIPLE_BUFFER_SLOTS][64];
} post;

static void *write_letters(void *self)
{
    (void)self;
    for (uint32_t i = 1; i <= POST_COUNT; i++) {
        for (uint32_t k = 0; k < 64; k++) {
            post.letter[post.buffer.writing][k] = i;
        }
        triple_buffer_post(&post.buffer);
    }
    return NULL;
}

static void test_the_newest_value_is_complete_and_never_older_than_the_last(void **state)
{
    (void)state;
    pthread_t writer;
    uint32_t newest = 0;
    memset(&post, 0, sizeof post);
    triple_buffer_init(&post.buffer);
    assert_false(triple_buffer_fetch(&post.buffer));
    assert_int_equal(pthread_create(&writer, NULL, write_letters, NULL), 0);
    while (newest < POST_COUNT) {
        const int is_new = triple_buffer_fetch(&post.buffer);
        const uint32_t *letter = post.letter[post.buffer.reading];
        assert_true(is_new ? letter[0] > newest : letter[0] == newest);
        newest = letter[0];
        for (uint32_t k = 1; k < 64; k++) {
            assert_int_equal(letter[k], newest);
        }
    }
    pthread_join(writer, NULL);
    assert_false(triple_buffer_fetch(&post.buffer));
}

/* ---- Ring as a HID port --------------------------------------------------------------------- */

static void test_reports_of_a_removed_device_are_not_given_to_the_next(void **state)
{
    (void)state;
    struct hid_device_info face;
    struct hid_raw raw;
    hid_port_init(&port, wake, &wakes);
    assert_int_equal(hid_port_open(&port, &face), HAL_ERR_GONE);
    assert_int_equal(hid_port_take(&port, &raw), HAL_ERR_GONE);
    face = face_of(1);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    hid_port_report(&port, 10, (const uint8_t *)"a", 1);
    hid_port_detach(&port);
    face = face_of(2);
    hid_port_attach(&port, &face);
    hid_port_report(&port, 20, (const uint8_t *)"b", 1);
    /* The last report of the first device is still delivered. */
    assert_int_equal(hid_port_take(&port, &raw), 1);
    assert_int_equal(raw.bytes[0], 'a');
    /* The next call reports that the first device is gone. */
    assert_int_equal(hid_port_take(&port, &raw), HAL_ERR_GONE);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    assert_int_equal(face.identity.product, 2);
    assert_int_equal(hid_port_take(&port, &raw), 1);
    assert_int_equal(raw.bytes[0], 'b');
    assert_int_equal(hid_port_take(&port, &raw), 0);
}

static void test_unread_reports_are_dropped_when_their_device_is_removed(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    hid_port_init(&port, wake, &wakes);
    hid_port_attach(&port, &face);
    hid_port_report(&port, 10, (const uint8_t *)"a", 1);
    hid_port_detach(&port);
    face = face_of(2);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    assert_int_equal(face.identity.product, 2);
    assert_int_equal(hid_port_take(&port, &raw), 0);
}

static void test_time_stamps_never_decrease(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    hid_port_init(&port, wake, &wakes);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    hid_port_report(&port, 100, (const uint8_t *)"a", 1);
    hid_port_report(&port, 90, (const uint8_t *)"b", 1);
    assert_int_equal(hid_port_take(&port, &raw), 1);
    assert_int_equal(hid_port_take(&port, &raw), 1);
    assert_int_equal(raw.time_ns, 100);
}

static void test_a_report_of_an_invalid_size_is_ignored(void **state)
{
    (void)state;
    static const uint8_t bytes[HID_REPORT_MAX + 1u] = { 5 };
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    hid_port_init(&port, wake, &wakes);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    hid_port_report(&port, 1, bytes, 0);
    hid_port_report(&port, 2, bytes, HID_REPORT_MAX + 1u);
    assert_int_equal(hid_port_take(&port, &raw), 0);
    assert_int_equal(atomic_load(&port.lost), 1);
    hid_port_report(&port, 3, bytes, HID_REPORT_MAX);
    assert_int_equal(hid_port_take(&port, &raw), 1);
    assert_int_equal(raw.size, HID_REPORT_MAX);
    assert_int_equal(hid_port_send(&port, bytes, HID_REPORT_MAX + 1u), HAL_ERR_IO);
    assert_int_equal(hid_port_send(&port, bytes, 0), HAL_ERR_IO);
}

static void test_an_output_report_for_a_removed_device_is_not_sent_to_the_next(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    hid_port_init(&port, wake, &wakes);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    wakes = 0;
    assert_int_equal(hid_port_send(&port, (const uint8_t *)"x", 1), HAL_OK);
    assert_int_equal(wakes, 1);
    hid_port_detach(&port);
    hid_port_attach(&port, &face);
    assert_int_equal(hid_port_outgoing(&port), 0);
    assert_int_equal(hid_port_open(&port, &face), HAL_OK);
    assert_int_equal(hid_port_send(&port, (const uint8_t *)"y", 1), HAL_OK);
    assert_int_equal(hid_port_outgoing(&port), 1);
    assert_int_equal(port.out_bytes[0], 'y');
    assert_int_equal(hid_port_send(&port, (const uint8_t *)"z", 1), HAL_ERR_BUSY);
    hid_port_sent(&port);
    assert_int_equal(hid_port_send(&port, (const uint8_t *)"z", 1), HAL_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reports_pass_complete_and_in_order_and_the_last_is_never_lost),
        cmocka_unit_test(test_a_full_queue_keeps_the_newest_report_and_counts_lost_ones),
        cmocka_unit_test(test_the_report_beside_a_full_queue_stays_in_order_over_a_wrap),
        cmocka_unit_test(test_queue_counters_can_wrap),
        cmocka_unit_test(test_the_newest_value_is_complete_and_never_older_than_the_last),
        cmocka_unit_test(test_reports_of_a_removed_device_are_not_given_to_the_next),
        cmocka_unit_test(test_unread_reports_are_dropped_when_their_device_is_removed),
        cmocka_unit_test(test_time_stamps_never_decrease),
        cmocka_unit_test(test_a_report_of_an_invalid_size_is_ignored),
        cmocka_unit_test(test_an_output_report_for_a_removed_device_is_not_sent_to_the_next),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
