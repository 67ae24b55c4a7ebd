/* poi_tape.c -- fuzz target: arbitrary bytes as a script of poses and as lines of a poi's
 * configuration. The parser must either reject the bytes with a reason, or accept only poses within
 * the reach of the poi. */
#include <string.h>

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/pose_script.h"
#include "tests/fuzz/trap.h"

#define STEPS_MAX 4000u

static void hold_report(const struct pose_tape *tape, const struct poi_report *report)
{
    const vec3 at_m = report->target.position_m;
    const struct angles turn = report->target.angles;
    HOLD(tape->glide.to.lost || v3_is_finite(at_m));
    HOLD(f_is_finite(turn.yaw_rad) && f_is_finite(turn.pitch_rad) && f_is_finite(turn.roll_rad));
    HOLD(!(f_abs(at_m.y) > 1.0001f) && !(f_abs(at_m.z) > 1.0001f));
}

/* Checks that an accepted line sets no value that is NaN or infinite. */
static void hold_config(const char *line)
{
    struct poi_config config;
    const char *why = NULL;
    poi_config_init(&config);
    if (poi_config_line(&config, line, &why) < 0) {
        HOLD(why && strlen(why) > 5);
        return;
    }
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        HOLD(v3_is_finite(config.spool_m[i]) && f_is_finite(config.zero_m[i]));
        HOLD(f_is_finite(config.step_m[i]) && config.channel[i] <= POI_CONFIG_CHANNEL_MAX);
    }
    HOLD(v3_is_finite(config.ring_m) && config.mark_count <= POI_CONFIG_MARK_MAX);
    HOLD(config.motor_least >= 0.0f && config.motor_least < 1.0f && config.motor_hz >= 20u);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct pose_tape tape;
    char line[512];
    size_t fed = 0;
    int result = 1;
    memset(&tape, 0, sizeof tape);
    for (uint32_t n = 0; n < STEPS_MAX && result >= 0 && !(result == 0 && tape.ended); n++) {
        struct poi_report report = { 0 };
        const size_t room = POSE_TAPE_SIZE - tape.size;
        const size_t more = size - fed < room ? size - fed : room;
        memcpy(tape.text + tape.size, bytes + fed, more);
        tape.size += (uint32_t)more;
        fed += more;
        tape.ended = fed == size;
        result = pose_tape_step(&tape, 0.5f, &report);
        if (result == 1) {
            char text[POSE_LINE_SIZE];
            hold_report(&tape, &report);
            pose_line_write(&report, text);
            HOLD(strnlen(text, sizeof text) < sizeof text);
        }
        HOLD(result >= 0 || tape.why);
    }
    size = size < sizeof line ? size : sizeof line - 1u;
    memcpy(line, bytes, size);
    line[size] = '\0';
    hold_config(line);
    return 0;
}
