/* hid_port_sim.h -- the simulated twin of a HID transport, which delivers raw reports.
 *
 * A test sends reports with hid_port_sim_report() or by a script of timestamps. Faults are selected
 * by report number: unplug, garbage, duplicates, jumps, silence, and reports that are short,
 * long, empty or of an undeclared id. The caller owns the state. */
#ifndef KINGYO_DRIVERS_SIM_HID_PORT_SIM_H
#define KINGYO_DRIVERS_SIM_HID_PORT_SIM_H

#include "drivers/hid/hid_port.h"

#define HID_SIM_NEVER UINT32_MAX

/* Fault of the reports `from` <= number < `to`. A list may contain several faults of one kind. */
enum hid_sim_kind {
    HID_SIM_FINE = 0,
    HID_SIM_SILENCE, /* The report is lost. */
    HID_SIM_GARBAGE, /* Random bytes behind the id. */
    HID_SIM_NOISE,   /* Random bytes and a random length. */
    HID_SIM_TWICE,   /* The report arrives twice. */
    HID_SIM_SHORT,   /* Half of the report. */
    HID_SIM_LONG,    /* Undeclared bytes behind the report. */
    HID_SIM_EMPTY,   /* An empty transfer, which a real transport must not pass on. */
    HID_SIM_WRONG_ID,
    HID_SIM_JUMP,  /* Every byte behind the id at its extreme: all axes jump. */
    HID_SIM_STUCK, /* The bytes of the previous report. */
    HID_SIM_KIND_COUNT,
};

struct hid_sim_fault {
    uint8_t kind; /* enum hid_sim_kind */
    uint32_t from, to;
};

struct hid_port_sim {
    struct hal_clock clock;
    /* Attached device, owned by the caller; null for a slot that is never used. */
    const struct hid_device_info *face;
    /* Reports sorted by time and owned by the caller, sent when their time comes. */
    const struct hid_raw *script;
    uint32_t script_count, script_next;
    const struct hid_sim_fault *faults; /* Owned by the caller. */
    uint32_t fault_count;
    /* Number of the report before which the device is unplugged, or HID_SIM_NEVER. */
    uint32_t unplug_at;
    uint64_t replug_ns; /* Time from which open() finds the device again. */
    uint8_t absent;     /* 1 while no device is attached; the caller may change it. */
    uint8_t busy;       /* 1 makes send() return HAL_ERR_BUSY. */

    uint32_t said_count; /* Reports sent so far, which is the number of the next. */
    uint8_t is_open, gone;
    struct hid_raw last; /* The report sent last. */
    struct hid_raw ring[HID_REPORTS_MAX];
    uint32_t ring_first, ring_count;
    uint32_t lost_count, open_count;
    uint8_t sent[HID_REPORT_MAX]; /* The newest output report. */
    uint32_t sent_size, sent_count;
};

/* Initializes a port without faults, to which `face` is attached (null: no device). */
void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_device_info *face);

/* Sends a report now. A report is lost while the port is not open. */
void hid_port_sim_report(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size);

/* Returns the port of the simulated slot. */
struct hid_port hid_port_sim_port(struct hid_port_sim *sim);

#endif
