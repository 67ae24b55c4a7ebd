/* panel.c -- buttons: a desktop's keys, whoever plays, since Esc must quit. */
#include "board/desktop/parts.h"
#include "drivers/buttons_join.h"
#include "drivers/buttons_keyboard.h"

static struct {
    struct buttons_join join;
    struct buttons_keyboard keyboard;
} devices;

void panel_open(struct hal *hal, const struct board_options *options)
{
    (void)options;
    devices.join = (struct buttons_join){ 0 };
    devices.keyboard = (struct buttons_keyboard){ 0 };
    buttons_join_add(&devices.join, buttons_keyboard_device(&devices.keyboard));
    hal->buttons = buttons_join_device(&devices.join);
}
