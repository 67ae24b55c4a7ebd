/* test_replay_initial_state.c -- Tests how the initial state is encoded in a recording. Decoding
 * must restore every bit, the encoding must be compact, and an invalid state must be rejected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/replay/replay.h"

static struct core core;
static struct core_config config, back;
static uint8_t bytes[REPLAY_INITIAL_STATE_MAX];

static uint32_t draw(uint32_t at, uint32_t what)
{
    return rng_u32((struct rng_key){ 11, at, what, RNG_TEST });
}

/* Fills a struct with random bytes. The struct contains only numbers, so all its values are valid
 * for C. */
static void scatter(void *at, size_t size, uint32_t what)
{
    uint8_t *to = at;
    for (size_t i = 0; i < size; i++) {
        to[i] = (uint8_t)draw((uint32_t)i, what);
    }
}

static void fill_ranking(struct ranking *ranking)
{
    scatter(ranking, sizeof *ranking, 1);
    for (uint32_t board = 0; board < RANK_BOARD_COUNT; board++) {
        for (uint32_t i = 0; i < RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            struct rank_row *row = &ranking->row[board][i / RANK_ROWS][i % RANK_ROWS];
            row->slot %= POI_MAX;
            row->round_id %= LEDGER_ID_MAX;
            for (uint32_t k = 0; k < LEDGER_NAME_SIZE; k++) {
                row->name[k] |= (char)0x80; /* The highest bit is set, so no character of the name
                                               is a control character. */
            }
            row->name[LEDGER_NAME_SIZE - 1u] = '\0';
        }
    }
}

/* Limits the random numbers of a balance to the valid range. */
static void limit_balance(struct balance *balance)
{
    uint32_t *const counts[] = { &balance->units, &balance->bonus_units, &balance->paid,
                                 &balance->service, &balance->unlogged };
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        *counts[i] %= BALANCE_MAX;
    }
    balance->open %= PAYMENT_SERVICE + 1u;
    balance->returned = balance->returned % 2u ? PAYMENT_PAID : PAYMENT_SERVICE;
    balance->tickets %= BALANCE_TICKETS_MAX;
}

static void bring_into_range(struct game_session *session)
{
    struct ledger *ledger = &session->ledger;
    ledger->last_id %= LEDGER_ID_MAX;
    ledger->saved_id %= ledger->last_id + 1u;
    ledger->boot %= LEDGER_BOOTS_MAX;
    ledger->minute %= 24u * 60u;
    ledger->is_healthy &= 1u;
    ledger->store_came_late &= 1u;
    session->health_log.is_written &= 1u;
    limit_balance(&ledger->balance);
    limit_balance(&ledger->committed);
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        limit_balance(&ledger->after[i]);
    }
    for (uint32_t i = 0; i < COIN_LINE_COUNT; i++) {
        session->credit.pending_coins[i].units %= BALANCE_MAX;
        session->credit.pending_coins[i].owed %= BALANCE_MAX;
    }
}

static void fill(void)
{
    config = (struct core_config){ .seed = 0x89abcdef,
                                   .preset = TANK_PRESET_THESIS,
                                   .fish_count = 33,
                                   .language = LANGUAGE_EN,
                                   .round_s = 599,
                                   .modes = 5,
                                   .grade = 5,
                                   .players = 3,
                                   .credit_coins = 7,
                                   .ticket_fish = 9 };
    scatter(&config.persistent.ledger, sizeof config.persistent.ledger, 2);
    scatter(&config.persistent.audits, sizeof config.persistent.audits, 3);
    fill_ranking(&config.persistent.ranking);
    scatter(&config.session, sizeof config.session, 5);
    bring_into_range(&config.session);
    config.persistent.ledger.last_id %= LEDGER_ID_MAX;
    config.persistent.ledger.boots %= LEDGER_BOOTS_MAX;
    limit_balance(&config.persistent.ledger.balance);
    config.persistent.ledger.stand = (struct ledger_stand){ 0x01020304, 0xf0005, 0x60 };
    config.session.language.chosen = LANGUAGE_EN;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        config.persistent.settings.value[id] = draw(id, 4) % 2u ? setting->min : setting->max;
    }
}

/* Equal state hashes mean that every member of every struct is equal (see test_core_hash.c). */
static void test_the_largest_initial_state_is_restored_bit_for_bit(void **state)
{
    (void)state;
    fill();
    const size_t size = replay_initial_state_encode(&config, bytes);
    assert_in_range(size, 4000, REPLAY_INITIAL_STATE_MAX * 2u / 3u);
    memset(&back, 0, sizeof back);
    assert_int_equal(replay_initial_state_decode(&back, bytes, size, REPLAY_VERSION), 1);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    const uint64_t hash = core_hash(&core);
    assert_int_equal(core_init(&core, &back), CORE_OK);
    assert_true(core_hash(&core) == hash);
}

static void test_an_empty_initial_state_takes_few_bytes(void **state)
{
    (void)state;
    const struct core_config fresh = { .seed = 7, .fish_count = 12 };
    /* core_init() has set all settings to their defaults, so the encoding must be short. */
    assert_int_equal(core_init(&core, &fresh), CORE_OK);
    const size_t size = replay_initial_state_encode(&core.config, bytes);
    assert_in_range(size, 10, 80);
    assert_int_equal(replay_initial_state_decode(&back, bytes, size, REPLAY_VERSION), 1);
    assert_memory_equal(&back.persistent, &core.config.persistent, sizeof back.persistent);
}

static void test_a_truncated_or_extended_initial_state_is_rejected(void **state)
{
    (void)state;
    fill();
    const size_t size = replay_initial_state_encode(&config, bytes);
    for (size_t cut = 0; cut < size; cut++) {
        assert_int_equal(replay_initial_state_decode(&back, bytes, cut, REPLAY_VERSION), 0);
    }
    bytes[size] = 128; /* The additional byte encodes two zero bytes, which make the decoded state
                          too long. */
    assert_int_equal(replay_initial_state_decode(&back, bytes, size + 1u, REPLAY_VERSION), 0);
}

static void test_an_invalid_initial_state_is_rejected(void **state)
{
    (void)state;
    fill();
    config.persistent.ranking.row[RANK_BOARD_COUNT - 1u][2][9].slot = POI_MAX - 1u;
    size_t size = replay_initial_state_encode(&config, bytes);
    assert_int_equal(replay_initial_state_decode(&back, bytes, size, REPLAY_VERSION), 1);
    /* Each byte 0xff encodes 129 zero bytes, so the encoded state is much too long. */
    memset(bytes, 0xff, sizeof bytes);
    assert_int_equal(replay_initial_state_decode(&back, bytes, sizeof bytes, REPLAY_VERSION), 0);
    memset(bytes, 0x41, sizeof bytes); /* With this content, the names have no terminating zero. */
    for (size_t i = 0; i < sizeof bytes; i += 129) {
        bytes[i] = 127;
    }
    for (size = 0; size < sizeof bytes; size++) {
        assert_int_equal(replay_initial_state_decode(&back, bytes, size, REPLAY_VERSION), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_largest_initial_state_is_restored_bit_for_bit),
        cmocka_unit_test(test_an_empty_initial_state_takes_few_bytes),
        cmocka_unit_test(test_a_truncated_or_extended_initial_state_is_rejected),
        cmocka_unit_test(test_an_invalid_initial_state_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
