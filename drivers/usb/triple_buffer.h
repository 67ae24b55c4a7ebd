/* triple_buffer.h -- a lock-free triple buffer, which passes the newest value from one thread to
 * another.
 *
 * The owner has three slots (array elements) for values. The writer uses one slot, the reader uses
 * another, and the middle slot holds the last published value. An unread value is overwritten, so
 * the reader only sees the newest value. */
#ifndef KINGYO_DRIVERS_USB_TRIPLE_BUFFER_H
#define KINGYO_DRIVERS_USB_TRIPLE_BUFFER_H

#include <stdatomic.h>
#include <stdint.h>

#include "core/base/panic.h"

#define TRIPLE_BUFFER_SLOTS 3u
/* Bit of `middle` that is set while the published value was not read yet. The lower bits are the
 * slot index. */
#define TRIPLE_BUFFER_FRESH 4u

struct triple_buffer {
    uint32_t writing; /* Index of the writer's slot, used only by the writer. */
    uint32_t reading; /* Index of the reader's slot, used only by the reader. */
    atomic_uint middle;
};

/* Initializes the buffer. Until the first triple_buffer_post() the reader uses slot 1, which the
 * owner must have filled. */
static inline void triple_buffer_init(struct triple_buffer *mail)
{
    mail->writing = 0u;
    mail->reading = 1u;
    atomic_init(&mail->middle, 2u);
}

/* Publishes the slot `mail->writing` and selects another slot for the next value. Called only by
 * the writer. Returns 1 if the previous value was never read, otherwise 0. */
static inline int triple_buffer_post(struct triple_buffer *mail)
{
    const unsigned old = atomic_exchange_explicit(
        &mail->middle, mail->writing | TRIPLE_BUFFER_FRESH, memory_order_acq_rel);
    mail->writing = old & (TRIPLE_BUFFER_FRESH - 1u);
    CORE_ASSERT(mail->writing < TRIPLE_BUFFER_SLOTS);
    return (old & TRIPLE_BUFFER_FRESH) != 0;
}

/* Selects the newest value as slot `mail->reading`. Called only by the reader. Returns 1 if the
 * value is new, otherwise 0. */
static inline int triple_buffer_fetch(struct triple_buffer *mail)
{
    if (!(atomic_load_explicit(&mail->middle, memory_order_relaxed) & TRIPLE_BUFFER_FRESH)) {
        return 0;
    }
    const unsigned old =
        atomic_exchange_explicit(&mail->middle, mail->reading, memory_order_acq_rel);
    mail->reading = old & (TRIPLE_BUFFER_FRESH - 1u);
    CORE_ASSERT(mail->reading < TRIPLE_BUFFER_SLOTS);
    return 1;
}

#endif
