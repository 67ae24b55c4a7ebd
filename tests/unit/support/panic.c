/* panic.c -- reports failed assertions of the core to cmocka. A test can expect an assertion with
 * expect_assert_failure(). An assertion that is not expected fails the test and prints its
 * condition. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "core/base/panic.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    mock_assert(0, condition, file, line);
    /* Never executed, because mock_assert() either fails the test or returns to the test by
     * longjmp. */
    abort();
}
