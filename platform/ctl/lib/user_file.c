/* user_file.c -- opens files that the user names on the command line. */
#include "platform/ctl/lib/user_file.h"

#include <errno.h>

#include "platform/os/print.h"
#include "platform/os/file.h"

enum exit_code user_file_error(const char *speaker, const char *path, uint32_t size_max, int error)
{
    if (error == EFBIG) {
        const int in_kib = size_max < 1u << 20;
        print_error("%s: %s: is larger than %u %s", speaker, path, size_max >> (in_kib ? 10 : 20),
                    in_kib ? "KiB" : "MiB");
        return EXIT_BAD_DATA;
    }
    print_error("%s: %s: %s", speaker, path, file_error(error));
    return EXIT_IO;
}

enum exit_code user_file_open(const char *speaker, const char *path, uint32_t size_max, FILE **out)
{
    *out = file_open(path, size_max);
    return *out ? EXIT_OK : user_file_error(speaker, path, size_max, errno);
}
