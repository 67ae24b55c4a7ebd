/* ledger.h -- the ledger: the append-only list of everything that must survive a power cut.
 *
 * The core emits one entry for each persistent event, such as a coin, a started round, a finished
 * round or a changed setting. Entry ids rise by one, starting with the first entry that this kiosk
 * ever wrote. The store (platform/store/storage.h) writes entries in order, so the disk always
 * holds the list up to some id, which is input.record_saved_id. Every entry up to that id is
 * committed, so no power cut removes or duplicates it. Each entry contains the balance after the
 * entry, so the newest entry on disk defines the balance at the next start. */
#pragma once

#include <stdint.h>

#include "core/input.h"

/* Capacity of the ring buffer of entries that are not yet on disk. A sync of the SD card takes a
 * second. In that time a cabinet takes fewer coins and ends fewer rounds than the ring buffer
 * holds. When the ring buffer is full, coins are added to the balance's `unlogged`, and the coin
 * slot closes. */
#define LEDGER_RING 32u
/* Number of places in the ring buffer reserved for the start and the end of rounds, so that a
 * started round can always be finished. */
#define LEDGER_RESERVE 4u
/* Size of a name in bytes: ten kana of three bytes each and a terminating zero fit. */
#define LEDGER_NAME_SIZE 32u

/* Largest entry id and largest number of kiosk starts, so that neither number wraps. At one entry
 * per second a kiosk reaches the limit after 126 years. The core writes no larger id, so a record
 * with a larger id is damaged. */
#define LEDGER_ID_MAX 4000000000u
#define LEDGER_BOOTS_MAX LEDGER_ID_MAX

enum ledger_kind {
    LEDGER_NOTHING = 0,
    /* The kiosk started. `count` is the number of starts so far. `value` is the number of coin
     * units that could not be logged before this start. */
    LEDGER_BOOT,
    LEDGER_COINS,   /* `count` pulses of coin line `detail` (from 0), worth `value` units. */
    LEDGER_SERVICE, /* The SERVICE button added a credit without payment. */
    /* A round started. `balance.open` is the kind of credit that paid for the round. `detail` is
     * the mode of the round, or CHOICE_LAB. `count` is the paper grade, or 0 in the lab. */
    LEDGER_BEGIN,
    /* A round ended; `round` is its record. `value` is the number of tickets won. `detail` is
     * ROUND_CUT_OFF if a power cut ended the round, otherwise 0. */
    LEDGER_ROUND,
    /* A round was cancelled. `count` is the number of credits returned, 0 in free play. `detail` is
     * an enum refund_cause. `value` is the enum round_payment before the refund. */
    LEDGER_REFUND,
    /* `count` credits expired, together with the units inserted towards the next credit. */
    LEDGER_EXPIRED,
    /* `count` test pulses arrived in the operator's menu. The coin meter counts the pulses, but the
     * balance does not change. */
    LEDGER_TEST_COIN,
    /* A setting changed to `value`. The setting's id is `detail` + (`count` << 8). */
    LEDGER_SETTING,
    /* Audit counters of group `detail` were reset to zero. `value` is the sum of the counters
     * before the reset. */
    LEDGER_RESET,
    /* A player entered `name`, or the operator removed the name. The player had slot `detail` in
     * the round whose entry id is `count`. */
    LEDGER_NAME,
    /* Machine faults since the previous LEDGER_HEALTH, stored in `health`. `count` is the number of
     * tilt events, and `value` the uptime in seconds, both since the previous LEDGER_HEALTH. */
    LEDGER_HEALTH,
    /* Factory reset of settings, balance and calibration. `count` is the number of credits in the
     * balance before the reset. `value` is the number of owed tickets before the reset. */
    LEDGER_FACTORY,
    /* Inserted units became `count` credits. `value` is the number of bonus credits among the
     * `count` credits. */
    LEDGER_CREDITS,
    /* An open round or a visit to the growth lab ended without a result to store. A lab visit has
     * no result, and neither has a round that no player joined. */
    LEDGER_LEFT,
    /* A PIN was entered. `detail` is 1 for a correct PIN after wrong attempts, and 0 for a wrong
     * PIN. */
    LEDGER_PIN,
    /* State of an open round whose credit is no longer refundable. The functions of
     * core/game/accounting/round_standing.c pack the state into `detail`, `count` and `value`. */
    LEDGER_STAND,
    /* The controller of slot `detail` was disconnected repeatedly during a round. */
    LEDGER_LOSS,
    LEDGER_TICKET, /* `count` tickets, always 1, moved from the balance to the dispenser. */
    LEDGER_KIND_COUNT,
};

enum refund_cause {
    /* All controllers were disconnected, and none was connected again in time. */
    REFUND_NO_POI = 0,
    REFUND_OPERATOR, /* The operator opened the menu. */
    /* The round was still open at startup, because the kiosk crashed or lost power. */
    REFUND_RESTART,
    REFUND_CAUSE_COUNT,
};

#define ROUND_CUT_OFF 1u

/* Kind of credit that paid for the open round. */
enum round_payment {
    PAYMENT_NONE = 0,
    PAYMENT_FREE,
    PAYMENT_PAID,          /* A paid credit from `balance.paid`. */
    PAYMENT_SERVICE,       /* A service credit from `balance.service`. */
    PAYMENT_KIND_MASK = 3, /* Mask of the kinds of credit above, without the flag PAYMENT_SPENT. */
    /* Flag: the credit is not refundable, because two thirds of the round were played or the credit
     * was already refunded once. */
    PAYMENT_SPENT = 4,
};

struct balance {
    uint32_t units; /* Units inserted towards the next credit. */
    /* Units inserted since the last bonus or since the last round, whichever is later. */
    uint32_t bonus_units;
    uint32_t paid;    /* Credits that were bought and not yet played. */
    uint32_t service; /* Credits from the SERVICE button that were not yet played. */
    /* Units inserted while the ledger's ring buffer was full. No ledger entry contains these units
     * yet. */
    uint32_t unlogged;
    /* Kind of credit that paid for the open round (enum round_payment); PAYMENT_NONE means no open
     * round. */
    uint8_t open;
    /* PAYMENT_PAID or PAYMENT_SERVICE if a credit of that kind was refunded. The next round uses
     * the refunded credit, which cannot be refunded a second time. PAYMENT_NONE means that the
     * balance contains no refunded credit. */
    uint8_t returned;
    /* Tickets won and not yet sent to the dispenser, 0 .. BALANCE_TICKETS_MAX. */
    uint16_t tickets;
};

/* Largest number of owed tickets, which fits 16 bits. Further tickets are dropped and not counted
 * in the audits. */
#define BALANCE_TICKETS_MAX 60000u
/* Upper limit of each count in the balance; no coin box holds so many coins. */
#define BALANCE_MAX 1000000u

/* Machine faults since the previous LEDGER_HEALTH entry. */
struct health {
    uint32_t up_s; /* Seconds since the kiosk started, not since the previous entry. */
    uint32_t dropped_ticks;
    uint32_t device_faults;
};

/* Stored result of a finished round. */
struct round_record {
    uint32_t id;   /* Id of the round's ledger entry; 0 means no record. */
    uint32_t seed; /* Seed of the tank that was played. */
    uint32_t start_tick;
    /* Tick at which the round would have ended without pauses: start_tick plus the number of played
     * ticks. */
    uint32_t end_tick;
    uint32_t caught; /* Fish caught by all players together. */
    /* Number of fish in the tank, including caught fish. 0 means unknown, because an earlier
     * version of Kingyo wrote the record. `round_s` and `preset` are then unknown too. */
    uint16_t fish_count;
    uint16_t round_s; /* Configured length of the round in seconds. */
    uint8_t preset;   /* Preset of the tank (enum tank_preset_id). */
    uint8_t by_bot;   /* 1 if the bot played, so the record is not a score; otherwise 0. */
    uint8_t mode;     /* enum game_mode */
    uint8_t grade;    /* Grade of the paper, 4 .. 7. */
    uint8_t players;  /* Bit mask of the slots that took part. */
    /* 1 if the mode keeps no score, so the record counts only as a played round; otherwise 0. */
    uint8_t unscored;
    /* Easiest level of the players (enum level). LEVEL_MASTER in records of an earlier version. */
    uint8_t level;
    struct player_record {
        uint32_t caught;
        uint32_t scoops;        /* Number of times the ring entered the water. */
        uint32_t hole_area_mm2; /* Total hole area of the last sheet at the end of the round. */
        /* Tick at which the first sheet became useless, without pauses, as in `end_tick`. 0 means
         * that the sheet remained usable. */
        uint32_t torn_tick;
        /* Number of sheets that the player received; 1 in modes that do not replace torn paper. */
        uint32_t sheets;
        uint8_t fouls;
    } player[POI_MAX];
};

struct ledger_entry {
    uint32_t id;   /* Id of the entry; 0 means no entry. */
    uint32_t boot; /* Boot counter (number of kiosk starts so far) when the entry was written. */
    /* Tick at which the entry was written, counted from the kiosk start `boot`. `boot` and `tick`
     * order the entries without a clock. */
    uint32_t tick;
    /* Day on which the entry was written, as in struct input. `day` and `minute` may be wrong, so
     * they are used only as hints. */
    uint16_t day;
    uint16_t minute;
    uint8_t kind; /* enum ledger_kind */
    uint8_t detail;
    uint32_t count;
    int32_t value;
    struct balance balance; /* Balance after this entry. */
    struct health health;
    struct round_record round;
    char name[LEDGER_NAME_SIZE]; /* Name of the player in UTF-8, padded with zeros. */
};

/* Copy of three fields of the newest LEDGER_STAND of an open round. All fields are 0 if the round
 * has no LEDGER_STAND. */
struct ledger_stand {
    uint32_t count;
    int32_t value;
    uint8_t detail;
};

/* State of the ledger that the store loads at startup. All fields are 0 if the store has no
 * entry. */
struct ledger_start {
    uint32_t last_id; /* Id of the newest entry. */
    /* Number of kiosk starts, including the current start; 0 means that the kiosk has no store. */
    uint32_t boots;
    struct balance balance;
    /* State of the open round if `balance.open` has the flag PAYMENT_SPENT. */
    struct ledger_stand stand;
};
