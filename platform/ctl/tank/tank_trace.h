/* tank_trace.h -- writes the pose of every fish to a CSV file, so that published results of the
 * tank can be checked independently. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_TRACE_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_TRACE_H

#include <stdint.h>
#include <stdio.h>

#include "core/tank/tank.h"
#include "platform/config/options.h"
#include "platform/os/file.h"

struct tank_trace {
    const char *path;
    struct atomic_file out;
    FILE *file; /* Stream that writes to `out` while the trace is open. Null if there is no
                   trace. */
};

/* Creates the file at `path` and writes the header row. `path` must outlive `trace`. Returns
 * EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code tank_trace_open(struct tank_trace *trace, const char *path);

/* Writes one row for each fish of the tank. */
void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick);

/* Closes the file. Returns EXIT_OK. If any row could not be written, prints one line to standard
 * error and returns EXIT_IO. */
enum exit_code tank_trace_close(struct tank_trace *trace);

/* Returns the name of a gait: "burst", "swim", "rest", "escape", "surface" or "held". "held" means
 * that the fish is on a poi or in a bowl. */
const char *tank_trace_gait(uint8_t gait);

#endif
