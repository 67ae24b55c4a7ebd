/* number.c -- parses numbers digit by digit, independent of the locale. A leading zero does not
 * mean octal. */
#include "platform/os/number.h"

#include <assert.h>
#include <string.h>

#define DECIMAL_MAX 40u
#define EXPONENT_MAX 99

int number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out)
{
    assert(out || !text);
    uint64_t value = 0;
    if (!text || *text == '\0') {
        return 0;
    }
    for (; *text; text++) {
        if (*text < '0' || *text > '9') {
            return 0;
        }
        value = value * 10u + (uint64_t)(*text - '0');
        if (value > UINT32_MAX) {
            return 0;
        }
    }
    if (value < min || value > max) {
        return 0;
    }
    *out = (uint32_t)value;
    return 1;
}

/* ---- Decimal numbers ----------------------------------------------------------------------- */

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static double power_of_ten(int exponent)
{
    assert(exponent >= -200 && exponent <= 200);
    double power = 1.0;
    for (int i = 0; i < (exponent < 0 ? -exponent : exponent); i++) {
        power *= 10.0;
    }
    return power;
}

/* Reads the digits at the start of `text` into `mantissa` and counts them in `count`. Returns the
 * text after the digits. */
static const char *take_digits(const char *text, double *mantissa, int *count)
{
    for (*count = 0; is_digit(*text); text++, ++*count) {
        *mantissa = *mantissa * 10.0 + (double)(*text - '0');
    }
    return text;
}

/* Reads an exponent, for example "e-3" as -3. Returns the text after the exponent, or null if the
 * exponent is malformed. */
static const char *take_exponent(const char *text, int *exponent)
{
    const int negative = text[1] == '-';
    double value = 0.0;
    int count = 0;
    text = take_digits(text + 1 + (text[1] == '-' || text[1] == '+'), &value, &count);
    if (count == 0 || value > (double)EXPONENT_MAX) {
        return NULL;
    }
    *exponent = negative ? -(int)value : (int)value;
    return text;
}

int number_parse_decimal(const char *text, double min, double max, double *out)
{
    assert(out || !text);
    double mantissa = 0.0;
    int whole = 0, fraction = 0, exponent = 0;
    if (!text || strlen(text) > DECIMAL_MAX) {
        return 0;
    }
    const int negative = *text == '-';
    text = take_digits(text + (*text == '-' || *text == '+'), &mantissa, &whole);
    if (*text == '.') {
        text = take_digits(text + 1, &mantissa, &fraction);
    }
    if (whole + fraction > 0 && (*text == 'e' || *text == 'E')) {
        text = take_exponent(text, &exponent);
    }
    if (whole + fraction == 0 || !text || *text != '\0') {
        return 0;
    }
    exponent -= fraction;
    const double power = power_of_ten(exponent);
    const double size = exponent < 0 ? mantissa / power : mantissa * power;
    const double value = negative ? -size : size;
    if (!(value >= min && value <= max)) {
        return 0;
    }
    *out = value;
    return 1;
}

uint32_t number_print_fixed(char out[NUMBER_FIXED_MAX], double value, uint32_t decimals)
{
    assert(decimals <= 6 && value > -1e12 && value < 1e12);
    char digits[NUMBER_FIXED_MAX];
    const double scaled = (value < 0.0 ? -value : value) * power_of_ten((int)decimals) + 0.5;
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
