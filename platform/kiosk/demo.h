/* demo.h -- the bot plays a round off screen, on a clock that only the program moves, and
 * pictures of it are written. It begins when the hands are over the water: what comes before, from
 * START on, is played unseen. Equal options give equal plays, to the last bit. */
#ifndef KINGYO_PLATFORM_KIOSK_DEMO_H
#define KINGYO_PLATFORM_KIOSK_DEMO_H

#include "platform/kiosk/session.h"

#define DEMO_SEED 2013u /* Where none is given, so that two people see the same demonstration. */

/* Returns an exit code; what failed was told. */
enum exit_code demo_run(struct session *session);

#endif
