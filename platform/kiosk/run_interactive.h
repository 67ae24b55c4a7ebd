/* run_interactive.h -- runs the kiosk on a screen until the user or the operator ends it. */
#ifndef KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H
#define KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H

#include "platform/kiosk/run_common.h"

/* Returns 1 if the kiosk may start without a screen and wait for one, otherwise 0. The kiosk waits
 * if a service manager ($NOTIFY_SOCKET) started it, because then no user reads error messages. */
int run_interactive_waits_for_screen(void);

/* Opens the board. Returns 1 if session->hal has a display or waits for one, otherwise 0. */
int run_interactive_open(struct run_common *session);

/* Runs frames until the end. Returns an exit code. Reports all errors before it returns. */
enum exit_code run_interactive_run(struct run_common *session);

#endif
