/* hid_mapping_infer.h -- infers a mapping from recorded motion. A part of hid_learn. */
#ifndef KINGYO_DRIVERS_HID_HID_MAPPING_INFER_H
#define KINGYO_DRIVERS_HID_HID_MAPPING_INFER_H

#include "drivers/hid/hid_learn.h"

/* Returns the descriptor group of a recorded field. */
const struct hid_group *hid_mapping_infer_group(const struct hid_learn *learn,
                                                const struct learn_field *field);

/* Returns 1 if the field reports relative motion. A puck (multi-axis controller) counts as
 * absolute even if its descriptor declares relative axes. */
int hid_mapping_infer_is_relative(const struct hid_group *group);

/* Returns the highest possible value of a field. Some descriptors declare a maximum that does
 * not fit into the field, and some declare none for buttons. */
int64_t hid_mapping_infer_high(const struct hid_group *group);

/* Returns how clearly the current step was demonstrated, [0, 1]. */
float hid_mapping_infer_clarity(const struct hid_learn *learn);

/* Fills learn->map from all steps. Returns 1, or 0 if the recording makes no usable mapping. */
int hid_mapping_infer_map(struct hid_learn *learn);

#endif
