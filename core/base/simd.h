/* simd.h -- SIMD form of fmath.h: computes several floats at once. The result of each lane is
 * bit-identical to the result of the scalar function.
 *
 * A SIMD kernel is a source file named *_simd.c that uses these functions. A lane is one element of
 * a vector. Each kernel is compiled for four lanes (SSE2, NEON, or scalar code if the target has
 * neither). On x86-64 each kernel is also compiled for eight lanes (-mavx2 -DSIMD_WIDE).
 * SIMD_NAME() gives the two builds of a function different names, and SIMD_PICK() calls the build
 * that the platform selected. Files named *_lanes.c also use these functions. They are compiled
 * only once, for four lanes, because four lanes are fast enough for their callers.
 *
 * The game state never depends on the number of lanes: each lane's value equals the result of the
 * scalar function to the last bit.
 *
 * The vectors are extensions of the compilers (gcc from version 12, clang), so a kernel is plain C
 * on every target. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/base/fmath.h"
#include "core/base/mem.h"

#ifdef SIMD_WIDE
#define SIMD_LANES 8
#define SIMD_NAME(name) name##_8
#else
#define SIMD_LANES 4
#define SIMD_NAME(name) name##_4
#endif

/* Kernels declared between SIMD_BEGIN and SIMD_END have hidden visibility, so that a pointer to a
 * kernel needs no entry in a table of the dynamic linker. */
#define SIMD_BEGIN _Pragma("GCC visibility push(hidden)")
#define SIMD_END _Pragma("GCC visibility pop")

/* Gives the name of a build of the kernel `name`. `lanes` is the number of lanes: 4, 8, or 0 for
 * the default (4). Example: SIMD_PICK(lanes, swim_move_block)(shoal, first). */
#ifdef __x86_64__
#define SIMD_LANES_MAX 8u
#define SIMD_PICK(lanes, name) ((lanes) == 8u ? name##_8 : name##_4)
#else
#define SIMD_LANES_MAX 4u
#define SIMD_PICK(lanes, name) ((void)(lanes), name##_4)
#endif

/* Returns true if the kernels were built for this number of lanes. 0 selects the default of 4
 * lanes. */
static inline bool simd_is_built(uint32_t lanes)
{
    return lanes == 0u || lanes == 4u || lanes == SIMD_LANES_MAX;
}

typedef float flanes __attribute__((vector_size(4 * SIMD_LANES)));
/* Integer vector or mask. A mask holds -1 in a lane where the condition is true, otherwise 0. */
typedef int32_t ilanes __attribute__((vector_size(4 * SIMD_LANES)));
typedef float fquad __attribute__((vector_size(16)));

static inline flanes simd_splat(float x)
{
    return x - (flanes){ 0 }; /* Every lane is x - 0. The form x + 0 would change -0 to 0. */
}

static inline flanes simd_load(const float *from)
{
    flanes a;
    MEM_COPY(&a, from, sizeof a);
    return a;
}

static inline void simd_store(float *to, flanes a)
{
    MEM_COPY(to, &a, sizeof a);
}

/* Loads four floats from `low`. With eight lanes, the upper four lanes are loaded from `high`. */
static inline flanes simd_load_pair(const void *low, const void *high)
{
    fquad first;
    MEM_COPY(&first, low, sizeof first);
#ifdef SIMD_WIDE
    fquad fifth;
    MEM_COPY(&fifth, high, sizeof fifth);
    return __builtin_shufflevector(first, fifth, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    (void)high;
    return first;
#endif
}

/* Loads four floats of the record at `first`. With eight lanes, the upper four lanes come from the
 * record four records later. `stride` is the size of a record in bytes. */
static inline flanes simd_load_row(const void *first, size_t stride)
{
    return simd_load_pair(first, (const char *)first + (SIMD_LANES - 4u) * stride);
}

static inline void simd_store_row(void *first, size_t stride, flanes row)
{
#ifdef SIMD_WIDE
    const fquad low = __builtin_shufflevector(row, row, 0, 1, 2, 3);
    const fquad high = __builtin_shufflevector(row, row, 4, 5, 6, 7);
    MEM_COPY(first, &low, sizeof low);
    MEM_COPY((char *)first + 4u * stride, &high, sizeof high);
#else
    (void)stride;
    MEM_COPY(first, &row, sizeof row);
#endif
}

/* LOW and HIGH interleave the vectors a and b. In each group of four lanes, LOW(a, b) is a[0],
 * b[0], a[1], b[1], and HIGH(a, b) is a[2], b[2], a[3], b[3]. */
#ifdef SIMD_WIDE
#define LOW(a, b) __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define HIGH(a, b) __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#else
#define LOW(a, b) __builtin_shufflevector(a, b, 0, 4, 1, 5)
#define HIGH(a, b) __builtin_shufflevector(a, b, 2, 6, 3, 7)
#endif

/* Transposes four rows into four columns: column[m] holds element m of every row. The transpose of
 * the columns is the rows again. */
static inline void simd_turn(flanes column[4], flanes row0, flanes row1, flanes row2, flanes row3)
{
    const flanes a = LOW(row0, row2), b = LOW(row1, row3);
    const flanes c = HIGH(row0, row2), d = HIGH(row1, row3);
    column[0] = LOW(a, b);
    column[1] = HIGH(a, b);
    column[2] = LOW(c, d);
    column[3] = HIGH(c, d);
}
#undef LOW
#undef HIGH

/* Loads four consecutive floats of each of SIMD_LANES records. column[m] holds float m of all
 * records. Records are `stride` bytes apart; `first` points at the floats of the first record. */
static inline void simd_load_quads(flanes column[4], const void *first, size_t stride)
{
    const char *from = first;
    simd_turn(column, simd_load_row(from, stride), simd_load_row(from + stride, stride),
              simd_load_row(from + 2u * stride, stride), simd_load_row(from + 3u * stride, stride));
}

/* Stores four floats to each of SIMD_LANES records; the inverse of simd_load_quads(). */
static inline void simd_store_quads(void *first, size_t stride, const flanes column[4])
{
    char *to = first;
    flanes row[4];
    simd_turn(row, column[0], column[1], column[2], column[3]);
    simd_store_row(to, stride, row[0]);
    simd_store_row(to + stride, stride, row[1]);
    simd_store_row(to + 2u * stride, stride, row[2]);
    simd_store_row(to + 3u * stride, stride, row[3]);
}

/* Returns `a` in lanes where `mask` is -1, otherwise `b`. The bits of a lane are copied
 * unchanged. */
static inline flanes simd_select(ilanes mask, flanes a, flanes b)
{
    return (flanes)((mask & (ilanes)a) | (~mask & (ilanes)b));
}

static inline flanes simd_abs(flanes a)
{
    return (flanes)((ilanes)a & 0x7fffffff);
}

/* Minimum and maximum with the same results as f_min() and f_max(). If the operands are equal or
 * one operand is NaN, the result is the second operand, as for the x86 instructions. clang compiles
 * the comparison to these instructions, but gcc does not. */
#if defined(__SSE2__) && defined(SIMD_WIDE) && !defined(__clang__)
#define SIMD_MIN_OP(a, b) __builtin_ia32_minps256(a, b)
#define SIMD_MAX_OP(a, b) __builtin_ia32_maxps256(a, b)
#elif defined(__SSE2__) && !defined(__clang__)
#define SIMD_MIN_OP(a, b) __builtin_ia32_minps(a, b)
#define SIMD_MAX_OP(a, b) __builtin_ia32_maxps(a, b)
#else
#define SIMD_MIN_OP(a, b) simd_select((a) < (b), a, b)
#define SIMD_MAX_OP(a, b) simd_select((a) > (b), a, b)
#endif

static inline flanes simd_min(flanes a, flanes b)
{
    return SIMD_MIN_OP(a, b);
}

static inline flanes simd_max(flanes a, flanes b)
{
    return SIMD_MAX_OP(a, b);
}
#undef SIMD_MIN_OP
#undef SIMD_MAX_OP

static inline flanes simd_clamp(flanes x, flanes low, flanes high)
{
    return simd_min(simd_max(x, low), high);
}

static inline flanes simd_lerp(flanes a, flanes b, flanes t)
{
    return a + (b - a) * t;
}

static inline flanes simd_sqrt(flanes a)
{
    /* The compiler turns the loop into a single instruction. */
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        a[lane] = f_sqrt(a[lane]);
    }
    return a;
}

static inline flanes simd_floor(flanes x)
{
    /* 2^23. A float of at least this magnitude has no fractional part. */
    const ilanes small = simd_abs(x) < 8388608.0f;
    const ilanes toward_zero = __builtin_convertvector((flanes)(small & (ilanes)x), ilanes);
    const flanes whole = __builtin_convertvector(toward_zero, flanes);
    return simd_select(small, simd_select(whole > x, whole - 1.0f, whole), x);
}

static inline flanes simd_wrap_angle(flanes x)
{
    return x - F_TAU * simd_floor((x + F_PI) / F_TAU);
}

/* Returns one bit for each lane of `mask`; bit 0 belongs to lane 0. */
static inline uint32_t simd_bits(ilanes mask)
{
#if defined(__AVX2__) && defined(SIMD_WIDE)
    return (uint32_t)__builtin_ia32_movmskps256((flanes)mask);
#elif defined(__SSE2__) && !defined(SIMD_WIDE)
    return (uint32_t)__builtin_ia32_movmskps((flanes)mask);
#else
    uint32_t bits = 0;
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        bits |= (uint32_t)(mask[lane] & 1) << lane;
    }
    return bits;
#endif
}

struct simd_sin_cos {
    flanes sin, cos;
};

/* Returns f_sin() and f_cos() of each lane, with one range reduction for both functions. */
static inline struct simd_sin_cos simd_sin_cos(flanes x)
{
    const float half_pi_high = 1.5703125f, half_pi_low = 4.83826794897e-4f;
    const flanes turns = simd_floor(x / (half_pi_high + half_pi_low) + 0.5f);
    const flanes r = (x - turns * half_pi_high) - turns * half_pi_low;
    const flanes s = r * r;
    const flanes high = 1.0f / 120.0f - s * (1.0f / 5040.0f - s * (1.0f / 362880.0f));
    const flanes sine = r * (1.0f - s * (1.0f / 6.0f - s * high));
    const flanes cosine =
        1.0f - s * (0.5f - s * (1.0f / 24.0f - s * (1.0f / 720.0f - s * (1.0f / 40320.0f))));
    const ilanes quadrant = __builtin_convertvector(turns, ilanes);
    const ilanes odd = (quadrant & 1) != 0;
    /* Bit 1 of `quadrant` determines the sign. The shift by 30 moves this bit to bit 31, the sign
     * bit of a float. */
    const ilanes sine_sign = (quadrant & 2) << 30, cosine_sign = ((quadrant + 1) & 2) << 30;
    return (struct simd_sin_cos){
        .sin = (flanes)((ilanes)simd_select(odd, cosine, sine) ^ sine_sign),
        .cos = (flanes)((ilanes)simd_select(odd, sine, cosine) ^ cosine_sign),
    };
}
