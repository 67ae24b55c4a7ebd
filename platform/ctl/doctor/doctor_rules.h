/* doctor_rules.h -- the controllers that board/udev/70-kingyo.rules lists, and the udev advice for
 * each controller. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_RULES_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_RULES_H

#include "platform/ctl/doctor/doctor.h"

/* Writes the udev advice for a controller to `out`. For a listed controller the advice is to
 * install our rules. For any other controller the advice contains the rule that it needs. */
void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product);

#endif
