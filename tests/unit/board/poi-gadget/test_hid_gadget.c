/* test_hid_gadget.c -- tests the poi's end of the USB connection. A socket pair replaces the USB
 * device file, and the test acts as the host. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include "board/poi-gadget/hid_gadget.h"

static struct hid_gadget gadget;
static int host;

/* Opens a pair of packet sockets. Packet sockets deliver each report separately, as the USB device
 * file does. */
static int plug_in(void **state)
{
    (void)state;
    int ends[2];
    assert_int_equal(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, ends), 0);
    hid_gadget_init(&gadget, "/nowhere/hidg0");
    gadget.fd = ends[0];
    host = ends[1];
    return 0;
}

static int pull_out(void **state)
{
    (void)state;
    hid_gadget_close(&gadget);
    close(host);
    return 0;
}

static void test_only_reports_that_were_sent_get_a_sequence_number(void **state)
{
    (void)state;
    const struct poi_report report = { .target.position_m = { 0.1f, 0.2f, 0.3f } };
    struct poi_report got;
    uint8_t bytes[64];
    uint32_t sent = 0;
    while (sent < 100000 && hid_gadget_send(&gadget, &report)) {
        /* The host reads no reports, so the socket buffer becomes full after a while. */
        sent++;
    }
    assert_true(sent > 1 && sent < 100000);
    assert_int_equal(gadget.sent_count, sent);
    assert_int_equal(gadget.skipped_count, 1);
    for (uint32_t i = 0; i < sent; i++) {
        assert_int_equal(read(host, bytes, sizeof bytes), POI_REPORT_SIZE);
        assert_true(poi_report_decode(bytes, POI_REPORT_SIZE, &got));
        assert_int_equal(got.sequence, i & 255u);
    }
    /* A report that could not be sent gets no sequence number, so the numbers have no gap. */
    assert_true(hid_gadget_send(&gadget, &report));
    assert_int_equal(read(host, bytes, sizeof bytes), POI_REPORT_SIZE);
    assert_int_equal(bytes[1], sent & 255u);
}

static void test_the_newest_output_report_is_used_and_invalid_ones_are_rejected(void **state)
{
    (void)state;
    uint8_t bytes[POI_FORCE_SIZE];
    struct poi_force force = { 0 };
    assert_false(hid_gadget_feel(&gadget, &force));
    for (uint32_t i = 1; i <= 3; i++) {
        poi_force_encode(&(struct poi_force){ .slap = 0.2f * (float)i }, (uint8_t)i, bytes);
        assert_int_equal(write(host, bytes, sizeof bytes), sizeof bytes);
    }
    assert_int_equal(write(host, "nonsense", 8), 8);
    assert_true(hid_gadget_feel(&gadget, &force));
    assert_float_equal(force.slap, 0.6f, 0.003f);
    assert_int_equal(gadget.felt_count, 3);
    assert_int_equal(gadget.refused_count, 1);
    assert_false(hid_gadget_feel(&gadget, &force));
}

static void test_a_removed_usb_function_is_closed(void **state)
{
    (void)state;
    const struct poi_report report = { 0 };
    close(host);
    host = -1;
    /* The host has closed its end, so the write fails with EPIPE. SIGPIPE is ignored, as in
     * run(). */
    assert_false(hid_gadget_send(&gadget, &report));
    assert_int_equal(gadget.fd, -1);
    assert_false(hid_gadget_open(&gadget));
    assert_false(hid_gadget_send(&gadget, &report));
    assert_int_equal(gadget.skipped_count, 2);
    assert_int_equal(gadget.sequence, 0);
}

int main(void)
{
    signal(SIGPIPE, SIG_IGN);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_only_reports_that_were_sent_get_a_sequence_number,
                                        plug_in, pull_out),
        cmocka_unit_test_setup_teardown(
            test_the_newest_output_report_is_used_and_invalid_ones_are_rejected, plug_in, pull_out),
        cmocka_unit_test_setup_teardown(test_a_removed_usb_function_is_closed, plug_in, pull_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
