/* seats.h -- who sits where: shares what can be a poi out among the players' seats.
 *
 * Sources come and go while the kiosk runs: a USB poi is plugged in, a pad's battery ends. Each
 * seat's device of struct hal stays the same and passes on to whatever source sits there. The best
 * kind gets the first seat; who sits keeps his place among his kind. In a game a seat changes only
 * if its controller is away and another of its kind stands by. Whoever is there and has no
 * seat is listened to all the same, lest his words pile up: his buttons count, and the operator's
 * desk may learn him. */
#ifndef KINGYO_DRIVERS_SEATS_H
#define KINGYO_DRIVERS_SEATS_H

#include "platform/hal.h"

#define SEAT_SOURCE_MAX (3u * POI_MAX) /* USB pois, pads, and room for one pointer. */
#define SEAT_EMPTY UINT8_MAX

/* The kinds of sources, best first. */
enum seat_kind {
    SEAT_USB = 0, /* A poi one can hold, or what the operator chose to be one. */
    SEAT_PAD,
    SEAT_POINTER, /* The mouse, a finger. */
};

struct seat_source {
    struct hal_poi poi;
    struct hal_shade fan;         /* Ops null: it has none. */
    int (*is_there)(void *self);  /* Whether somebody could play with it now; null: always. */
    void *self;                   /* Of is_there(). */
    uint8_t kind;                 /* enum seat_kind */
    uint8_t stands_in;            /* It is there whenever nobody else is, whatever is_there() says:
                                     a mouse that lies about is no second player. */
};

struct seats {
    struct seat_source source[SEAT_SOURCE_MAX];
    uint32_t source_count;
    uint32_t there;           /* Sources that were there when they were last asked, a bit each; */
    uint32_t idle;            /* and those of them that are open without a seat. */
    struct view view;         /* As told last, and how that lies on the screen; */
    struct showing showing;   /* who sits down is told both. */
    uint8_t has_view;
    const char *empty_line;   /* What the first seat says while nobody sits there. */
    struct seat {
        struct seats *seats;
        uint8_t index;
        uint8_t source;       /* < source_count, or SEAT_EMPTY. */
    } seat[POI_MAX];
};

/* Nobody sits anywhere. `empty_line` is kept, not copied: what is missing, and what to do. */
void seats_init(struct seats *seats, const char *empty_line);

/* Adds a source, the best first. -1: there are SEAT_SOURCE_MAX already, and it will not play. */
int seats_add(struct seats *seats, const struct seat_source *source);

struct hal_poi seats_poi(struct seats *seats, uint32_t seat);
struct hal_shade seats_fan(struct seats *seats, uint32_t seat);
struct hal_seats seats_device(struct seats *seats);

/* The rule alone: who sits in `seat` (SEAT_EMPTY, or the place of a source) goes where he should,
 * given the kinds of `count` sources and which of them are `there` (a bit each). */
void seats_share(uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t there);

#endif
