/* usb_mail.h -- the newest value of something large, from one thread to another, without a lock.
 *
 * The owner keeps three of it: one is being written, one read, and one lies between them. What was
 * not fetched before the next was posted is never seen, which is what newest means. */
#ifndef KINGYO_DRIVERS_USB_MAIL_H
#define KINGYO_DRIVERS_USB_MAIL_H

#include <stdatomic.h>
#include <stdint.h>

#define USB_MAIL_SLOTS 3u
#define USB_MAIL_FRESH 4u /* Beside the index of the slot in the middle: nobody fetched it yet. */

struct usb_mail {
    uint32_t writing;   /* The writer's alone. */
    uint32_t reading;   /* The reader's alone. */
    atomic_uint middle;
};

/* The reader sees slot 1, which the owner has filled, until something is posted. */
static inline void usb_mail_init(struct usb_mail *mail)
{
    mail->writing = 0u;
    mail->reading = 1u;
    atomic_init(&mail->middle, 2u);
}

/* Writer: slot `mail->writing` is whole; it writes the next value into another one. 1: nobody
 * fetched the one before. */
static inline int usb_mail_post(struct usb_mail *mail)
{
    const unsigned old = atomic_exchange_explicit(&mail->middle, mail->writing | USB_MAIL_FRESH,
                                                  memory_order_acq_rel);
    mail->writing = old & (USB_MAIL_FRESH - 1u);
    return (old & USB_MAIL_FRESH) != 0;
}

/* Reader: from now on slot `mail->reading` is the newest. 1: it is another one than before. */
static inline int usb_mail_fetch(struct usb_mail *mail)
{
    if (!(atomic_load_explicit(&mail->middle, memory_order_relaxed) & USB_MAIL_FRESH)) {
        return 0;
    }
    const unsigned old =
        atomic_exchange_explicit(&mail->middle, mail->reading, memory_order_acq_rel);
    mail->reading = old & (USB_MAIL_FRESH - 1u);
    return 1;
}

#endif
