/* sensor_source.h -- poses from the board's own sensors, or from simulated sensors with a hand that
 * scoops. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSOR_SOURCE_H
#define KINGYO_BOARD_POI_GADGET_SENSOR_SOURCE_H

#include "board/poi-gadget/pose_source.h"
#include "board/poi-gadget/scoop.h"
#include "board/poi-gadget/sensor_twin.h"
#include "board/poi-gadget/sensors.h"

/* Number of consecutive missed readings after which the position counts as unknown. */
#define SENSOR_GONE_BEATS 25u

struct sensor_source {
    struct board_pose pose;
    struct sensors sensors;
    struct readings readings;
    uint32_t missed; /* Number of consecutive missed readings. */
};

/* Returns a source of the board's sensors, which must be open. `config` must outlive the source,
 * and must be valid and calibrated. */
struct pose_source sensor_source(struct sensor_source *source, const struct poi_config *config);

struct sensor_source_twin {
    struct scoop scoop;
    struct sensor_twin twin;
    struct board_pose pose;
};

/* Returns a source of simulated sensors with a hand that scoops. */
struct pose_source sensor_source_twin(struct sensor_source_twin *source,
                                      const struct poi_config *config);

#endif
