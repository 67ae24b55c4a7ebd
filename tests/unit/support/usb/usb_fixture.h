/* usb_fixture.h -- simulated USB devices, and a test fixture that runs the drivers' USB thread with
 * them. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_USB_USB_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_USB_USB_FIXTURE_H

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <libusb.h>

#include "drivers/hid/poi_report.h"
#include "drivers/usb/usb_transport.h"
#include "platform/os/clock.h"
#include "tests/unit/support/usb/usb_sim.h"

/* Report descriptor of the boot keyboard in HID 1.11, appendix E.6. */
static const uint8_t keyboard_descriptor[] = {
    0x05, 0x01, 0x09, 0x06, 0xa1, 0x01, 0x05, 0x07, 0x19, 0xe0, 0x29, 0xe7, 0x15, 0x00, 0x25, 0x01,
    0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x95, 0x01, 0x75, 0x08, 0x81, 0x01, 0x95, 0x05, 0x75, 0x01,
    0x05, 0x08, 0x19, 0x01, 0x29, 0x05, 0x91, 0x02, 0x95, 0x01, 0x75, 0x03, 0x91, 0x01, 0x95, 0x06,
    0x75, 0x08, 0x15, 0x00, 0x25, 0x65, 0x05, 0x07, 0x19, 0x00, 0x29, 0x65, 0x81, 0x00, 0xc0,
};

/* Report descriptor of a joystick with eight buttons and two axes of one byte each, without report
 * ids. */
static const uint8_t joystick_descriptor[] = {
    0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81, 0x25,
    0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0x05, 0x09, 0x19, 0x01, 0x29, 0x08,
    0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0xc0,
};

/* Report descriptor of eight vendor-defined bytes. The first interface of tablets and wireless
 * receivers has such a descriptor. */
static const uint8_t vendor_descriptor[] = {
    0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x09, 0x01, 0x15, 0x00,
    0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x08, 0x81, 0x02, 0xc0,
};

#define OWN_INTERFACE                                                                              \
    {                                                                                              \
        .class = LIBUSB_CLASS_HID,                                                                 \
        .packet_size = 64,                                                                         \
        .has_out = 1,                                                                              \
        .descriptor = poi_descriptor,                                                              \
        .descriptor_size = POI_DESCRIPTOR_SIZE,                                                    \
    }
#define KEYBOARD_INTERFACE                                                                         \
    {                                                                                              \
        .class = LIBUSB_CLASS_HID,                                                                 \
        .subclass = 1,                                                                             \
        .protocol = 1,                                                                             \
        .packet_size = 8,                                                                          \
        .descriptor = keyboard_descriptor,                                                         \
        .descriptor_size = sizeof keyboard_descriptor,                                             \
    }
#define VENDOR_INTERFACE                                                                           \
    {                                                                                              \
        .class = LIBUSB_CLASS_HID,                                                                 \
        .packet_size = 8,                                                                          \
        .descriptor = vendor_descriptor,                                                           \
        .descriptor_size = sizeof vendor_descriptor,                                               \
    }
#define JOYSTICK_INTERFACE                                                                         \
    {                                                                                              \
        .class = LIBUSB_CLASS_HID,                                                                 \
        .packet_size = 8,                                                                          \
        .descriptor = joystick_descriptor,                                                         \
        .descriptor_size = sizeof joystick_descriptor,                                             \
    }

/* A Kingyo poi controller that another maker builds, with that maker's USB vendor id. */
static const struct usb_sim_kind own_poi = {
    .vendor = 0xcafe,
    .product = 0x0b01,
    .name = "Poi",
    .serial = "A1",
    .is_bound = 1,
    .interface_count = 1,
    .interface = { OWN_INTERFACE },
};
static const struct usb_sim_kind second_poi = {
    .vendor = 0xcafe,
    .product = 0x0b01,
    .name = "Poi",
    .serial = "A2",
    .is_bound = 1,
    .interface_count = 1,
    .interface = { OWN_INTERFACE },
};
static const struct usb_sim_kind plain_poi = {
    /* A Kingyo poi controller without a serial number. */
    .vendor = 0xcafe, .product = 0x0b01,    .name = "Poi",
    .is_bound = 1,    .interface_count = 1, .interface = { OWN_INTERFACE },
};
static const struct usb_sim_kind unbound_poi = {
    /* A Kingyo poi controller to which no kernel driver is bound. */
    .vendor = 0x1209,
    .product = 0x0001,
    .name = "Bench poi",
    .interface_count = 1,
    .interface = { OWN_INTERFACE },
};
static const struct usb_sim_kind joystick = {
    .vendor = 0x046d,
    .product = 0xc215,
    .name = "Joystick",
    .serial = "J7",
    .is_bound = 1,
    .interface_count = 1,
    .interface = { JOYSTICK_INTERFACE },
};
static const struct usb_sim_kind keyboard = {
    .vendor = 0x046a,
    .product = 0x0001,
    .name = "Keyboard",
    .is_bound = 1,
    .interface_count = 1,
    .interface = { KEYBOARD_INTERFACE },
};

/* Test fixture with the temporary folders of one test, and the USB thread that uses these
 * folders. */
struct usb_fixture {
    char folder[64], sysfs[96], choices[96];
    struct usb_event_thread *thread;
    char why[HAL_TEXT_SIZE];
    /* Protects `message_count` and `message`, which the USB thread writes. */
    pthread_mutex_t lock;
    uint32_t message_count;
    char message[HAL_TEXT_SIZE];
};

/* Stores the text `line`, which the USB thread reports through this callback. Takes the lock. */
static inline void fixture_on_message(void *self, const char *line)
{
    struct usb_fixture *fixture = self;
    pthread_mutex_lock(&fixture->lock);
    snprintf(fixture->message, sizeof fixture->message, "%s", line);
    fixture->message_count++;
    pthread_mutex_unlock(&fixture->lock);
}

/* Returns the number of lines that the USB thread has reported. Copies the newest line to
 * `line`. */
static inline uint32_t fixture_message(struct usb_fixture *fixture, char line[HAL_TEXT_SIZE])
{
    pthread_mutex_lock(&fixture->lock);
    const uint32_t count = fixture->message_count;
    snprintf(line, HAL_TEXT_SIZE, "%s", fixture->message);
    pthread_mutex_unlock(&fixture->lock);
    return count;
}

/* Creates the temporary folders and an empty bus. */
static inline void fixture_prepare(struct usb_fixture *fixture)
{
    pthread_mutex_init(&fixture->lock, NULL);
    fixture->message_count = 0;
    snprintf(fixture->folder, sizeof fixture->folder, "/tmp/kingyo-usb-XXXXXX");
    if (!mkdtemp(fixture->folder)) {
        abort();
    }
    snprintf(fixture->sysfs, sizeof fixture->sysfs, "%s/sys", fixture->folder);
    snprintf(fixture->choices, sizeof fixture->choices, "%s/usb.txt", fixture->folder);
    usb_sim_begin(fixture->sysfs);
}

/* Starts the USB thread with the clock `clock`. `listed` has the keys of the devices that may
 * play. */
static inline void fixture_start_with(struct usb_fixture *fixture, struct hal_clock clock,
                                      const struct usb_key *listed, uint32_t listed_count)
{
    const struct usb_transport_config config = {
        .clock = clock,
        .choices = fixture->choices,
        .listed = listed,
        .listed_count = listed_count,
        .sysfs = fixture->sysfs,
        .report = fixture_on_message,
        .report_self = fixture,
    };
    fixture->thread = usb_transport_start(&config, fixture->why);
}

/* Starts the USB thread with the real clock. `listed` has the keys of the devices that may play. */
static inline void fixture_start(struct usb_fixture *fixture, const struct usb_key *listed,
                                 uint32_t listed_count)
{
    fixture_start_with(fixture, clock_device(), listed, listed_count);
}

/* Ends the USB thread and removes the temporary folders. Returns the number of resources that were
 * not released, plus 1 if the folders could not be removed. */
static inline uint32_t fixture_end(struct usb_fixture *fixture)
{
    char command[128];
    usb_transport_stop(fixture->thread);
    const uint32_t left = usb_sim_end();
    snprintf(command, sizeof command, "rm -r '%s'", fixture->folder);
    return left + (system(command) != 0);
}

/* Returns the row `index` of the device list. */
static inline struct hid_row fixture_row(struct usb_fixture *fixture, uint32_t index)
{
    struct hid_row rows[CONTROLLER_MAX];
    const struct hid_device_list device_list = usb_transport_list(fixture->thread);
    device_list.ops->rows(device_list.self, rows);
    return rows[index];
}

#define FIXTURE_WAIT_MS 5000u

/* Waits until row `index` of the device list has the state `state`. Returns 0 on timeout, otherwise
 * 1. */
static inline int fixture_wait_state(struct usb_fixture *fixture, uint32_t index, uint8_t state)
{
    for (uint32_t i = 0; i < FIXTURE_WAIT_MS * 5u; i++) {
        if (fixture_row(fixture, index).state == state) {
            return 1;
        }
        usleep(200);
    }
    return 0;
}

/* Waits until slot `index` has a device, and copies its description to `face`. Returns 0 on
 * timeout, otherwise 1. */
static inline int fixture_open(struct usb_fixture *fixture, uint32_t index,
                               struct hid_device_info *face)
{
    struct hid_port *const port = usb_transport_port(fixture->thread, index);
    for (uint32_t i = 0; i < FIXTURE_WAIT_MS * 5u; i++) {
        if (hid_port_open(port, face) == HAL_OK) {
            return 1;
        }
        usleep(200);
    }
    return 0;
}

/* Waits until the port of slot `index` has a report or an error, and takes it. Returns the result
 * of hid_port_take(), or 0 on timeout. */
static inline int fixture_take(struct usb_fixture *fixture, uint32_t index, struct hid_raw *raw)
{
    struct hid_port *const port = usb_transport_port(fixture->thread, index);
    for (uint32_t i = 0; i < FIXTURE_WAIT_MS * 20u; i++) {
        const int result = hid_port_take(port, raw);
        if (result != 0) {
            return result;
        }
        usleep(50);
    }
    return 0;
}

/* Sends a report that contains the number `number`. */
static inline void fixture_send(uint32_t device, uint32_t number)
{
    uint8_t bytes[POI_REPORT_SIZE] = { POI_REPORT_ID, (uint8_t)number, (uint8_t)(number >> 8) };
    usb_sim_report(device, bytes, sizeof bytes);
}

/* Returns the number in a report that fixture_send() sent. */
static inline uint32_t fixture_number(const struct hid_raw *raw)
{
    return (uint32_t)raw->bytes[1] | (uint32_t)raw->bytes[2] << 8;
}

#endif
