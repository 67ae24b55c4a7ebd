/* pose_script.c -- parses and prints pose lines, moves the simulated hand along a polynomial of
 * degree five between two poses, and reads the lines from a text buffer that is filled from an
 * input. */
#include "board/poi-gadget/pose_script.h"

#include <assert.h>
#include <errno.h>
#include <poll.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/fmath.h"
#include "platform/os/print.h"

/* ---- Lines ----------------------------------------------------------------------------------- */

#define MM 0.001f

static const struct key_name {
    const char *name;
    uint8_t button;
} keys[] = {
    { "OK", POI_BUTTON_OK },       { "START", POI_BUTTON_START }, { "LEFT", POI_BUTTON_LEFT },
    { "RIGHT", POI_BUTTON_RIGHT }, { "FAN", POI_BUTTON_FAN },
};
#define KEY_COUNT (sizeof keys / sizeof keys[0])

#define BLANKS " \t\r\n"

static bool read_number(const char *word, float most, float *out)
{
    char *end;
    const float value = strtof(word, &end);
    if (end == word || *end != '\0' || !f_is_finite(value) || f_abs(value) > most) {
        return false;
    }
    *out = value;
    return true;
}

/* Parses the six numbers of a pose. Positions must be within +-1,000 mm, and angles within +-360
 * degrees. */
static int read_pose(struct poi_target *out, char *word, char **rest, const char **why)
{
    const float most[6] = { 1000.0f, 1000.0f, 1000.0f, 360.0f, 360.0f, 360.0f };
    float number[6];
    for (uint32_t i = 0; i < 6; i++, word = i < 6 ? strtok_r(NULL, BLANKS, rest) : NULL) {
        if (!word) {
            *why = "a pose is six numbers: X Y Z in mm, pitch yaw roll in degrees";
            return -1;
        }
        if (!read_number(word, most[i], &number[i])) {
            *why = i < 3 ? "a place is a number of mm within +-1000"
                         : "an angle is a number of degrees within +-360";
            return -1;
        }
    }
    out->position_m = v3_scale(v3(number[0], number[1], number[2]), MM);
    out->angles = (struct angles){ .pitch_rad = f_wrap_angle(number[3] * F_DEG),
                                   .yaw_rad = f_wrap_angle(number[4] * F_DEG),
                                   .roll_rad = f_wrap_angle(number[5] * F_DEG) };
    return 1;
}

int pose_line_read(struct pose_line *out, const char *text, const char **why)
{
    char copy[POSE_LINE_SIZE];
    struct pose_line line = { 0 };
    if ((size_t)snprintf(copy, sizeof copy, "%s", text) >= sizeof copy) {
        *why = "the line is longer than 127 bytes";
        return -1;
    }
    copy[strcspn(copy, "#")] = '\0';
    char *rest, *word = strtok_r(copy, BLANKS, &rest);
    if (!word) {
        return 0;
    }
    if (word[0] == '+') {
        float glide_ms;
        if (!read_number(word + 1, POSE_LINE_GLIDE_S * 1000.0f, &glide_ms) || glide_ms < 0.0f) {
            *why = "a glide is + and a number of ms, 0 .. 600000";
            return -1;
        }
        line.glide_s = glide_ms / 1000.0f;
        word = strtok_r(NULL, BLANKS, &rest);
    }
    line.lost = word && strcmp(word, "lost") == 0;
    if (!line.lost && read_pose(&line.target, word, &rest, why) < 0) {
        return -1;
    }
    while ((word = strtok_r(NULL, BLANKS, &rest)) != NULL) {
        size_t k = 0;
        while (k < KEY_COUNT && strcmp(keys[k].name, word) != 0) {
            k++;
        }
        if (k == KEY_COUNT) {
            *why = "a key is OK, START, LEFT, RIGHT or FAN";
            return -1;
        }
        line.buttons |= keys[k].button;
    }
    *out = line;
    return 1;
}

void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE])
{
    const vec3 place_m = report->target.position_m;
    const struct angles angles = report->target.angles;
    int length = v3_is_finite(place_m)
                     ? snprintf(text, POSE_LINE_SIZE, "%.2f %.2f %.2f  %.2f %.2f %.2f",
                                (double)(place_m.x / MM), (double)(place_m.y / MM),
                                (double)(place_m.z / MM), (double)(angles.pitch_rad / F_DEG),
                                (double)(angles.yaw_rad / F_DEG), (double)(angles.roll_rad / F_DEG))
                     : snprintf(text, POSE_LINE_SIZE, "lost");
    for (size_t k = 0; k < KEY_COUNT && length > 0 && (uint32_t)length < POSE_LINE_SIZE; k++) {
        if (report->buttons & keys[k].button) {
            length +=
                snprintf(text + length, POSE_LINE_SIZE - (uint32_t)length, " %s", keys[k].name);
        }
    }
}

/* ---- Motion from pose to pose ---------------------------------------------------------------- */

/* Tolerance in seconds when the end of a motion is detected. The tolerance is needed because the
 * sum of ten steps of 0.01 s is not exactly 0.1 s in binary floating point. */
#define ROUNDING_S 1e-4f

bool pose_glide_is_there(const struct pose_glide *glide)
{
    return !glide->begun || glide->at_s >= glide->to.glide_s - ROUNDING_S;
}

void pose_glide_send(struct pose_glide *glide, const struct pose_line *to)
{
    *glide = (struct pose_glide){ .begun = true,
                                  .from = glide->begun && !glide->to.lost ? glide->to : *to,
                                  .to = *to };
}

/* Interpolates between two angles in the direction of the smaller rotation. */
static float turn_between(float from_rad, float to_rad, float t)
{
    return f_wrap_angle(from_rad + t * f_wrap_angle(to_rad - from_rad));
}

void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out)
{
    assert(glide->begun);
    assert(seconds >= 0.0f);
    const struct poi_target *from = &glide->from.target, *to = &glide->to.target;
    glide->at_s += seconds;
    /* `t` is the completed part of the motion, [0, 1], when the part `s` of its duration has
     * passed. The speed and the acceleration are 0 at the start and at the end. */
    const float s = glide->at_s / glide->to.glide_s;
    const float t =
        pose_glide_is_there(glide) ? 1.0f : s * s * s * (10.0f - s * (15.0f - 6.0f * s));
    out->target.position_m = v3_lerp(from->position_m, to->position_m, t);
    out->target.angles = (struct angles){
        .yaw_rad = turn_between(from->angles.yaw_rad, to->angles.yaw_rad, t),
        .pitch_rad = turn_between(from->angles.pitch_rad, to->angles.pitch_rad, t),
        .roll_rad = turn_between(from->angles.roll_rad, to->angles.roll_rad, t),
    };
    if (glide->to.lost) {
        out->target.position_m.x = __builtin_nanf("");
    }
    out->buttons = glide->to.buttons;
}

/* ---- Buffered text --------------------------------------------------------------------------- */

/* Moves one line from the buffer to `line`. Returns 1 if a line was moved, or 0 if the buffer has
 * no complete line. If the line is too long or not text, sets `why` and returns -1. */
static int cut_line(struct pose_tape *tape, char line[POSE_LINE_SIZE])
{
    const char *end = memchr(tape->text, '\n', tape->size);
    if (!end && !(tape->ended && tape->size > 0) && tape->size < POSE_LINE_SIZE) {
        return 0;
    }
    const uint32_t whole = end ? (uint32_t)(end - tape->text) : tape->size;
    const uint32_t kept = whole < POSE_LINE_SIZE ? whole : POSE_LINE_SIZE - 1;
    memcpy(line, tape->text, kept);
    line[kept] = '\0';
    const uint32_t used = end ? whole + 1 : whole;
    memmove(tape->text, tape->text + used, tape->size - used);
    tape->size -= used;
    tape->line++;
    if (whole >= POSE_LINE_SIZE || strlen(line) != kept) {
        tape->why = "the line is longer than 127 bytes, or no text";
        return -1;
    }
    return 1;
}

int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out)
{
    if (pose_glide_is_there(&tape->glide)) {
        char text[POSE_LINE_SIZE];
        struct pose_line line;
        int got = 1, is_pose = 0;
        /* Empty lines and comments contain no pose and are skipped. */
        while (!is_pose && (got = cut_line(tape, text)) == 1) {
            is_pose = pose_line_read(&line, text, &tape->why);
        }
        if (got < 0 || is_pose < 0) {
            return -1;
        }
        if (is_pose) {
            pose_glide_send(&tape->glide, &line);
        } else if (!tape->glide.begun || tape->ended) {
            return 0;
        }
    }
    pose_glide_step(&tape->glide, seconds, out);
    return 1;
}

/* ---- Source of poses ------------------------------------------------------------------------- */

/* Advances the script by all cycles of the main loop that fit into `seconds`, and returns the pose
 * of the last cycle. */
static enum pose_result script_step(void *self, float seconds, struct poi_report *out)
{
    struct pose_script_source *script = self;
    uint8_t buttons = 0;
    bool any = false;
    int got = 1;
    const uint32_t beats = (uint32_t)(seconds / script->beat_s + 0.5f);
    for (uint32_t i = 0; got == 1 && i < beats; i++) {
        struct pollfd ready = { .fd = script->fd, .events = POLLIN };
        struct pose_tape *tape = &script->tape;
        if (tape->size < POSE_TAPE_SIZE && !tape->ended && poll(&ready, 1, 0) > 0) {
            const ssize_t size =
                read(script->fd, tape->text + tape->size, POSE_TAPE_SIZE - tape->size);
            tape->size += size > 0 ? (uint32_t)size : 0u;
            tape->ended = size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR);
        }
        got = pose_tape_step(tape, script->beat_s, out);
        if (got == 1) {
            buttons |= out->buttons;
            out->buttons = buttons;
            any = true;
        }
    }
    if (got < 0) {
        print_error("%s:%u: %s", script->name, script->tape.line, script->tape.why);
        return POSE_BAD;
    }
    if (!any) {
        return script->tape.ended ? POSE_END : POSE_NONE;
    }
    /* A tremor of half a position step of the report is added, with alternating sign. A real hand
     * is never exactly still, and the kiosk treats a sensor with constant values as failed. */
    const float half_m = 0.5f * POI_REPORT_REACH_M / 32767.0f;
    out->target.position_m.x += script->step++ & 1u ? half_m : -half_m;
    return POSE_NEW;
}

struct pose_source pose_script_source(struct pose_script_source *script, int fd, const char *name,
                                      uint32_t rate_hz)
{
    assert(name);
    assert(rate_hz > 0);
    *script =
        (struct pose_script_source){ .fd = fd, .name = name, .beat_s = 1.0f / (float)rate_hz };
    return (struct pose_source){ .step = script_step, .self = script };
}
