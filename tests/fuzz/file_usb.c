/* file_usb.c -- fuzz target: arbitrary bytes as usb.txt, the file with the operator's choices of
 * controllers. The parser must count the invalid lines and describe the last of them in one line.
 * The accepted choices must be the same after they were saved and loaded again. */
#include <stdio.h>
#include <string.h>

#include "drivers/usb/usb_choice.h"
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/trap.h"

static int same_kept(const struct usb_choice *a, const struct usb_choice *b)
{
    uint32_t index = 0;
    char one[USB_CHOICE_LINE_SIZE], other[USB_CHOICE_LINE_SIZE];
    for (; usb_choice_line(a, index, one); index++) {
        if (!usb_choice_line(b, index, other) || strcmp(one, other) != 0) {
            return 0;
        }
    }
    return !usb_choice_line(b, index, other);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static char path[SCRATCH_PATH_SIZE], saved[SCRATCH_PATH_SIZE];
    static struct usb_choice choice, again;
    char why[HAL_TEXT_SIZE] = "";
    struct usb_key requested[USB_REQUEST_MAX];
    if (!path[0]) {
        scratch_path(path, "usb.txt");
        scratch_path(saved, "usb-saved.txt");
    }
    scratch_put(path, bytes, size);
    memset(&choice, 0, sizeof choice);
    memset(&again, 0, sizeof again);
    const int bad = usb_choice_load(&choice, path, why);
    HOLD(bad >= 0 && (bad == 0) == (why[0] == '\0'));
    HOLD(strnlen(why, sizeof why) < sizeof why && !strchr(why, '\n'));
    HOLD(choice.request_count <= USB_REQUEST_MAX);
    HOLD(usb_choice_wanted(&choice, requested) <= choice.request_count);
    HOLD(usb_choice_save(&choice, saved) == 0);
    HOLD(usb_choice_load(&again, saved, why) == 0 && same_kept(&choice, &again));
    return 0;
}
