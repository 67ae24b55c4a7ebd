/* usb_choice.h -- rules for which USB controllers the kiosk claims and which slot they get.
 *
 * A slot is the place of one of up to POI_MAX controllers. A controller plays while it has a slot
 * and moves a poi. A controller is claimed if the operator selected it in the menu (stored in a
 * file) or if the option --usb names it. Kingyo's poi controller (poi_report.h) is always claimed
 * unless a rule forbids it. Kingyo's poi controller has no fixed vendor id and is recognized by its
 * report descriptor.
 *
 * Some report descriptors can only be read after claiming. A device is claimed for this purpose
 * only if its id is selected or is the test id of pid.codes. An interface with the keys of a
 * keyboard is never claimed, even if it was selected. All functions are pure, except
 * usb_choice_load() and usb_choice_save(), which use the file of rules. The file is replaced
 * atomically. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/hid_port.h"
#include "platform/hal.h"

/* Vendor id of the test id of pid.codes (a registry of free USB ids). No product may be sold with
 * this id. */
#define USB_BENCH_VENDOR 0x1209u
#define USB_BENCH_PRODUCT 0x0001u
/* Size of the text of a key (struct usb_key), such as "057e:2009:SERIAL", with the terminating
 * zero. */
#define USB_KEY_TEXT_SIZE (10u + HID_TEXT_SIZE)
/* Maximum number of rules in struct usb_choice. A rule (struct usb_request) allows or forbids a
 * controller to play. 32 rules are enough for four pois, each replaced seven times. */
#define USB_REQUEST_MAX 32u
#define USB_ERROR_SIZE 96u

/* Key that names one controller, or all controllers of a product. */
struct usb_key {
    uint16_t vendor, product;
    char serial[HID_TEXT_SIZE]; /* Serial number of the controller. "" means any serial number. */
};

/* Parses "VVVV:PPPP" or "VVVV:PPPP:SERIAL". VVVV and PPPP are four hexadecimal digits each. Returns
 * 0, or -1 if the text is invalid. */
int usb_key_read(struct usb_key *out, const char *text);

/* Writes the key in the format that usb_key_read() parses. */
void usb_key_write(const struct usb_key *key, char text[USB_KEY_TEXT_SIZE]);

/* Returns the key (vendor, product and serial number) of the controller `identity`. The serial
 * number is "" if the controller has none. */
struct usb_key usb_key_of(const struct hid_identity *identity);

/* A rule that allows or forbids one controller, or all controllers of a product, to play. */
struct usb_request {
    struct usb_key key;
    /* True if the controller may play. False if the controller must not play, even if it would play
     * without the rule. */
    bool plays;
    bool kept; /* True if the rule is stored in the file. */
};

/* List of rules (struct usb_request), which allow or forbid controllers to play. The all-zero list
 * accepts only Kingyo's poi controller. */
struct usb_choice {
    uint32_t request_count;
    struct usb_request request[USB_REQUEST_MAX];
};

/* Adds a rule and removes an older rule for the same key. If the list is full, the oldest rule is
 * dropped. */
void usb_choice_request(struct usb_choice *choice, const struct usb_key *key, bool plays,
                        bool kept);

/* Copies to `out` the keys of all rules that allow playing. Returns the number of keys. */
uint32_t usb_choice_wanted(const struct usb_choice *choice, struct usb_key out[USB_REQUEST_MAX]);

/* Parses one line of the file of rules. "plays KEY" allows the controller with this key to play.
 * "rests KEY" forbids this controller to play. A line that starts with '#' is a comment. Returns 0,
 * or -1 with one sentence in `error`. */
int usb_choice_read_line(struct usb_choice *choice, const char *line, char error[USB_ERROR_SIZE]);

/* Size of the buffer for usb_choice_line(). */
#define USB_CHOICE_LINE_SIZE (USB_KEY_TEXT_SIZE + 8u)
/* Writes line `index` (from 0) of the file of rules without a newline. Returns true, or false if
 * there is no such line. */
bool usb_choice_line(const struct usb_choice *choice, uint32_t index,
                     char line[USB_CHOICE_LINE_SIZE]);

/* Kind of an interface by its input report descriptor, ordered from unsuitable to best. */
enum usb_kind {
    USB_KIND_UNKNOWN = 0, /* The descriptor was not read yet. */
    USB_KIND_NOTHING,     /* The descriptor has no input fields or cannot be parsed. */
    /* The descriptor has keys of a keyboard, or has only fields that cannot control a poi, such as
     * media keys or a power supply. */
    USB_KIND_KEYS,
    /* The descriptor has usable fields but no mapping, so the operator must let the kiosk learn the
     * controller. */
    USB_KIND_LEARNABLE,
    USB_KIND_MAPPED, /* hid_mapping_choose() finds a mapping for the descriptor. */
    USB_KIND_OWN,    /* The descriptor is exactly that of Kingyo's poi controller. */
};

/* Candidate for claiming: a HID interface of a device. */
struct usb_candidate {
    const struct hid_identity *identity;
    /* True if the interface descriptor declares a boot keyboard (HID 1.11, section 4.2). */
    bool is_boot_keyboard;
    uint8_t kind;  /* Kind of the interface (enum usb_kind). */
    uint8_t worth; /* Score of the mapping, from hid_mapping_score(). */
};

/* Sets the kind and the score of `subject` from the `size` bytes of its report descriptor. A size
 * of 0 means that the descriptor was not read yet. `scratch` is overwritten. */
void usb_choice_read(struct usb_candidate *subject, const uint8_t *bytes, uint32_t size,
                     struct hid_descriptor *scratch);

enum usb_verdict {
    USB_BARRED = 0, /* The interface must never be claimed. */
    /* The interface may be claimed only after the operator selects the controller. */
    USB_FREE,
    /* The interface may be claimed only to read its report descriptor. Afterwards
     * usb_choice_evaluate() must be called again. */
    USB_ASK,
    USB_PLAYS,
};

/* Returns whether the kiosk may claim an interface. The kind of the interface and the most specific
 * rule determine the result. */
enum usb_verdict usb_choice_evaluate(const struct usb_choice *choice,
                                     const struct usb_candidate *subject);

/* Returns true if interface `a` of a device should be claimed rather than interface `b`. An
 * interface that can play is preferred, then an interface whose descriptor must be read, then an
 * interface that must be learned. Ties are resolved by the kind, by hid_mapping_score(), and then
 * by the lower interface number. */
bool usb_choice_is_better(const struct usb_choice *choice, const struct usb_candidate *a,
                          const struct usb_candidate *b);

/* State of a slot, and identity of the controller that has the slot now or had the slot last. */
struct usb_place {
    bool was_taken; /* True if `identity` is valid. */
    bool is_taken;  /* True if the controller is attached now. */
    /* True for a limited time after the controller was unplugged. A different controller must not
     * get the slot during that time. */
    bool is_held;
    struct hid_identity identity;
};

/* Returns the slot for a new controller, or POI_MAX if there is none. The first choice is the
 * former slot of the controller, found by serial number or port. The second choice is a slot that
 * was never used. The third choice is a vacant slot that is not held for a different controller. */
uint32_t usb_choice_slot(const struct usb_place place[POI_MAX],
                         const struct hid_identity *identity);

/* Returns how likely two identities belong to the same controller: 0 means different, 4 means
 * certain. */
uint32_t usb_choice_similarity(const struct hid_identity *a, const struct hid_identity *b);

/* ---- File of rules --------------------------------------------------------------------------- */

/* Adds the rules of the file to `choice`. A missing file adds no rules. Returns the number of
 * invalid lines, or a negative errno value if the file cannot be read completely. If the result is
 * not 0, `why` has one sentence. For an invalid line, the sentence starts with FILE:LINE of the
 * last invalid line. After a negative result the file must not be overwritten. */
int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE]);

/* Writes the rules that are marked as kept, and waits for the disk. Returns 0 or a negative errno
 * value. After an error the old file is unchanged, unless only flushing the folder failed. If
 * `path` is "" nothing is stored and the result is 0. */
int usb_choice_save(const struct usb_choice *choice, const char *path);
