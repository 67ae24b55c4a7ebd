/* usb_slot.h -- one slot, shared between the event thread and the frame loop.
 *
 * The event thread attaches a controller, delivers its reports and detaches it. The frame loop
 * uses the slot as a struct hid_port. Each attachment has a generation number, so that no report
 * is credited to the next controller. No call blocks. */
#ifndef KINGYO_DRIVERS_USB_USB_SLOT_H
#define KINGYO_DRIVERS_USB_USB_SLOT_H

#include <stdatomic.h>
#include <stdint.h>

#include "drivers/hid/hid_port.h"
#include "drivers/usb/report_ring.h"
#include "drivers/usb/triple_buffer.h"

/* State of the slot's output report. */
enum usb_outgoing {
    USB_OUT_NONE = 0,  /* The frame loop may write the next report. */
    USB_OUT_READY,     /* The event thread may send the report. */
    USB_OUT_SUBMITTED, /* The transfer of the report is in flight. */
};

struct usb_attachment {
    uint32_t generation;
    struct hid_device_info face;
};

struct usb_slot {
    /* The following fields are shared by both threads. */
    struct report_ring ring;
    atomic_uint generation; /* Number of the attachment; odd while a controller is attached. */
    struct triple_buffer mail;
    struct usb_attachment attachment[TRIPLE_BUFFER_SLOTS];
    /* enum usb_outgoing; selects the thread that owns the next three fields. */
    atomic_uint outgoing;
    uint32_t out_size, out_generation;
    uint8_t out_bytes[HID_REPORT_MAX];
    /* The following field is used only by the event thread. */
    uint64_t last_ns; /* Time stamp of the newest report. */
    /* The following fields are used only by the frame loop. */
    uint32_t opened;  /* Generation that the frame loop opened last; 0: none. */
    uint8_t is_never; /* 1 if USB is not available at all. */
    struct hid_identity identity;
    void (*wake)(void *self); /* Wakes the event thread for an output report; does not block. */
    void *wake_self;
    char text[HAL_TEXT_SIZE];
};

/* Initializes an empty slot. `wake` is called for each output report. */
void usb_slot_init(struct usb_slot *seat, void (*wake)(void *self), void *wake_self);

/* ---- Event thread --------- */

/* Attaches a controller to an empty slot. `face` is copied. */
void usb_slot_attach(struct usb_slot *seat, const struct hid_device_info *face);

/* Detaches the controller. The queued reports can still be read. */
void usb_slot_detach(struct usb_slot *seat);

/* Queues a report of the attached controller, received at `now_ns`. Size 0 is ignored, and a
 * report of more than HID_REPORT_MAX bytes counts as lost. */
void usb_slot_report(struct usb_slot *seat, uint64_t now_ns, const uint8_t *bytes, uint32_t size);

/* Returns the size of the output report to send now, or 0. The event thread owns `out_bytes`
 * until usb_slot_sent(). */
uint32_t usb_slot_outgoing(struct usb_slot *seat);

/* Releases the output report, so that the frame loop may write the next one. */
void usb_slot_sent(struct usb_slot *seat);

/* ---- Frame loop --------------- */

/* Returns the port of the slot for poi_hid.h. */
struct hid_port usb_slot_port(struct usb_slot *seat);

#endif
