/* pad.c -- fuzz target: arbitrary events of a gamepad or of a touch screen. The decoded pose must
 * be finite.
 *
 * The input is a byte that selects the device (an even value selects the gamepad), and events. A
 * gamepad event is a byte of time, a byte for the kind of the event, and as many bytes as this kind
 * needs. A touch event is one byte each for time, kind, finger, x and y. */
#include <string.h>

#include "drivers/gamepad/gamepad_decoder.h"
#include "drivers/pointer/touch_fingers.h"
#include "tests/fuzz/trap.h"

/* Unit of the time byte of an event. The values 0 to 254 are up to 127 ms, and 255 means eight
 * seconds. */
#define TIME_STEP_NS 500000u

static const struct view view = { .eye_m = { 0.0f, 0.9f, 0.7f },
                                  .half_height_tan = 0.4f,
                                  .aspect_min = 1.6f };

struct input_bytes {
    const uint8_t *at;
    size_t left;
};

/* Copies the next `size` bytes of the input. If the input is shorter, the missing bytes are
 * zeros. */
static void take(struct input_bytes *input, void *out, size_t size)
{
    const size_t taken = size < input->left ? size : input->left;
    memset(out, 0, size);
    memcpy(out, input->at, taken);
    input->at += taken;
    input->left -= taken;
}

static uint64_t next_ns(struct input_bytes *input, uint64_t now_ns)
{
    uint8_t step;
    take(input, &step, 1);
    return now_ns + (step == 255u ? 8000000000u : step * TIME_STEP_NS);
}

static void hold_target(const struct poi_target *target)
{
    HOLD(v3_is_finite(target->position_m));
    HOLD(f_is_finite(target->angles.pitch_rad) && f_is_finite(target->angles.yaw_rad) &&
         f_is_finite(target->angles.roll_rad));
    HOLD(f_abs(target->angles.pitch_rad) < 4.0f && f_abs(target->angles.roll_rad) < 4.0f);
}

static void hold_pad(struct gamepad_queue *track, uint64_t now_ns, uint32_t max)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct button_sample buttons, again;
    const uint32_t count = gamepad_queue_pop(track, now_ns, samples, max);
    HOLD(count <= max && (max == 0 || count > 0));
    for (uint32_t i = 0; i < count; i++) {
        hold_target(&samples[i].target);
        HOLD(i == 0 || samples[i].time_ns >= samples[i - 1].time_ns);
    }
    const struct shade_input fan = stick_motion_fan(&track->decoder.fly, now_ns);
    HOLD(!fan.present || (f_is_finite(fan.x_m) && f_is_finite(fan.z_m)));
    gamepad_queue_buttons(track, &buttons);
    HOLD((buttons.held & ~(uint32_t)INPUT_BUTTON_ALL) == 0);
    gamepad_queue_buttons(track, &again);
    /* A button press must be returned by only one poll. */
    HOLD(again.pressed == 0 && again.held == buttons.held);
}

static void play_pad(struct input_bytes *input)
{
    static struct gamepad_queue track;
    struct gamepad_report report = { .time_ns = 1000000000u };
    gamepad_queue_init(&track, &view, report.time_ns);
    while (input->left >= 2u) {
        uint8_t what;
        report.time_ns = next_ns(input, report.time_ns);
        take(input, &what, 1);
        report.has_turn = (what & 1u) != 0;
        report.has_weight = (what & 2u) != 0;
        take(input, report.axis, sizeof report.axis);
        take(input, &report.buttons, what & 4u ? sizeof report.buttons : 0u);
        take(input, &report.turn_rad_s, report.has_turn ? sizeof report.turn_rad_s : 0u);
        take(input, &report.weight_m_s2, report.has_weight ? sizeof report.weight_m_s2 : 0u);
        gamepad_queue_push(&track, &report);
        HOLD(track.report_count <= GAMEPAD_REPORTS_MAX);
        if (what & 8u) {
            hold_pad(&track, report.time_ns + what, what >> 2);
        }
    }
    hold_pad(&track, report.time_ns, HAL_POI_SAMPLES_MAX);
}

static void play_screen(struct input_bytes *input)
{
    struct touch_fingers fingers = { 0 };
    struct pointer_report report = { .width_px = 1280, .height_px = 720 };
    struct pointer_poi pointer;
    pointer_poi_init(&pointer, &view);
    while (input->left >= 2u) {
        struct touch_event event = { .time_ns = next_ns(input, report.time_ns) };
        uint8_t id;
        take(input, &event.kind, 1);
        take(input, &id, 1);
        event.id = id % 16u;
        take(input, &event.x, sizeof event.x);
        take(input, &event.y, sizeof event.y);
        const int changed = touch_fingers_take(&fingers, &event);
        HOLD(changed == 0 || changed == 1);
        HOLD(fingers.count <= TOUCH_FINGER_MAX && fingers.x >= 0.0f && fingers.x <= 1.0f);
        HOLD(fingers.dips == (fingers.count >= TOUCH_DIP_FINGERS));
        report.time_ns = event.time_ns;
        touch_fingers_point(&fingers, &report);
        pointer_poi_report(&pointer, &report);
        const struct poi_target target = pointer_poi_target(&pointer, report.time_ns);
        hold_target(&target);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct input_bytes input = { bytes, size };
    uint8_t which;
    take(&input, &which, 1);
    if (which % 2u == 0) {
        play_pad(&input);
    } else {
        play_screen(&input);
    }
    return 0;
}
