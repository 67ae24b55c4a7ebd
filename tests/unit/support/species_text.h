/* species_text.h -- the text of a small complete species, and functions that test the error
 * messages of the reader of such texts. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_SPECIES_TEXT_H
#define KINGYO_TESTS_UNIT_SUPPORT_SPECIES_TEXT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "core/morph/morph.h"
#include "platform/species/text.h"

#define TEXT_SIZE 4096

static struct species_text species;

#define KEY_BODY                                                                                   \
    "coat 000000 112233 ffffff abcdef c0a040 0 .5\n"                                               \
    "station 0 0 0 0 2\nstation .3 .3 .2 0 2\nstation .6 .3 .2 0 2\nstation 1 .1 .05 0 2\n"        \
    "eye .1 .02 .08 .2\n"                                                                          \
    "fin tail -.05 .05 0 0\nray 0 .2 30 0\nray 1 .2 -30 0\n"                                       \
    "fin dorsal .4 .8 0 0\nray 0 .2 30 0\nray 1 .2 30 0\n"                                         \
    "fin anal .7 .8 0 0\nray 0 .2 30 0\nray 1 .2 30 0\n"                                           \
    "fin pectoral .3 .35 .3 0\nray 0 .2 30 0\nray 1 .2 30 0\n"                                     \
    "fin pelvic .45 .5 .4 0\nray 0 .2 30 0\nray 1 .2 30 0\n"
#define HEAD "species test\ngrowth .3 .5 -.1\nhatch .005 .1\n"
#define KEYS "key a 10\n" KEY_BODY "key b 20\n" KEY_BODY "key c 40\n" KEY_BODY
#define KNOTS "knot 0 1 0 0\nknot .5 .15 .7 .15\nknot 1 0 0 1\n"

/* Returns the error message of the reader for `text`, or an empty string if the reader accepts
 * `text`. */
static inline const char *complaint_of(const char *text)
{
    static char complaint[256];
    memset(complaint, 0, sizeof complaint);
    FILE *in = fmemopen((void *)(uintptr_t)text, strlen(text), "r");
    FILE *out = fmemopen(complaint, sizeof complaint - 1, "w");
    const bool good = species_read(in, "t.txt", out, &species);
    fclose(in);
    fclose(out);
    assert_true(good == (complaint[0] == '\0'));
    return complaint;
}

/* Asserts that the reader rejects `text` with a message of one line that contains `complaint`. */
static inline void assert_refused(const char *text, const char *complaint)
{
    const char *answer = complaint_of(text);
    assert_non_null(strstr(answer, complaint));
    /* The message must have only one newline, at its end. */
    assert_ptr_equal(strchr(answer, '\n'), answer + strlen(answer) - 1);
}

#endif
