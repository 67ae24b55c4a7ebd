/* sensor_sim.h -- a six-axis sensor made of memory: trembles as true ones do, breaks as asked.
 *
 * Its reports come at a steady rate; each says where `hand` is, a hair beside it. One fault at a
 * time, between two moments: what cables, radios and sensors do to a hand that does nothing wrong.
 * The caller owns the state and leads the hand. */
#ifndef KINGYO_DRIVERS_SENSOR_SIM_H
#define KINGYO_DRIVERS_SENSOR_SIM_H

#include "platform/hal.h"

#define SENSOR_SIM_HELD_MAX 64u

enum sensor_fault {
    SENSOR_FINE = 0,
    SENSOR_GONE,         /* Unplugged: poll() and open() fail. */
    SENSOR_SILENT,       /* Linked, but nothing comes. */
    SENSOR_HELD_BACK,    /* Nothing comes, and all of it at once when it is over. */
    SENSOR_STUCK,        /* The same bits again and again. */
    SENSOR_JUMPED,       /* A metre aside. */
    SENSOR_FLIPPED,      /* Upside down. */
    SENSOR_NOT_A_NUMBER, /* NaN or infinite, in one field after the other. */
    SENSOR_GARBAGE,      /* Any bits in all fields. */
    SENSOR_TWICE,        /* Each report comes twice. */
    SENSOR_FAULT_COUNT,
};

struct sensor_sim {
    struct hal_clock clock;
    struct poi_target hand;    /* Where it truly is; the caller moves it. */
    uint64_t period_ns;        /* Between two reports. */
    uint8_t fault;             /* enum sensor_fault ... */
    uint64_t from_ns, to_ns;   /* ... from the first of these on, and before the second. */

    uint64_t next_ns;          /* When the next report is due. */
    uint32_t count;            /* Of reports so far; each trembles by its number. */
    uint32_t open_count;
    struct poi_target last;    /* Said in the last report. */
    struct poi_target held[SENSOR_SIM_HELD_MAX]; /* Kept back, oldest first. */
    uint32_t held_count;
    struct view view;          /* As look() said last. */
    struct poi_force felt;     /* What the hand was last made to feel. */
};

/* A fine sensor of `rate_hz` >= 1 reports a second, the hand at the middle of the water. */
void sensor_sim_init(struct sensor_sim *sim, struct hal_clock clock, uint32_t rate_hz);

struct hal_poi sensor_sim_device(struct sensor_sim *sim);

#endif
