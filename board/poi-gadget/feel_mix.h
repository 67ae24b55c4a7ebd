/* feel_mix.h -- converts the host's force feedback to the levels of one vibration motor and one
 * light. The functions are pure.
 *
 * A vibration motor cannot push or turn the hand. Only the levels of the force feedback report are
 * used, and the force and the torque are ignored. Drag in the water gives a hum, a slap of a fish's
 * tail gives a pulse that decays, and a tear of the paper gives a rattle. The motor stops if the
 * host sends no more reports. */
#ifndef KINGYO_BOARD_POI_GADGET_FEEL_MIX_H
#define KINGYO_BOARD_POI_GADGET_FEEL_MIX_H

#include "core/output.h"

/* Time in seconds without a report after which the motor stops. A kiosk sends one report in each
 * video frame. */
#define FEEL_SILENT_S 0.25f
/* Level of the motor at full drag. The remaining range is used for slaps and tears. */
#define FEEL_DRAG_SHARE 0.5f
#define FEEL_SLAP_S 0.060f /* Time constant in seconds with which the pulse of a slap decays. */
#define FEEL_TEAR_S 0.150f
/* Frequency of the rattle in Hz. A higher frequency feels like an engine and not like tearing
 * paper. */
#define FEEL_RATTLE_HZ 25.0f

struct feel_mix {
    float drag, slap, tear; /* Present levels of drag, slap and tear, in [0, 1]. The levels
                               decay. */
    float silent_s, rattle_s;
};

struct feel_levels {
    float motor, light; /* Levels of the motor and of the light, in [0, 1]. */
};

/* Advances the levels by `seconds` and returns the outputs. `newest` is the newest report from the
 * host, or null if no report has arrived since the last call. */
struct feel_levels feel_mix_step(struct feel_mix *mix, const struct poi_force *newest,
                                 float seconds);

#endif
