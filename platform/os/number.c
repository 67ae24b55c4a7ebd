/* number.c -- parses and prints numbers; see number.h. A leading zero does not mean octal. */
#include "platform/os/number.h"

#include <errno.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

#define DECIMAL_MAX 40u

bool number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out)
{
    CORE_ASSERT(out || !text);
    if (!text || text[0] == '\0' || text[strspn(text, "0123456789")] != '\0') {
        return false;
    }
    errno = 0;
    const unsigned long long value = strtoull(text, NULL, 10);
    if (errno != 0 || value < min || value > max) {
        return false;
    }
    *out = (uint32_t)value;
    return true;
}

/* ---- Decimal numbers ----------------------------------------------------------------------- */

bool number_parse_decimal(const char *text, double min, double max, double *out)
{
    CORE_ASSERT(out || !text);
    static locale_t plain; /* The locale "C", in which the decimal separator is a point. */
    char *end;
    /* These characters exclude texts that strtod() would also accept: blanks, hexadecimal numbers,
     * infinity and NaN. */
    if (!text || text[0] == '\0' || strlen(text) > DECIMAL_MAX ||
        text[strspn(text, "0123456789+-.eE")] != '\0') {
        return false;
    }
    plain = plain ? plain : newlocale(LC_ALL_MASK, "C", NULL);
    if (!plain) {
        return false;
    }
    const double value = strtod_l(text, &end, plain);
    if (*end != '\0' || !(value >= min && value <= max)) {
        return false;
    }
    *out = value;
    return true;
}

uint32_t number_print_fixed(char out[NUMBER_FIXED_MAX], double value, uint32_t decimals)
{
    CORE_ASSERT(decimals <= 6 && value > -1e12 && value < 1e12);
    char digits[NUMBER_FIXED_MAX];
    static const double powers[] = { 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6 };
    const double scaled = (value < 0.0 ? -value : value) * powers[decimals] + 0.5;
    uint64_t rest = (uint64_t)scaled;
    uint32_t count = 0, length = 0;
    if (value < 0.0 && rest > 0) { /* A value that rounds to zero is printed without a minus
                                      sign. */
        out[length++] = '-';
    }
    do {
        digits[count++] = (char)('0' + rest % 10u);
        rest /= 10u;
    } while (rest > 0 || count <= decimals);
    while (count > 0) {
        out[length++] = digits[--count];
        if (count == decimals && decimals > 0) {
            out[length++] = '.';
        }
    }
    return length;
}
