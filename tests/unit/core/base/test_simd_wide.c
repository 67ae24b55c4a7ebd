/* test_simd_wide.c -- test_simd.c once more, as the Makefile builds kernels for eight lanes. */
#include "tests/unit/core/base/test_simd.c"
