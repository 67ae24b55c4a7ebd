/* usb_choice_file.c -- reads and writes the file of rules, which has one line for each rule. The
 * file is replaced by a rename. */
#include "drivers/usb/usb_choice_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "platform/os/file.h"

static int usb_choice_file_read_lines(struct usb_choice *choice, const char *path, FILE *file,
                                      char why[HAL_TEXT_SIZE])
{
    char line[2u * USB_CHOICE_LINE_SIZE], error[USB_ERROR_SIZE];
    uint32_t number = 0;
    int bad = 0;
    while (fgets(line, sizeof line, file)) {
        number++;
        if (usb_choice_read_line(choice, line, error)) {
            snprintf(why, HAL_TEXT_SIZE, "%.60s:%u: %s", path, number, error);
            bad++;
        }
    }
    return ferror(file) ? -errno : bad;
}

int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE])
{
    const int handle = path[0] ? file_handle(path, O_RDONLY, 0) : -1;
    FILE *file = handle >= 0 ? fdopen(handle, "r") : NULL;
    const int error = !path[0] || file || errno == ENOENT ? 0 : -errno;
    const int result = file ? usb_choice_file_read_lines(choice, path, file, why) : error;
    /* open() of a socket fails with ENXIO. */
    if (result == -ENOTSUP || result == -EISDIR || result == -ELOOP || result == -ENXIO) {
        snprintf(why, HAL_TEXT_SIZE, "%.60s: is not a regular file", path);
    } else if (result < 0) {
        snprintf(why, HAL_TEXT_SIZE, "%.60s: cannot read: %.40s", path, strerror(-result));
    }
    if (file) {
        fclose(file);
    }
    return result;
}

static int write_lines(const struct usb_choice *choice, FILE *file)
{
    char line[USB_CHOICE_LINE_SIZE];
    fputs("# Controllers on USB that play, or rest, as the operator chose in the menu.\n", file);
    for (uint32_t i = 0; usb_choice_line(choice, i, line); i++) {
        fprintf(file, "%s\n", line);
    }
    const int failed = fflush(file) != 0 || ferror(file) || fsync(fileno(file)) != 0;
    const int error = failed ? -errno : 0;
    return fclose(file) != 0 && !error ? -errno : error;
}

/* Flushes the folder of the file, so that the renamed file survives a power loss. Returns 0 or a
 * negative errno value. */
static int sync_folder(const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
    const int fd = open(folder[0] ? folder : "/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int error = fd < 0 || fsync(fd) != 0 ? -errno : 0;
    if (fd >= 0) {
        close(fd);
    }
    return error;
}

int usb_choice_save(const struct usb_choice *choice, const char *path)
{
    char part[PATH_MAX];
    if (!path[0]) {
        return 0;
    }
    if ((size_t)snprintf(part, sizeof part, "%s.part", path) >= sizeof part) {
        return -ENAMETOOLONG;
    }
    unlink(part); /* The temporary file can remain from a power loss or from another process. */
    FILE *file = fopen(part, "wxe");
    int error = file ? write_lines(choice, file) : -errno;
    if (!error && rename(part, path) != 0) {
        error = -errno;
    }
    if (error && file) {
        unlink(part);
    }
    return error ? error : sync_folder(path);
}
