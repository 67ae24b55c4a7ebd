/* hid_port_sim.h -- the simulated twin of a HID transport: raw reports, below the decoder.
 *
 * What a controller says is said to it (hid_port_sim_say(), or a script on the time of a clock);
 * cables and firmware do to it what they do, by the number of the report: unplug, garbage,
 * duplicates, jumps, silence, reports that are short, long, empty or of an id that nobody declared.
 * The caller owns the state. */
#ifndef KINGYO_DRIVERS_HID_PORT_SIM_H
#define KINGYO_DRIVERS_HID_PORT_SIM_H

#include "drivers/hid_port.h"

#define HID_SIM_NEVER UINT32_MAX

/* What befalls reports `from` <= number < `to`; scripts of faults may hold several of a kind. */
enum hid_sim_kind {
    HID_SIM_FINE = 0,
    HID_SIM_SILENCE, /* It never arrives. */
    HID_SIM_GARBAGE, /* Any bytes behind the id. */
    HID_SIM_NOISE,   /* Any bytes at all, of any length. */
    HID_SIM_TWICE,   /* It comes twice. */
    HID_SIM_SHORT,   /* Half of it. */
    HID_SIM_LONG,    /* With bytes behind it that nobody declared. */
    HID_SIM_EMPTY,   /* A transfer of no bytes, which a transport should have swallowed. */
    HID_SIM_WRONG_ID,
    HID_SIM_JUMP,    /* Every byte behind the id at its end: all axes at once. */
    HID_SIM_STUCK,   /* The bytes of the last one again. */
    HID_SIM_KIND_COUNT,
};

struct hid_sim_fault {
    uint8_t kind; /* enum hid_sim_kind */
    uint32_t from, to;
};

struct hid_port_sim {
    struct hal_clock clock;
    const struct hid_face *face;       /* Who sits here; the caller's. Null: nobody ever. */
    const struct hid_raw *script;      /* Said when their time comes; the caller's, by time. */
    uint32_t script_count, script_next;
    const struct hid_sim_fault *faults; /* The caller's. */
    uint32_t fault_count;
    uint32_t unplug_at;                /* Before the report of this number; HID_SIM_NEVER: never. */
    uint64_t replug_ns;                /* From then on open() finds it again. */
    uint8_t absent;                    /* Nobody sits here for now; the caller may change it. */
    uint8_t busy;                      /* send() finds the last report on its way. */

    uint32_t said_count;               /* Reports said so far: the number of the next. */
    uint8_t is_open, gone;
    struct hid_raw last;               /* Said last. */
    struct hid_raw ring[HID_REPORTS_MAX];
    uint32_t ring_first, ring_count;
    uint32_t lost_count, open_count;
    uint8_t sent[HID_REPORT_MAX];      /* The newest output report. */
    uint32_t sent_size, sent_count;
};

/* A fine port in which `face` sits; null: nobody. */
void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_face *face);

/* Its controller sends a report now; what is said while nobody listens is lost. */
void hid_port_sim_say(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size);

struct hid_port hid_port_sim_port(struct hid_port_sim *sim);

#endif
