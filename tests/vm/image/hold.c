/* hold.c -- stops only the first thread of a process, to simulate a frame loop that hangs.
 *
 * Usage: hold PID
 *
 * The thread stays stopped until this program or the process ends. SIGSTOP is not used, because it
 * would stop the other threads too. Exit code 0 means that the process has ended, and 74 that it
 * could not be stopped. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

/* Returns 1 if the process has ended or has received SIGABRT, SIGKILL or SIGTERM. After one of
 * these signals the stopped thread is released, so that the signal can end the process. */
static bool is_over(pid_t pid)
{
    int status;
    if (waitpid(pid, &status, __WALL) != pid || WIFEXITED(status) || WIFSIGNALED(status)) {
        return true;
    }
    const int number = WIFSTOPPED(status) && status >> 16 == 0 ? WSTOPSIG(status) : 0;
    if (number == SIGABRT || number == SIGKILL || number == SIGTERM) {
        ptrace(PTRACE_DETACH, pid, NULL, number);
        return true;
    }
    return false;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: hold PID\n");
        return 2;
    }
    const pid_t pid = (pid_t)strtol(argv[1], NULL, 10);
    if (ptrace(PTRACE_SEIZE, pid, NULL, NULL) != 0 ||
        ptrace(PTRACE_INTERRUPT, pid, NULL, NULL) != 0) {
        perror("hold");
        return 74;
    }
    while (!is_over(pid)) {
    }
    return 0;
}
