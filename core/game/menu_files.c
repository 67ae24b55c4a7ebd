/* menu_files.c -- turning over what was found in the data folder. */
#include "core/core.h"
#include "core/game/menu_parts.h"

#define FILES_SHOWN 5u

uint32_t menu_files_shown(int upright)
{
    return upright ? SCENE_FILE_MAX : FILES_SHOWN;
}

uint16_t menu_files_offers(const struct menu *menu)
{
    const int is_long = menu->desk.file_count > menu_files_shown(menu->upright);
    return (uint16_t)((is_long ? MENU_TAG(FILES_MORE) : 0u) | MENU_TAG(FILES_BACK));
}

void menu_files_enter(struct core *core)
{
    core->game.menu.file_first = 0;
}

/* Behind the last row comes the first again. */
void menu_files_take(struct core *core, uint32_t tag, struct output *output)
{
    struct menu *menu = &core->game.menu;
    (void)tag;
    (void)output;
    const uint32_t next = menu->file_first + menu_files_shown(menu->upright);
    menu->file_first = (uint8_t)(next < menu->desk.file_count ? next : 0u);
}
