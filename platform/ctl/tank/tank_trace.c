/* tank_trace.c -- writes the rows of the trace independently of the locale.
 *
 * Positions have four decimals of a centimetre. An overlap of 0.5 mm can then be measured with an
 * error of about a thousandth. */
#include "platform/ctl/tank/tank_trace.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "platform/os/number.h"
#include "platform/os/print.h"

#define DEG (180.0 / 3.14159265358979323846)
#define ROW_MAX 512u

static const char *const gait_names[GAIT_COUNT] = {
    [GAIT_REST] = "rest",     [GAIT_SWIM] = "swim",       [GAIT_BURST] = "burst",
    [GAIT_ESCAPE] = "escape", [GAIT_SURFACE] = "surface", [GAIT_HELD] = "held",
    [GAIT_BOWL] = "held",
};
static const char *const avoiding_names[] = { "none", "yaw", "pitch" };

const char *tank_trace_gait(uint8_t gait)
{
    return gait_names[gait];
}

static enum exit_code tank_trace_print_error(const struct tank_trace *trace, int error)
{
    print_error("kingyoctl tank: --trace: %s: %s", trace->path, strerror(error));
    return EXIT_IO;
}

enum exit_code tank_trace_open(struct tank_trace *trace, const char *path)
{
    trace->path = path;
    const int error = file_atomic_open(&trace->out, path);
    if (error) {
        return tank_trace_print_error(trace, -error);
    }
    trace->file = trace->out.file;
    fputs("tick,fish,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,length_cm,height_cm,width_cm,"
          "speed_cm_s,tail_hz,gait,stamina,avoiding\n",
          trace->file);
    return EXIT_OK;
}

static void add_row(struct tank_trace *trace, const struct fish *fish, uint32_t index,
                    uint32_t tick)
{
    const struct {
        double value;
        uint32_t decimals;
    } figures[] = {
        { (double)tick, 0 },
        { (double)index, 0 },
        { 100.0 * (double)fish->position_m.x, 4 },
        { 100.0 * (double)fish->position_m.y, 4 },
        { 100.0 * (double)fish->position_m.z, 4 },
        { DEG * (double)fish->angles.yaw_rad, 4 },
        { DEG * (double)fish->angles.pitch_rad, 4 },
        { DEG * (double)fish->angles.roll_rad, 4 },
        { 100.0 * (double)fish->length_m, 4 },
        { 100.0 * (double)fish->height_m, 4 },
        { 100.0 * (double)fish->width_m, 4 },
        { 100.0 * (double)v3_length(fish->velocity_m_s), 4 },
        { (double)fish->tail_beat_hz, 3 },
    };
    char row[ROW_MAX];
    uint32_t length = 0;
    for (uint32_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        length += number_print_fixed(row + length, figures[i].value, figures[i].decimals);
        row[length++] = ',';
    }
    fwrite(row, 1, length, trace->file);
    length = number_print_fixed(row, 100.0 * (double)fish->stamina, 3);
    fprintf(trace->file, "%s,%.*s,%s\n", gait_names[fish->gait], (int)length, row,
            avoiding_names[fish->avoiding]);
}

void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        add_row(trace, &tank->fish[i], i, tick);
    }
}

enum exit_code tank_trace_close(struct tank_trace *trace)
{
    const int error = file_atomic_close(&trace->out);
    trace->file = NULL;
    return error ? tank_trace_print_error(trace, -error) : EXIT_OK;
}
