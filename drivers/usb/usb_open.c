/* usb_open.c -- opens a controller: claims its interface, reads its report descriptor, and selects
 * the report protocol. */
#include <stdio.h>
#include <string.h>

#include "drivers/usb/usb_device.h"
#include "drivers/usb/usb_sysfs.h"

#define HID_REPORT_DESCRIPTOR 0x22u /* Type of a report descriptor (HID 1.11, section 7.1). */
#define HID_SET_IDLE 0x0au          /* Code of the request SET_IDLE (HID 1.11, section 7.2). */
#define HID_SET_PROTOCOL 0x0bu
#define DESCRIPTOR_MS 1000u
#define REQUEST_MS 250u

static enum usb_device_fault trouble_of(int error)
{
    switch (error) {
    case LIBUSB_SUCCESS:
        return USB_FINE;
    case LIBUSB_ERROR_ACCESS:
        return USB_DENIED;
    case LIBUSB_ERROR_BUSY:
        return USB_HELD;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
        return USB_AWAY;
    default:
        return USB_BROKEN;
    }
}

static void read_text(libusb_device_handle *handle, uint8_t index, char out[HID_TEXT_SIZE])
{
    unsigned char text[HID_TEXT_SIZE];
    const int size = index == 0u || out[0]
                         ? -1
                         : libusb_get_string_descriptor_ascii(handle, index, text, sizeof text);
    if (size > 0) {
        snprintf(out, HID_TEXT_SIZE, "%.*s", size, (const char *)text);
        usb_sysfs_clean_text(out);
    }
}

static int interface_request(libusb_device_handle *handle, const struct usb_device *device,
                             uint8_t request, uint16_t value)
{
    const uint8_t type =
        LIBUSB_ENDPOINT_OUT | LIBUSB_REQUEST_TYPE_CLASS | LIBUSB_RECIPIENT_INTERFACE;
    return libusb_control_transfer(handle, type, request, value, device->pipe.interface_number,
                                   NULL, 0, REQUEST_MS);
}

/* Reads the report descriptor with GET_DESCRIPTOR (HID 1.11, section 7.1.1). A kernel driver may
 * put a corrected descriptor into /sys and correct the reports to match. Kingyo receives the
 * reports unmodified, so it needs the original descriptor. The descriptor of /sys is used only if
 * the device does not respond. */
static enum usb_device_fault read_descriptor(libusb_device_handle *handle,
                                             struct usb_device *device)
{
    const uint8_t type =
        LIBUSB_ENDPOINT_IN | LIBUSB_REQUEST_TYPE_STANDARD | LIBUSB_RECIPIENT_INTERFACE;
    uint8_t bytes[HID_DESCRIPTOR_MAX];
    const int size = libusb_control_transfer(
        handle, type, LIBUSB_REQUEST_GET_DESCRIPTOR, HID_REPORT_DESCRIPTOR << 8,
        device->pipe.interface_number, bytes, (uint16_t)device->declared_size, DESCRIPTOR_MS);
    if (size > 0) {
        memcpy(device->face.descriptor, bytes, (size_t)size);
        device->face.descriptor_size = (uint32_t)size;
        device->is_read = 1;
        return USB_FINE;
    }
    if (size != LIBUSB_ERROR_NO_DEVICE && device->face.descriptor_size > 0u) {
        return USB_FINE;
    }
    return size == LIBUSB_ERROR_NO_DEVICE ? USB_AWAY : USB_BROKEN;
}

/* Computes the size of the largest input report, which the transfers need. */
static void measure_reports(struct usb_device *device, struct hid_descriptor *scratch)
{
    uint32_t most = 0;
    hid_descriptor_read(scratch, device->face.descriptor, device->face.descriptor_size);
    for (uint32_t id = 0; id < 256u; id++) {
        const uint32_t size = (scratch->report_bits[id] + 7u) / 8u;
        most = size > most ? size : most;
    }
    device->pipe.has_report_ids = scratch->has_report_ids;
    device->pipe.report_size_max = most + scratch->has_report_ids;
}

/* Sends the requests of HID 1.11 section 7.2 to a claimed interface. A device may reject requests
 * that it does not support, so only a disconnected device is an error. */
static enum usb_device_fault make_ready(libusb_device_handle *handle, struct usb_device *device)
{
    if (device->is_boot &&
        interface_request(handle, device, HID_SET_PROTOCOL, 1u) == LIBUSB_ERROR_NO_DEVICE) {
        return USB_AWAY;
    }
    return interface_request(handle, device, HID_SET_IDLE, 0u) == LIBUSB_ERROR_NO_DEVICE ? USB_AWAY
                                                                                         : USB_FINE;
}

static enum usb_device_fault learn(libusb_device_handle *handle, struct usb_device *device,
                                   const struct usb_evaluation *judge)
{
    read_text(handle, device->serial_index, device->face.identity.serial);
    read_text(handle, device->product_index, device->face.identity.name);
    const enum usb_device_fault trouble = read_descriptor(handle, device);
    if (trouble != USB_FINE) {
        return trouble;
    }
    usb_device_evaluate(device, judge);
    if (device->verdict != USB_PLAYS) {
        return USB_FINE;
    }
    measure_reports(device, judge->scratch);
    return make_ready(handle, device);
}

enum usb_device_fault usb_device_open(struct usb_device *device, const struct usb_evaluation *judge,
                                      libusb_device_handle **out)
{
    libusb_device_handle *handle;
    *out = NULL;
    enum usb_device_fault trouble = trouble_of(libusb_open(device->device, &handle));
    if (trouble != USB_FINE) {
        return trouble;
    }
    libusb_set_auto_detach_kernel_driver(handle, 1);
    trouble = trouble_of(libusb_claim_interface(handle, device->pipe.interface_number));
    if (trouble == USB_FINE) {
        trouble = learn(handle, device, judge);
        if (trouble == USB_FINE && device->verdict == USB_PLAYS) {
            *out = handle;
            return USB_FINE;
        }
        libusb_release_interface(handle, device->pipe.interface_number);
    }
    libusb_close(handle);
    return trouble;
}
