/* usb_choice.h -- which controllers on USB may be claimed, and at which seat they sit. Pure.
 *
 * Claimed is what somebody named: the operator in the menu (kept in a file), whoever started the
 * kiosk (--usb), and our own poi: its makers have ids of their own, so it is known by its report
 * descriptor. Where that cannot be read without claiming, only a named id is asked, and the one
 * that pid.codes keeps for anybody's bench. What has keys to type with is never claimed, whoever
 * names it. */
#ifndef KINGYO_DRIVERS_USB_CHOICE_H
#define KINGYO_DRIVERS_USB_CHOICE_H

#include <stddef.h>
#include <stdint.h>

#include "core/input.h"
#include "drivers/hid_descriptor.h"
#include "drivers/hid_port.h"

#define USB_BENCH_VENDOR 0x1209u  /* pid.codes' id for tests: no product may be sold with it. */
#define USB_BENCH_PRODUCT 0x0001u
#define USB_KEY_TEXT_SIZE (10u + HID_TEXT_SIZE) /* "057e:2009:" and a serial number. */
#define USB_WISH_MAX 32u /* A stall whose four pois were replaced seven times. */
#define USB_ERROR_SIZE 96u

/* A controller, or every one of a kind. */
struct usb_key {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": whatever its serial number is. */
};

/* Reads "VVVV:PPPP" or "VVVV:PPPP:SERIAL", four hexadecimal digits each. 0, or -1. */
int usb_key_read(struct usb_key *out, const char *text);
void usb_key_write(const struct usb_key *key, char text[USB_KEY_TEXT_SIZE]);
struct usb_key usb_key_of(const struct hid_identity *identity);

struct usb_wish {
    struct usb_key key;
    uint8_t plays; /* 0: it rests, although it would play by itself. */
    uint8_t kept;  /* It belongs into the file. */
};

/* Zero wants nothing but our own poi. */
struct usb_choice {
    uint32_t wish_count;
    struct usb_wish wish[USB_WISH_MAX];
};

/* In place of an older wish for the same key. When full, the oldest is forgotten. */
void usb_choice_wish(struct usb_choice *choice, const struct usb_key *key, int plays, int kept);

/* The keys that play; how many. */
uint32_t usb_choice_wanted(const struct usb_choice *choice, struct usb_key out[USB_WISH_MAX]);

/* The file of choices: a line "plays KEY" or "rests KEY" each, '#' begins a comment line. Reads one
 * line: 0, or -1 and one sentence in `error`. */
int usb_choice_read_line(struct usb_choice *choice, const char *line, char error[USB_ERROR_SIZE]);

/* The file's line `index` without a newline, or 0 when there are no more. */
#define USB_CHOICE_LINE_SIZE (USB_KEY_TEXT_SIZE + 8u)
int usb_choice_line(const struct usb_choice *choice, uint32_t index,
                    char line[USB_CHOICE_LINE_SIZE]);

/* What an input report descriptor is good for. */
enum usb_kind {
    USB_KIND_UNKNOWN = 0, /* It was not read yet. */
    USB_KIND_NOTHING,     /* No input fields, or it cannot be read. */
    USB_KIND_KEYS,        /* Keys to type with, whatever is beside them; or nothing but media keys,
                             a power supply and the like: no hand leads those. */
    USB_KIND_LEARNABLE,   /* Fields that no map of ours knows: it must be learned. */
    USB_KIND_HAND,        /* A hand can lead it as it is: hid_map_choose() finds a map. */
    USB_KIND_OWN,         /* Our own poi, byte for byte. */
};

/* One interface of a device. */
struct usb_subject {
    const struct hid_identity *identity;
    uint8_t is_boot_keyboard; /* By its interface descriptor, HID 1.11 section 4.2. */
    uint8_t kind;             /* enum usb_kind */
    uint8_t worth;            /* hid_map_worth() */
};

/* Gives `subject` kind and worth by its report descriptor; size 0: that was not read yet. */
void usb_choice_read(struct usb_subject *subject, const uint8_t *bytes, uint32_t size,
                     struct hid_descriptor *scratch);

enum usb_verdict {
    USB_BARRED = 0, /* Never. */
    USB_FREE,       /* Only if it is chosen. */
    USB_ASK,        /* It may be claimed to read its report descriptor; then judge again. */
    USB_PLAYS,
};
enum usb_verdict usb_choice_judge(const struct usb_choice *choice,
                                  const struct usb_subject *subject);

/* Of two interfaces of a device, whether `a` is the one to claim rather than `b`: one that can be
 * played as it is, then one that is yet to be asked, then one that must be learned; of equals the
 * one that leads a hand better, at last the one with the lower number. */
int usb_choice_is_better(const struct usb_choice *choice, const struct usb_subject *a,
                         const struct usb_subject *b);

/* Who sits, or sat, where. */
struct usb_place {
    uint8_t was_taken; /* `identity` sits there or did last. */
    uint8_t is_taken;  /* It sits there now. */
    uint8_t is_held;   /* It went only just now: a stranger does not get its seat. */
    struct hid_identity identity;
};

/* The seat for who comes: its own, as its serial number or else its port says; else one that nobody
 * ever had; else one that is not held. POI_MAX: none. */
uint32_t usb_choice_seat(const struct usb_place place[POI_MAX],
                         const struct hid_identity *identity);

/* How much two look like the same controller: 0 not at all; more is more. */
uint32_t usb_choice_likeness(const struct hid_identity *a, const struct hid_identity *b);

#endif
