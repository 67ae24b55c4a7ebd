/* startle.h -- the startle response: stimuli, alarm, threshold and latency.
 *
 * The eyes see a disc loom if its image is large enough and grows fast. The ear and the lateral
 * line feel the pressure of the water that a disc pushes (flow.h), which grows with the square of
 * its speed. Shadows add the alarm of shade.h. All stimuli add to one alarm. If the alarm exceeds
 * the threshold of the individual, a start begins after a latency: 8 to 15 ms after a blow to the
 * water (Eaton et al. 1977), 60 to 150 ms after a sight. The stimulus constants are design values
 * set by play, except the visual angle. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_STARTLE_H
#define KINGYO_CORE_TANK_BEHAVIOR_STARTLE_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

enum startle_cause {
    STARTLE_NONE = 0,
    STARTLE_LOOM,     /* Vision: an object grows. */
    STARTLE_PRESSURE, /* Lateral line: the water moves. */
    STARTLE_SHADOW,   /* Vision: the light fades. */
};

/* The image of a disc in an eye. */
struct startle_view {
    float size_rad;     /* Mean diameter of the image. An edge-on disc is little more than a
                           line. */
    float growth_rad_s; /* Growth of `size_rad`; negative while the disc recedes. */
};

struct startle_view startle_view(const struct obstacle *disc, vec3 eye_m);

/* Alarm per second that a disc causes in a fish of medium boldness, and the sense that contributes
 * more. */
struct startle_stimulus {
    uint8_t cause; /* enum startle_cause */
    float alarm_per_s;
};

struct startle_stimulus startle_of_disc(const struct obstacle *disc, const struct fish *fish);

/* Returns the alarm at which the fish starts: 0.45 for the timidest, 0.9 for the boldest, more
 * after habituation. */
float startle_threshold(const struct fish *fish);

/* Adds `alarm` >= 0 from a stimulus at `from_m`. If the sum exceeds the fish's threshold, the
 * latency of `cause` begins. A fish that is already starting, or started too recently, ignores
 * it. */
void startle_alarm(struct fish *fish, enum startle_cause cause, vec3 from_m, float alarm,
                   uint32_t index, const struct perception *around);

/* Advances the startle response by `around->dt_s`: alarm and habituation decay, discs are sensed,
 * and a due start begins. Does nothing if the behavior parameters disable escapes. */
void startle_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns 1 if the fish must decide in every tick, because it is startled or escapes, or because a
 * disc moves near it. */
int startle_alert(const struct fish *fish, const struct perception *around);

#endif
