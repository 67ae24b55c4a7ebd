/* cpu.c -- detects processor features and sets the floating-point control register; see cpu.h.
 *
 * The file includes no C library header, so that a test can compile it for other architectures. */
#include "platform/cpu.h"

#if defined(__x86_64__)

/* CONTROL_STANDARD is the default of MXCSR (Intel SDM volume 1, section 10.2.3): all exceptions are
 * masked, rounding is to nearest, FZ and DAZ are off. CONTROL_MASK leaves out the status flags in
 * the low six bits. */
#define CONTROL_STANDARD 0x1f80u
#define CONTROL_MASK 0xffc0u

static uint32_t control_get(void)
{
    return __builtin_ia32_stmxcsr();
}

static void control_set(uint32_t word)
{
    __builtin_ia32_ldmxcsr(word);
}

#elif defined(__aarch64__)

/* CONTROL_STANDARD is the default of FPCR (Arm ARM): round to nearest, no FZ (bit 24), no FZ16 (bit
 * 19), no DN (bit 25) and no traps. FPCR has no status flags. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0xffffffffu

static uint32_t control_get(void)
{
    uint64_t word;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return (uint32_t)word;
}

static void control_set(uint32_t word)
{
    __asm__ volatile("msr fpcr, %0" : : "r"((uint64_t)word));
}

#elif defined(__arm__) && defined(__ARM_FP)

/* CONTROL_STANDARD is the default of FPSCR (Arm ARM). CONTROL_MASK selects the mode and trap bits 8
 * to 12, 15 and 16 to 26. All other bits are status flags. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0x07ff9f00u

static uint32_t control_get(void)
{
    uint32_t word;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(word));
    return word;
}

static void control_set(uint32_t word)
{
    __asm__ volatile("vmsr fpscr, %0" : : "r"(word));
}

#elif defined(__riscv) && defined(__riscv_flen)

/* CONTROL_STANDARD is the default of fcsr (RISC-V unprivileged ISA): round to nearest. CONTROL_MASK
 * selects the rounding mode, bits 5 to 7. The low five bits are status flags. RISC-V has no
 * flush-to-zero mode. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0xe0u

static uint32_t control_get(void)
{
    unsigned long word;
    __asm__ volatile("frcsr %0" : "=r"(word));
    return (uint32_t)word;
}

static void control_set(uint32_t word)
{
    __asm__ volatile("fscsr %0" : : "r"((unsigned long)word));
}

#else

/* No control register is known for this architecture. Only the core's own check
 * (core/base/float_env.h) applies. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0u

static uint32_t control_get(void)
{
    return 0;
}

static void control_set(uint32_t word)
{
    (void)word;
}

#endif

int cpu_set_float(void)
{
    const int was_other = (control_get() & CONTROL_MASK) != CONTROL_STANDARD;
    if (was_other) {
        control_set(CONTROL_STANDARD);
    }
    return was_other;
}

uint8_t cpu_lanes(void)
{
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") ? 8 : 4;
#else
    return 4;
#endif
}
