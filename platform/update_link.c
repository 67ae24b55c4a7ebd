/* update_link.c -- asks the update service and reads its reports; see update_link.h. */
#include "platform/update_link.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"

#define READ_NS (NS_PER_S / 4u) /* Interval between two reads of the status. */
#define LINE_SIZE 128u

static const char *const step_names[UPDATE_STEP_COUNT] = {
    [UPDATE_STEP_WAIT] = "closed",     [UPDATE_STEP_NO_STICK] = "no-stick",
    [UPDATE_STEP_FOUND] = "found",     [UPDATE_STEP_CHECKING] = "checking",
    [UPDATE_STEP_WRITING] = "writing", [UPDATE_STEP_DONE] = "done",
    [UPDATE_STEP_FAILED] = "failed",
};
static const char *const fault_names[UPDATE_FAULT_COUNT] = {
    [UPDATE_FAULT_NONE] = "",
    [UPDATE_FAULT_FELL_BACK] = "fell-back",
    [UPDATE_FAULT_NO_FILESYSTEM] = "no-filesystem",
    [UPDATE_FAULT_NO_FOLDER] = "no-folder",
    [UPDATE_FAULT_UNSIGNED] = "unsigned",
    [UPDATE_FAULT_WRONG_KEY] = "wrong-key",
    [UPDATE_FAULT_WRONG_BOARD] = "wrong-board",
    [UPDATE_FAULT_OLDER] = "older",
    [UPDATE_FAULT_SAME_VERSION] = "same-version",
    [UPDATE_FAULT_TOO_LARGE] = "too-large",
    [UPDATE_FAULT_DAMAGED] = "damaged",
    [UPDATE_FAULT_PULLED] = "pulled",
    [UPDATE_FAULT_CANCELED] = "canceled",
    [UPDATE_FAULT_CARD] = "card",
    [UPDATE_FAULT_ON_TRIAL] = "on-trial",
};

/* Returns the index of `word` in `names`, or `count` if the word is unknown. */
static uint32_t index_of(const char *const *names, uint32_t count, const char *word)
{
    uint32_t index = 0;
    while (index < count && strcmp(names[index], word) != 0) {
        index++;
    }
    return index;
}

void update_link_parse(const char *line, struct scene_update *out)
{
    char step[16] = "", rest[SCENE_UPDATE_NAME_SIZE] = "";
    unsigned percent = 0;
    *out = (struct scene_update){ 0 };
    if (sscanf(line, "%15s %3u %63[^\n]", step, &percent, rest) < 2 || percent > 100) {
        return;
    }
    const uint32_t found = index_of(step_names, UPDATE_STEP_COUNT, step);
    if (found == UPDATE_STEP_COUNT) {
        return;
    }
    out->step = (uint8_t)found;
    out->percent = (uint8_t)percent;
    if (found == UPDATE_STEP_FAILED || found == UPDATE_STEP_NO_STICK) {
        const uint32_t fault = index_of(fault_names, UPDATE_FAULT_COUNT, rest);
        out->fault = (uint8_t)(fault < UPDATE_FAULT_COUNT ? fault : UPDATE_FAULT_DAMAGED);
    } else {
        memcpy(out->name, rest, sizeof rest);
    }
}

/* Reads the service's line. Returns false if the file cannot be read. */
static bool read_status(struct update_link *link)
{
    char line[LINE_SIZE] = "";
    const int fd = file_handle(link->status, O_RDONLY, 0);
    const ssize_t length = fd >= 0 ? read(fd, line, sizeof line - 1u) : -1;
    if (fd >= 0) {
        close(fd);
    }
    if (length < 0) {
        return false;
    }
    update_link_parse(line, &link->newest);
    return true;
}

/* Creates or removes an empty file in the runtime folder. */
static void set_request(struct update_link *link, const char *name, bool *is_set, bool sets)
{
    CORE_ASSERT(link->is_available);
    if (sets) {
        const int fd = file_handle_at(link->folder, name, O_WRONLY | O_CREAT, 0644);
        *is_set = fd >= 0;
        if (fd >= 0) {
            close(fd);
        }
    } else {
        unlinkat(link->folder, name, 0);
        *is_set = false;
    }
}

static void remove_requests(struct update_link *link)
{
    set_request(link, UPDATE_LINK_START, &link->has_started, false);
    set_request(link, UPDATE_LINK_OPEN, &link->is_open, false);
}

void update_link_begin(struct update_link *link, const char *folder, const char *status)
{
    *link = (struct update_link){ 0 };
    snprintf(link->status, sizeof link->status, "%s", status);
    if (!folder || !folder[0] || !read_status(link)) {
        return;
    }
    link->newest = (struct scene_update){ 0 };
    link->folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    link->is_available = link->folder >= 0;
    if (link->is_available) {
        remove_requests(link);
    }
}

void update_link_end(struct update_link *link)
{
    if (link->is_available) {
        remove_requests(link);
        close(link->folder);
        link->is_available = false;
    }
}

uint8_t update_link_state(const struct update_link *link)
{
    const uint8_t step = link->newest.step;
    if (!link->is_available) {
        return UPDATE_NONE;
    }
    return step == UPDATE_STEP_FOUND && !link->has_started               ? UPDATE_READY
           : step == UPDATE_STEP_CHECKING || step == UPDATE_STEP_WRITING ? UPDATE_BUSY
                                                                         : UPDATE_IDLE;
}

void update_link_step(struct update_link *link, bool is_page_open, uint64_t now_ns)
{
    if (!link->is_available) {
        return;
    }
    if (!is_page_open) {
        if (link->is_open) {
            remove_requests(link);
        }
        link->newest = (struct scene_update){ 0 };
        link->next_ns = 0;
        return;
    }
    if (!link->is_open) {
        set_request(link, UPDATE_LINK_OPEN, &link->is_open, true);
    }
    if (now_ns < link->next_ns) {
        return;
    }
    link->next_ns = now_ns + READ_NS;
    if (!read_status(link)) {
        link->newest = (struct scene_update){ 0 };
    }
    /* The request to write is for one update only. */
    const uint8_t step = link->newest.step;
    if (link->has_started &&
        (step == UPDATE_STEP_FAILED || step == UPDATE_STEP_NO_STICK || step == UPDATE_STEP_DONE)) {
        set_request(link, UPDATE_LINK_START, &link->has_started, false);
    }
}

void update_link_start(struct update_link *link)
{
    if (update_link_state(link) == UPDATE_READY) {
        set_request(link, UPDATE_LINK_START, &link->has_started, true);
    }
}
