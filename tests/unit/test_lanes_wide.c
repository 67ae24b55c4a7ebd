/* test_lanes_wide.c -- test_lanes.c once more, as the Makefile builds kernels for eight lanes. */
#include "tests/unit/test_lanes.c"
