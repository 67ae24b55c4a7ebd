/* test_hid_source.c -- Tests the reader of a live HID device: its descriptor, one report per read,
 * and an unplugged device.
 *
 * A socket simulates the device node, because a socket also keeps the boundaries of reports. The
 * linker option --wrap redirects system calls to the functions in this file. */
#include <errno.h>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/ctl/devices/hid_source.h"

/* Report descriptor of a joystick with X and Y, one byte each, under report id 3. */
static const uint8_t joystick[] = { 0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x85, 0x03,
                                    0x09, 0x30, 0x09, 0x31, 0x26, 0xff, 0x00, 0x75,
                                    0x08, 0x95, 0x02, 0x81, 0x02, 0xc0 };

static struct {
    const uint8_t *descriptor;
    uint32_t size;
    /* errno that each simulated system call sets, or 0 if the call succeeds. */
    int open_errno, ioctl_errno, read_errno;
    int device; /* End of the socket pair to which the tests write reports. */
    int ours;
} kernel;

int __wrap_open(const char *path, int flags, ...);
int __wrap_ioctl(int file, unsigned long request, void *out);
ssize_t __real_read(int file, void *out, size_t size);
ssize_t __wrap_read(int file, void *out, size_t size);

int __wrap_open(const char *path, int flags, ...)
{
    (void)path;
    (void)flags;
    errno = kernel.open_errno;
    return kernel.open_errno ? -1 : kernel.ours;
}

int __wrap_ioctl(int file, unsigned long request, void *out)
{
    (void)file;
    if (kernel.ioctl_errno) {
        errno = kernel.ioctl_errno;
        return -1;
    }
    if (request == HIDIOCGRDESCSIZE) {
        *(int *)out = (int)kernel.size;
    } else if (request == HIDIOCGRDESC) {
        struct hidraw_report_descriptor *reported = out;
        /* The caller sets `size` to the size of the descriptor before it requests the bytes. */
        assert_int_equal(reported->size, kernel.size);
        memcpy(reported->value, kernel.descriptor, kernel.size);
    }
    return 0;
}

ssize_t __wrap_read(int file, void *out, size_t size)
{
    if (kernel.read_errno && file == kernel.ours) {
        errno = kernel.read_errno;
        return -1;
    }
    return __real_read(file, out, size);
}

static struct hid_source source;
static struct hid_descriptor descriptor;

static int plug_in(void **state)
{
    int pair[2];
    (void)state;
    assert_int_equal(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair), 0);
    memset(&kernel, 0, sizeof kernel);
    kernel.descriptor = joystick;
    kernel.size = sizeof joystick;
    kernel.ours = pair[0];
    kernel.device = pair[1];
    return 0;
}

static int pull_out(void **state)
{
    (void)state;
    close(kernel.device);
    if (!kernel.open_errno) {
        close(kernel.ours);
    }
    return 0;
}

static enum hid_pull pull(struct hid_report *out, enum exit_code *code)
{
    return hid_source_pull(&source, 0, out, code);
}

static void test_a_device_node_provides_its_descriptor(void **state)
{
    (void)state;
    assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_OK);
    assert_true(source.is_node);
    assert_int_equal(descriptor.group_count, 1);
}

static void test_each_read_is_one_report_of_any_length(void **state)
{
    (void)state;
    struct hid_report report = { 0 };
    enum exit_code code = EXIT_OK;
    assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_OK);
    assert_int_equal(pull(&report, &code), HID_PULL_NOTHING);
    send(kernel.device, "\x03\x10\x20", 3, 0);
    send(kernel.device, "\x03\x11", 2, 0);
    send(kernel.device, "\x03\x12\x22\x32\x42", 5, 0);
    assert_int_equal(pull(&report, &code), HID_PULL_REPORT);
    assert_int_equal(report.size, 3);
    assert_int_equal(pull(&report, &code), HID_PULL_REPORT);
    assert_int_equal(report.size, 2);
    assert_false(hid_report_is_whole(&descriptor, report));
    assert_int_equal(pull(&report, &code), HID_PULL_REPORT);
    assert_int_equal(report.size, 5);
    assert_int_equal(report.bytes[1], 0x12);
    assert_int_equal(pull(&report, &code), HID_PULL_NOTHING);
}

static void test_an_unplugged_device_is_an_io_error(void **state)
{
    (void)state;
    static const int errors[] = { ENODEV, EIO };
    for (size_t i = 0; i < 2; i++) {
        struct hid_report report = { 0 };
        enum exit_code code = EXIT_OK;
        assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_OK);
        send(kernel.device, "\x03\x10\x20", 3, 0);
        kernel.read_errno = errors[i];
        assert_int_equal(pull(&report, &code), HID_PULL_END);
        assert_int_equal(code, EXIT_IO);
        kernel.read_errno = 0;
    }
}

static void test_a_signal_does_not_end_the_input(void **state)
{
    (void)state;
    struct hid_report report = { 0 };
    enum exit_code code = EXIT_OK;
    assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_OK);
    send(kernel.device, "\x03\x10\x20", 3, 0);
    kernel.read_errno = EINTR;
    assert_int_equal(pull(&report, &code), HID_PULL_NOTHING);
    kernel.read_errno = 0;
    assert_int_equal(pull(&report, &code), HID_PULL_REPORT);
}

static void test_a_path_that_is_not_a_node_needs_a_descriptor(void **state)
{
    (void)state;
    kernel.ioctl_errno = ENOTTY;
    assert_int_equal(hid_source_open(&source, "/dev/null", &descriptor, NULL), EXIT_USAGE);
    assert_int_equal(source.file, -1);
    kernel.ours = kernel.device; /* The tested source has closed this end of the socket pair, so the
                                    teardown must not close it again. */
}

static void test_a_device_without_permission_is_an_io_error(void **state)
{
    (void)state;
    kernel.open_errno = EACCES;
    assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_IO);
    close(kernel.ours);
}

static void test_an_invalid_descriptor_is_a_data_error(void **state)
{
    (void)state;
    kernel.size = sizeof joystick - 1u;
    assert_int_equal(hid_source_open(&source, "/dev/hidraw0", &descriptor, NULL), EXIT_BAD_DATA);
    kernel.ours = kernel.device;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_device_node_provides_its_descriptor, plug_in,
                                        pull_out),
        cmocka_unit_test_setup_teardown(test_each_read_is_one_report_of_any_length, plug_in,
                                        pull_out),
        cmocka_unit_test_setup_teardown(test_an_unplugged_device_is_an_io_error, plug_in, pull_out),
        cmocka_unit_test_setup_teardown(test_a_signal_does_not_end_the_input, plug_in, pull_out),
        cmocka_unit_test_setup_teardown(test_a_path_that_is_not_a_node_needs_a_descriptor, plug_in,
                                        pull_out),
        cmocka_unit_test_setup_teardown(test_a_device_without_permission_is_an_io_error, plug_in,
                                        pull_out),
        cmocka_unit_test_setup_teardown(test_an_invalid_descriptor_is_a_data_error, plug_in,
                                        pull_out),
    };
    return cmocka_run_group_tests_name("hid_source", tests, NULL, NULL);
}
