/* bench_start.c -- benchmark of the time from exec to the first presented frame, and of the peak
 * memory.
 *
 * Usage: bench_start SECONDS PROGRAM [WORDS...]
 *
 * The benchmark takes the place of systemd, the service manager, to which the kiosk sends READY=1
 * after its first frame. It then lets the kiosk run for SECONDS more, ends it with SIGTERM and
 * prints `first_frame_ms peak_mib`. */
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define PATIENCE_MS 60000

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static int listen_as_manager(char path[108])
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    snprintf(path, 108, "/tmp/kingyo-bench-%d", (int)getpid());
    strcpy(address.sun_path, path);
    const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    return fd >= 0 && bind(fd, (struct sockaddr *)&address, sizeof address) == 0 ? fd : -1;
}

/* Returns 1 if READY=1 arrived before the timeout. */
static int wait_for_first_frame(int fd)
{
    struct pollfd waited = { .fd = fd, .events = POLLIN };
    char message[256];
    while (poll(&waited, 1, PATIENCE_MS) == 1) {
        const ssize_t size = recv(fd, message, sizeof message - 1, 0);
        message[size > 0 ? size : 0] = '\0';
        if (strstr(message, "READY=1")) {
            return 1;
        }
    }
    return 0;
}

int main(int argc, char **argv)
{
    char path[108];
    if (argc < 3) {
        fprintf(stderr, "usage: bench_start SECONDS PROGRAM [WORDS...]\n");
        return 2;
    }
    const int fd = listen_as_manager(path);
    if (fd < 0) {
        fprintf(stderr, "bench_start: %s: %s\n", path, strerror(errno));
        return 74;
    }
    setenv("NOTIFY_SOCKET", path, 1);
    const double begin_ms = now_ms();
    const pid_t child = fork();
    if (child == 0) {
        /* Redirects the program's output to standard error, so that standard output has only the
         * result line of this benchmark. */
        dup2(STDERR_FILENO, STDOUT_FILENO);
        execv(argv[2], argv + 2);
        _exit(127);
    }
    const int came = wait_for_first_frame(fd);
    const double first_frame_ms = now_ms() - begin_ms;
    sleep(came ? (unsigned)atoi(argv[1]) : 0);
    kill(child, SIGTERM);
    struct rusage usage;
    int status;
    wait4(child, &status, 0, &usage);
    unlink(path);
    if (!came) {
        fprintf(stderr, "bench_start: no first frame within %d s\n", PATIENCE_MS / 1000);
        return 1;
    }
    printf("%.0f %.1f\n", first_frame_ms, (double)usage.ru_maxrss / 1024.0);
    return 0;
}
