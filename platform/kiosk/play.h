/* play.h -- the stall on a screen, open until someone closes it. */
#ifndef KINGYO_PLATFORM_KIOSK_PLAY_H
#define KINGYO_PLATFORM_KIOSK_PLAY_H

#include "platform/kiosk/session.h"

/* Whether the stall opens without a screen, and shows itself when there is one: where a service
 * manager started it ($NOTIFY_SOCKET), nobody stands there to read that there is none. */
int play_waits_for_screen(void);

/* Opens the board. Whether session->hal has a display at all, or waits for one. */
int play_open(struct session *session);

/* Runs frames until the end. Returns an exit code; what failed was told. */
enum exit_code play_run(struct session *session);

#endif
