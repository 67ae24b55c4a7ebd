/* test_simd_wide.c -- builds test_simd.c a second time, with compiler options of the Makefile that
 * select eight lanes. */
#include "tests/unit/core/base/test_simd.c"
