/* sensor_source.c -- reads the real or simulated sensors, computes the pose, and returns the
 * report. */
#include "board/poi-gadget/sensor_source.h"

#define TWIN_NOISE_STEPS 1.5f /* Noise in steps of a 12-bit converter with a cheap potentiometer. */

static enum pose_result sensor_step(void *self, float seconds, struct poi_report *out)
{
    struct sensor_source *source = self;
    source->missed = sensors_read(&source->sensors, &source->readings) ? 0 : source->missed + 1;
    board_pose_step(&source->pose, &source->readings, seconds, out);
    if (source->missed > SENSOR_GONE_BEATS) {
        out->target.position_m.x = __builtin_nanf("");
    }
    return POSE_NEW;
}

struct pose_source sensor_source(struct sensor_source *source, const struct poi_config *config)
{
    board_pose_init(&source->pose, config);
    source->missed = 0;
    return (struct pose_source){ .step = sensor_step, .self = source };
}

static enum pose_result twin_step(void *self, float seconds, struct poi_report *out)
{
    struct sensor_source_twin *source = self;
    struct poi_report hand = { 0 };
    struct readings readings;
    scoop_step(&source->scoop, seconds, &hand);
    sensor_twin_step(&source->twin, &hand, seconds, &readings);
    board_pose_step(&source->pose, &readings, seconds, out);
    return POSE_NEW;
}

struct pose_source sensor_source_twin(struct sensor_source_twin *source,
                                      const struct poi_config *config)
{
    *source = (struct sensor_source_twin){
        .twin = { .config = config, .noise_steps = TWIN_NOISE_STEPS },
    };
    board_pose_init(&source->pose, config);
    return (struct pose_source){ .step = twin_step, .self = source };
}
