/* hid_learn.h -- learns a mapping from demonstrated motion: still, left, right, away, near, dip.
 *
 * For controllers that have no known mapping and no usable usages. Every field of every report
 * is recorded. The field that moved farthest in one direction and then in the opposite one
 * becomes the axis. A field that varies while the controller is at rest is excluded. The
 * operator confirms each step (hid_learn_next()). Pure; all state is in the caller's memory. */
#ifndef KINGYO_DRIVERS_HID_HID_LEARN_H
#define KINGYO_DRIVERS_HID_HID_LEARN_H

#include <stdint.h>

#include "drivers/hid/hid_mapping.h"

/* Fields recorded over all reports; a game pad has 90. Further fields are ignored. */
#define LEARN_FIELD_MAX 256u
#define LEARN_KEY_MAX 16u /* Keys of array fields that are recorded. */

/* Recording of one field: absolute values, or for a relative field the sum of its values. */
struct learn_field {
    uint16_t group, index;
    uint8_t heard, rested;         /* 1 if seen in any report, and 1 if seen in LEARN_REST. */
    int64_t rest_low, rest_high;   /* Range of the values in LEARN_REST. */
    int64_t now;                   /* Newest value, or newest sum of a relative field. */
    int64_t low[LEARN_STEP_COUNT]; /* Lowest and highest value in each step. */
    int64_t high[LEARN_STEP_COUNT];
    int64_t end[LEARN_STEP_COUNT]; /* Value at the end of each step. */
};

/* Recording of one key of an array field. */
struct learn_key {
    uint16_t group; /* Group of at most HID_ARRAY_MAX elements. */
    uint8_t rested; /* 1 if pressed before LEARN_DIP, which excludes the key. */
    hid_usage usage;
};

struct hid_learn {
    struct hid_descriptor descriptor;
    struct hid_mapping offered; /* The mapping without learning, whose buttons are kept. */
    struct hid_mapping map;     /* The learned mapping, valid in LEARN_TRY. */
    uint8_t step;               /* enum learn_step */
    uint32_t report_count;      /* Number of reports in the current step. */
    uint64_t begun_ns, now_ns;  /* Time of the first and the newest report of the current step. */
    uint32_t field_count, key_count;
    struct learn_field field[LEARN_FIELD_MAX];
    struct learn_key key[LEARN_KEY_MAX];
};

/* Starts with LEARN_REST. The step is LEARN_FAILED if the descriptor cannot be parsed, belongs
 * to a keyboard or has no usable fields. */
void hid_learn_begin(struct hid_learn *learn, const struct hid_device_info *face);

/* Records one report. Incomplete and undeclared reports are ignored. */
void hid_learn_report(struct hid_learn *learn, const struct hid_raw *raw);

/* Finishes the current step. After LEARN_DIP the step is LEARN_TRY, or LEARN_FAILED if the
 * recording does not make a usable mapping. */
void hid_learn_next(struct hid_learn *learn);

/* Returns how clearly the current step was demonstrated, 0 .. 255. */
uint8_t hid_learn_progress(const struct hid_learn *learn);

#endif
