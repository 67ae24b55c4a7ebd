/* hid_sim.h -- simulated HID controllers: a transport in memory that delivers raw reports to a
 * port, and the list of the connected devices.
 *
 * A test sends reports with hid_port_sim_report(). Faults are selected by report number:
 * unplugging, garbage, duplicates, jumps, silence, and reports that are short, long, empty or of an
 * undeclared id. The caller owns the state. */
#pragma once

#include <stdbool.h>

#include "drivers/hid/hid_device_list.h"
#include "drivers/hid/hid_port.h"

#define HID_SIM_NEVER UINT32_MAX

/* Kind of a fault of a simulated controller. A fault applies to all reports from number `from` to
 * number `to` - 1. A list may contain several faults of one kind. */
enum hid_sim_kind {
    HID_SIM_FINE = 0,
    HID_SIM_SILENCE, /* The report is lost. */
    HID_SIM_GARBAGE, /* The bytes after the id are random. */
    HID_SIM_NOISE,   /* All bytes and the length are random. */
    HID_SIM_TWICE,   /* The report arrives twice. */
    HID_SIM_SHORT,   /* Only the first half of the report arrives. */
    HID_SIM_LONG,    /* Undeclared bytes follow the report. */
    HID_SIM_EMPTY,   /* The transfer is empty, which the port ignores. */
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
    struct hid_port port;
    struct hal_clock clock;
    const struct hid_sim_fault *faults; /* List of faults, owned by the caller. */
    uint32_t fault_count;
    /* The device is unplugged before the report with this number (from 0). HID_SIM_NEVER means
     * never. */
    uint32_t unplug_at;
    /* True if output reports stay pending, so that hid_port_send() returns HAL_ERR_BUSY. */
    bool busy;

    bool is_attached;
    /* Number of reports since the initialization, which is also the number of the next report. */
    uint32_t report_count;
    struct hid_raw last;          /* Report that was delivered last, with its faults. */
    uint8_t sent[HID_REPORT_MAX]; /* Newest output report. */
    uint32_t sent_size;           /* Number of bytes in `sent`. */
};

/* Initializes a port without faults to which the device `face` is attached. A null `face` means no
 * device. */
void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_device_info *face);

/* Unplugs the attached device, and attaches the device `face` unless it is null. `unplug_at`
 * becomes HID_SIM_NEVER. `face` is copied. */
void hid_port_sim_plug(struct hid_port_sim *sim, const struct hid_device_info *face);

/* Delivers a report at the current time. The report is lost if no device is attached. */
void hid_port_sim_report(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size);

/* ---- The device list --------------------------------------------------------------------------
 *
 * A test plugs controllers in and unplugs them. A selected controller is attached to a simulated
 * slot, the place of one of up to four controllers. */

struct hid_device_list_sim {
    /* Port of each slot, owned by the caller. Null means that the slot does not exist. */
    struct hid_port_sim *port[POI_MAX];
    /* Connected device of each row of the device list, owned by the caller. Null means that the row
     * has no connected device. */
    const struct hid_device_info *face[CONTROLLER_MAX];
    bool chosen[CONTROLLER_MAX];
    /* True if the kiosk must not use the device of the row, for example a keyboard. */
    bool barred[CONTROLLER_MAX];
    /* Identity of the last device of each row. For a lost controller (CONTROLLER_LOST) the list
     * returns this identity. */
    struct hid_identity who[CONTROLLER_MAX];
    /* True if opening the device fails because of missing permission. */
    bool denied[CONTROLLER_MAX];
    /* Slot of the row's device plus 1. 0 means that the device has no slot. */
    uint8_t taken[CONTROLLER_MAX];
    uint32_t choose_count, release_count;
};

/* Initializes the list with empty rows. `ports` has the ports of the POI_MAX slots. The pointers
 * are copied. */
void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const ports[POI_MAX]);

/* Plugs a controller into an empty row, or unplugs the row's controller if `face` is null. A
 * selected controller is attached to its slot again when it returns. */
void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face);

/* Returns the simulated device list. */
struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim);
