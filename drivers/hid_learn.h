/* hid_learn.h -- learns a controller by being shown: still, left, right, away, near, dip. Pure.
 *
 * For what no table knows and no usage tells. It looks at every field of every report, and asks of
 * each how far it went in one direction and back the other way; whoever went farthest is the axis.
 * What trembles or counts while all is still is none. Steps go on when whoever holds it says that
 * he did as he was told (hid_learn_next()); all of it lies in the caller's memory. */
#ifndef KINGYO_DRIVERS_HID_LEARN_H
#define KINGYO_DRIVERS_HID_LEARN_H

#include <stdint.h>

#include "drivers/hid_map.h"

#define LEARN_FIELD_MAX 256u /* Of all reports; a pad has 90. Further ones are not heard. */
#define LEARN_KEY_MAX 16u    /* Keys of arrays that went down in a step. */

/* What one field did. Ways are of the values from where it rested; of a relative field, of their
 * sum. */
struct learn_field {
    uint16_t group, index;
    uint8_t heard, rested;         /* It was in a report at all; ... while all was still. */
    int64_t rest_low, rest_high;   /* While all was still. */
    int64_t now;                   /* Newest value or sum. */
    int64_t low[LEARN_STEP_COUNT]; /* The farthest of each step, both ways. */
    int64_t high[LEARN_STEP_COUNT];
    int64_t end[LEARN_STEP_COUNT]; /* Where it was when the step ended. */
};

/* A key of an array. */
struct learn_key {
    uint16_t group; /* Of at most HID_ARRAY_MAX elements. */
    uint8_t rested; /* It was down while all was still: none. */
    hid_usage usage;
};

struct hid_learn {
    struct hid_descriptor descriptor;
    struct hid_map offered; /* What would be played without: its buttons are kept. */
    struct hid_map map;     /* As learned; of LEARN_TRY. */
    uint8_t step;           /* enum learn_step */
    uint32_t report_count;  /* In this step. */
    uint64_t begun_ns, now_ns; /* Of this step's first and newest report. */
    uint32_t field_count, key_count;
    struct learn_field field[LEARN_FIELD_MAX];
    struct learn_key key[LEARN_KEY_MAX];
};

/* Begins with LEARN_REST; LEARN_FAILED where there is nothing to be learned: a descriptor that
 * cannot be read, a keyboard, no fields. */
void hid_learn_begin(struct hid_learn *learn, const struct hid_face *face);

/* Whoever holds it moved it. What is no whole report is passed over. */
void hid_learn_report(struct hid_learn *learn, const struct hid_raw *raw);

/* The step is done. After LEARN_DIP comes LEARN_TRY, or LEARN_FAILED if what was shown cannot be a
 * poi. */
void hid_learn_next(struct hid_learn *learn);

/* 0 .. 255: how clearly the present step was seen. */
uint8_t hid_learn_progress(const struct hid_learn *learn);

#endif
