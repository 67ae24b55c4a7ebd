/* test_audits.c -- checks which counters the start of a game changes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/game/accounting/audits.h"

#define MINUTE (13u * 60u + 59u)
#define HOUR 13u

/* Day 0 of the calendar, 2000-01-01, is a Saturday. Days 2 to 8 are Monday to Sunday. */
static void test_a_game_is_counted_at_its_weekday_and_hour(void **state)
{
    (void)state;
    for (uint32_t weekday = 0; weekday < 7u; weekday++) {
        struct audits audits = { 0 };
        const struct ledger_entry entry = { .kind = LEDGER_BEGIN,
                                            .day = (uint16_t)(2u + weekday),
                                            .minute = MINUTE };
        audits_note(&audits, &entry);
        for (uint32_t i = 0; i < 7u; i++) {
            assert_int_equal(audits.count[AUDIT_WEEKDAY + i], i == weekday);
        }
        for (uint32_t i = 0; i < 24u; i++) {
            assert_int_equal(audits.count[AUDIT_HOUR + i], i == HOUR);
        }
    }
}

static void test_a_game_without_a_date_is_counted_at_no_weekday_or_hour(void **state)
{
    (void)state;
    struct audits audits = { 0 };
    const struct ledger_entry entry = { .kind = LEDGER_BEGIN, .minute = MINUTE };
    audits_note(&audits, &entry);
    for (uint32_t i = AUDIT_HOUR; i < AUDIT_WEEKDAY + 7u; i++) {
        assert_int_equal(audits.count[i], 0);
    }
    assert_int_equal(audits.count[AUDIT_PLAYS_FREE], 1);
}

static void test_rounds_of_an_easier_level_are_not_counted_as_master(void **state)
{
    (void)state;
    struct audits audits = { .count[AUDIT_ROUNDS] = 3 };
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_MASTER), 3);
    audits.count[AUDIT_ROUNDS_EASIER] = 2;
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_MASTER), 1);
    assert_int_equal(audits_rounds_at(audits.count, LEVEL_NORMAL), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_game_is_counted_at_its_weekday_and_hour),
        cmocka_unit_test(test_a_game_without_a_date_is_counted_at_no_weekday_or_hour),
        cmocka_unit_test(test_rounds_of_an_easier_level_are_not_counted_as_master),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
