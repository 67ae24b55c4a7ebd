/* watchdog_host.c -- replaces systemd for the kiosk in the guest. The program starts the kiosk,
 * and resets the timer of the hardware watchdog while the kiosk reports that it runs.
 *
 * Usage: watchdog_host DEVICE SECONDS COMMAND [WORD...]
 *
 * The program opens the watchdog DEVICE when the command sends READY=1, and resets the timer at
 * each WATCHDOG=1. If the kiosk hangs, the watchdog resets the machine. When the command exits,
 * the program disarms the watchdog and returns the exit code of the command. Finally the program
 * prints on standard error how often it reset the timer, and the longest interval between two
 * resets. */
#include <fcntl.h>
#include <linux/watchdog.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define LINE_SIZE 256

struct watchdog_host {
    const char *device;
    int timeout_s;
    int watchdog_fd; /* Descriptor of the open watchdog device. -1 means that the watchdog is not
                        armed yet. */
    unsigned fed;
    double fed_s, longest_s;
};

static volatile sig_atomic_t asked_to_end;
static pid_t child;

static void pass_on(int number)
{
    asked_to_end = 1;
    kill(child, number);
}

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static int open_socket(void)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    snprintf(address.sun_path, sizeof address.sun_path, "/run/watchdog_host.%d", (int)getpid());
    unlink(address.sun_path);
    const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (fd < 0 || bind(fd, (const struct sockaddr *)&address, sizeof address) != 0) {
        perror("watchdog_host: socket");
        exit(74);
    }
    chmod(address.sun_path, 0666); /* The socket is writable for all users, because the command may
                                      run as any user. */
    setenv("NOTIFY_SOCKET", address.sun_path, 1);
    return fd;
}

static void arm(struct watchdog_host *watchdog_host)
{
    watchdog_host->watchdog_fd = open(watchdog_host->device, O_WRONLY | O_CLOEXEC);
    if (watchdog_host->watchdog_fd < 0 ||
        ioctl(watchdog_host->watchdog_fd, WDIOC_SETTIMEOUT, &watchdog_host->timeout_s) != 0) {
        perror(watchdog_host->device);
        return;
    }
    watchdog_host->fed_s = now_s();
    fprintf(stderr, "watchdog_host: ready; %s bites after %d s\n", watchdog_host->device,
            watchdog_host->timeout_s);
}

static void feed(struct watchdog_host *watchdog_host)
{
    const double time_s = now_s();
    if (watchdog_host->watchdog_fd >= 0 &&
        ioctl(watchdog_host->watchdog_fd, WDIOC_KEEPALIVE, 0) == 0) {
        watchdog_host->longest_s = time_s - watchdog_host->fed_s > watchdog_host->longest_s
                                       ? time_s - watchdog_host->fed_s
                                       : watchdog_host->longest_s;
        watchdog_host->fed_s = time_s;
        watchdog_host->fed++;
    }
}

static void listen_to(struct watchdog_host *watchdog_host, int fd)
{
    char line[LINE_SIZE];
    struct pollfd wait = { .fd = fd, .events = POLLIN };
    if (poll(&wait, 1, 100) <= 0) {
        return;
    }
    const ssize_t size = recv(fd, line, sizeof line - 1, 0);
    line[size > 0 ? size : 0] = '\0';
    if (strstr(line, "READY=1") && watchdog_host->watchdog_fd < 0) {
        arm(watchdog_host);
    }
    if (strstr(line, "WATCHDOG=1")) {
        feed(watchdog_host);
    }
}

static void start(char **command, int timeout_s)
{
    char usec[32];
    snprintf(usec, sizeof usec, "%d000000", timeout_s);
    setenv("WATCHDOG_USEC", usec, 1);
    child = fork();
    if (child == 0) {
        execvp(command[0], command);
        perror(command[0]);
        _exit(127);
    }
}

int main(int argc, char **argv)
{
    int status;
    if (argc < 4) {
        fprintf(stderr, "usage: watchdog_host DEVICE SECONDS COMMAND [WORD...]\n");
        return 2;
    }
    struct watchdog_host watchdog_host = { .device = argv[1],
                                           .timeout_s = atoi(argv[2]),
                                           .watchdog_fd = -1 };
    const int fd = open_socket();
    start(argv + 3, watchdog_host.timeout_s);
    signal(SIGTERM, pass_on);
    while (waitpid(child, &status, WNOHANG) == 0) {
        listen_to(&watchdog_host, fd);
    }
    if (watchdog_host.watchdog_fd >= 0 && write(watchdog_host.watchdog_fd, "V", 1) != 1) {
        perror(watchdog_host.device);
    }
    fprintf(stderr, "watchdog_host: fed %u times, %.1f s apart at most\n", watchdog_host.fed,
            watchdog_host.longest_s);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
