/* panic.c -- reports failed assertions of the core to cmocka.
 *
 * A test can expect an assertion with expect_assert_failure(). An unexpected assertion fails the
 * test and prints its condition. */
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
    /* mock_assert() returns to the test by longjmp or fails the test, so this line is never
     * reached. */
    abort();
}
