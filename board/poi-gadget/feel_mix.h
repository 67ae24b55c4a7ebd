/* feel_mix.h -- converts force feedback to the levels of one small motor and one light. The
 * functions are pure.
 *
 * A vibration motor can neither push nor turn the hand, so only the levels of the report are used.
 * Drag makes the motor hum, a slap gives a pulse that decays, and a tear gives a rattle. A board
 * with motors on its spools may use force and torque. The motor stops if the host sends no more
 * reports. */
#ifndef KINGYO_BOARD_POI_GADGET_FEEL_MIX_H
#define KINGYO_BOARD_POI_GADGET_FEEL_MIX_H

#include "core/output.h"

/* Seconds without a report after which the motor stops. A kiosk sends one report in each frame. */
#define FEEL_SILENT_S 0.25f
/* Share of the motor's level for drag. The rest is reserved for slaps and tears. */
#define FEEL_DRAG_SHARE 0.5f
#define FEEL_SLAP_S 0.060f /* Time in which a slap decays. */
#define FEEL_TEAR_S 0.150f
#define FEEL_RATTLE_HZ 25.0f /* Rattle frequency, which resembles paper rather than an engine. */

struct feel_mix {
    float drag, slap, tear; /* Decaying levels of drag, slap and tear, in [0, 1]. */
    float silent_s, rattle_s;
};

struct feel_levels {
    float motor, light; /* Levels of the motor and the light, in [0, 1]. */
};

/* Advances the mix by `seconds`. A null `newest` means that no report has arrived. */
struct feel_levels feel_mix_step(struct feel_mix *mix, const struct poi_force *newest,
                                 float seconds);

#endif
