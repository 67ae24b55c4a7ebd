/* doctor_rules.h -- which controllers board/udev/70-kingyo.rules lists, and what to tell of any. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_RULES_H
#define KINGYO_PLATFORM_CTL_DOCTOR_RULES_H

#include "platform/ctl/doctor.h"

/* How our rules are put to work for one that they list; else the rule of its own that it needs. */
void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product);

#endif
