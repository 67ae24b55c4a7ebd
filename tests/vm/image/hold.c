/* hold.c -- stops the first thread of a process, and no other, until this ends or the process does.
 *
 * hold PID. What a frame loop that hangs looks like from outside: SIGSTOP would stop the threads
 * beside it, too. Exit code 0: the process is no more; 74: it could not be held. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

/* A signal that would end the process ends it: the thread is let go for that. */
static int is_over(pid_t pid)
{
    int status;
    if (waitpid(pid, &status, __WALL) != pid || WIFEXITED(status) || WIFSIGNALED(status)) {
        return 1;
    }
    const int number = WIFSTOPPED(status) && status >> 16 == 0 ? WSTOPSIG(status) : 0;
    if (number == SIGABRT || number == SIGKILL || number == SIGTERM) {
        ptrace(PTRACE_DETACH, pid, NULL, number);
        return 1;
    }
    return 0;
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
