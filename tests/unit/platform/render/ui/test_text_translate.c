/* test_text_translate.c -- every line of a device is known in Japanese, with its names and
 * figures in it; and nothing is lost of one that is not. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "drivers/pointer/buttons_keyboard.h"
#include "platform/os/file.h"
#include "platform/render/ui/text.h"
#include "platform/store/storage.h"
#include "platform/watchdog.h"

static char out[TEXT_TRANSLATE_SIZE];

static const char *in_japanese(const char *line)
{
    text_translate(out, sizeof out, LANGUAGE_JA, line);
    return out;
}

/* Each pattern, filled with something, is found again, and in Japanese all of that is there. */
static void test_every_pattern_is_its_own(void **state)
{
    (void)state;
    for (uint32_t key = TEXT_SAYS_NO_PICTURE; key <= TEXT_SAYS_NO_ROOM; key++) {
        const char *words[2] = { text_words(LANGUAGE_EN, (enum text_key)key),
                                 text_words(LANGUAGE_JA, (enum text_key)key) };
        char line[2][TEXT_TRANSLATE_SIZE];
        for (uint32_t side = 0; side < 2u; side++) {
            char name[] = "x0";
            size_t length = 0;
            for (const char *c = words[side]; *c; c++) {
                const int is_gap = c[0] == '{' && c[1] == '}';
                length += (size_t)snprintf(line[side] + length, TEXT_TRANSLATE_SIZE - length,
                                           "%.*s", is_gap ? 2 : 1, is_gap ? name : c);
                name[1] = (char)(name[1] + is_gap);
                c += is_gap;
            }
        }
        assert_string_not_equal(line[0], line[1]);
        assert_string_equal(in_japanese(line[0]), line[1]);
        text_translate(out, sizeof out, LANGUAGE_EN, line[0]);
        assert_string_equal(out, line[0]);
    }
}

/* As devices really say them, reasons in reasons and remarks side by side. */
static void test_lines_as_they_are_said(void **state)
{
    static const char *const lines[][2] = {
        { "OpenGL ES 3.2 llvmpipe (LLVM 15.0.6, 256 bits), 1280x720, scene 1x, floor 0.6x, "
          "4 samples",
          "OpenGL ES 3.2 llvmpipe (LLVM 15.0.6, 256 bits), 1280x720、場面1倍、底0.6倍、なめらかさ4" },
        { "no picture: screen: it was pulled out", "映りません：画面：抜かれました" },
        { "store: 3 entries not written: database or disk is full; free some space; it is retried",
          "帳簿：3件を書けていません：ディスクがいっぱいです。空きを作ってください。もう一度試します" },
        { "no store: /var/lib/kingyo/kingyo.db: disk I/O error; nothing is kept",
          "帳簿がありません：/var/lib/kingyo/kingyo.db：ディスクの読み書きに失敗。何も残りません" },
        { "libgpiod 1.6.3: 6 of 8 lines; no start, coin (BTN_START is held by 'x': end that, or "
          "take it off the line)",
          "libgpiod 1.6.3：6本（全部で8本）; start, coinがありません（BTN_STARTは「x」が使っています："
          "それを終えるか、線から外してください）" },
        { "libgpiod 2.2: 7 of 8 lines; no coin (COIN: no chip has that line; kingyoctl lines list "
          "shows them)",
          "libgpiod 2.2：7本（全部で8本）; coinがありません（COIN：どのチップにもない線です。"
          "kingyoctl lines list で見られます）" },
        { "libusb: 5 controllers, 2 of them play; no hot-plug, looked for once a second",
          "libusb：コントローラー5台、うち2台で遊べます; 抜き差しは毎秒調べます" },
        { "three fingers start; ...", "三本の指でスタート; ..." },
        { "/var/lib/kingyo/kingyo.db", "/var/lib/kingyo/kingyo.db" },
        { "something that nobody foresaw; three fingers start",
          "something that nobody foresaw; 三本の指でスタート" },
        { "", "" },
    };
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_string_equal(in_japanese(lines[i][0]), lines[i][1]);
    }
}

/* Not what a test remembers of them, but what they say today. */
static void test_the_drivers_own_words_are_known(void **state)
{
    struct buttons_keyboard keyboard = { 0 };
    struct storage storage = { 0 };
    const struct hal_buttons buttons = buttons_keyboard_device(&keyboard);
    const struct hal_storage store = storage_device(&storage);
    char line[HAL_TEXT_SIZE];
    (void)state;
    snprintf(line, sizeof line, "%s", buttons.ops->describe(buttons.self));
    assert_string_not_equal(in_japanese(line), line);
    assert_null(strstr(out, "arrows"));
    snprintf(line, sizeof line, "%s", store.ledger.ops->describe(store.ledger.self));
    assert_string_not_equal(in_japanese(line), line);
    store.ledger.ops->open(store.ledger.self);
    snprintf(line, sizeof line, "%s", store.ledger.ops->describe(store.ledger.self));
    assert_string_not_equal(in_japanese(line), line);
    assert_null(strstr(out, "folder"));
}

/* English is left where two words of it stand side by side. */
static void expect_japanese(const char *line)
{
    in_japanese(line);
    for (const char *c = out; *c; c++) {
        if (c[0] >= 'a' && c[0] <= 'z' && c[1] == ' ' && c[2] >= 'a' && c[2] <= 'z') {
            fail_msg("'%s' became '%s'", line, out);
        }
    }
}

static void test_what_is_no_regular_file_is_known(void **state)
{
    static const int errors[] = { ELOOP, ENOTSUP, EFBIG };
    (void)state;
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
        expect_japanese(file_error(errors[i]));
    }
    assert_string_equal(in_japanese("/var/lib/kingyo/usb.txt: is not a regular file"),
                        "/var/lib/kingyo/usb.txt：ふつうのファイルではありません");
    expect_japanese("was not a regular file, and was set aside");
}

/* All that a store can be like, in the words that it has for it today. */
static void test_whatever_the_store_says_is_known(void **state)
{
    static const int errors[] = { SQLITE_BUSY,       SQLITE_LOCKED,      SQLITE_FULL,
                                  SQLITE_READONLY,   SQLITE_IOERR,       SQLITE_CORRUPT,
                                  SQLITE_CANTOPEN,   SQLITE_NOTADB,      LEDGER_FILE_FOREIGN,
                                  LEDGER_FILE_NEWER, LEDGER_FILE_LOCKED, LEDGER_FILE_LINK,
                                  LEDGER_FILE_MOVED };
    static struct storage storage;
    const struct hal_storage store = storage_device(&storage);
    (void)state;
    for (uint32_t has_file = 0; has_file < 2u; has_file++) {
        for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++) {
            storage = (struct storage){ .path = "/kingyo.db" };
            atomic_store(&storage.has_file, has_file != 0);
            atomic_store(&storage.error, errors[i]);
            expect_japanese(store.ledger.ops->describe(store.ledger.self));
        }
    }
    atomic_store(&storage.error, SQLITE_OK);
    atomic_store(&storage.edit_error, ENOSPC);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
    atomic_store(&storage.edit_error, 0);
    atomic_store(&storage.strange, 1);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
    atomic_store(&storage.aside, 2);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
    atomic_store(&storage.busy_since_ms, 1);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
}

static void test_what_is_too_long_ends_after_a_whole_character(void **state)
{
    (void)state;
    for (size_t size = 1; size < 40u; size++) {
        text_translate(out, size, LANGUAGE_JA, "three fingers start");
        const size_t length = strlen(out);
        assert_true(length < size && length % 3u == 0 && length + 3u >= (size < 28u ? size : 0u));
        assert_memory_equal(out, "三本の指でスタート", length);
    }
    char line[2048];
    for (size_t i = 0; i + 1u < sizeof line; i++) { /* Remarks without end, and none of ours. */
        line[i] = i % 2u ? ' ' : ';';
    }
    line[sizeof line - 1u] = '\0';
    in_japanese(line);
    assert_true(strlen(out) < sizeof out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_pattern_is_its_own),
        cmocka_unit_test(test_lines_as_they_are_said),
        cmocka_unit_test(test_the_drivers_own_words_are_known),
        cmocka_unit_test(test_what_is_no_regular_file_is_known),
        cmocka_unit_test(test_whatever_the_store_says_is_known),
        cmocka_unit_test(test_what_is_too_long_ends_after_a_whole_character),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
