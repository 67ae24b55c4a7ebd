/* ledger.h -- the append-only list of everything that must survive a power cut.
 *
 * The core emits one entry for each persistent event, such as a coin, a started round, a finished
 * round or a changed setting. Entry ids rise by one, starting with the first entry that this kiosk
 * ever wrote. The store (platform/store/storage.h) writes entries in order, so the disk always
 * holds the list up to some id. input.record_saved_id is that id: every entry up to it is
 * committed, so no power cut removes or duplicates it. Each entry contains the balance after the
 * entry, so the newest entry on disk defines the balance at the next start. */
#ifndef KINGYO_CORE_LEDGER_H
#define KINGYO_CORE_LEDGER_H

#include <stdint.h>

#include "core/input.h"

/* Capacity of the ring of entries that are not yet on disk. The ring holds more coins than a
 * cabinet takes in the second that a card needs for a sync, and the ends of a round. When the ring
 * is full, coins are added to the balance's `unlogged`, and the coin slot closes. */
#define LEDGER_RING 32u
/* Ring entries reserved for the start and the end of rounds, so that a started round can always
 * be finished. */
#define LEDGER_RESERVE 4u
#define LEDGER_NAME_SIZE 32u /* Ten kana of three bytes each and a terminating zero. */

/* Largest entry id and largest start count, so that neither wraps. At one entry per second a kiosk
 * reaches the limit after 126 years. The core writes no larger id, and a record with a larger id is
 * damaged. */
#define LEDGER_ID_MAX 4000000000u
#define LEDGER_BOOTS_MAX LEDGER_ID_MAX

enum ledger_kind {
    LEDGER_NOTHING = 0,
    LEDGER_BOOT,      /* The kiosk started. `count`: number of starts so far; `value`: units of
                         coins that the previous start could not log. */
    LEDGER_COINS,     /* `count` pulses of coin line `detail` (from 0), worth `value` units. */
    LEDGER_SERVICE,   /* The SERVICE button added a credit without payment. */
    LEDGER_BEGIN,     /* A round started, paid with the kind of credit in purse.open. `detail`: mode
                         of the round, or CHOICE_LAB; `count`: paper grade, 0 in the lab. */
    LEDGER_ROUND,     /* A round ended, see `round`. `value`: tickets won; `detail`: ROUND_CUT_OFF
                         if a power cut ended the round, else 0. */
    LEDGER_REFUND,    /* A round was cancelled. `count`: credits returned, 0 for free play;
                         `detail`: enum refund_cause; `value`: enum round_payment before the
                         refund. */
    LEDGER_EXPIRED,   /* `count` credits expired, together with the units inserted towards the next
                         credit. */
    LEDGER_TEST_COIN, /* `count` test pulses in the operator's menu: counted by the meter, not added
                         to the balance. */
    LEDGER_SETTING,   /* Setting `detail` `count` << 8 changed to `value`. */
    LEDGER_RESET,     /* Audit counters of group `detail` were reset to zero; `value`: their sum
                         before. */
    LEDGER_NAME,      /* Name of the player in slot `detail` of the round whose entry id is `count`:
                         `name`. */
    LEDGER_HEALTH,    /* Faults of the machine since the previous LEDGER_HEALTH: `health`. `count`:
                         tilt events; `value`: uptime in seconds. */
    LEDGER_FACTORY,   /* Factory reset of settings, balance and calibration. `count`: credits in the
                         balance before; `value`: tickets owed before. */
    LEDGER_CREDITS,   /* Inserted units became `count` credits; `value` of them are bonus
                         credits. */
    LEDGER_LEFT,      /* An open round or growth-lab visit ended without a result to store, because
                         it was the lab or no player joined. */
    LEDGER_PIN,       /* A PIN was entered. `detail` 1: correct, after wrong attempts; 0: wrong. */
    LEDGER_STAND,     /* State of an open round whose credit is no longer refundable.
                         core/game/accounting/round_standing.c packs `detail`, `count` and
                         `value`. */
    LEDGER_LOSS,      /* The controller of slot `detail` was lost again during a round. */
    LEDGER_TICKET,    /* `count` tickets, always 1, moved from the balance to the dispenser. */
    LEDGER_KIND_COUNT,
};

enum refund_cause {
    REFUND_NO_POI = 0, /* The pois were lost and no player returned. */
    REFUND_OPERATOR,   /* The operator opened the menu. */
    REFUND_RESTART,    /* The round was still open at startup, because the kiosk crashed or lost
                          power. */
    REFUND_CAUSE_COUNT,
};

#define ROUND_CUT_OFF 1u

/* Kind of credit that paid for the open round. */
enum round_payment {
    PAYMENT_NONE = 0,
    PAYMENT_FREE,
    PAYMENT_PAID,          /* Paid credit, from purse.paid. */
    PAYMENT_SERVICE,       /* Service credit, from purse.service. */
    PAYMENT_KIND_MASK = 3, /* Mask of the values above. */
    PAYMENT_SPENT = 4,     /* Flag: the credit is not refundable, because two thirds of the round
                              were played or the credit was already refunded once. */
};

struct balance {
    uint32_t units;       /* Units inserted towards the next credit. */
    uint32_t bonus_units; /* Units inserted since the last bonus or the last round. */
    uint32_t paid;        /* Credits that were bought and not yet played. */
    uint32_t service;     /* Credits from the SERVICE button that were not yet played. */
    uint32_t unlogged;    /* Units inserted while the ledger ring was full, not yet logged. */
    uint8_t open;         /* enum round_payment */
    uint8_t returned; /* PAYMENT_PAID or PAYMENT_SERVICE: a credit of that kind was refunded. The
                         next round uses this credit and cannot be refunded again. PAYMENT_NONE: no
                         refunded credit. */
    uint16_t tickets; /* Tickets won and not yet sent to the dispenser, 0 ..
                         BALANCE_TICKETS_MAX. */
};

#define BALANCE_TICKETS_MAX 60000u /* Fits 16 bits. Tickets beyond this number are dropped. */
/* Upper limit of each count in the balance; no coin box holds so many coins. */
#define BALANCE_MAX 1000000u

/* Machine faults since the previous LEDGER_HEALTH entry. */
struct health {
    uint32_t up_s; /* Seconds since the kiosk started, independent of earlier entries. */
    uint32_t dropped_ticks;
    uint32_t device_faults;
};

/* Stored result of a finished round. */
struct round_record {
    uint32_t id;   /* Id of the round's ledger entry; 0: no record. */
    uint32_t seed; /* Seed of the tank that was played. */
    uint32_t start_tick;
    uint32_t end_tick;   /* start_tick plus the ticks that were played; pauses are excluded. */
    uint32_t caught;     /* Fish caught by all players together. */
    uint16_t fish_count; /* Fish in the tank, caught ones included; 0: unknown, because an earlier
                            version of Kingyo wrote the record. The same holds for `round_s` and
                            `preset`. */
    uint16_t round_s;    /* Configured length of the round in seconds. */
    uint8_t preset;      /* enum tank_preset_id */
    uint8_t by_bot;      /* 1: the bot played, so the record is no score. */
    uint8_t mode;        /* enum game_mode */
    uint8_t grade;       /* Grade of the paper, 4 .. 7. */
    uint8_t players;     /* Bit mask of the slots that took part. */
    uint8_t unscored; /* 1: the mode keeps no score, so the record counts only as a played round. */
    struct player_record {
        uint32_t caught;
        uint32_t scoops;        /* Number of times the ring entered the water. */
        uint32_t hole_area_mm2; /* Total hole area of the last sheet at the end of the round. */
        uint32_t torn_tick;     /* Tick at which the first sheet became useless, in the same time
                                   base as end_tick; 0: the sheet lasted. */
        uint32_t sheets;        /* Sheets that the player received; 1 in modes that do not replace
                                   torn paper. */
        uint8_t fouls;
    } player[POI_MAX];
};

struct ledger_entry {
    uint32_t id;   /* Id of the entry; 0: no entry. */
    uint32_t boot; /* Start number of the kiosk. */
    uint32_t tick; /* Tick within that start. `boot` and `tick` order the entries without a
                      clock. */
    uint16_t day;  /* Day from the clock, as input.day; a hint only, as `minute` is. */
    uint16_t minute;
    uint8_t kind; /* enum ledger_kind */
    uint8_t detail;
    uint32_t count;
    int32_t value;
    struct balance balance; /* Balance after this entry. */
    struct health health;
    struct round_record round;
    char name[LEDGER_NAME_SIZE]; /* UTF-8, padded with zeros. */
};

/* Fields of the newest LEDGER_STAND of an open round; all zero: no such entry. */
struct ledger_stand {
    uint32_t count;
    int32_t value;
    uint8_t detail;
};

/* Ledger state that the store loads at startup; all zero: nothing was stored. */
struct ledger_start {
    uint32_t last_id; /* Id of the newest entry. */
    uint32_t boots;   /* Number of starts, including the current one; 0: the kiosk has no store. */
    struct balance balance;
    struct ledger_stand stand; /* State of the open round if purse.open has PAYMENT_SPENT. */
};

#endif
