/* test_text_translate.c -- Tests that the messages of all devices are translated into Japanese.
 * Names and numbers in a message must be kept, and an unknown message must stay unchanged. */
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

/* Each pattern of a message has gaps, which the test fills with the values x0, x1 and so on. The
 * translation must be the Japanese pattern with the same values in its gaps. */
static void test_every_message_pattern_is_unique(void **state)
{
    (void)state;
    for (uint32_t key = TEXT_MESSAGE_NO_PICTURE; key <= TEXT_MESSAGE_NO_ROOM; key++) {
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

/* The messages in this test were copied from real devices. Some messages have nested reasons or
 * several remarks. */
static void test_messages_of_devices_are_translated(void **state)
{
    static const char *const lines[][2] = {
        { "OpenGL ES 3.2 llvmpipe (LLVM 15.0.6, 256 bits), 1280x720, scene 1x, floor 0.6x, "
          "4 samples",
          "OpenGL ES 3.2 llvmpipe (LLVM 15.0.6, 256 bits), 1280x720、場面1倍、底0.6倍、なめらかさ4" },
        { "no picture: screen: the screen was unplugged", "映りません：画面：抜かれました" },
        { "store: 3 entries not written: database or disk is full; free some space; it is retried",
          "帳簿：3件を書けていません：ディスクがいっぱいです。空きを作ってください。もう一度試します" },
        { "no store: /var/lib/kingyo/kingyo.db: disk I/O error; nothing is kept",
          "帳簿がありません：/var/lib/kingyo/kingyo.db：ディスクの読み書きに失敗。何も残りません" },
        { "libgpiod 1.6.3: 6 of 8 lines; no start, coin (BTN_START is in use by 'x': stop that "
          "program or driver)",
          "libgpiod 1.6.3：6本（全部で8本）; start, coinがありません（BTN_STARTは「x」が使っています："
          "それを終えるか、線から外してください）" },
        { "libgpiod 2.2: 7 of 8 lines; no coin (COIN: no chip has that line; kingyoctl lines list "
          "shows them)",
          "libgpiod 2.2：7本（全部で8本）; coinがありません（COIN：どのチップにもない線です。"
          "kingyoctl lines list で見られます）" },
        { "libgpiod 2.2: 8 of 8 lines; no ticket (TICKETS does not switch: check the cable and "
          "power of its chip)",
          "libgpiod 2.2：8本（全部で8本）; ticketがありません（TICKETSが切り替わりません："
          "チップの線と電源を調べてください）" },
        { "libusb: 5 controllers, 2 of them play; no hot-plug, searched once per second",
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

/* The drivers of this version generate the messages of this test, so that a change of a message is
 * detected. */
static void test_the_current_messages_of_the_drivers_are_translated(void **state)
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

/* Translates a message into Japanese. Fails if the result has two lower-case English words in
 * sequence, because a part was then not translated. */
static void expect_japanese(const char *line)
{
    in_japanese(line);
    for (const char *c = out; *c; c++) {
        if (c[0] >= 'a' && c[0] <= 'z' && c[1] == ' ' && c[2] >= 'a' && c[2] <= 'z') {
            fail_msg("'%s' became '%s'", line, out);
        }
    }
}

static void test_messages_about_non_regular_files_are_translated(void **state)
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

/* Puts a store into each of its error states, and translates the message of each state. */
static void test_all_messages_of_the_store_are_translated(void **state)
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
    atomic_store(&storage.quarantined, 2);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
    atomic_store(&storage.busy_since_ms, 1);
    expect_japanese(store.ledger.ops->describe(store.ledger.self));
}

static void test_a_too_long_message_is_truncated_at_a_whole_character(void **state)
{
    (void)state;
    for (size_t size = 1; size < 40u; size++) {
        text_translate(out, size, LANGUAGE_JA, "three fingers start");
        const size_t length = strlen(out);
        assert_true(length < size && length % 3u == 0 && length + 3u >= (size < 28u ? size : 0u));
        assert_memory_equal(out, "三本の指でスタート", length);
    }
    char line[2048];
    /* The line is a very long list of unknown remarks. */
    for (size_t i = 0; i + 1u < sizeof line; i++) {
        line[i] = i % 2u ? ' ' : ';';
    }
    line[sizeof line - 1u] = '\0';
    in_japanese(line);
    assert_true(strlen(out) < sizeof out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_message_pattern_is_unique),
        cmocka_unit_test(test_messages_of_devices_are_translated),
        cmocka_unit_test(test_the_current_messages_of_the_drivers_are_translated),
        cmocka_unit_test(test_messages_about_non_regular_files_are_translated),
        cmocka_unit_test(test_all_messages_of_the_store_are_translated),
        cmocka_unit_test(test_a_too_long_message_is_truncated_at_a_whole_character),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
