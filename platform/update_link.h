/* update_link.h -- connects the update page of the operator's menu with the service that updates
 * the machine from a USB stick (board/image/UPDATE.md).
 *
 * The kiosk asks by the existence of two empty files in its own runtime folder, which the service
 * never opens. The service reports in one line of a file that only the service can write. Both
 * folders are in memory (tmpfs), so no function blocks. No function allocates memory. */
#pragma once

#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/scene_menu.h"

/* File in which the service reports. An image without a key for updates has no such file. */
#define UPDATE_LINK_STATUS "/run/kingyo-update/status"
/* Names of the requests in the kiosk's runtime folder. */
#define UPDATE_LINK_OPEN "update-open"
#define UPDATE_LINK_START "update-start"

struct update_link {
    bool is_available; /* True if the machine can be updated. */
    int folder;        /* Descriptor of the kiosk's runtime folder, if updates are available. */
    char status[PATH_MAX];
    bool is_open;     /* True while the request UPDATE_LINK_OPEN exists. */
    bool has_started; /* True while the request UPDATE_LINK_START exists. */
    uint64_t next_ns; /* Time of the next read of the status. */
    struct scene_update newest;
};

/* Prepares the link and removes requests of an earlier run. `folder` is the runtime folder of the
 * kiosk; null or "" means that there is none. `status` is the file of the service. Without a folder
 * or a status the machine has no updates. */
void update_link_begin(struct update_link *link, const char *folder, const char *status);

/* Removes the requests, and closes the folder. */
void update_link_end(struct update_link *link);

/* Returns the state for the core's input (enum update_state). */
uint8_t update_link_state(const struct update_link *link);

/* Creates or removes the requests, and reads the status a few times in each second while the page
 * is open. Call once per frame. */
void update_link_step(struct update_link *link, bool is_page_open, uint64_t now_ns);

/* Requests that the service writes the update. Has no effect unless an update was found. */
void update_link_start(struct update_link *link);

/* Parses one line of the service into `out`. A line that is not valid gives UPDATE_STEP_WAIT. */
void update_link_parse(const char *line, struct scene_update *out);
