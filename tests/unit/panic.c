/* panic.c -- a broken invariant of the core is something a test can expect.
 *
 * expect_assert_failure(...) catches it; anywhere else it fails the test and names the
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
    abort(); /* mock_assert leaves by longjmp or by failing the test; nothing comes back here. */
}
