/* pose_decoder.c -- fuzz target: an arbitrary controller, a mapping for this controller, and
 * arbitrary reports. The decoded pose must be finite, and each report must be decoded within a time
 * limit.
 *
 * Input: the vendor, the product and the size of the descriptor (two bytes each, low byte first),
 * the descriptor, and a mapping as a line of text. An empty line selects the automatic mapping.
 * Reports follow: a byte of time, a byte of size, and the bytes of the report. */
#include <string.h>
#include <time.h>

#include "drivers/hid/poi_hid.h"
#include "tests/fuzz/trap.h"

/* Unit of the time byte of a report. The values 0 to 254 are up to 127 ms, and 255 means eight
 * seconds. */
#define TIME_STEP_NS 500000u

/* CPU time limit for the decoding of one report. The limit allows for the sanitizers, which make
 * the decoder about 20 times slower. */
#define REPORT_NS_MAX 4000000ull
/* Number of times that a slow report is measured. The report fails only if all measurements are
 * slow, because another process can slow down a single one. */
#define REPORT_TRIES 3u

static const struct view view = { .eye_m = { 0.0f, 0.9f, 0.7f },
                                  .half_height_tan = 0.4f,
                                  .aspect_min = 1.6f };
static struct hid_device_info face;
static struct hid_mapping map;
static struct hid_pose_decoder hand, before;

static uint16_t word_at(const uint8_t *bytes)
{
    return (uint16_t)(bytes[0] | bytes[1] << 8);
}

static void hold_finite(const struct poi_sample *sample, uint64_t time_ns)
{
    const vec3 at = sample->target.position_m;
    const struct angles angles = sample->target.angles;
    HOLD(f_is_finite(at.x) && f_is_finite(at.y) && f_is_finite(at.z));
    HOLD(f_is_finite(angles.pitch_rad) && f_is_finite(angles.yaw_rad) &&
         f_is_finite(angles.roll_rad));
    HOLD(sample->time_ns <= time_ns);
}

static void hold_hand(uint64_t time_ns)
{
    struct poi_sample sample;
    struct button_sample buttons = { 0 }, again = { 0 };
    if (hid_pose_decoder_sample(&hand, time_ns, &sample)) {
        hold_finite(&sample, time_ns);
    }
    const struct shade_input fan = hid_pose_decoder_fan(&hand, time_ns);
    HOLD(!fan.present || (f_is_finite(fan.x_m) && f_is_finite(fan.z_m)));
    hid_pose_decoder_buttons(&hand, &buttons);
    HOLD((buttons.held & ~(uint32_t)INPUT_BUTTON_ALL) == 0 && buttons.coin_count[0] == 0);
    hid_pose_decoder_buttons(&hand, &again);
    /* A button press must be returned by only one poll. */
    HOLD(again.pressed == 0 && again.held == buttons.held);
}

static uint64_t cpu_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

static int report_in_time(const struct hid_raw *raw)
{
    uint64_t took = REPORT_NS_MAX + 1u;
    int moved = 0;
    before = hand;
    for (uint32_t i = 0; i < REPORT_TRIES && took > REPORT_NS_MAX; i++) {
        hand = before;
        const uint64_t begun = cpu_ns();
        moved = hid_pose_decoder_report(&hand, raw);
        took = cpu_ns() - begun;
    }
    HOLD(took <= REPORT_NS_MAX);
    return moved;
}

static void play(const uint8_t *bytes, size_t size)
{
    struct hid_raw raw = { .time_ns = 1000000000u };
    uint32_t count = 0;
    while (size >= 2u) {
        const size_t requested = bytes[1], taken = requested < size - 2u ? requested : size - 2u;
        raw.time_ns += bytes[0] == 255u ? 8000000000u : bytes[0] * TIME_STEP_NS;
        raw.size = (uint32_t)taken;
        memcpy(raw.bytes, bytes + 2, taken);
        const int moved = report_in_time(&raw);
        HOLD(moved == 0 || moved == 1);
        HOLD(hand.refused_count <= ++count);
        hold_hand(raw.time_ns + bytes[0]);
        bytes += 2u + taken;
        size -= 2u + taken;
    }
}

/* Parses the line of text at `bytes` as a mapping. If the line is empty or invalid, the automatic
 * mapping is used. Returns the number of bytes of the line. */
static size_t take_map(const uint8_t *bytes, size_t size)
{
    static char text[HID_MAPPING_TEXT_SIZE];
    char error[HAL_TEXT_SIZE];
    size_t length = 0;
    while (length < size && bytes[length] != '\n' && length + 1u < sizeof text) {
        text[length] = (char)bytes[length];
        length++;
    }
    text[length] = '\0';
    if (length == 0 || hid_mapping_read(&map, text, error)) {
        hid_descriptor_read(&hand.descriptor, face.descriptor, face.descriptor_size);
        hid_mapping_choose(&map, &face.identity, &hand.descriptor);
    }
    return length < size ? length + 1u : length;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 6u) {
        return 0;
    }
    face.identity.vendor = word_at(bytes);
    face.identity.product = word_at(bytes + 2);
    const size_t requested = word_at(bytes + 4) % (HID_DESCRIPTOR_MAX + 1u);
    const size_t taken = requested < size - 6u ? requested : size - 6u;
    memcpy(face.descriptor, bytes + 6, taken);
    face.descriptor_size = (uint32_t)taken;
    bytes += 6u + taken;
    size -= 6u + taken;
    const size_t line = take_map(bytes, size);
    HOLD(map.source != HID_MAPPING_NONE || map.count <= HID_BINDING_MAX);
    if (hid_pose_decoder_init(&hand, &face, &map, &view) == 0) {
        HOLD(hid_mapping_is_sound(&map, &hand.descriptor));
        play(bytes + line, size - line);
    }
    return 0;
}
