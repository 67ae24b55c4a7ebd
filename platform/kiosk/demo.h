/* demo.h -- plays a round by the bot off screen, on a simulated clock, and writes pictures of it.
 *
 * The pictures begin when the pois are over the water; the time from START to there is played
 * without pictures. Equal options give equal games, to the last bit. */
#ifndef KINGYO_PLATFORM_KIOSK_DEMO_H
#define KINGYO_PLATFORM_KIOSK_DEMO_H

#include "platform/kiosk/run_common.h"

#define DEMO_SEED 2013u /* Default seed, so that two users see the same demonstration. */

/* Runs the demonstration. Returns an exit code; errors were reported. */
enum exit_code demo_run(struct run_common *session);

#endif
