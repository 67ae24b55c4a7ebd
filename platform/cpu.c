/* cpu.c -- asked once at the start; the core itself never looks at the machine. */
#include "platform/cpu.h"

uint8_t cpu_lanes(void)
{
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") ? 8 : 4;
#else
    return 4;
#endif
}
