/* panel.c -- every button there is, as one panel: a desktop's keys, whoever plays, since Esc must
 * quit, and those of controllers. */
#include "board/desktop/parts.h"
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
    hands_add_buttons(&devices.join);
    hal->buttons = buttons_join_device(&devices.join);
}
