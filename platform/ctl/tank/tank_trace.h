/* tank_trace.h -- writes the pose of every fish as CSV, so that the tank's published results can be
 * checked independently. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_TRACE_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_TRACE_H

#include <stdint.h>
#include <stdio.h>

#include "core/tank/tank.h"
#include "platform/config/options.h"
#include "platform/os/atomic_file.h"

struct tank_trace {
    const char *path;
    struct atomic_file out;
    FILE *file; /* File of `out` while the trace is open. */
};

/* Creates the file and writes its header row. `path` must outlive `trace`. Returns EXIT_OK, or
 * prints one line to standard error and returns EXIT_IO. */
enum exit_code tank_trace_open(struct tank_trace *trace, const char *path);

/* Writes one row for each fish. */
void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick);

/* Closes the trace. Returns EXIT_OK. Prints one line to standard error and returns EXIT_IO if a row
 * was not written. */
enum exit_code tank_trace_close(struct tank_trace *trace);

/* Returns the gait's name: "burst", "swim", "rest", "escape", "surface" or "held" (on a poi or in a
 * bowl). */
const char *tank_trace_gait(uint8_t gait);

#endif
