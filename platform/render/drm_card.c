/* drm_card.c -- finds the graphics card with the monitor in /sys/class/drm, which lists cards
 * ("card1") and connectors ("card1-HDMI-A-1"). */
#include "platform/render/drm_card.h"

#include <SDL.h>
#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

/* State of a connector, in ascending order: absent, without a monitor, with a monitor. The state of
 * a card is the highest state of its connectors. */
enum socket_state {
    SOCKET_NONE = 0,
    SOCKET_FREE,
    SOCKET_CONNECTED,
};

/* Returns the number N of the connector name "cardN-CONNECTOR". Returns -1 for a card's own name,
 * such as "card1". Returns -1 for a writeback connector, which writes into memory and has no
 * monitor. */
static int card_of(const char *name)
{
    int card = -1, length = 0;
    if (sscanf(name, "card%2d-%n", &card, &length) != 1 || length == 0 || card < 0 ||
        card >= DRM_CARD_MAX || strncmp(name + length, "Writeback", 9) == 0) {
        return -1;
    }
    return card;
}

static enum socket_state look_at_socket(const char *folder, const char *name)
{
    char path[PATH_MAX], word[16] = "";
    snprintf(path, sizeof path, "%s/%.255s/status", folder, name);
    FILE *file = fopen(path, "re");
    if (!file) {
        return SOCKET_NONE;
    }
    const int is_read = fscanf(file, "%15s", word) == 1;
    fclose(file);
    return is_read && strcmp(word, "connected") == 0 ? SOCKET_CONNECTED : SOCKET_FREE;
}

int drm_card_find(const char *root)
{
    char path[PATH_MAX / 2];
    enum socket_state best[DRM_CARD_MAX] = { SOCKET_NONE };
    const struct dirent *entry;
    int found = -1;
    snprintf(path, sizeof path, "%s/sys/class/drm", root);
    DIR *folder = opendir(path);
    while (folder && (entry = readdir(folder))) {
        const int card = card_of(entry->d_name);
        const enum socket_state state =
            card >= 0 ? look_at_socket(path, entry->d_name) : SOCKET_NONE;
        if (state > SOCKET_NONE && state > best[card]) {
            best[card] = state;
        }
    }
    if (folder) {
        closedir(folder);
    }
    for (int card = 0; card < DRM_CARD_MAX; card++) {
        if (best[card] > (found < 0 ? SOCKET_NONE : best[found])) {
            found = card;
        }
    }
    return found;
}

void drm_card_prefer(void)
{
    char index[16];
    const int card = drm_card_find("");
    if (card >= 0) {
        snprintf(index, sizeof index, "%d", card);
        /* The environment variable SDL_KMSDRM_DEVICE_INDEX takes precedence over this hint. */
        SDL_SetHint(SDL_HINT_KMSDRM_DEVICE_INDEX, index);
    }
}
