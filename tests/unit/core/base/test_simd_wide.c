/* test_simd_wide.c -- builds test_simd.c again for eight lanes. The Makefile sets the compiler
 * options for eight lanes. */
#include "tests/unit/core/base/test_simd.c"
