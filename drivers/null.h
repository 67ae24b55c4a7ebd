/* null.h -- provides a null driver for each missing device, so that no pointer in struct hal is
 * null. The drivers do nothing, report HAL_ERR_ABSENT and have no state. */
#pragma once

#include "platform/hal.h"

/* Returns null drivers for all devices, a clock that always returns 0, and a slot device whose
 * function arrange() changes no slot. Each describe() returns `line`, which names the missing
 * device and the remedy. The text is not copied and must stay valid. If `line` is null the
 * description is "", which suits a device that this kiosk never has. */
struct hal null_hal(const char *line);
