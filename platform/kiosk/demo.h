/* demo.h -- runs the demonstration: the core's bot plays one round without a screen, on a simulated
 * clock, and pictures of the round are written.
 *
 * The first picture is taken when the pois are over the water. The time from the press of START to
 * the first picture is simulated without pictures. Equal options give identical games. */
#ifndef KINGYO_PLATFORM_KIOSK_DEMO_H
#define KINGYO_PLATFORM_KIOSK_DEMO_H

#include "platform/kiosk/run_common.h"

/* Default seed of the random number generator, so that two users see the same demonstration. */
#define DEMO_SEED 2013u

/* Runs the demonstration. Returns an exit code. Reports all errors before it returns. */
enum exit_code demo_run(struct run_common *session);

#endif
