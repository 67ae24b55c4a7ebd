/* feel_mix.c -- adds the decaying levels of drag, slap and tear to the level of the motor. */
#include "board/poi-gadget/feel_mix.h"

static float die_away(float level, float seconds, float within_s)
{
    return level * f_exp(-seconds / within_s);
}

static void feel_mix_add_force(struct feel_mix *mix, const struct poi_force *newest, float seconds)
{
    mix->silent_s = newest ? 0.0f : mix->silent_s + seconds;
    if (newest) {
        mix->drag = f_clamp(newest->drag, 0.0f, 1.0f);
        mix->slap = f_max(mix->slap, f_clamp(newest->slap, 0.0f, 1.0f));
        mix->tear = f_max(mix->tear, f_clamp(newest->tear, 0.0f, 1.0f));
    }
    if (mix->silent_s > FEEL_SILENT_S) {
        mix->drag = 0.0f;
    }
}

struct feel_levels feel_mix_step(struct feel_mix *mix, const struct poi_force *newest,
                                 float seconds)
{
    mix->slap = die_away(mix->slap, seconds, FEEL_SLAP_S);
    mix->tear = die_away(mix->tear, seconds, FEEL_TEAR_S);
    feel_mix_add_force(mix, newest, seconds);
    mix->rattle_s = mix->tear > 0.02f ? mix->rattle_s + seconds : 0.0f;
    const float beat = mix->rattle_s * FEEL_RATTLE_HZ;
    const float rattle = beat - f_floor(beat) < 0.5f ? mix->tear : 0.0f;
    const float blow = f_max(mix->slap, rattle);
    return (struct feel_levels){
        .motor = f_min(FEEL_DRAG_SHARE * mix->drag + blow, 1.0f),
        .light = f_max(mix->slap, mix->tear),
    };
}
