/* number.c -- one digit after the other, so that no locale and no octal zero has a say. */
#include "platform/number.h"

int number_parse(const char *text, uint32_t min, uint32_t max, uint32_t *out)
{
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
