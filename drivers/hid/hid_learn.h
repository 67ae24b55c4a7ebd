/* hid_learn.h -- learns the mapping of a controller from motion that the operator demonstrates in
 * steps: rest, left, right, far, near, dip.
 *
 * Used for controllers that are not known and whose descriptor does not name usable axes. Every
 * field of every report is recorded. For each axis, the field that moved farthest in one step and
 * in the opposite direction in the next step is selected. A field that varies while the controller
 * is at rest is excluded. The operator confirms each step, which calls hid_learn_next(). Pure: all
 * state is in the caller's memory. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "drivers/hid/hid_mapping.h"

/* Largest number of recorded fields. A game pad has 90 fields. Further fields are ignored. */
#define LEARN_FIELD_MAX 256u
#define LEARN_KEY_MAX 16u /* Largest number of recorded keys of array fields. */

/* Recording of one field. For a relative field the values are added, so that all recorded values
 * are positions. */
struct learn_field {
    /* Index of the field's group in the HID descriptor, and index of the field in this group. */
    uint16_t group, index;
    bool reported;               /* True if the field was reported in any step. */
    bool rested;                 /* True if the field was reported in LEARN_REST. */
    int64_t rest_low, rest_high; /* Lowest and highest value of the field in LEARN_REST. */
    int64_t now;                 /* Newest value, or newest sum of a relative field. */
    /* Lowest value of the field in each step. `high` has the highest value in each step. */
    int64_t low[LEARN_STEP_COUNT];
    int64_t high[LEARN_STEP_COUNT];
    int64_t end[LEARN_STEP_COUNT]; /* Value of the field at the end of each step. */
};

/* Recording of one key of an array field. */
struct learn_key {
    uint16_t group; /* Index of the key's group, which has at most HID_ARRAY_MAX elements. */
    /* True if the key was pressed before the step LEARN_DIP. The key is then excluded from the
     * mapping. */
    bool rested;
    hid_usage usage;
};

struct hid_learn {
    struct hid_descriptor descriptor;
    /* Mapping that the controller has without learning. The learned mapping keeps the buttons of
     * this mapping. */
    struct hid_mapping offered;
    struct hid_mapping map; /* The learned mapping, valid in the step LEARN_TRY. */
    uint8_t step;           /* Current step (enum learn_step). */
    uint32_t report_count;  /* Number of reports in the current step. */
    /* Times of the first and of the newest report in the current step. */
    uint64_t begun_ns, now_ns;
    uint32_t field_count, key_count;
    struct learn_field field[LEARN_FIELD_MAX];
    struct learn_key key[LEARN_KEY_MAX];
};

/* Starts with the step LEARN_REST. The step is LEARN_FAILED if the descriptor cannot be parsed,
 * belongs to a keyboard or has no usable fields. */
void hid_learn_begin(struct hid_learn *learn, const struct hid_device_info *face);

/* Records one report. Incomplete and undeclared reports are ignored. */
void hid_learn_report(struct hid_learn *learn, const struct hid_raw *raw);

/* Finishes the current step. After LEARN_DIP the step is LEARN_TRY, or LEARN_FAILED if no usable
 * mapping results from the recording. */
void hid_learn_next(struct hid_learn *learn);

/* Returns how clearly the current step was demonstrated: 0 means not at all, 255 means fully. */
uint8_t hid_learn_progress(const struct hid_learn *learn);

/* ---- Inference from the recording, for hid_learn.c only -------------------------------------- */

/* Returns the descriptor's group of a recorded field. */
const struct hid_group *hid_mapping_infer_group(const struct hid_learn *learn,
                                                const struct learn_field *field);

/* Returns true if the fields of `group` report relative motion. The axes of a multi-axis
 * controller (a 3D mouse or puck) count as absolute even if its descriptor declares them as
 * relative. */
bool hid_mapping_infer_is_relative(const struct hid_group *group);

/* Returns how clearly the current step was demonstrated: 0 means not at all, 1 means fully. */
float hid_mapping_infer_clarity(const struct hid_learn *learn);

/* Fills learn->map from the recording of all steps. Returns true, or false if no usable
 * mapping results. */
bool hid_mapping_infer_map(struct hid_learn *learn);
