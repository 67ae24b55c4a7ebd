/* startle.h -- the startle response: stimuli, alarm, threshold and latency.
 *
 * The eyes detect an approaching disc if its visual angle is large enough and grows fast enough.
 * The ear and the lateral line detect the pressure of the water that a disc pushes (flow.h), which
 * grows with the square of the disc's speed. Shadows add the alarm of shade.h. All stimuli add to
 * one alarm. If the alarm exceeds the threshold of the fish, a C-start (escape.h) begins after a
 * latency. The latency is 8 to 15 ms after a blow to the water (Eaton et al. 1977) and 60 to 150 ms
 * after a visual stimulus. The constants of the stimuli are design values from play tests, except
 * the visual angle. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_STARTLE_H
#define KINGYO_CORE_TANK_BEHAVIOR_STARTLE_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

enum startle_cause {
    STARTLE_NONE = 0,
    STARTLE_LOOM,     /* Vision: the image of an object grows. */
    STARTLE_PRESSURE, /* Lateral line and ear: the pressure of moving water. */
    STARTLE_SHADOW,   /* Vision: the light fades. */
};

/* The image of a disc in the eye of a fish. */
struct startle_view {
    float size_rad;     /* Mean visual angle of the image. The image of a disc that is seen edge-on
                           is nearly a line. */
    float growth_rad_s; /* Growth of `size_rad` per second; < 0 while the disc recedes. */
};

struct startle_view startle_view(const struct obstacle *disc, vec3 eye_m);

/* Alarm per second that a disc causes in a fish, and the sense (vision or pressure) that receives
 * the stronger stimulus. */
struct startle_stimulus {
    uint8_t cause; /* Sense that receives the stronger stimulus (enum startle_cause). */
    float alarm_per_s;
};

struct startle_stimulus startle_of_disc(const struct obstacle *disc, const struct fish *fish);

/* Returns the alarm above which the fish begins a C-start: 0.45 for the most timid fish, 0.9 for
 * the boldest fish. The threshold is higher after habituation or while the fish gulps, but at most
 * 0.95. */
float startle_threshold(const struct fish *fish);

/* Adds `alarm` >= 0 from a stimulus at `from_m` to the alarm of the fish. If the sum exceeds the
 * fish's threshold, the latency of `cause` begins. No latency begins while the fish escapes, or
 * until `refractory_s` of the fish is 0. */
void startle_alarm(struct fish *fish, enum startle_cause cause, vec3 from_m, float alarm,
                   uint32_t index, const struct perception *around);

/* Advances the startle response by `around->dt_s`: alarm and habituation decay, the fish senses
 * shades and discs, and a C-start begins if its latency has ended. Does nothing if
 * around->params->escapes is 0. */
void startle_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns 1 if the fish must decide in every tick, because it is alarmed or escapes, or because a
 * disc moves near the fish. Otherwise returns 0. */
int startle_alert(const struct fish *fish, const struct perception *around);

#endif
