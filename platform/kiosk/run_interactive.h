/* run_interactive.h -- runs the kiosk on a screen until the user or the operator ends it. */
#ifndef KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H
#define KINGYO_PLATFORM_KIOSK_RUN_INTERACTIVE_H

#include "platform/kiosk/run_common.h"

/* Returns 1 if a service manager started the kiosk ($NOTIFY_SOCKET is set), otherwise 0. In a
 * service, the kiosk starts without a screen and waits for one, because no user would read an error
 * message. */
int run_interactive_waits_for_screen(void);

/* Opens the board's devices. Returns 1 if the display is open, or if the kiosk waits until a screen
 * is connected. Otherwise returns 0. */
int run_interactive_open(struct run_common *session);

/* Runs frames until the end. Returns an exit code. Reports all errors before it returns. */
enum exit_code run_interactive_run(struct run_common *session);

#endif
