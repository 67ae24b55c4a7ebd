/* hid_judge.h -- which field was shown as which way, and the map of them. A part of hid_learn. */
#ifndef KINGYO_DRIVERS_HID_JUDGE_H
#define KINGYO_DRIVERS_HID_JUDGE_H

#include "drivers/hid_learn.h"

const struct hid_group *hid_judge_group(const struct hid_learn *learn,
                                        const struct learn_field *field);

/* Whether it gives ways, not places; a puck that says so gives places all the same. */
int hid_judge_is_relative(const struct hid_group *group);

/* Its highest value. Makers declare ranges that no bits of theirs can hold, or for buttons none. */
int64_t hid_judge_high(const struct hid_group *group);

/* [0, 1]: how clearly the present step was seen: how far the farthest field went. */
float hid_judge_clearness(const struct hid_learn *learn);

/* Fills learn->map from all steps; 0: what was shown cannot be a poi. */
int hid_judge_map(struct hid_learn *learn);

#endif
