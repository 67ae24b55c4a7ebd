/* hid_mapping_infer.h -- infers a mapping from recorded motion. A private part of hid_learn. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_INFER_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_INFER_H

#include "drivers/hid/hid_learn.h"

/* Returns the descriptor's group of a recorded field. */
const struct hid_group *hid_mapping_infer_group(const struct hid_learn *learn,
                                                const struct learn_field *field);

/* Returns 1 if the fields of `group` report relative motion, otherwise 0. The axes of a multi-axis
 * controller (a 3D mouse or puck) count as absolute even if its descriptor declares them as
 * relative. */
int hid_mapping_infer_is_relative(const struct hid_group *group);

/* Returns the highest possible value of the fields of `group`. Some descriptors declare a maximum
 * that does not fit into the field, and some declare no maximum for buttons. */
int64_t hid_mapping_infer_high(const struct hid_group *group);

/* Returns how clearly the current step was demonstrated: 0 means not at all, 1 means fully. */
float hid_mapping_infer_clarity(const struct hid_learn *learn);

/* Fills learn->map from the recording of all steps. Returns 1, or 0 if no usable mapping
 * results. */
int hid_mapping_infer_map(struct hid_learn *learn);

#endif
