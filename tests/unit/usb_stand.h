/* usb_stand.h -- a USB bus made of memory: the part of libusb that the drivers call, linked in its
 * place, over devices that a test plugs in and pulls out while the drivers' thread runs.
 *
 * It behaves as libusb 1.0.26 on Linux does, and watches its caller: what must not be done is
 * counted as a breach and said on standard error. */
#ifndef KINGYO_TESTS_USB_STAND_H
#define KINGYO_TESTS_USB_STAND_H

#include <stdint.h>

#define STAND_DEVICE_MAX 4096u    /* Of one test's life; a storm plugs many. */
#define STAND_INTERFACE_MAX 4u
#define STAND_WIRE_MAX 4096u      /* Reports that wait for a transfer. */

/* What a kind of device declares of itself. */
struct stand_interface {
    uint8_t class, subclass, protocol;
    uint16_t packet_size;      /* 0: no interrupt endpoint. */
    uint8_t has_out;
    const uint8_t *descriptor; /* Of its reports. */
    uint32_t descriptor_size;
    const uint8_t *mended;     /* What /sys shows in its place; null: the same. */
    uint32_t mended_size;
};

struct stand_kind {
    uint16_t vendor, product;
    const char *name, *serial; /* Null: none. */
    uint8_t is_bound;          /* A HID driver of the kernel has it: /sys shows the descriptor. */
    uint32_t interface_count;
    struct stand_interface interface[STAND_INTERFACE_MAX];
};

/* How it shows that a cable was pulled. */
enum stand_parting {
    STAND_GONE = 0, /* Every transfer says NO_DEVICE, and then hot-plug does. */
    STAND_IO_FIRST, /* One says ERROR, the others NO_DEVICE. */
    STAND_LATE,     /* As STAND_GONE; hot-plug says nothing until stand_announce(). */
    STAND_QUIET,    /* Hot-plug speaks first; transfers come back only when cancelled. */
};

/* Empty bus, no faults. `sysfs` is a folder of the test's own, or null. */
void stand_begin(const char *sysfs);

/* 0 when all was given back: handles, devices, transfers, lists; else how much was not. */
uint32_t stand_end(void);

/* "3-1": plugs in at bus 3, port 1. Which it is, from 0. */
uint32_t stand_plug(const struct stand_kind *kind, uint8_t port);
void stand_unplug(uint32_t device, enum stand_parting how);
void stand_announce(uint32_t device);

/* One report on the wire, or a short packet of length 0. */
void stand_report(uint32_t device, const uint8_t *bytes, uint32_t size);

/* The next transfer that would come back does so with this libusb_transfer_status. */
void stand_fail(uint32_t device, int status);

/* How many reports no transfer has taken yet. */
uint32_t stand_waiting(uint32_t device);

/* What was done to it. */
struct stand_seen {
    uint32_t opens, closes, claims, releases;
    uint32_t claimed_interfaces; /* A bit each, ever. */
    uint32_t in_flight, in_flight_max;
    uint32_t clear_halts, set_idles, set_protocols, descriptor_reads;
    uint32_t outs, set_reports;  /* Output reports that arrived, by either way. */
    uint32_t out_size;
    uint8_t out[64];             /* The newest, with what came before it on the control pipe. */
    uint16_t set_report_value;
};
struct stand_seen stand_seen(uint32_t device);

/* Faults, of every device. */
struct stand_faults {
    int open_error, claim_error; /* enum libusb_error */
    uint32_t close_ms;           /* libusb_close() takes so long. */
    uint32_t cancel_ms;          /* A cancelled transfer comes back so much later. */
    uint8_t stalls_requests;     /* SET_IDLE and SET_PROTOCOL are unknown. */
    uint8_t hold_outs;           /* Output reports are taken from the host only after this ends. */
    uint8_t lets_outs_time_out;
    uint8_t is_unconfigured;     /* The kernel has not chosen a configuration yet. */
    uint8_t hides_descriptor;    /* GET_DESCRIPTOR of the report descriptor is refused. */
    int init_error;
    uint8_t no_hotplug;
};
void stand_set_faults(const struct stand_faults *faults);

/* What was done wrong since stand_begin(): talking to a device from within a callback, closing
 * under a transfer, using what was closed, calling from a thread that is not the drivers' own. */
uint32_t stand_breaches(void);

/* All calls of libusb so far but those that set up and tear down. */
uint32_t stand_calls(void);

#endif
