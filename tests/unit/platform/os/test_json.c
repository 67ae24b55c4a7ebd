/* test_json.c -- Tests the writer of JSON documents: commas, line breaks and escapes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/os/json.h"

static void test_commas_separate_the_elements_of_every_level(void **state)
{
    char text[256];
    struct json json = { .buffer = text, .size = sizeof text };
    (void)state;
    json_open(&json, NULL, '{');
    json_open(&json, "none", '[');
    json_close(&json, ']');
    json_open(&json, "rows", '[');
    for (uint32_t i = 0; i < 2; i++) {
        json_line(&json, 2);
        json_open(&json, NULL, '{');
        json_value(&json, "i", "%u", i);
        json_bool(&json, "odd", i == 1);
        json_close(&json, '}');
    }
    json_line(&json, 0);
    json_close(&json, ']');
    json_value(&json, "half", "%.2f", 0.5);
    json_close(&json, '}');
    json_end(&json);
    assert_string_equal(text, "{\"none\": [], \"rows\": [\n  {\"i\": 0, \"odd\": false},\n"
                              "  {\"i\": 1, \"odd\": true}\n], \"half\": 0.50}\n");
    assert_int_equal(json.used, sizeof "{\"none\": [], \"rows\": [\n  {\"i\": 0, \"odd\": false},\n"
                                       "  {\"i\": 1, \"odd\": true}\n], \"half\": 0.50}\n" -
                                    1u);
}

static void test_text_of_any_bytes_is_a_valid_string(void **state)
{
    char text[128];
    struct json json = { .buffer = text, .size = sizeof text };
    (void)state;
    json_open(&json, NULL, '[');
    json_text(&json, NULL, "a\"b\\c\n\x1b\xff\xe3\x81\x82\xc2\x9b");
    json_text(&json, NULL, "");
    json_close(&json, ']');
    assert_string_equal(text,
                        "[\"a\\\"b\\\\c\\u000a\\u001b\xEF\xBF\xBD\xe3\x81\x82\\u009b\", \"\"]");
}

static void test_a_format_writes_the_same_document_as_single_calls(void **state)
{
    char text[256];
    struct json json = { .buffer = text, .size = sizeof text };
    (void)state;
    json_print(&json, "{count: %u, less: %d, bytes: %zu, sum: %llu, half: %.2f, gone: %.1f,", 3u,
               -1, (size_t)7, 1ull << 40, 0.5, (double)NAN);
    json_print(&json, "hash: %016llx, name: %s, yes: %hhd,\n  list: [%s, {}, []]\n", 0xabcull,
               "a\"b, c: {", true, "x");
    json_print(&json, "COLOR_0: [%.9g, %.6g, %.3g]}", (double)0.1f, 10.0, (double)NAN);
    json_end(&json);
    assert_string_equal(text, "{\"count\": 3, \"less\": -1, \"bytes\": 7, \"sum\": 1099511627776, "
                              "\"half\": 0.50, \"gone\": null, \"hash\": \"0000000000000abc\", "
                              "\"name\": \"a\\\"b, c: {\", \"yes\": true,\n"
                              "  \"list\": [\"x\", {}, []],\n"
                              "\"COLOR_0\": [0.100000001, 10, null]}\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_commas_separate_the_elements_of_every_level),
        cmocka_unit_test(test_text_of_any_bytes_is_a_valid_string),
        cmocka_unit_test(test_a_format_writes_the_same_document_as_single_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
