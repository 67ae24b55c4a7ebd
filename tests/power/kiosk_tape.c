/* kiosk_tape.c -- maps the tape of a real kiosk into memory. The tape is the file with the recorded
 * file operations. */
#include "tests/power/kiosk_tape.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

struct kiosk_tape *kiosk_tape_map(const char *path)
{
    const int fd = (int)syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0 || syscall(SYS_ftruncate, fd, sizeof(struct kiosk_tape)) != 0) {
        return NULL;
    }
    void *there = mmap(NULL, sizeof(struct kiosk_tape), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    if (there == MAP_FAILED) {
        return NULL;
    }
    struct kiosk_tape *map = there;
    map->tape.ops = map->ops;
    map->tape.room = KIOSK_OPS_MAX;
    map->tape.bytes = map->bytes;
    map->tape.bytes_room = KIOSK_BYTES_MAX;
    return map;
}
