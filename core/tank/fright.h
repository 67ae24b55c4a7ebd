/* fright.h -- what startles a fish, how much, and how long its nerves take to answer.
 *
 * Eyes see a disc loom: its image is large enough and grows fast. The ear and the lateral line feel
 * the pressure of the water that a disc pushes (flow.h), which grows as the square of its speed.
 * Shadows add what shade.h says. All add to one alarm; past what the individual bears, a start
 * waits for its latency and then begins, 8 to 15 ms after a blow to the water (Eaton et al. 1977),
 * 60 to 150 ms after a sight. The figures of stimuli are design, set by play, but for the angle
 * that must be seen.
 */
#ifndef KINGYO_CORE_TANK_FRIGHT_H
#define KINGYO_CORE_TANK_FRIGHT_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

enum fright_cause {
    FRIGHT_NONE = 0,
    FRIGHT_LOOM,     /* Seen: something grows. */
    FRIGHT_PRESSURE, /* Felt: water moves. */
    FRIGHT_SHADOW,   /* Seen: the light goes. */
};

/* A disc as an eye sees it. */
struct fright_view {
    float size_rad;     /* Mean diameter of its image. An edge-on disc is little but a line. */
    float growth_rad_s; /* How fast that grows; negative while it recedes. */
};

struct fright_view fright_view(const struct obstacle *disc, vec3 eye_m);

/* Alarm a second that a disc gives a fish of middling temper, and by which sense more. */
struct fright {
    uint8_t cause; /* enum fright_cause */
    float alarm_per_s;
};

struct fright fright_of_disc(const struct obstacle *disc, const struct fish *fish);

/* The alarm at which it starts: the timid at 0.45, the bold at 0.9; more when used to frights. */
float fright_threshold(const struct fish *fish);

/* Adds `alarm` >= 0 of a stimulus at `from_m`. If that is more than the fish bears, and it is not
 * already starting or too soon after the last start, the latency of `cause` begins to run. */
void fright_alarm(struct fish *fish, enum fright_cause cause, vec3 from_m, float alarm,
                  uint32_t index, const struct surroundings *around);

/* `around->dt_s` later: alarm and habit fade, discs are sensed, a start that was waited for begins.
 * Nothing where the law knows no escapes. */
void fright_tick(struct fish *fish, uint32_t index, const struct surroundings *around);

/* Whether it must think in every tick: it is startled or escapes, or a disc moves near it. */
int fright_alert(const struct fish *fish, const struct surroundings *around);

#endif
