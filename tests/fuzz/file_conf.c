/* file_conf.c -- fuzz target: arbitrary bytes as kingyo.conf. Checks that each warning is one
 * printable line, that the number of warnings is limited, and that every accepted value is within
 * the range of its setting. */
#include <string.h>

#include "drivers/gpio/gpio_config.h"
#include "drivers/usb/usb_choice.h"
#include "platform/config/config_file.h"
#include "platform/setting_text.h"
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/trap.h"

/* Replaces the function of board/desktop that validates the names of GPIO lines. The real function
 * is not linked, because its file needs SDL and threads. */
int board_check_lines(const char (*line)[BOARD_LINE_SIZE], uint32_t count, char why[HAL_TEXT_SIZE])
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    for (uint32_t i = 0; i < count; i++) {
        if (!gpio_wire_read(line[i], wires, why)) {
            return -1;
        }
    }
    return gpio_config_agrees(wires, why) ? 0 : -1;
}

bool board_check_usb(const char *text)
{
    struct usb_key key;
    return usb_key_read(&key, text) == 0;
}

static unsigned warning_count;

static void hold_warning(const char *line)
{
    warning_count++;
    HOLD(line[0] != '\0' && strchr(line, ':'));
    for (const char *c = line; *c; c++) {
        HOLD((unsigned char)*c >= ' ' && *c != 0x7f);
    }
}

static void hold_settings(const struct options *options)
{
    struct settings settings;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        char text[SETTING_TEXT_MAX];
        int32_t value = options->file.value[id], again = value + 1;
        if (options->file.is_set[id]) {
            HOLD(settings_allows(id, value));
            setting_print(id, value, text);
            HOLD(setting_parse(id, text, &again) && again == value);
        }
    }
    options_first(options, &settings);
    options_last(options, &settings);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        HOLD(settings_allows(id, settings.value[id]));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static char path[SCRATCH_PATH_SIZE];
    static struct options options;
    if (!path[0]) {
        scratch_path(path, "kingyo.conf");
    }
    scratch_put(path, bytes, size);
    memset(&options, 0, sizeof options);
    warning_count = 0;
    HOLD(config_file_read(&options, path, hold_warning) == 0);
    HOLD(warning_count <= CONFIG_WARNINGS_MAX + 1u);
    HOLD(options.usb_count <= BOARD_USB_MAX && options.line_count <= BOARD_LINE_MAX);
    hold_settings(&options);
    return 0;
}
