/* tank_trace.h -- where every fish is, as CSV, so that anyone can test what the tank claims. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TRACE_H
#define KINGYO_PLATFORM_CTL_TANK_TRACE_H

#include <stdint.h>
#include <stdio.h>

#include "core/tank/tank.h"
#include "platform/kiosk/options.h"
#include "platform/out_file.h"

struct tank_trace {
    const char *path;
    struct out_file out;
    FILE *file; /* That of `out` while it is open. */
};

/* Makes the file with its head. EXIT_OK, or EXIT_IO, told. `path` must outlive `trace`. */
enum exit_code tank_trace_open(struct tank_trace *trace, const char *path);

/* A row of each fish. */
void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick);

/* EXIT_OK, or EXIT_IO, told, when a row did not reach the file. */
enum exit_code tank_trace_close(struct tank_trace *trace);

/* "burst", "swim", "rest", "escape", "surface" or "held" (on a poi or in a bowl). */
const char *tank_trace_gait(uint8_t gait);

#endif
