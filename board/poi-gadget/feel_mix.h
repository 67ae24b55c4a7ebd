/* feel_mix.h -- what one small motor and one light make of what the hand is to feel. Pure.
 *
 * A motor that only hums can neither push nor turn the hand, so of the report it takes the levels:
 * drag hums, a slap kicks and dies away, a tear rattles. A board with motors on its spools may use
 * force and torque. A host that fell silent is no reason to go on humming. */
#ifndef KINGYO_POI_GADGET_FEEL_MIX_H
#define KINGYO_POI_GADGET_FEEL_MIX_H

#include "core/output.h"

#define FEEL_SILENT_S 0.25f     /* Kiosks tell once a frame. */
#define FEEL_DRAG_SHARE 0.5f    /* Of the motor; the rest is for blows. */
#define FEEL_SLAP_S 0.060f      /* A slap dies away in that. */
#define FEEL_TEAR_S 0.150f
#define FEEL_RATTLE_HZ 25.0f    /* As paper, not as an engine. */

struct feel_mix {
    float drag, slap, tear;     /* [0, 1], as they die away. */
    float silent_s, rattle_s;
};

struct feel_levels {
    float motor, light;         /* [0, 1] */
};

/* `newest` null: no news in these `seconds`. */
struct feel_levels feel_mix_step(struct feel_mix *mix, const struct poi_force *newest,
                                 float seconds);

#endif
