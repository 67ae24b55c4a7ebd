/* panic.c -- makes a failed assertion of the core visible to cmocka.
 *
 * expect_assert_failure(...) catches the failed assertion. Otherwise the assertion fails the test
 * and prints its condition. */
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
    abort(); /* mock_assert() leaves by longjmp or fails the test, so that control never returns to
                this line. */
}
