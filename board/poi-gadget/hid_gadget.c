/* hid_gadget.c -- reads and writes USB reports without blocking. */
#include "board/poi-gadget/hid_gadget.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <string.h>
#include <unistd.h>

/* Number of consecutive failed writes after which the device is opened again. At 250 reports per
 * second, 64 writes take a quarter of a second. */
#define SHUT_MAX 64u
/* Maximum number of reads in one call. The host sends one report in each video frame, and f_hid
 * queues four reports. */
#define READS_MAX 8

void hid_gadget_init(struct hid_gadget *gadget, const char *path)
{
    assert(path);
    *gadget = (struct hid_gadget){ .path = path, .fd = -1 };
}

static bool is_stdout(const struct hid_gadget *gadget)
{
    return strcmp(gadget->path, "-") == 0;
}

bool hid_gadget_open(struct hid_gadget *gadget)
{
    if (gadget->fd < 0) {
        gadget->fd =
            is_stdout(gadget) ? STDOUT_FILENO : open(gadget->path, O_RDWR | O_NONBLOCK | O_CLOEXEC);
    }
    return gadget->fd >= 0;
}

/* Handles the error in errno. EAGAIN means that the host has not fetched the last report, or that
 * no output report has arrived. ESHUTDOWN means that no host has configured the device. After any
 * other error, the device is closed, because its USB function no longer exists. */
static void survive(struct hid_gadget *gadget)
{
    if (errno != EAGAIN && errno != EINTR && errno != ESHUTDOWN) {
        hid_gadget_close(gadget);
    }
}

bool hid_gadget_send(struct hid_gadget *gadget, const struct poi_report *report)
{
    struct poi_report numbered = *report;
    uint8_t bytes[POI_REPORT_SIZE];
    assert(gadget->shut_count < SHUT_MAX);
    numbered.sequence = gadget->sequence;
    poi_report_encode(&numbered, bytes);
    if (gadget->fd >= 0) {
        if (write(gadget->fd, bytes, sizeof bytes) == (ssize_t)sizeof bytes) {
            gadget->sequence++;
            gadget->sent_count++;
            gadget->shut_count = 0;
            return true;
        }
        /* A missing host and a removed USB function give the same error. The device is therefore
         * closed after SHUT_MAX consecutive errors, so that a new USB function is found when the
         * device is opened again. */
        gadget->shut_count = errno == ESHUTDOWN ? gadget->shut_count + 1 : 0;
        survive(gadget);
        if (gadget->shut_count >= SHUT_MAX) {
            hid_gadget_close(gadget);
            gadget->shut_count = 0;
        }
    }
    gadget->skipped_count++;
    return false;
}

bool hid_gadget_feel(struct hid_gadget *gadget, struct poi_force *out)
{
    bool felt = false;
    for (int i = 0; i < READS_MAX && gadget->fd >= 0 && !is_stdout(gadget); i++) {
        uint8_t bytes[64];
        const ssize_t size = read(gadget->fd, bytes, sizeof bytes);
        if (size < 0) {
            survive(gadget);
            break;
        }
        if (size == 0) {
            break;
        }
        if (poi_force_decode(bytes, (uint32_t)size, out, NULL)) {
            gadget->felt_count++;
            felt = true;
        } else {
            gadget->refused_count++;
        }
    }
    return felt;
}

void hid_gadget_close(struct hid_gadget *gadget)
{
    if (gadget->fd >= 0 && !is_stdout(gadget)) {
        close(gadget->fd);
    }
    gadget->fd = -1;
}
