/* trap.h -- the macro HOLD(), with which fuzz targets check a condition. If the condition is false,
 * HOLD() ends the process. */
#ifndef KINGYO_TESTS_FUZZ_TRAP_H
#define KINGYO_TESTS_FUZZ_TRAP_H

#include <stddef.h>
#include <stdint.h>

/* Entry point of a fuzz target, which libFuzzer calls with each input. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

#define HOLD(condition)                                                                            \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            __builtin_trap();                                                                      \
        }                                                                                          \
    } while (0)

#endif
