/* learn.c -- fuzz target: the dialog that learns a controller's mapping, with an arbitrary
 * controller and arbitrary reports. A learned mapping must be usable for play.
 *
 * Input: the size of the descriptor (two bytes, low byte first), the descriptor, and steps. Each
 * step is a byte of time. The value 255 means that the user confirms the instruction. Any other
 * value is followed by a byte of size and the bytes of a report. */
#include <string.h>

#include "drivers/hid/hid_learn.h"
#include "drivers/hid/poi_hid.h"
#include "tests/fuzz/trap.h"

#define TIME_STEP_NS 4000000u
#define NEXT 255u

static struct hid_device_info face;
static struct hid_learn learn;
static struct hid_pose_decoder hand;

static void hold_learned(void)
{
    const struct view view = { .eye_m = { 0.0f, 0.9f, 0.7f },
                               .half_height_tan = 0.4f,
                               .aspect_min = 1.6f };
    char text[HID_MAPPING_TEXT_SIZE];
    HOLD(hid_mapping_is_sound(&learn.map, &learn.descriptor));
    HOLD(learn.map.source == HID_MAPPING_LEARNED && hid_mapping_write(&learn.map, text) == 0);
    HOLD(hid_pose_decoder_init(&hand, &face, &learn.map, &view) == 0);
}

static void show(const uint8_t *bytes, size_t size)
{
    struct hid_raw raw = { .time_ns = 1000000000u };
    while (size >= 2u || (size == 1u && bytes[0] == NEXT)) {
        const size_t room = size - 2u, requested = size > 1u ? bytes[1] : 0u;
        const size_t taken = bytes[0] == NEXT ? 0u : requested < room ? requested : room;
        if (bytes[0] == NEXT) {
            hid_learn_next(&learn);
        } else {
            raw.time_ns += bytes[0] * TIME_STEP_NS;
            raw.size = (uint32_t)taken;
            memcpy(raw.bytes, bytes + 2, taken);
            hid_learn_report(&learn, &raw);
        }
        (void)hid_learn_progress(&learn);
        HOLD(learn.field_count <= LEARN_FIELD_MAX && learn.key_count <= LEARN_KEY_MAX);
        HOLD(learn.step <= LEARN_FAILED);
        if (learn.step == LEARN_TRY) {
            hold_learned();
        }
        const size_t used = bytes[0] == NEXT ? 1u : 2u + taken;
        bytes += used;
        size -= used;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 2u) {
        return 0;
    }
    const size_t requested = (size_t)(bytes[0] | bytes[1] << 8) % (HID_DESCRIPTOR_MAX + 1u);
    const size_t taken = requested < size - 2u ? requested : size - 2u;
    memcpy(face.descriptor, bytes + 2, taken);
    face.descriptor_size = (uint32_t)taken;
    hid_learn_begin(&learn, &face);
    show(bytes + 2 + taken, size - 2u - taken);
    return 0;
}
