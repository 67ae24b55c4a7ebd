/* panic.c -- handles a failed assertion in a fuzz target: prints the condition and ends the
 * process, so that the fuzzer stores the input. */
#include <stdio.h>
#include <stdlib.h>

#include "core/base/panic.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}
