/* run_interactive.h -- runs the kiosk on a screen until it is closed. */
#ifndef KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H
#define KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H

#include "platform/kiosk/run_common.h"

/* Returns 1 if the kiosk starts without a screen and uses one that appears later. This applies to a
 * start by a service manager ($NOTIFY_SOCKET), where no user could read an error message. */
int run_interactive_waits_for_screen(void);

/* Opens the board. Returns 1 if session->hal has a display or waits for one. */
int run_interactive_open(struct run_common *session);

/* Runs frames until the end. Returns an exit code; errors were reported. */
enum exit_code run_interactive_run(struct run_common *session);

#endif
