/* script_source.c -- reads lines of poses from an input, and appends the lines to a text buffer
 * (pose_tape.h). */
#include "board/poi-gadget/script_source.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

#include "platform/os/print.h"

static void read_more(struct script_source *script)
{
    struct pollfd ready = { .fd = script->fd, .events = POLLIN };
    uint32_t room;
    char *at = pose_tape_room(&script->tape, &room);
    if (room == 0 || script->tape.ended || poll(&ready, 1, 0) <= 0) {
        return;
    }
    const ssize_t size = read(script->fd, at, room);
    if (size > 0) {
        pose_tape_wrote(&script->tape, (uint32_t)size);
    } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
        script->tape.ended = 1;
    }
}

/* Adds an alternating tremor of half a step of the report to the position. A real hand is never
 * exactly still, and the kiosk treats a sensor with constant values as failed. */
static void tremble(struct script_source *script, struct poi_report *report)
{
    const float half_m = 0.5f * POI_REPORT_REACH_M / 32767.0f;
    report->target.position_m.x += script->step++ & 1u ? half_m : -half_m;
}

/* Advances the script by all cycles in `seconds`. Returns 1 and writes the last pose to `out` if
 * any cycle gave a pose. Returns 0 if no pose is available, or -1 if a line is invalid. */
static int step_beats(struct script_source *script, float seconds, struct poi_report *out)
{
    uint8_t buttons = 0;
    int any = 0;
    for (float left_s = seconds; left_s > 0.5f * script->beat_s; left_s -= script->beat_s) {
        read_more(script);
        const int got = pose_tape_step(&script->tape, script->beat_s, out);
        if (got <= 0) {
            return got < 0 ? -1 : any;
        }
        buttons |= out->buttons;
        out->buttons = buttons;
        any = 1;
    }
    return any;
}

static enum pose_result script_step(void *self, float seconds, struct poi_report *out)
{
    struct script_source *script = self;
    const int got = step_beats(script, seconds, out);
    if (got < 0) {
        print_error("%s:%u: %s", script->name, script->tape.line, script->tape.why);
        return POSE_BAD;
    }
    if (got == 0) {
        return script->tape.ended ? POSE_END : POSE_NONE;
    }
    tremble(script, out);
    return POSE_NEW;
}

struct pose_source script_source(struct script_source *script, int fd, const char *name,
                                 uint32_t rate_hz)
{
    *script = (struct script_source){ .fd = fd, .name = name, .beat_s = 1.0f / (float)rate_hz };
    return (struct pose_source){ .step = script_step, .self = script };
}
