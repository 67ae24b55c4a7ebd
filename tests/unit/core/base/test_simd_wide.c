/* test_simd_wide.c -- builds test_simd.c again with eight lanes, as the Makefile builds the SIMD
 * functions. */
#include "tests/unit/core/base/test_simd.c"
