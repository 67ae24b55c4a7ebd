/* doctor_rules.h -- advice on udev rules for a controller. The udev rules
 * board/udev/70-kingyo.rules list the controllers to which the kiosk has access. */
#ifndef KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_RULES_H
#define KINGYO_PLATFORM_CTL_DOCTOR_DOCTOR_RULES_H

#include "platform/ctl/doctor/doctor.h"

/* Writes the advice for a controller to `out`. If the rules list the controller, the advice is to
 * install Kingyo's rules. Otherwise the advice contains the rule that must be added for the
 * controller. */
void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product);

#endif
