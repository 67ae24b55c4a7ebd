/* play.h -- the stall on a screen, open until someone closes it. */
#ifndef KINGYO_PLATFORM_KIOSK_PLAY_H
#define KINGYO_PLATFORM_KIOSK_PLAY_H

#include "platform/kiosk/session.h"

/* Whether session->hal, opened by play_open, has a display at all. */
int play_open(struct session *session);

/* Runs frames until the end. Returns an exit code; what failed was told. */
enum exit_code play_run(struct session *session);

#endif
