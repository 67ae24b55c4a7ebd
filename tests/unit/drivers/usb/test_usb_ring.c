/* test_usb_ring.c -- what crosses between two threads crosses whole, in order, and never
 * late. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <pthread.h>
#include <sched.h>
#include <string.h>

#include "drivers/usb/usb_slot.h"
#include "drivers/usb/triple_buffer.h"

#define REPORT_COUNT 200000u
#define POST_COUNT 200000u

static struct usb_ring ring;
static struct usb_slot seat;

/* ---- The ring ------------------------------------------------------------------------------- */

static void fill_bytes(uint8_t bytes[HID_REPORT_MAX], uint32_t size, uint32_t number)
{
    memset(bytes, (int)(uint8_t)number, size);
    memcpy(bytes, &number, sizeof number);
}

/* Sizes differ, so that one read half by the old size would show. */
static uint32_t size_of(uint32_t number)
{
    return 4u + number % (HID_REPORT_MAX - 3u);
}

static atomic_int wrote;

/* Now and then in bursts that no ring holds. */
static void *write_reports(void *self)
{
    uint8_t bytes[HID_REPORT_MAX];
    (void)self;
    for (uint32_t i = 0; i < REPORT_COUNT; i++) {
        fill_bytes(bytes, size_of(i), i);
        if (!usb_ring_push(&ring, i >> 8, i, bytes, size_of(i)) && i % 64u == 0u) {
            sched_yield();
        }
    }
    atomic_store(&wrote, 1);
    return NULL;
}

static void check_report(const struct usb_ring_slot *slot, uint32_t number)
{
    uint8_t bytes[HID_REPORT_MAX];
    fill_bytes(bytes, size_of(number), number);
    assert_int_equal(slot->raw.size, size_of(number));
    assert_memory_equal(slot->raw.bytes, bytes, slot->raw.size);
    assert_int_equal(slot->raw.time_ns, number);
    assert_int_equal(slot->generation, number >> 8);
}

static void test_reports_cross_between_threads_whole_and_in_order_and_the_last_always(void **state)
{
    (void)state;
    pthread_t writer;
    uint32_t count = 0, next = 0;
    usb_ring_init(&ring);
    assert_int_equal(pthread_create(&writer, NULL, write_reports, NULL), 0);
    for (;;) {
        const int is_all = atomic_load(&wrote);
        const struct usb_ring_slot *slot = usb_ring_peek(&ring);
        if (!slot && is_all) {
            break;
        }
        if (!slot) {
            sched_yield();
            continue;
        }
        assert_true(slot->raw.time_ns >= next); /* Its number. */
        next = (uint32_t)slot->raw.time_ns + 1u;
        check_report(slot, next - 1u);
        count++;
        usb_ring_drop(&ring);
    }
    pthread_join(writer, NULL);
    assert_int_equal(next, REPORT_COUNT);
    assert_int_equal(count + usb_ring_lost(&ring), REPORT_COUNT);
}

static uint32_t next_number(void)
{
    const struct usb_ring_slot *slot = usb_ring_peek(&ring);
    const uint32_t number = slot ? (uint32_t)slot->raw.time_ns : UINT32_MAX;
    if (slot) {
        usb_ring_drop(&ring);
    }
    return number;
}

static void test_a_full_ring_keeps_the_newest_and_counts_what_it_cannot(void **state)
{
    (void)state;
    const uint8_t byte = 7;
    usb_ring_init(&ring);
    for (uint32_t i = 0; i < HID_REPORTS_MAX; i++) {
        assert_true(usb_ring_push(&ring, 1, i, &byte, 1));
    }
    assert_false(usb_ring_push(&ring, 1, 5000, &byte, 1));
    assert_int_equal(usb_ring_lost(&ring), 0);
    assert_false(usb_ring_push(&ring, 1, 5001, &byte, 1));
    assert_int_equal(usb_ring_lost(&ring), 1);
    for (uint32_t i = 0; i < 10; i++) {
        assert_int_equal(next_number(), i);
    }
    assert_true(usb_ring_push(&ring, 1, 5002, &byte, 1)); /* Room again: that came later. */
    for (uint32_t i = 10; i < HID_REPORTS_MAX; i++) {
        assert_int_equal(next_number(), i);
    }
    assert_int_equal(next_number(), 5001);
    assert_int_equal(next_number(), 5002);
    assert_int_equal(next_number(), UINT32_MAX);
    assert_int_equal(usb_ring_lost(&ring), 1);
}

/* Neither the wait beside the ring nor the numbers of reports are thrown by a wrap. */
static void test_one_that_waits_beside_a_full_ring_keeps_its_turn_over_a_wrap(void **state)
{
    (void)state;
    const uint8_t byte = 7;
    usb_ring_init(&ring);
    ring.next_number = UINT32_MAX - HID_REPORTS_MAX - 1u;
    for (uint32_t i = 0; i < HID_REPORTS_MAX + 2u; i++) { /* The last is number UINT32_MAX. */
        usb_ring_push(&ring, 1, i, &byte, 1);
    }
    for (uint32_t i = 0; i < HID_REPORTS_MAX - 1u; i++) {
        assert_int_equal(next_number(), i);
    }
    assert_true(usb_ring_push(&ring, 1, 9000, &byte, 1)); /* Number 0. */
    assert_int_equal(next_number(), HID_REPORTS_MAX - 1u);
    assert_int_equal(next_number(), HID_REPORTS_MAX + 1u);
    assert_int_equal(next_number(), 9000);
}

static void test_counters_may_wrap(void **state)
{
    (void)state;
    const uint8_t byte = 7;
    usb_ring_init(&ring);
    atomic_store(&ring.pushed, UINT32_MAX - 5u);
    atomic_store(&ring.taken, UINT32_MAX - 5u);
    for (uint32_t i = 0; i < 3u * HID_REPORTS_MAX; i++) {
        assert_true(usb_ring_push(&ring, 1, i, &byte, 1));
        assert_int_equal(usb_ring_peek(&ring)->raw.time_ns, i);
        usb_ring_drop(&ring);
    }
    assert_null(usb_ring_peek(&ring));
}

/* ---- The mail ------------------------------------------------------------------------------- */

static struct {
    struct triple_buffer mail;
    uint32_t letter[TRIPLE_BUFFER_SLOTS][64];
} post;

static void *write_letters(void *self)
{
    (void)self;
    for (uint32_t i = 1; i <= POST_COUNT; i++) {
        for (uint32_t k = 0; k < 64; k++) {
            post.letter[post.mail.writing][k] = i;
        }
        triple_buffer_post(&post.mail);
    }
    return NULL;
}

static void test_the_newest_value_is_whole_and_never_older_than_before(void **state)
{
    (void)state;
    pthread_t writer;
    uint32_t newest = 0;
    memset(&post, 0, sizeof post);
    triple_buffer_init(&post.mail);
    assert_false(triple_buffer_fetch(&post.mail));
    assert_int_equal(pthread_create(&writer, NULL, write_letters, NULL), 0);
    while (newest < POST_COUNT) {
        const int is_new = triple_buffer_fetch(&post.mail);
        const uint32_t *letter = post.letter[post.mail.reading];
        assert_true(is_new ? letter[0] > newest : letter[0] == newest);
        newest = letter[0];
        for (uint32_t k = 1; k < 64; k++) {
            assert_int_equal(letter[k], newest);
        }
    }
    pthread_join(writer, NULL);
    assert_false(triple_buffer_fetch(&post.mail));
}

/* ---- The seat ------------------------------------------------------------------------------- */

static uint32_t wakes;

static void wake(void *self)
{
    (void)self;
    wakes++;
}

static struct hid_device_info face_of(uint16_t product)
{
    return (struct hid_device_info){ .identity = { .vendor = 1, .product = product },
                                     .descriptor_size = 1 };
}

static void test_what_one_left_behind_is_not_taken_for_the_nexts(void **state)
{
    (void)state;
    struct hid_device_info face;
    struct hid_raw raw;
    usb_slot_init(&seat, wake, NULL);
    const struct hid_port port = usb_slot_port(&seat);
    assert_int_equal(port.ops->open(port.self, &face), HAL_ERR_GONE);
    assert_int_equal(port.ops->take(port.self, &raw), HAL_ERR_GONE);
    face = face_of(1);
    usb_slot_attach(&seat, &face);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    usb_slot_report(&seat, 10, (const uint8_t *)"a", 1);
    usb_slot_detach(&seat);
    face = face_of(2);
    usb_slot_attach(&seat, &face);
    usb_slot_report(&seat, 20, (const uint8_t *)"b", 1);
    assert_int_equal(port.ops->take(port.self, &raw), 1); /* The first one's last word ... */
    assert_int_equal(raw.bytes[0], 'a');
    assert_int_equal(port.ops->take(port.self, &raw), HAL_ERR_GONE); /* ... and its end. */
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    assert_int_equal(face.identity.product, 2);
    assert_int_equal(port.ops->take(port.self, &raw), 1);
    assert_int_equal(raw.bytes[0], 'b');
    assert_int_equal(port.ops->take(port.self, &raw), 0);
}

static void test_what_came_before_the_seat_was_looked_at_is_dropped_with_its_owner(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    usb_slot_init(&seat, wake, NULL);
    const struct hid_port port = usb_slot_port(&seat);
    usb_slot_attach(&seat, &face);
    usb_slot_report(&seat, 10, (const uint8_t *)"a", 1);
    usb_slot_detach(&seat);
    face = face_of(2);
    usb_slot_attach(&seat, &face);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    assert_int_equal(face.identity.product, 2);
    assert_int_equal(port.ops->take(port.self, &raw), 0);
}

static void test_time_stamps_never_go_back(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    usb_slot_init(&seat, wake, NULL);
    const struct hid_port port = usb_slot_port(&seat);
    usb_slot_attach(&seat, &face);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    usb_slot_report(&seat, 100, (const uint8_t *)"a", 1);
    usb_slot_report(&seat, 90, (const uint8_t *)"b", 1);
    assert_int_equal(port.ops->take(port.self, &raw), 1);
    assert_int_equal(port.ops->take(port.self, &raw), 1);
    assert_int_equal(raw.time_ns, 100);
}

static void test_sizes_that_are_no_report_are_no_report(void **state)
{
    (void)state;
    static const uint8_t bytes[HID_REPORT_MAX + 1u] = { 5 };
    struct hid_device_info face = face_of(1);
    struct hid_raw raw;
    usb_slot_init(&seat, wake, NULL);
    const struct hid_port port = usb_slot_port(&seat);
    usb_slot_attach(&seat, &face);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    usb_slot_report(&seat, 1, bytes, 0);
    usb_slot_report(&seat, 2, bytes, HID_REPORT_MAX + 1u);
    assert_int_equal(port.ops->take(port.self, &raw), 0);
    assert_int_equal(port.ops->lost_count(port.self), 1);
    usb_slot_report(&seat, 3, bytes, HID_REPORT_MAX);
    assert_int_equal(port.ops->take(port.self, &raw), 1);
    assert_int_equal(raw.size, HID_REPORT_MAX);
    assert_int_equal(port.ops->send(port.self, bytes, HID_REPORT_MAX + 1u), HAL_ERR_IO);
    assert_int_equal(port.ops->send(port.self, bytes, 0), HAL_ERR_IO);
}

static void test_a_blow_for_one_who_left_does_not_reach_the_next(void **state)
{
    (void)state;
    struct hid_device_info face = face_of(1);
    usb_slot_init(&seat, wake, NULL);
    const struct hid_port port = usb_slot_port(&seat);
    usb_slot_attach(&seat, &face);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    wakes = 0;
    assert_int_equal(port.ops->send(port.self, (const uint8_t *)"x", 1), HAL_OK);
    assert_int_equal(wakes, 1);
    usb_slot_detach(&seat);
    usb_slot_attach(&seat, &face);
    assert_int_equal(usb_slot_outgoing(&seat), 0);
    assert_int_equal(port.ops->open(port.self, &face), HAL_OK);
    assert_int_equal(port.ops->send(port.self, (const uint8_t *)"y", 1), HAL_OK);
    assert_int_equal(usb_slot_outgoing(&seat), 1);
    assert_int_equal(seat.out_bytes[0], 'y');
    assert_int_equal(port.ops->send(port.self, (const uint8_t *)"z", 1), HAL_ERR_BUSY);
    usb_slot_sent(&seat);
    assert_int_equal(port.ops->send(port.self, (const uint8_t *)"z", 1), HAL_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reports_cross_between_threads_whole_and_in_order_and_the_last_always),
        cmocka_unit_test(test_a_full_ring_keeps_the_newest_and_counts_what_it_cannot),
        cmocka_unit_test(test_one_that_waits_beside_a_full_ring_keeps_its_turn_over_a_wrap),
        cmocka_unit_test(test_counters_may_wrap),
        cmocka_unit_test(test_the_newest_value_is_whole_and_never_older_than_before),
        cmocka_unit_test(test_what_one_left_behind_is_not_taken_for_the_nexts),
        cmocka_unit_test(test_what_came_before_the_seat_was_looked_at_is_dropped_with_its_owner),
        cmocka_unit_test(test_time_stamps_never_go_back),
        cmocka_unit_test(test_sizes_that_are_no_report_are_no_report),
        cmocka_unit_test(test_a_blow_for_one_who_left_does_not_reach_the_next),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
