/* map_text.c -- fuzz target: an arbitrary line as a stored mapping of a controller. The parser must
 * either reject the line with one sentence, or read a mapping that does not change when it is
 * written and read again. */
#include <stdbool.h>
#include <string.h>

#include "drivers/hid/hid_mapping.h"
#include "tests/fuzz/trap.h"

static void hold_sentence(const char error[HAL_TEXT_SIZE])
{
    const size_t length = strnlen(error, HAL_TEXT_SIZE);
    HOLD(length > 0 && length < HAL_TEXT_SIZE);
}

static bool is_same(const struct hid_binding *a, const struct hid_binding *b)
{
    return a->role == b->role && a->manner == b->manner && a->report_id == b->report_id &&
           a->bit_offset == b->bit_offset && a->bit_size == b->bit_size &&
           a->is_signed == b->is_signed && a->usage == b->usage && a->rest == b->rest &&
           a->full == b->full && a->dead == b->dead;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static char text[8192], written[HID_MAPPING_TEXT_SIZE];
    static struct hid_mapping map, again;
    char error[HAL_TEXT_SIZE] = "";
    size = size < sizeof text ? size : sizeof text - 1u;
    memcpy(text, bytes, size);
    text[size] = '\0';
    if (hid_mapping_read(&map, text, error)) {
        hold_sentence(error);
        return 0;
    }
    HOLD(map.count <= HID_BINDING_MAX);
    HOLD(hid_mapping_write(&map, written) == 0 && hid_mapping_read(&again, written, error) == 0);
    HOLD(again.source == map.source && again.style == map.style && again.count == map.count);
    HOLD(again.trembles == map.trembles && again.feels == map.feels);
    for (uint32_t i = 0; i < map.count; i++) {
        HOLD(is_same(&map.binding[i], &again.binding[i]));
    }
    return 0;
}
