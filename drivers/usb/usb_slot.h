/* usb_slot.h -- one slot for a USB controller, shared between the event thread and the frame loop.
 *
 * The event thread attaches a controller, delivers its reports and detaches it. The frame loop uses
 * the slot as a struct hid_port. Each attachment has a generation number, so that a report of one
 * controller is never taken for a report of the next controller. No call blocks. */
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
    USB_OUT_SUBMITTED, /* The event thread is sending the report. */
};

struct usb_attachment {
    uint32_t generation;
    struct hid_device_info face;
};

struct usb_slot {
    /* The event thread and the frame loop share the fields from `ring` to `out_bytes`. */
    struct report_ring ring;
    atomic_uint generation; /* Number that increases with each attach and each detach. It is odd
                               while a controller is attached. */
    struct triple_buffer mail;
    struct usb_attachment attachment[TRIPLE_BUFFER_SLOTS];
    /* State of the output report (enum usb_outgoing). The state determines which thread may use
     * `out_size`, `out_generation` and `out_bytes`. */
    atomic_uint outgoing;
    uint32_t out_size, out_generation;
    uint8_t out_bytes[HID_REPORT_MAX];
    /* Only the event thread uses `last_ns`. */
    uint64_t last_ns; /* Time stamp of the newest report. */
    /* Only the frame loop uses the fields from `opened` on. */
    uint32_t opened;  /* Generation number at the last successful open(); 0 means that open() never
                         succeeded. */
    uint8_t is_never; /* 1 if USB is not available at all, otherwise 0. */
    struct hid_identity identity;
    void (*wake)(void *self); /* Wakes the event thread for an output report. The callback must not
                                 block. */
    void *wake_self;
    char text[HAL_TEXT_SIZE];
};

/* Initializes an empty slot. `wake` is called for each output report. */
void usb_slot_init(struct usb_slot *seat, void (*wake)(void *self), void *wake_self);

/* ---- Functions for the event thread --------- */

/* Attaches a controller to an empty slot. `face` is copied. */
void usb_slot_attach(struct usb_slot *seat, const struct hid_device_info *face);

/* Detaches the controller. The queued reports can still be read. */
void usb_slot_detach(struct usb_slot *seat);

/* Queues a report of the attached controller that was received at `now_ns`. A report of size 0 is
 * ignored. A report of more than HID_REPORT_MAX bytes is counted as lost. */
void usb_slot_report(struct usb_slot *seat, uint64_t now_ns, const uint8_t *bytes, uint32_t size);

/* Returns the size of the output report that must be sent now, or 0 if there is none. If the size
 * is not 0, the event thread owns `out_bytes` until usb_slot_sent(). */
uint32_t usb_slot_outgoing(struct usb_slot *seat);

/* Releases the output report, so that the frame loop may write the next one. */
void usb_slot_sent(struct usb_slot *seat);

/* ---- Functions for the frame loop --------------- */

/* Returns the port of the slot for poi_hid.h. */
struct hid_port usb_slot_port(struct usb_slot *seat);

#endif
