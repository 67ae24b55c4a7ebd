/* hid_port.h -- a port: one slot for a HID controller, with the lock-free queue of its reports.
 *
 * A slot is the place of one of up to POI_MAX controllers. Two threads share a port. The
 * transport attaches a controller, delivers its reports and detaches it. The frame loop opens the
 * port and takes the reports. The module poi_hid.h decodes the reports. The transport is the event
 * thread of libusb (usb_transport.h) or a simulation (hid_sim.h). Each attachment has a generation
 * number, so that a report of one controller is never taken for a report of the next controller. No
 * call blocks. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/base/panic.h"
#include "platform/hal.h"

/* Largest report, in bytes. Game pads send 64 bytes, the largest pen tablets 192. */
#define HID_REPORT_MAX 256u
/* Capacity of a port's queue, enough for 1,000 reports per second while the frame loop does not
 * run for one second. */
#define HID_REPORTS_MAX 1024u
#define HID_DESCRIPTOR_MAX 4096u /* Largest report descriptor, in bytes. Linux reads no more. */
#define HID_TEXT_SIZE 64u

/* Identity of a controller. The texts are UTF-8 and truncated to fit. "" means that the device does
 * not report the text. */
struct hid_identity {
    uint16_t vendor, product, release;
    uint8_t interface_number;
    char serial[HID_TEXT_SIZE];
    char name[HID_TEXT_SIZE];
    /* USB path of the device. For example, "3-1.4" is bus 3, port 1, and port 4 of the hub at port
     * 1. */
    char port[32];
};

/* Identity and report descriptor of an attached device. The struct is a complete copy, from which a
 * decoder can be initialized. */
struct hid_device_info {
    struct hid_identity identity;
    uint32_t descriptor_size; /* Number of bytes in `descriptor`, at most HID_DESCRIPTOR_MAX. */
    uint8_t descriptor[HID_DESCRIPTOR_MAX];
};

/* An input report as received from the device. */
struct hid_raw {
    /* Time of arrival, read from the HAL clock (hal_clock_ops). The time never decreases from
     * report to report. */
    uint64_t time_ns;
    /* Number of bytes, 1 to HID_REPORT_MAX. A transfer of length 0 is not a report. */
    uint32_t size;
    /* Content of the report, starting with the report id if the device uses report ids. */
    uint8_t bytes[HID_REPORT_MAX];
};

/* ---- Triple buffer --------------------------------------------------------------------------- */

/* The triple buffer passes the newest value from one thread to another without a lock. The owner
 * has an array of three values. The writer uses one value, the reader uses another, and the middle
 * value is the one that was published last. An unread value is overwritten, so the reader only sees
 * the newest value. */
#define TRIPLE_BUFFER_SLOTS 3u
/* Bit of `middle` that is set while the published value was not read yet. The lower bits are the
 * index of the value. */
#define TRIPLE_BUFFER_FRESH 4u

struct triple_buffer {
    uint32_t writing; /* Index of the writer's value, used only by the writer. */
    uint32_t reading; /* Index of the reader's value, used only by the reader. */
    atomic_uint middle;
};

/* Initializes the indices of the buffer. Until the first triple_buffer_fetch() that returns true,
 * the reader uses the value at index 1 of the owner's array. The owner must fill this value before
 * the reader uses it. */
static inline void triple_buffer_init(struct triple_buffer *buffer)
{
    buffer->writing = 0u;
    buffer->reading = 1u;
    atomic_init(&buffer->middle, 2u);
}

/* Publishes the value `buffer->writing` and selects another value to write next. Called only by the
 * writer. Returns true if the previously published value was never read. */
static inline bool triple_buffer_post(struct triple_buffer *buffer)
{
    const unsigned old = atomic_exchange_explicit(
        &buffer->middle, buffer->writing | TRIPLE_BUFFER_FRESH, memory_order_acq_rel);
    buffer->writing = old & (TRIPLE_BUFFER_FRESH - 1u);
    CORE_ASSERT(buffer->writing < TRIPLE_BUFFER_SLOTS);
    return (old & TRIPLE_BUFFER_FRESH) != 0;
}

/* Selects the newest value as `buffer->reading`. Called only by the reader. Returns true if the
 * value is new. */
static inline bool triple_buffer_fetch(struct triple_buffer *buffer)
{
    if (!(atomic_load_explicit(&buffer->middle, memory_order_relaxed) & TRIPLE_BUFFER_FRESH)) {
        return false;
    }
    const unsigned old =
        atomic_exchange_explicit(&buffer->middle, buffer->reading, memory_order_acq_rel);
    buffer->reading = old & (TRIPLE_BUFFER_FRESH - 1u);
    CORE_ASSERT(buffer->reading < TRIPLE_BUFFER_SLOTS);
    return true;
}

/* ---- Port ------------------------------------------------------------------------------------ */

/* Size of a cache line in bytes. The transport and the frame loop write to different cache
 * lines. */
#define HID_PORT_LINE_SIZE 64u

/* A report in the queue. */
struct hid_port_report {
    uint32_t generation; /* Generation number of the controller that sent the report. */
    /* Sequence number of the report. Lost reports are numbered too. The number wraps at 2^32. */
    uint32_t number;
    struct hid_raw raw;
};

/* State of the output report of a port. */
enum hid_port_outgoing {
    HID_PORT_OUT_NONE = 0,  /* The frame loop may write the next output report. */
    HID_PORT_OUT_READY,     /* The transport may send the output report. */
    HID_PORT_OUT_SUBMITTED, /* The transport is sending the output report. */
};

/* A controller that was attached to the port. */
struct hid_attachment {
    uint32_t generation;
    struct hid_device_info face;
};

struct hid_port {
    /* The transport writes the fields from `pushed` to `last_ns`. */
    _Alignas(HID_PORT_LINE_SIZE)
        atomic_uint pushed; /* `pushed` is the number of reports that were added to the queue.
                               `taken` is the number of reports that were removed. Both counters
                               wrap at 2^32. */
    /* Number of reports since hid_port_init() that were dropped, because the queue was full or the
     * report was too long. */
    atomic_uint lost;
    /* Number that increases with each attach and each detach. The number is odd while a controller
     * is attached. */
    atomic_uint generation;
    uint32_t next_number; /* Sequence number of the next report. */
    uint64_t last_ns;     /* Time stamp of the newest report. */
    /* The frame loop writes the fields from `taken` to `wake_self`. */
    _Alignas(HID_PORT_LINE_SIZE) atomic_uint taken;
    /* Generation number at the last successful hid_port_open(). 0 means that hid_port_open() never
     * succeeded. */
    uint32_t opened;
    /* `has_late` is true if `late` contains an unread report. `is_late` is true if that report is
     * the oldest report of the port. */
    bool has_late, is_late;
    bool is_unusable; /* True if no controller can ever be attached. */
    /* Callback that wakes the transport for an output report. The callback must not block. */
    void (*wake)(void *self);
    void *wake_self;
    /* Both threads use the fields from `newest` on. */
    _Alignas(HID_PORT_LINE_SIZE) struct triple_buffer newest; /* Triple buffer for `attachment`. */
    /* Triple buffer for `late`, which holds the newest report while the queue is full. */
    struct triple_buffer overflow;
    struct hid_attachment attachment[TRIPLE_BUFFER_SLOTS];
    struct hid_port_report late[TRIPLE_BUFFER_SLOTS];
    struct hid_port_report queue[HID_REPORTS_MAX];
    /* State of the output report (enum hid_port_outgoing). The state determines which thread may
     * use `out_size`, `out_generation` and `out_bytes`. */
    atomic_uint outgoing;
    uint32_t out_size, out_generation;
    uint8_t out_bytes[HID_REPORT_MAX];
};

/* Initializes an empty port. `wake` is called for each output report. */
void hid_port_init(struct hid_port *port, void (*wake)(void *self), void *wake_self);

/* ---- Functions for the transport ------------------------------------------------------------- */

/* Attaches a controller to an empty port. The identity and the descriptor in `face` are copied. */
void hid_port_attach(struct hid_port *port, const struct hid_device_info *face);

/* Detaches the controller. The frame loop can still take the queued reports. */
void hid_port_detach(struct hid_port *port);

/* Queues a report of the attached controller that was received at `now_ns`. A report of size 0 is
 * ignored. A report of more than HID_REPORT_MAX bytes is counted as lost. While the queue is full,
 * the newest report is kept beside the queue and every other report is counted as lost. The newest
 * report must arrive, because many controllers report only changes. */
void hid_port_report(struct hid_port *port, uint64_t now_ns, const uint8_t *bytes, uint32_t size);

/* Returns the size of the output report that must be sent now, or 0 if there is none. If the size
 * is not 0, the transport owns `out_bytes` until hid_port_sent(). */
uint32_t hid_port_outgoing(struct hid_port *port);

/* Releases the output report, so that the frame loop may write the next one. */
void hid_port_sent(struct hid_port *port);

/* ---- Functions for the frame loop ------------------------------------------------------------ */

/* Opens the port. Returns HAL_OK and fills `out` if a controller is attached. Returns HAL_ERR_GONE
 * if no controller is attached now, or HAL_ERR_ABSENT if no controller can ever be attached. After
 * hid_port_take() returned HAL_ERR_GONE, the caller calls hid_port_open() again until a controller
 * is attached. */
int hid_port_open(struct hid_port *port, struct hid_device_info *out);

/* Removes the oldest report of the opened controller. Returns 1 and fills `out`, or returns 0 if
 * there is no report. Returns HAL_ERR_GONE if the controller was unplugged and its last report was
 * already removed, or HAL_ERR_ABSENT if no controller can ever be attached. */
int hid_port_take(struct hid_port *port, struct hid_raw *out);

/* Sends an output report, which starts with its id. Returns HAL_OK. Returns HAL_ERR_BUSY while the
 * previous report is being sent. After HAL_ERR_BUSY the new report is dropped. Returns HAL_ERR_GONE
 * if the opened controller was unplugged, or HAL_ERR_IO if `size` is not 1 to HID_REPORT_MAX. */
int hid_port_send(struct hid_port *port, const uint8_t *bytes, uint32_t size);
