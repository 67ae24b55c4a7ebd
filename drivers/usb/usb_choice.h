/* usb_choice.h -- rules for which USB controllers are claimed and which slot they get. Pure.
 *
 * A controller is claimed if the operator chose it in the menu (stored in a file) or if --usb
 * names it. Our own poi is always claimed, unless a rule forbids it. It has no fixed vendor id
 * and is recognized by its report descriptor. If the descriptor cannot be read without claiming,
 * only chosen ids and the test id of pid.codes are claimed to read it. An interface with typing
 * keys is never claimed, even if it was chosen. */
#ifndef KINGYO_DRIVERS_USB_USB_CHOICE_H
#define KINGYO_DRIVERS_USB_USB_CHOICE_H

#include <stddef.h>
#include <stdint.h>

#include "core/input.h"
#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_port.h"

#define USB_BENCH_VENDOR 0x1209u /* pid.codes' test id, which no product may be sold with. */
#define USB_BENCH_PRODUCT 0x0001u
#define USB_KEY_TEXT_SIZE (10u + HID_TEXT_SIZE) /* Size of "057e:2009:" with a serial number. */
#define USB_REQUEST_MAX 32u /* Capacity of the rules: four pois, each replaced seven times. */
#define USB_ERROR_SIZE 96u

/* A controller, or all controllers of a product. */
struct usb_key {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* "": any serial number. */
};

/* Parses "VVVV:PPPP" or "VVVV:PPPP:SERIAL" with four hexadecimal digits each. Returns 0, or -1
 * if the text is invalid. */
int usb_key_read(struct usb_key *out, const char *text);

/* Writes the key in the format that usb_key_read() parses. */
void usb_key_write(const struct usb_key *key, char text[USB_KEY_TEXT_SIZE]);

/* Returns the key of a controller, including its serial number if it has one. */
struct usb_key usb_key_of(const struct hid_identity *identity);

struct usb_request {
    struct usb_key key;
    uint8_t plays; /* 0: the controller must not play, even if it would without this rule. */
    uint8_t kept;  /* 1 if the rule is stored in the file. */
};

/* The list of rules. The zero value accepts only our own poi. */
struct usb_choice {
    uint32_t wish_count;
    struct usb_request wish[USB_REQUEST_MAX];
};

/* Adds a rule and removes an older rule for the same key. When the list is full, the oldest rule
 * is dropped. */
void usb_choice_request(struct usb_choice *choice, const struct usb_key *key, int plays, int kept);

/* Copies the keys of all rules that allow playing. Returns their number. */
uint32_t usb_choice_wanted(const struct usb_choice *choice, struct usb_key out[USB_REQUEST_MAX]);

/* Parses one line of the choices file: "plays KEY", "rests KEY", or a comment that starts with
 * '#'. Returns 0, or -1 and one sentence in `error`. */
int usb_choice_read_line(struct usb_choice *choice, const char *line, char error[USB_ERROR_SIZE]);

/* Writes line `index` of the choices file without a newline. Returns 1, or 0 if there are no
 * more lines. */
#define USB_CHOICE_LINE_SIZE (USB_KEY_TEXT_SIZE + 8u)
int usb_choice_line(const struct usb_choice *choice, uint32_t index,
                    char line[USB_CHOICE_LINE_SIZE]);

/* Classes of input report descriptors. */
enum usb_kind {
    USB_KIND_UNKNOWN = 0, /* The descriptor was not read yet. */
    USB_KIND_NOTHING,     /* No input fields, or the descriptor cannot be parsed. */
    /* Typing keys in addition to any other fields, or only fields that cannot control a poi,
     * such as media keys or a power supply. */
    USB_KIND_KEYS,
    USB_KIND_LEARNABLE, /* Input fields without a mapping; the controller must be learned. */
    USB_KIND_HAND,      /* A mapping exists: hid_mapping_choose() finds one. */
    USB_KIND_OWN,       /* Exactly the descriptor of our own poi. */
};

/* An interface of a device. */
struct usb_candidate {
    const struct hid_identity *identity;
    uint8_t is_boot_keyboard; /* From the interface descriptor, HID 1.11 section 4.2. */
    uint8_t kind;             /* enum usb_kind */
    uint8_t worth;            /* Rating by hid_mapping_score(). */
};

/* Sets the kind and worth of `subject` from its report descriptor. Size 0 means that the
 * descriptor was not read yet. */
void usb_choice_read(struct usb_candidate *subject, const uint8_t *bytes, uint32_t size,
                     struct hid_descriptor *scratch);

enum usb_verdict {
    USB_BARRED = 0, /* Must never be claimed. */
    USB_FREE,       /* Claimed only after it is chosen. */
    USB_ASK,        /* May be claimed to read its report descriptor and then be classified again. */
    USB_PLAYS,
};

/* Returns whether an interface may be claimed, by its kind and by the most specific rule. */
enum usb_verdict usb_choice_evaluate(const struct usb_choice *choice,
                                     const struct usb_candidate *subject);

/* Returns 1 if interface `a` of a device is to be claimed rather than `b`. A playable interface
 * comes first, then one whose descriptor must be read, then one that must be learned. Ties are
 * decided by kind, by hid_mapping_score(), and then by the lower interface number. */
int usb_choice_is_better(const struct usb_choice *choice, const struct usb_candidate *a,
                         const struct usb_candidate *b);

/* The controller that has a slot, or that had it last. */
struct usb_place {
    uint8_t was_taken; /* 1 if `identity` is valid. */
    uint8_t is_taken;  /* 1 if the controller is attached now. */
    /* 1 shortly after unplugging, when another controller must not get the slot. */
    uint8_t is_held;
    struct hid_identity identity;
};

/* Returns the slot for a new controller, or POI_MAX if there is none. The controller's former
 * slot comes first, found by serial number or port. A slot that was never used is next, then one
 * that is not held. */
uint32_t usb_choice_slot(const struct usb_place place[POI_MAX],
                         const struct hid_identity *identity);

/* Returns how likely two identities are the same controller, 0 (different) .. 4 (certain). */
uint32_t usb_choice_similarity(const struct hid_identity *a, const struct hid_identity *b);

#endif
