/* hid_sim.h -- a simulated HID transport: ports, which deliver raw reports to slots, and the list
 * of the connected devices.
 *
 * A test sends reports with hid_port_sim_report(), or by a script of reports with time stamps.
 * Faults are selected by report number: unplugging, garbage, duplicates, jumps, silence, and
 * reports that are short, long, empty or of an undeclared id. The caller owns the state. */
#ifndef KINGYO_DRIVERS_SIM_HID_SIM_H
#define KINGYO_DRIVERS_SIM_HID_SIM_H

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"

#define HID_SIM_NEVER UINT32_MAX

/* Kind of a fault. A fault applies to the reports whose number is at least `from` and less than
 * `to`. A list may contain several faults of one kind. */
enum hid_sim_kind {
    HID_SIM_FINE = 0,
    HID_SIM_SILENCE, /* The report is lost. */
    HID_SIM_GARBAGE, /* The bytes after the id are random. */
    HID_SIM_NOISE,   /* All bytes and the length are random. */
    HID_SIM_TWICE,   /* The report arrives twice. */
    HID_SIM_SHORT,   /* Only the first half of the report arrives. */
    HID_SIM_LONG,    /* Undeclared bytes follow the report. */
    HID_SIM_EMPTY,   /* The transfer is empty. A real transport must not pass on such a report. */
    HID_SIM_WRONG_ID,
    HID_SIM_JUMP,  /* Every byte after the id has its extreme value, so that all axes jump. */
    HID_SIM_STUCK, /* The report has the bytes of the previous report. */
    HID_SIM_KIND_COUNT,
};

struct hid_sim_fault {
    uint8_t kind; /* Kind of the fault (enum hid_sim_kind). */
    uint32_t from, to;
};

struct hid_port_sim {
    struct hal_clock clock;
    /* Attached device, owned by the caller; null for a slot that is never used. */
    const struct hid_device_info *face;
    /* Reports sorted by time, owned by the caller. Each report is sent at its time. */
    const struct hid_raw *script;
    uint32_t script_count, script_next;
    const struct hid_sim_fault *faults; /* List of faults, owned by the caller. */
    uint32_t fault_count;
    /* Number of the report before which the device is unplugged; HID_SIM_NEVER means never. */
    uint32_t unplug_at;
    uint64_t replug_ns; /* Time from which open() finds the device again. */
    uint8_t absent;     /* 1 while no device is attached, otherwise 0; the caller may change it. */
    uint8_t busy;       /* 1 if send() returns HAL_ERR_BUSY, otherwise 0. */

    uint32_t said_count; /* Number of reports sent so far. The next report gets this number. */
    uint8_t is_open, gone;
    struct hid_raw last; /* Last report that was sent. */
    struct hid_raw ring[HID_REPORTS_MAX];
    uint32_t ring_first, ring_count;
    uint32_t lost_count, open_count;
    uint8_t sent[HID_REPORT_MAX]; /* Newest output report. */
    uint32_t sent_size, sent_count;
};

/* Initializes a port without faults to which the device `face` is attached. A null `face` means no
 * device. */
void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_device_info *face);

/* Sends a report at the current time. The report is lost if the port is not open. */
void hid_port_sim_report(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size);

/* Returns the port of the simulated slot. */
struct hid_port hid_port_sim_port(struct hid_port_sim *sim);

/* ---- The device list --------------------------------------------------------------------------
 *
 * A test plugs controllers in and unplugs them. A selected controller is attached to a simulated
 * slot, the place of one of up to four controllers. */

struct hid_device_list_sim {
    struct hid_port_sim *seat[POI_MAX]; /* Port of each slot, owned by the caller; null means that
                                           the slot does not exist. */
    /* Connected device of each row of the device list, owned by the caller; null means that the row
     * has no connected device. */
    const struct hid_device_info *face[CONTROLLER_MAX];
    uint8_t chosen[CONTROLLER_MAX];
    uint8_t barred[CONTROLLER_MAX]; /* 1 if the kiosk must not use the device of the row, for
                                       example a keyboard; otherwise 0. */
    /* Identity of the last device of each row. For a lost controller (CONTROLLER_LOST) the list
     * returns this identity. */
    struct hid_identity who[CONTROLLER_MAX];
    uint8_t denied[CONTROLLER_MAX]; /* 1 if opening the device fails because of missing permission,
                                       otherwise 0. */
    uint8_t taken[CONTROLLER_MAX];  /* Slot of the row's device plus 1; 0 means that the device has
                                       no slot. */
    uint32_t choose_count, release_count;
};

/* Initializes the list with empty rows. `seats` has the ports of the POI_MAX slots; the pointers
 * are copied. */
void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const seats[POI_MAX]);

/* Plugs a controller into an empty row, or unplugs the row's controller if `face` is null. A
 * selected controller is attached to its slot again when it returns. */
void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face);

/* Returns the simulated device list. */
struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim);

#endif
