/* usb_device.c -- classifies a USB device without opening it, and opens it: claims its interface,
 * reads its report descriptor, and selects the report protocol. */
#include "drivers/usb/usb_device.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

/* Value of bInterfaceSubClass for interfaces with a boot protocol (HID 1.11, section 4.2). */
#define HID_BOOT 1u
/* Value of bInterfaceProtocol for a boot keyboard (HID 1.11, section 4.3). */
#define HID_BOOT_KEYBOARD 1u
#define HID_CLASS_DESCRIPTOR 0x21u /* Type of the HID class descriptor (HID 1.11, section 7.1). */
#define HID_REPORT_DESCRIPTOR 0x22u
#define PORT_DEPTH_MAX 7 /* Deepest nesting of hubs (USB 3.1, section 10.1). */

/* ---- Classification of devices -------------------------------------------------------------- */

/* Reads the interrupt endpoints of an interface. Returns 0, or -1 if the interface has no usable
 * input endpoint. */
static int read_pipe(const struct libusb_interface_descriptor *interface, struct usb_pipe *out)
{
    *out = (struct usb_pipe){ .interface_number = interface->bInterfaceNumber };
    for (uint8_t i = 0; i < interface->bNumEndpoints; i++) {
        const struct libusb_endpoint_descriptor *endpoint = &interface->endpoint[i];
        if ((endpoint->bmAttributes & 0x03u) != LIBUSB_TRANSFER_TYPE_INTERRUPT) {
            continue;
        }
        const uint8_t address = endpoint->bEndpointAddress;
        if (!(address & LIBUSB_ENDPOINT_IN) && out->out_endpoint == 0u) {
            out->out_endpoint = address;
        } else if ((address & LIBUSB_ENDPOINT_IN) && out->in_endpoint == 0u) {
            out->in_endpoint = address;
            out->in_packet_size = endpoint->wMaxPacketSize & 0x7ffu;
        }
    }
    return out->in_endpoint && out->in_packet_size > 0u && out->in_packet_size <= USB_TRANSFER_MAX
               ? 0
               : -1;
}

/* Returns the size of the report descriptor (wDescriptorLength) that the HID class descriptor
 * declares (HID 1.11, section 6.2.1). Returns HID_DESCRIPTOR_MAX if the size is not declared. */
static uint32_t declared_size(const struct libusb_interface_descriptor *interface)
{
    const uint8_t *extra = interface->extra;
    int left = interface->extra_length;
    while (left >= 2 && extra[0] >= 2 && extra[0] <= left) {
        if (extra[1] == HID_CLASS_DESCRIPTOR && extra[0] >= 9 &&
            extra[6] == HID_REPORT_DESCRIPTOR) {
            const uint32_t size = (uint32_t)extra[7] | (uint32_t)extra[8] << 8;
            return size <= HID_DESCRIPTOR_MAX ? size : HID_DESCRIPTOR_MAX;
        }
        left -= extra[0];
        extra += extra[0];
    }
    return HID_DESCRIPTOR_MAX;
}

static struct usb_candidate subject_of(const struct usb_device *device)
{
    return (struct usb_candidate){
        .identity = &device->face.identity,
        .is_boot_keyboard = device->is_boot_keyboard,
        .kind = device->kind,
        .worth = device->worth,
    };
}

/* Sets the kind, the score and the verdict of the device from its current descriptor and the
 * rules. */
static void evaluate(struct usb_device *device, struct usb_evaluation *evaluation)
{
    CORE_ASSERT(device->face.descriptor_size <= HID_DESCRIPTOR_MAX);
    struct usb_candidate subject = subject_of(device);
    usb_choice_read(&subject, device->face.descriptor, device->face.descriptor_size,
                    &evaluation->scratch);
    device->kind = subject.kind;
    device->worth = subject.worth;
    device->verdict = (uint8_t)usb_choice_evaluate(&evaluation->choice, &subject);
}

/* Classifies `device` by one of its interfaces. A report descriptor that was read from the device
 * itself is kept, because /sys has no descriptor while the interface is claimed. The descriptor in
 * /sys may also differ, because a kernel driver may correct it there. */
static void classify(struct usb_device *device, struct usb_evaluation *evaluation,
                     const struct libusb_interface_descriptor *interface)
{
    CORE_ASSERT(interface->bInterfaceClass == LIBUSB_CLASS_HID);
    struct hid_device_info *face = &device->face;
    uint8_t bytes[HID_DESCRIPTOR_MAX];
    const uint32_t size =
        usb_sysfs_descriptor(evaluation->sysfs, face->identity.port, device->configuration,
                             interface->bInterfaceNumber, bytes);
    const bool is_same = face->identity.interface_number == interface->bInterfaceNumber;
    if (!is_same || (size > 0u && !device->is_read)) {
        memcpy(face->descriptor, bytes, size);
        face->descriptor_size = size;
        device->is_read = false;
    }
    face->identity.interface_number = interface->bInterfaceNumber;
    device->is_boot = interface->bInterfaceSubClass == HID_BOOT;
    device->is_boot_keyboard =
        device->is_boot && interface->bInterfaceProtocol == HID_BOOT_KEYBOARD;
    device->declared_size = declared_size(interface);
    evaluate(device, evaluation);
}

/* Selects the best HID interface of a device. Only the first alternate setting of each interface is
 * examined, because this setting is active and HID devices have no further settings. Returns 0, or
 * -1 if there is no usable HID interface. */
static int pick_interface(struct usb_device *device, struct usb_evaluation *evaluation,
                          const struct libusb_config_descriptor *config)
{
    struct usb_device best = { .device = NULL };
    for (uint8_t i = 0; i < config->bNumInterfaces; i++) {
        const struct libusb_interface *interface = &config->interface[i];
        struct usb_device found = *device;
        if (interface->num_altsetting < 1 ||
            interface->altsetting[0].bInterfaceClass != LIBUSB_CLASS_HID ||
            read_pipe(&interface->altsetting[0], &found.pipe)) {
            continue;
        }
        classify(&found, evaluation, &interface->altsetting[0]);
        const struct usb_candidate one = subject_of(&found), other = subject_of(&best);
        if (!best.device || usb_choice_is_better(&evaluation->choice, &one, &other)) {
            best = found;
        }
    }
    if (!best.device) {
        return -1;
    }
    *device = best;
    return 0;
}

static int read_descriptors(struct usb_device *device, struct usb_evaluation *evaluation)
{
    struct libusb_config_descriptor *config;
    if (libusb_get_active_config_descriptor(device->device, &config) != LIBUSB_SUCCESS) {
        return -1;
    }
    device->configuration = config->bConfigurationValue;
    const int result = pick_interface(device, evaluation, config);
    libusb_free_config_descriptor(config);
    return result;
}

void usb_device_refresh(struct usb_device *device, struct usb_evaluation *evaluation)
{
    CORE_ASSERT(device->device);
    if (read_descriptors(device, evaluation)) {
        /* The device's configuration has changed, or the device is being unplugged. The
         * configuration of such a device cannot be read, and a device without a readable
         * configuration must not be claimed. */
        device->verdict = USB_BARRED;
    }
}

int usb_device_add(struct usb_device *out, libusb_device *device, struct usb_evaluation *evaluation)
{
    CORE_ASSERT(device);
    CORE_ASSERT(evaluation->sysfs[0]);
    struct libusb_device_descriptor descriptor;
    if (libusb_get_device_descriptor(device, &descriptor) != LIBUSB_SUCCESS ||
        descriptor.bDeviceClass == LIBUSB_CLASS_HUB) {
        return -1;
    }
    *out = (struct usb_device){
        .device = device,
        .serial_index = descriptor.iSerialNumber,
        .product_index = descriptor.iProduct,
        .face.identity = {
            .vendor = descriptor.idVendor,
            .product = descriptor.idProduct,
            .release = descriptor.bcdDevice,
        },
    };
    struct hid_identity *identity = &out->face.identity;
    uint8_t ports[PORT_DEPTH_MAX];
    const int depth = libusb_get_port_numbers(device, ports, PORT_DEPTH_MAX);
    int length =
        snprintf(identity->port, sizeof identity->port, "%u", libusb_get_bus_number(device));
    for (int i = 0; i < depth && length < 28; i++) {
        length += snprintf(identity->port + length, sizeof identity->port - (size_t)length, "%c%u",
                           i == 0 ? '-' : '.', ports[i]);
    }
    usb_sysfs_text(evaluation->sysfs, identity->port, "serial", identity->serial);
    usb_sysfs_text(evaluation->sysfs, identity->port, "product", identity->name);
    if (read_descriptors(out, evaluation)) {
        out->device = NULL;
        return -1;
    }
    libusb_ref_device(device);
    return 0;
}

void usb_device_remove(struct usb_device *device)
{
    CORE_ASSERT(device->device);
    libusb_unref_device(device->device);
    device->device = NULL;
}

/* ---- Opening --------------------------------------------------------------------------------- */

#define HID_SET_IDLE 0x0au /* Code of the request SET_IDLE (HID 1.11, section 7.2). */
#define HID_SET_PROTOCOL 0x0bu
#define DESCRIPTOR_MS 1000u
#define REQUEST_MS 250u

static enum usb_device_fault fault_of_error(int error)
{
    const bool is_away = error == LIBUSB_ERROR_NO_DEVICE || error == LIBUSB_ERROR_NOT_FOUND;
    return error == LIBUSB_SUCCESS        ? USB_FINE
           : error == LIBUSB_ERROR_ACCESS ? USB_DENIED
           : error == LIBUSB_ERROR_BUSY   ? USB_HELD
           : is_away                      ? USB_AWAY
                                          : USB_BROKEN;
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
        device->is_read = true;
        return USB_FINE;
    }
    return size == LIBUSB_ERROR_NO_DEVICE      ? USB_AWAY
           : device->face.descriptor_size > 0u ? USB_FINE
                                               : USB_BROKEN;
}

static enum usb_device_fault inspect_usb_device(libusb_device_handle *handle,
                                                struct usb_device *device,
                                                struct usb_evaluation *evaluation)
{
    CORE_ASSERT(device->declared_size <= HID_DESCRIPTOR_MAX);
    read_text(handle, device->serial_index, device->face.identity.serial);
    read_text(handle, device->product_index, device->face.identity.name);
    const enum usb_device_fault trouble = read_descriptor(handle, device);
    if (trouble != USB_FINE) {
        return trouble;
    }
    evaluate(device, evaluation);
    if (device->verdict != USB_PLAYS) {
        return USB_FINE;
    }
    /* The transfers need the size of the largest input report. */
    struct hid_descriptor *scratch = &evaluation->scratch;
    uint32_t most = 0;
    hid_descriptor_read(scratch, device->face.descriptor, device->face.descriptor_size);
    for (uint32_t id = 0; id < 256u; id++) {
        const uint32_t size = (scratch->report_bits[id] + 7u) / 8u;
        most = size > most ? size : most;
    }
    device->pipe.has_report_ids = scratch->has_report_ids;
    device->pipe.report_size_max = most + scratch->has_report_ids;
    /* A device may reject requests of HID 1.11 section 7.2 that it does not support. Therefore only
     * the disconnection of the device is an error. */
    const bool is_gone =
        (device->is_boot &&
         interface_request(handle, device, HID_SET_PROTOCOL, 1u) == LIBUSB_ERROR_NO_DEVICE) ||
        interface_request(handle, device, HID_SET_IDLE, 0u) == LIBUSB_ERROR_NO_DEVICE;
    return is_gone ? USB_AWAY : USB_FINE;
}

enum usb_device_fault usb_device_open(struct usb_device *device, struct usb_evaluation *evaluation,
                                      libusb_device_handle **out)
{
    CORE_ASSERT(device->device);
    CORE_ASSERT(device->verdict == USB_ASK || device->verdict == USB_PLAYS);
    libusb_device_handle *handle;
    *out = NULL;
    enum usb_device_fault trouble = fault_of_error(libusb_open(device->device, &handle));
    if (trouble != USB_FINE) {
        return trouble;
    }
    libusb_set_auto_detach_kernel_driver(handle, 1);
    trouble = fault_of_error(libusb_claim_interface(handle, device->pipe.interface_number));
    if (trouble == USB_FINE) {
        trouble = inspect_usb_device(handle, device, evaluation);
        if (trouble == USB_FINE && device->verdict == USB_PLAYS) {
            *out = handle;
            return USB_FINE;
        }
        libusb_release_interface(handle, device->pipe.interface_number);
    }
    libusb_close(handle);
    return trouble;
}
