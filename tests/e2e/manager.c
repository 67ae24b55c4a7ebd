/* manager.c -- receives the messages that the kiosk sends to its service manager, and records each
 * with its time.
 *
 * Usage: manager SOCKET FILE. Each datagram becomes a line "MILLISECONDS TEXT" of FILE, with the
 * time of the wall clock. The program runs until a signal ends it. */
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>

int main(int argc, char **argv)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    char text[512];
    if (argc != 3 || strlen(argv[1]) >= sizeof address.sun_path) {
        fprintf(stderr, "usage: manager SOCKET FILE\n");
        return 2;
    }
    memcpy(address.sun_path, argv[1], strlen(argv[1]) + 1u);
    const int fd = socket(AF_UNIX, SOCK_DGRAM, 0);
    FILE *file = fopen(argv[2], "w");
    if (fd < 0 || !file || bind(fd, (const struct sockaddr *)&address, sizeof address) != 0) {
        perror("manager");
        return 74;
    }
    for (;;) {
        const ssize_t size = recv(fd, text, sizeof text - 1u, 0);
        struct timespec now;
        if (size < 0) {
            return 74;
        }
        text[size] = '\0';
        clock_gettime(CLOCK_REALTIME, &now);
        fprintf(file, "%lld %s\n", (long long)now.tv_sec * 1000 + now.tv_nsec / 1000000, text);
        fflush(file);
    }
}
