/* sensor_source.h -- sources of poses that read the board's sensors, or simulated sensors with a
 * simulated hand that scoops. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSOR_SOURCE_H
#define KINGYO_BOARD_POI_GADGET_SENSOR_SOURCE_H

#include "board/poi-gadget/pose_source.h"
#include "board/poi-gadget/scoop.h"
#include "board/poi-gadget/sensor_twin.h"
#include "board/poi-gadget/sensors.h"

/* Number of consecutive failed readings after which the position counts as unknown. */
#define SENSOR_GONE_BEATS 25u

struct sensor_source {
    struct board_pose pose;
    struct sensors sensors;
    struct readings readings;
    uint32_t missed; /* Number of consecutive failed readings so far. */
};

/* Returns a source that reads the board's sensors. `source->sensors` must be open. `config` must
 * outlive the source. The caller guarantees that `config` is valid and calibrated. */
struct pose_source sensor_source(struct sensor_source *source, const struct poi_config *config);

struct sensor_source_twin {
    struct scoop scoop;
    struct sensor_twin twin;
    struct board_pose pose;
};

/* Returns a source of simulated sensors on a poi that a simulated hand moves (scoop.h). `config`
 * must outlive the source. */
struct pose_source sensor_source_twin(struct sensor_source_twin *source,
                                      const struct poi_config *config);

#endif
