/* startle.h -- the startle response (stimuli, alarm, threshold and latency), and the C-start that
 * follows.
 *
 * A poi (paper scoop) is a disc for the fish. The eyes detect an approaching disc if its visual
 * angle is large enough and grows fast enough. The ear and the lateral line detect the pressure of
 * the water that a moving disc pushes (water.h). A shadow on the fish also causes alarm
 * (shade_alarm()).
 *
 * All stimuli add to one number, the alarm of the fish. If the alarm exceeds the threshold of the
 * fish, the fish escapes by a C-start after a latency. The latency is 8 to 15 ms after a blow to
 * the water (Eaton et al. 1977) and 60 to 150 ms after a visual stimulus.
 *
 * The limits and strengths of the stimuli are design values from play tests, except the visual
 * angle.
 *
 * In the C-start a startled fish bends into a C, flips back with a thrust, and dashes away. In
 * stage 1, about 20 ms, the head turns by 60 to 120 degrees, mostly away from the stimulus, while
 * the body hardly moves. In stage 2, equally long, the tail flips back and the body turns to its
 * final course. The body accelerates forward at 15 to 40 m/s^2 up to 8 to 10 lengths per second. A
 * dash follows, which decays within a second (Eaton et al. 1977; Mirjany et al. 2011). */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

enum startle_cause {
    STARTLE_NONE = 0,
    STARTLE_LOOM, /* Startled by vision: the image of an approaching object grows. */
    /* Startled by the lateral line and the ear: the fish feels the pressure of moving water. */
    STARTLE_PRESSURE,
    STARTLE_SHADOW, /* Startled by vision: a shadow falls on the fish. */
};

/* The image of a disc-shaped obstacle, a poi (paper scoop), in the eye of a fish. */
struct startle_view {
    /* Visual angle of the image of a poi, averaged over height and width, because a poi that is
     * seen edge-on looks like a line. */
    float size_rad;
    /* Growth of `size_rad` per second; < 0 while the poi (paper scoop) moves away. */
    float growth_rad_s;
};

struct startle_view startle_view(const struct obstacle *disc, vec3 eye_m);

/* Stimulus by which a moving poi (paper scoop) startles a fish: the alarm per second that the poi
 * causes, and the sense (vision or pressure) that receives the stronger stimulus. */
struct startle_stimulus {
    /* Sense (vision or pressure) that receives the stronger stimulus (enum startle_cause). */
    uint8_t cause;
    float alarm_per_s;
};

struct startle_stimulus startle_of_disc(const struct obstacle *disc, const struct fish *fish);

/* Returns the alarm above which the fish begins a C-start (escape): 0.45 for the most timid fish,
 * 0.9 for the boldest fish. Habituation raises the threshold, and so does surface breathing, up to
 * 0.95. */
float startle_threshold(const struct fish *fish);

/* Adds `alarm` >= 0 from a stimulus at `from_m` to the alarm of the fish. If the fish's alarm then
 * exceeds its threshold, the fish is startled, and will escape after the latency of `cause`. A fish
 * is not startled while it escapes, or until its `refractory_s` is 0. */
void startle_alarm(struct fish *fish, enum startle_cause cause, vec3 from_m, float alarm,
                   uint32_t index, const struct perception *around);

/* Advances the startle response by `around->dt_s`: alarm and habituation decay, shades and moving
 * pois (paper scoops) raise the alarm, and a C-start (escape) begins if its latency has ended. Does
 * nothing if around->params->escapes is false. */
void startle_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns true if the fish must decide in every tick, because it is alarmed or escapes, or because
 * a poi (paper scoop) moves near the fish. */
bool startle_alert(const struct fish *fish, const struct perception *around);

enum escape_stage {
    ESCAPE_NONE = 0, /* The fish does not escape: its gait is not GAIT_ESCAPE. */
    ESCAPE_BEND,     /* Stage 1: the fish bends into a C. */
    ESCAPE_FLIP,     /* Stage 2: the tail flips back. */
    ESCAPE_DASH,
};

enum escape_stage escape_stage(const struct fish *fish);

/* Returns true while a C-start (escape) determines the turn and the bend of the fish: in stage 1
 * (bend into a C), in stage 2 (flip of the tail), and while the body bends back afterwards. */
bool escape_on_path(const struct fish *fish);

/* Returns the duration, s, of the first stage of a C-start, in which a fish of this length bends
 * into a C. The second stage, the flip of the tail, lasts equally long. The duration is 20 ms for a
 * fish of 5 cm and grows with the square root of the length. The result is rounded to whole ticks:
 * 2 ticks (16.7 ms) for a fish of 5 cm, and 3 ticks (25 ms) for a fish of 5.5 cm. */
float escape_stage_s(float length_m);

/* Begins a C-start (escape) of the fish away from a stimulus at `from_m`. The side, the angle of
 * the turn and the final course are random. Near a wall more fish turn toward the stimulus, because
 * the wall blocks the way out. */
void escape_start(struct fish *fish, vec3 from_m, uint32_t index, const struct perception *around);

/* Begins a dash along the fish's forward axis without a C-bend, for a fish that was thrown or fell
 * into the water. */
void escape_dash(struct fish *fish, uint32_t index, const struct perception *around);

/* Advances an escape by `around->dt_s` before the fish moves. Sets the heading, the bend goal and
 * the speed. */
void escape_tick(struct fish *fish, const struct perception *around);

/* Returns the speed goal of an escape along the fish's forward axis, m/s. */
float escape_speed_m_s(const struct fish *fish);

/* Returns true while the tail of an escaping fish beats and drives the fish. */
bool escape_beats(const struct fish *fish);
