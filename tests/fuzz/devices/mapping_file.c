/* mapping_file.c -- fuzz target: arbitrary text as a stored controller mapping. The parser must
 * either report the invalid line, or read an entry that does not change when it is written and
 * read again. The entry's file name must not contain a path, so that it cannot lead to another
 * folder. */
#include <string.h>

#include "drivers/hid/hid_mapping.h"
#include "tests/fuzz/trap.h"

static void hold_name(const struct hid_mapping_store_entry *entry)
{
    char name[HID_MAPPING_STORE_NAME_SIZE];
    hid_mapping_store_name(entry, name);
    HOLD(strnlen(name, sizeof name) < sizeof name && name[0] != '.' && !strchr(name, '/'));
    for (const char *letter = name; *letter; letter++) {
        HOLD(*letter > ' ' && *letter < 0x7f);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static char text[HID_MAPPING_STORE_TEXT_SIZE], written[HID_MAPPING_STORE_TEXT_SIZE];
    static struct hid_mapping_store_entry entry, again;
    char error[HAL_TEXT_SIZE] = "";
    size = size < sizeof text ? size : sizeof text - 1u;
    memcpy(text, bytes, size);
    text[size] = '\0';
    const int line = hid_mapping_store_read(&entry, text, error);
    HOLD(line >= 0 && strnlen(error, sizeof error) < sizeof error);
    if (line > 0) {
        HOLD(error[0] != '\0');
        return 0;
    }
    hold_name(&entry);
    HOLD(hid_mapping_store_write(&entry, written) == 0 &&
         hid_mapping_store_read(&again, written, error) == 0);
    HOLD(again.vendor == entry.vendor && again.product == entry.product);
    HOLD(strcmp(again.serial, entry.serial) == 0 && again.map.count == entry.map.count);
    return 0;
}
