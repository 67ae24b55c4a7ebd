/* cpu.c -- detects processor features and sets the floating-point control register; see cpu.h.
 *
 * The file includes no C library header, so that a test can compile it for other architectures. */
#include "platform/cpu.h"

/* Each architecture defines the type of its control register, CONTROL_STANDARD (the default value),
 * CONTROL_MASK (the bits that are compared with the default), and two macros that read the register
 * to a variable and write a value to the register. */
#if defined(__x86_64__)

/* Default of MXCSR (Intel SDM volume 1, section 10.2.3): all exceptions are masked, rounding is to
 * nearest, FZ and DAZ are off. The mask leaves out the status flags in the low six bits. */
#define CONTROL_STANDARD 0x1f80u
#define CONTROL_MASK 0xffc0u
#define CONTROL_READ(word) ((word) = __builtin_ia32_stmxcsr())
#define CONTROL_WRITE(word) __builtin_ia32_ldmxcsr(word)
typedef uint32_t control_word;

#elif defined(__aarch64__)

/* Default of FPCR (Arm ARM): round to nearest, no FZ (bit 24), no FZ16 (bit 19), no DN (bit 25) and
 * no traps. FPCR has no status flags. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0xffffffffu
#define CONTROL_READ(word) __asm__ volatile("mrs %0, fpcr" : "=r"(word))
#define CONTROL_WRITE(word) __asm__ volatile("msr fpcr, %0" : : "r"(word))
typedef uint64_t control_word;

#elif defined(__arm__) && defined(__ARM_FP)

/* Default of FPSCR (Arm ARM). The mask selects the mode and trap bits 8 to 12, 15 and 16 to 26. All
 * other bits are status flags. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0x07ff9f00u
#define CONTROL_READ(word) __asm__ volatile("vmrs %0, fpscr" : "=r"(word))
#define CONTROL_WRITE(word) __asm__ volatile("vmsr fpscr, %0" : : "r"(word))
typedef uint32_t control_word;

#elif defined(__riscv) && defined(__riscv_flen)

/* Default of fcsr (RISC-V unprivileged ISA): round to nearest. The mask selects the rounding mode,
 * bits 5 to 7. The low five bits are status flags. RISC-V has no flush-to-zero mode. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0xe0u
#define CONTROL_READ(word) __asm__ volatile("frcsr %0" : "=r"(word))
#define CONTROL_WRITE(word) __asm__ volatile("fscsr %0" : : "r"(word))
typedef unsigned long control_word;

#else

/* No control register is known for this architecture. Only the core's own check
 * (core/base/float_env.h) applies. */
#define CONTROL_STANDARD 0u
#define CONTROL_MASK 0u
#define CONTROL_READ(word) ((word) = CONTROL_STANDARD)
#define CONTROL_WRITE(word) ((void)(word))
typedef uint32_t control_word;

#endif

bool cpu_set_float(void)
{
    const control_word standard = CONTROL_STANDARD;
    control_word word;
    CONTROL_READ(word);
    if ((word & CONTROL_MASK) == standard) {
        return false;
    }
    CONTROL_WRITE(standard);
    return true;
}

uint8_t cpu_lanes(void)
{
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") ? 8 : 4;
#else
    return 4;
#endif
}
