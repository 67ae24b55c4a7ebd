/* connectors.c -- implementation of connectors.h. */
#include "platform/render/connectors.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

#define PATH_SIZE 512
#define HASH_BASIS 0xcbf29ce484222325ull /* Constants of the FNV-1a hash function. */
#define HASH_PRIME 0x100000001b3ull

/* Returns 1 for a display connector such as "card1-HDMI-A-1", otherwise 0. Examples of 0 are
 * "card1", "renderD128" and the kernel's writeback connectors, which only write into memory. */
static int is_socket(const char *name)
{
    return strncmp(name, "card", 4) == 0 && strchr(name, '-') && !strstr(name, "-Writeback-");
}

static int has_screen(const char *root, const char *name)
{
    char path[PATH_SIZE], status[16] = "";
    const int length = snprintf(path, sizeof path, "%s/%s/status", root, name);
    FILE *const file = length > 0 && length < PATH_SIZE ? fopen(path, "re") : NULL;
    if (file) {
        const size_t size = fread(status, 1, sizeof status - 1u, file);
        status[size] = '\0';
        fclose(file);
    }
    return strncmp(status, "connected", strlen("connected")) == 0;
}

static uint64_t hash_of(const char *name)
{
    uint64_t hash = HASH_BASIS;
    for (; *name; name++) {
        hash = (hash ^ (uint8_t)*name) * HASH_PRIME;
    }
    return hash;
}

/* The result is the sum of the hashes of the connectors' names. A sum is independent of the order
 * of the names, which may differ each time that the kernel lists the directory. */
struct connectors connectors_read(const char *root)
{
    struct connectors found = { 0 };
    DIR *const folder = opendir(root);
    if (!folder) {
        return found;
    }
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (!is_socket(entry->d_name)) {
            continue;
        }
        found.count++;
        if (has_screen(root, entry->d_name)) {
            found.connected++;
            found.which += hash_of(entry->d_name);
        }
    }
    closedir(folder);
    return found;
}
