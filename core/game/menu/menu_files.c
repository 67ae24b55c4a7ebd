/* menu_files.c -- the menu page that lists the files of the data folder. */
#include "core/game/game.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

#define FILES_SHOWN 5u

uint32_t menu_files_shown(int upright)
{
    return upright ? SCENE_FILE_MAX : FILES_SHOWN;
}

static int is_long(const struct menu *menu)
{
    return menu->controllers.file_count > menu_files_shown(menu->upright);
}

uint16_t menu_files_enabled(const struct menu *menu)
{
    return (uint16_t)((is_long(menu) ? MENU_TAG(FILES_MORE) : 0u) | MENU_TAG(FILES_SEEN) |
                      MENU_TAG(FILES_BACK));
}

/* Highlights an item that is harmless if it is selected by accident. */
void menu_files_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    struct menu *menu = &game->menu;
    menu->file_first = 0;
    menu->tag[MENU_FILES] = is_long(menu) ? FILES_MORE : FILES_BACK;
}

/* Shows the next rows of the list; after the last rows, the first rows follow. The item FILES_SEEN
 * sends a command to the shell, which acknowledges the quarantined databases. */
void menu_files_activate(struct game *game, struct core_config *config, uint32_t tag,
                         struct output *output)
{
    (void)config;
    struct menu *menu = &game->menu;
    if (tag == FILES_SEEN) {
        menu_command(&game->menu, output, COMMAND_SEEN);
        return;
    }
    const uint32_t next = menu->file_first + menu_files_shown(menu->upright);
    menu->file_first = (uint8_t)(next < menu->controllers.file_count ? next : 0u);
}
