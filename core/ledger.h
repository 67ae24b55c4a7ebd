/* ledger.h -- what must outlive a power cut, as a list that only grows.
 *
 * Whatever is worth keeping (a coin, a credit that is played, a round that is over, a setting that
 * was turned) leaves the core as one entry. Ids rise by one from the first entry that this kiosk
 * ever wrote. The store (platform/storage.h) writes them in their order, so that what is on disk is
 * always the list up to some id; input.record_saved_id says which. Up to there everything is
 * acknowledged: no power cut takes it back, none doubles it. Each entry carries the purse as it is
 * after it, so that the newest one on disk is the truth at the next start. */
#ifndef KINGYO_CORE_LEDGER_H
#define KINGYO_CORE_LEDGER_H

#include <stdint.h>

#include "core/input.h"

/* What is not on disk yet: more coins than fall while a card takes a second to sync, and the ends
 * of a round. When they are all taken, coins wait in the purse's `untold` and the slot closes. */
#define LEDGER_RING 32u
#define LEDGER_SPARE 4u /* Of them only for rounds that begin and end: what was begun can end. */
#define LEDGER_NAME_SIZE 32u /* Ten kana of three bytes each, and a zero. */

/* Ids and starts end here, so that neither wraps: at an entry a second a kiosk would need 126
 * years. A record beyond is damage, and the core writes none. */
#define LEDGER_ID_MAX 4000000000u
#define LEDGER_BOOTS_MAX LEDGER_ID_MAX

enum ledger_kind {
    LEDGER_NOTHING = 0,
    LEDGER_BOOT,      /* The kiosk began; `count`: its boots so far; `value`: units of coins that
                         the last start had found no room to tell of. */
    LEDGER_COINS,     /* `count` pulses of coin line `detail` (0 ..), worth `value` units. */
    LEDGER_SERVICE,   /* A credit that nobody paid for. */
    LEDGER_BEGIN,     /* A round began, for what purse.open says; `detail`: its mode, or CHOICE_LAB;
                         `count`: the grade of its paper, of the lab 0. */
    LEDGER_ROUND,     /* It is over: `round`; `value`: the tickets that it won; `detail`:
                         ROUND_CUT_OFF where a power cut ended it, else 0. */
    LEDGER_REFUND,    /* It will never be: `count` credits came back, 0 of a free one; `detail`:
                         enum refund_cause; `value`: enum purse_open, as it was. */
    LEDGER_EXPIRED,   /* `count` credits lapsed, and the units towards the next. */
    LEDGER_TEST_COIN, /* `count` pulses in the operator's menu: metered, nobody's money. */
    LEDGER_SETTING,   /* Setting `detail` | `count` << 8 was turned to `value`. */
    LEDGER_RESET,     /* Audits of group `detail` were set to zero; `value`: what their sum was. */
    LEDGER_NAME,      /* Who played in seat `detail` of the round whose entry is `count`: `name`. */
    LEDGER_HEALTH,    /* What the machine went through since the last of its kind: `health`;
                         `count`: shakes; `value`: seconds that it was up. */
    LEDGER_FACTORY,   /* Settings, purse and calibration as on the first day; `count` credits were
                         in the purse, and `value` tickets were owed. */
    LEDGER_CREDITS,   /* Units became `count` credits, `value` of them the bonus. */
    LEDGER_LEFT,      /* What had begun is over and there is nothing to tell of it: the growth lab,
                         or a round that nobody came to. */
    LEDGER_PIN,       /* Somebody typed one: `detail` 1, the right one after others; 0, another. */
    LEDGER_STAND,     /* How an open round stands whose credit cannot come back any more
                         (core/game/stand.c packs `detail`, `count` and `value`). */
    LEDGER_LOSS,      /* The controller of seat `detail` was lost in a round again. */
    LEDGER_TICKET,    /* `count` tickets, always 1, left the purse for the dispenser. */
    LEDGER_KIND_COUNT,
};

enum refund_cause {
    REFUND_NO_POI = 0, /* The pois were lost and nobody came again. */
    REFUND_OPERATOR,   /* The operator opened the menu. */
    REFUND_RESTART,    /* At the start it was still open: the kiosk had crashed, or the plug was
                          pulled. */
    REFUND_CAUSE_COUNT,
};

#define ROUND_CUT_OFF 1u

/* What the round that is open was paid with. */
enum purse_open {
    OPEN_NONE = 0,
    OPEN_FREE,
    OPEN_PAID,    /* One of purse.paid. */
    OPEN_SERVICE, /* One of purse.service. */
    OPEN_KIND = 3, /* Mask of the values above. */
    OPEN_SPENT = 4, /* Flag: the credit cannot come back. Two thirds of the round were played, or
                       the credit came back from an earlier round. */
};

struct purse {
    uint32_t units;       /* Inserted, towards the next credit. */
    uint32_t bonus_units; /* Inserted since the last bonus or the last round. */
    uint32_t paid;        /* Credits that were bought and not played, */
    uint32_t service;     /* and those that SERVICE gave. */
    uint32_t untold;      /* Units that fell while the ring was full. */
    uint8_t open;         /* enum purse_open */
    uint8_t returned;     /* OPEN_PAID or OPEN_SERVICE: one credit of that kind came back and is
                             played next, without a second refund. OPEN_NONE: no credit did. */
    uint16_t tickets;     /* Owed and not yet given to the dispenser, .. PURSE_TICKETS_MAX. */
};

#define PURSE_TICKETS_MAX 60000u /* Fits its 16 bits; tickets beyond this are not owed. */
#define PURSE_MAX 1000000u /* Each of its counts stops there: no box holds so many coins. */

/* What the machine went through since the entry of its kind before. */
struct health {
    uint32_t up_s;          /* Since it began, whatever was told before. */
    uint32_t dropped_ticks;
    uint32_t device_faults;
};

/* What is kept of a finished round. */
struct round_record {
    uint32_t id;   /* Its entry's; 0: there is none. */
    uint32_t seed; /* Of the tank it was played in. */
    uint32_t start_tick;
    uint32_t end_tick; /* start_tick and what was played: pauses are not in it. */
    uint32_t caught;   /* Of all players together. */
    uint16_t fish_count; /* In the tank, caught ones among them; 0: unknown, of an earlier Kingyo,
                            as are the next two. */
    uint16_t round_s; /* Its length, with which it began. */
    uint8_t preset;   /* enum tank_preset_id */
    uint8_t by_bot;   /* A demonstration is not a score. */
    uint8_t mode;     /* enum game_mode */
    uint8_t grade;    /* Of the paper, 4 .. 7. */
    uint8_t players;  /* Who took part, a bit each. */
    uint8_t unscored; /* Its mode keeps no score: it counts as played, nothing else. */
    struct player_record {
        uint32_t caught;
        uint32_t scoops;        /* Times the ring went in. */
        uint32_t hole_area_mm2; /* Of the paper that it held at the end. */
        uint32_t torn_tick;     /* When its first paper could hold nothing more, as end_tick is
                                   counted; 0: it lasted. */
        uint32_t sheets;        /* Papers that it got: 1 where nobody renews them. */
        uint8_t fouls;
    } player[POI_MAX];
};

struct ledger_entry {
    uint32_t id;     /* 0: there is none. */
    uint32_t boot;   /* Of the kiosk's starts, and ... */
    uint32_t tick;   /* ... its ticks: these two put entries in order without a clock. */
    uint16_t day;    /* What the clock said, as input.day and input.minute: a hint. */
    uint16_t minute;
    uint8_t kind;    /* enum ledger_kind */
    uint8_t detail;
    uint32_t count;
    int32_t value;
    struct purse purse; /* As it is after this. */
    struct health health;
    struct round_record round;
    char name[LEDGER_NAME_SIZE]; /* UTF-8, zero-filled. */
};

/* The fields of the newest LEDGER_STAND of an open round. Zero: there is none. */
struct ledger_stand {
    uint32_t count;
    int32_t value;
    uint8_t detail;
};

/* What the store remembers when the kiosk starts. Zero: nothing was ever kept. */
struct ledger_start {
    uint32_t last_id; /* The newest entry's. */
    uint32_t boots;   /* Starts so far, this one among them; 0: there is no store. */
    struct purse purse;
    struct ledger_stand stand; /* Of the open round, if purse.open has OPEN_SPENT. */
};

#endif
