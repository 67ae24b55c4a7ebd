/* usb_device.c -- classifies a USB device without opening it. */
#include "drivers/usb/usb_device.h"

#include <stdio.h>
#include <string.h>

#include "drivers/usb/usb_sysfs.h"

/* Value of bInterfaceSubClass for interfaces with a boot protocol (HID 1.11, section 4.2). */
#define HID_BOOT 1u
/* Value of bInterfaceProtocol for a boot keyboard (HID 1.11, section 4.3). */
#define HID_BOOT_KEYBOARD 1u
#define HID_CLASS_DESCRIPTOR 0x21u /* Type of the HID class descriptor (HID 1.11, section 7.1). */
#define HID_REPORT_DESCRIPTOR 0x22u
#define PORT_DEPTH_MAX 7 /* Deepest nesting of hubs (USB 3.1, section 10.1). */

/* ---- Classification of devices -------------------------------------------------------------- */

static void name_port(libusb_device *device, char out[32])
{
    uint8_t ports[PORT_DEPTH_MAX];
    const int depth = libusb_get_port_numbers(device, ports, PORT_DEPTH_MAX);
    int length = snprintf(out, 32, "%u", libusb_get_bus_number(device));
    for (int i = 0; i < depth && length < 28; i++) {
        length +=
            snprintf(out + length, 32u - (size_t)length, "%c%u", i == 0 ? '-' : '.', ports[i]);
    }
}

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

static int is_boot_keyboard(const struct libusb_interface_descriptor *interface)
{
    return interface->bInterfaceSubClass == HID_BOOT &&
           interface->bInterfaceProtocol == HID_BOOT_KEYBOARD;
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

void usb_device_evaluate(struct usb_device *device, const struct usb_evaluation *judge)
{
    struct usb_candidate subject = subject_of(device);
    usb_choice_read(&subject, device->face.descriptor, device->face.descriptor_size,
                    judge->scratch);
    device->kind = subject.kind;
    device->worth = subject.worth;
    device->verdict = (uint8_t)usb_choice_evaluate(judge->choice, &subject);
}

/* Classifies `device` by one of its interfaces. A report descriptor that was read from the device
 * itself is kept, because /sys has no descriptor while the interface is claimed. In addition, a
 * kernel driver may put a corrected descriptor into /sys. */
static void look_at(struct usb_device *device, const struct usb_evaluation *judge,
                    const struct libusb_interface_descriptor *interface)
{
    struct hid_device_info *face = &device->face;
    uint8_t bytes[HID_DESCRIPTOR_MAX];
    const uint32_t size =
        usb_sysfs_descriptor(judge->sysfs, face->identity.port, device->configuration,
                             interface->bInterfaceNumber, bytes);
    const int is_same = face->identity.interface_number == interface->bInterfaceNumber;
    if (!is_same || (size > 0u && !device->is_read)) {
        memcpy(face->descriptor, bytes, size);
        face->descriptor_size = size;
        device->is_read = 0;
    }
    face->identity.interface_number = interface->bInterfaceNumber;
    device->is_boot = interface->bInterfaceSubClass == HID_BOOT;
    device->is_boot_keyboard = (uint8_t)is_boot_keyboard(interface);
    device->declared_size = declared_size(interface);
    usb_device_evaluate(device, judge);
}

static int is_better(const struct usb_device *a, const struct usb_device *b,
                     const struct usb_evaluation *judge)
{
    const struct usb_candidate first = subject_of(a), second = subject_of(b);
    return usb_choice_is_better(judge->choice, &first, &second);
}

/* Selects the best HID interface of a device. Only the first alternate setting of each interface is
 * examined, because this setting is active and HID devices have no further settings. Returns 0, or
 * -1 if there is no usable HID interface. */
static int pick_interface(struct usb_device *device, const struct usb_evaluation *judge,
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
        look_at(&found, judge, &interface->altsetting[0]);
        if (!best.device || is_better(&found, &best, judge)) {
            best = found;
        }
    }
    if (!best.device) {
        return -1;
    }
    *device = best;
    return 0;
}

static int usb_device_read_descriptors(struct usb_device *device,
                                       const struct usb_evaluation *judge)
{
    struct libusb_config_descriptor *config;
    if (libusb_get_active_config_descriptor(device->device, &config) != LIBUSB_SUCCESS) {
        return -1;
    }
    device->configuration = config->bConfigurationValue;
    const int result = pick_interface(device, judge, config);
    libusb_free_config_descriptor(config);
    return result;
}

void usb_device_refresh(struct usb_device *device, const struct usb_evaluation *judge)
{
    if (usb_device_read_descriptors(device, judge)) {
        /* The device cannot be read, so it must not be claimed. Its configuration changed, or it is
         * being unplugged. */
        device->verdict = USB_BARRED;
    }
}

int usb_device_add(struct usb_device *out, libusb_device *device,
                   const struct usb_evaluation *judge)
{
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
    name_port(device, identity->port);
    usb_sysfs_text(judge->sysfs, identity->port, "serial", identity->serial);
    usb_sysfs_text(judge->sysfs, identity->port, "product", identity->name);
    if (usb_device_read_descriptors(out, judge)) {
        out->device = NULL;
        return -1;
    }
    libusb_ref_device(device);
    return 0;
}

void usb_device_remove(struct usb_device *device)
{
    libusb_unref_device(device->device);
    device->device = NULL;
}
