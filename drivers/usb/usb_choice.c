/* usb_choice.c -- implements the rules that allow or forbid USB controllers to play, the decisions
 * about claiming, and the choice of slots. Reads and writes the file of rules, which has one line
 * for each rule. */
#include "drivers/usb/usb_choice.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/hid/hid_mapping.h"
#include "drivers/hid/poi_report.h"
#include "platform/os/file.h"

#define HEX_DIGITS "0123456789abcdefABCDEF"

/* ---- Keys (names of controllers) ------------------------------------------------------------ */

int usb_key_read(struct usb_key *out, const char *text)
{
    unsigned vendor, product;
    int end = 0;
    /* strspn() checks that each id has exactly four hexadecimal digits, because sscanf() also
     * accepts signs, blanks and shorter numbers. */
    if (strspn(text, HEX_DIGITS) != 4u || text[4] != ':' || strspn(text + 5, HEX_DIGITS) != 4u ||
        sscanf(text, "%4x:%4x%n", &vendor, &product, &end) != 2) {
        return -1;
    }
    const char *serial = text + end + 1;
    const bool has_serial = text[end] == ':' && serial[0] && strlen(serial) < HID_TEXT_SIZE;
    if (text[end] && !has_serial) {
        return -1;
    }
    *out = (struct usb_key){ .vendor = (uint16_t)vendor, .product = (uint16_t)product };
    snprintf(out->serial, sizeof out->serial, "%s", has_serial ? serial : "");
    return 0;
}

void usb_key_write(const struct usb_key *key, char text[USB_KEY_TEXT_SIZE])
{
    CORE_ASSERT(memchr(key->serial, 0, sizeof key->serial));
    snprintf(text, USB_KEY_TEXT_SIZE, "%04x:%04x%s%s", key->vendor, key->product,
             key->serial[0] ? ":" : "", key->serial);
}

struct usb_key usb_key_of(const struct hid_identity *identity)
{
    struct usb_key key = { .vendor = identity->vendor, .product = identity->product };
    snprintf(key.serial, sizeof key.serial, "%s", identity->serial);
    return key;
}

/* ---- Rules of the operator ------------------------------------------------------------------ */

static void rule_remove(struct usb_choice *choice, uint32_t index)
{
    CORE_ASSERT(choice->request_count > 0);
    CORE_ASSERT(index < choice->request_count);
    choice->request_count--;
    memmove(&choice->request[index], &choice->request[index + 1u],
            (choice->request_count - index) * sizeof choice->request[0]);
}

void usb_choice_request(struct usb_choice *choice, const struct usb_key *key, bool plays, bool kept)
{
    CORE_ASSERT(choice->request_count <= USB_REQUEST_MAX);
    for (uint32_t i = 0; i < choice->request_count; i++) {
        const struct usb_request *old = &choice->request[i];
        if (old->key.vendor == key->vendor && old->key.product == key->product &&
            !strcmp(old->key.serial, key->serial)) {
            kept |= old->kept && old->plays == plays;
            rule_remove(choice, i);
            break;
        }
    }
    if (choice->request_count == USB_REQUEST_MAX) {
        rule_remove(choice, 0u);
    }
    choice->request[choice->request_count++] =
        (struct usb_request){ .key = *key, .plays = plays, .kept = kept };
}

int usb_choice_read_line(struct usb_choice *choice, const char *line, char error[USB_ERROR_SIZE])
{
    struct usb_key key;
    char text[USB_CHOICE_LINE_SIZE + 2u];
    const size_t length = strcspn(line, "\r\n");
    const size_t blank = strspn(line, " \t");
    if (blank >= length || line[blank] == '#') {
        return 0;
    }
    if (length >= sizeof text) {
        snprintf(error, USB_ERROR_SIZE, "a line is too long");
        return -1;
    }
    snprintf(text, sizeof text, "%.*s", (int)length, line);
    const bool plays = strncmp(text, "plays ", 6u) == 0;
    if (!plays && strncmp(text, "rests ", 6u) != 0) {
        snprintf(error, USB_ERROR_SIZE, "a line must begin with 'plays' or 'rests'");
        return -1;
    }
    if (usb_key_read(&key, text + 6)) {
        snprintf(error, USB_ERROR_SIZE, "'%.40s' is not VVVV:PPPP or VVVV:PPPP:SERIAL", text + 6);
        return -1;
    }
    usb_choice_request(choice, &key, plays, true);
    return 0;
}

bool usb_choice_line(const struct usb_choice *choice, uint32_t index,
                     char line[USB_CHOICE_LINE_SIZE])
{
    CORE_ASSERT(choice->request_count <= USB_REQUEST_MAX);
    char text[USB_KEY_TEXT_SIZE];
    for (uint32_t i = 0; i < choice->request_count; i++) {
        const struct usb_request *request = &choice->request[i];
        if (request->kept && index-- == 0u) {
            usb_key_write(&request->key, text);
            snprintf(line, USB_CHOICE_LINE_SIZE, "%s %s", request->plays ? "plays" : "rests", text);
            return true;
        }
    }
    return false;
}

uint32_t usb_choice_wanted(const struct usb_choice *choice, struct usb_key out[USB_REQUEST_MAX])
{
    CORE_ASSERT(choice->request_count <= USB_REQUEST_MAX);
    uint32_t count = 0;
    for (uint32_t i = 0; i < choice->request_count; i++) {
        if (choice->request[i].plays) {
            out[count++] = choice->request[i].key;
        }
    }
    return count;
}

/* Returns the most specific rule for a controller, or null if there is no rule. */
static const struct usb_request *rule_find(const struct usb_choice *choice,
                                           const struct hid_identity *identity)
{
    CORE_ASSERT(choice->request_count <= USB_REQUEST_MAX);
    const struct usb_request *found = NULL;
    for (uint32_t i = 0; i < choice->request_count; i++) {
        const struct usb_request *request = &choice->request[i];
        if (request->key.vendor != identity->vendor || request->key.product != identity->product) {
            continue;
        }
        if (!request->key.serial[0]) {
            found = found ? found : request;
        } else if (!strcmp(request->key.serial, identity->serial)) {
            return request;
        }
    }
    return found;
}

/* ---- Decisions about claiming --------------------------------------------------------------- */

/* Returns true for application usages that cannot control a poi. By the HID Usage Tables these are
 * keyboards, keypads, system controls, media keys, telephones, monitors, power supplies, bar code
 * scanners, scales, card readers, and FIDO security keys. */
static bool is_keys(hid_usage application)
{
    const uint32_t page = application >> 16, id = application & 0xffffu;
    return (page == 0x01u && (id == 0x06u || id == 0x07u || id == 0x80u)) || page == 0x0bu ||
           page == 0x0cu || (page >= 0x80u && page <= 0x8eu) || page == 0xf1d0u;
}

void usb_choice_read(struct usb_candidate *subject, const uint8_t *bytes, uint32_t size,
                     struct hid_descriptor *scratch)
{
    CORE_ASSERT(bytes || size == 0);
    subject->kind = USB_KIND_UNKNOWN;
    subject->worth = 0;
    if (size == 0u) {
        return;
    }
    if (hid_descriptor_read(scratch, bytes, size) != HID_OK) {
        subject->kind = USB_KIND_NOTHING;
        return;
    }
    /* `keys` is the number of groups whose application cannot control a poi. `others` is the number
     * of all other groups. */
    uint32_t keys = 0, others = 0;
    for (uint32_t i = 0; i < scratch->group_count; i++) {
        const struct hid_group *group = &scratch->group[i];
        if (group->range_count > 0 && !(group->flags & HID_CONSTANT)) {
            *(is_keys(group->application) ? &keys : &others) += 1u;
        }
    }
    subject->worth = (uint8_t)hid_mapping_score(subject->identity, scratch);
    subject->kind = (uint8_t)(poi_descriptor_is(bytes, size)      ? USB_KIND_OWN
                              : hid_mapping_has_keyboard(scratch) ? USB_KIND_KEYS
                              : subject->worth > 0                ? USB_KIND_MAPPED
                              : others > 0                        ? USB_KIND_LEARNABLE
                              : keys > 0                          ? USB_KIND_KEYS
                                                                  : USB_KIND_NOTHING);
}

enum usb_verdict usb_choice_evaluate(const struct usb_choice *choice,
                                     const struct usb_candidate *subject)
{
    CORE_ASSERT(subject->kind <= USB_KIND_OWN);
    if (subject->is_boot_keyboard || subject->kind == USB_KIND_NOTHING ||
        subject->kind == USB_KIND_KEYS) {
        return USB_BARRED;
    }
    const struct usb_request *request = rule_find(choice, subject->identity);
    if (request && !request->plays) {
        return USB_FREE;
    }
    if (subject->kind == USB_KIND_UNKNOWN) {
        const bool is_bench = subject->identity->vendor == USB_BENCH_VENDOR &&
                              subject->identity->product == USB_BENCH_PRODUCT;
        return request || is_bench ? USB_ASK : USB_FREE;
    }
    return request || subject->kind == USB_KIND_OWN ? USB_PLAYS : USB_FREE;
}

static uint32_t rank_of(const struct usb_choice *choice, const struct usb_candidate *subject)
{
    static const uint8_t ranks[] = {
        [USB_BARRED] = 0, [USB_FREE] = 1, [USB_ASK] = 3, [USB_PLAYS] = 4
    };
    const enum usb_verdict verdict = usb_choice_evaluate(choice, subject);
    return verdict == USB_PLAYS && subject->kind == USB_KIND_LEARNABLE ? 2u : ranks[verdict];
}

bool usb_choice_is_better(const struct usb_choice *choice, const struct usb_candidate *a,
                          const struct usb_candidate *b)
{
    CORE_ASSERT(a->identity && b->identity);
    const uint32_t rank = rank_of(choice, a), other = rank_of(choice, b);
    return rank != other          ? rank > other
           : a->kind != b->kind   ? a->kind > b->kind
           : a->worth != b->worth ? a->worth > b->worth
                                  : a->identity->interface_number < b->identity->interface_number;
}

/* ---- Choice of a slot ----------------------------------------------------------------------- */

uint32_t usb_choice_similarity(const struct hid_identity *a, const struct hid_identity *b)
{
    CORE_ASSERT(memchr(a->serial, 0, sizeof a->serial));
    CORE_ASSERT(memchr(b->serial, 0, sizeof b->serial));
    if (a->vendor != b->vendor || a->product != b->product) {
        return 0u;
    }
    const bool same_port = !strcmp(a->port, b->port);
    const bool same_serial = !strcmp(a->serial, b->serial);
    if (a->serial[0] && same_serial) {
        /* The port is compared too, because several cheap devices can have the same serial
         * number. */
        return same_port ? 4u : 3u;
    }
    if (same_port) {
        /* The identities belong to different devices of the same product that were plugged into the
         * same port one after the other. */
        return 2u;
    }
    return same_serial ? 1u : 0u; /* The devices have the same product and no serial number, but
                                     different ports. */
}

/* Returns the vacant slot whose last controller is most similar to `identity`, or POI_MAX if there
 * is none. Also returns POI_MAX if several slots are equally similar and only the product
 * matches. */
static uint32_t own_slot(const struct usb_place place[POI_MAX], const struct hid_identity *identity)
{
    uint32_t best = POI_MAX, most = 0u, equals = 0u;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint32_t likeness = place[i].was_taken && !place[i].is_taken
                                      ? usb_choice_similarity(&place[i].identity, identity)
                                      : 0u;
        if (likeness > most) {
            best = i;
            most = likeness;
            equals = 0u;
        } else if (likeness > 0u && likeness == most) {
            equals++;
        }
    }
    return most == 1u && equals > 0u ? POI_MAX : best;
}

uint32_t usb_choice_slot(const struct usb_place place[POI_MAX], const struct hid_identity *identity)
{
    const uint32_t own = own_slot(place, identity);
    if (own < POI_MAX) {
        return own;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (!place[i].was_taken) {
            return i;
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (!place[i].is_taken && !place[i].is_held) {
            return i;
        }
    }
    return POI_MAX;
}

/* ---- File of rules --------------------------------------------------------------------------- */

int usb_choice_load(struct usb_choice *choice, const char *path, char why[HAL_TEXT_SIZE])
{
    const int handle = path[0] ? file_handle(path, O_RDONLY, 0) : -1;
    FILE *file = handle >= 0 ? fdopen(handle, "r") : NULL;
    const int error = !path[0] || file || errno == ENOENT ? 0 : -errno;
    char line[2u * USB_CHOICE_LINE_SIZE], invalid[USB_ERROR_SIZE];
    int result = error;
    enum file_line end = FILE_LINE_END;
    for (uint32_t number = 1;
         file && (end = file_read_line(file, line, sizeof line)) != FILE_LINE_END; number++) {
        snprintf(invalid, sizeof invalid, "the line is too long or has a zero byte");
        if (end == FILE_LINE_BAD || usb_choice_read_line(choice, line, invalid)) {
            snprintf(why, HAL_TEXT_SIZE, "%.60s:%u: %s", path, number, invalid);
            result++;
        }
    }
    result = file && ferror(file) ? -errno : result;
    /* These errors mean that `path` is not a regular file. For example, open() of a socket fails
     * with ENXIO. */
    if (result == -ENOTSUP || result == -EISDIR || result == -ELOOP || result == -ENXIO) {
        snprintf(why, HAL_TEXT_SIZE, "%.60s: is not a regular file", path);
    } else if (result < 0) {
        snprintf(why, HAL_TEXT_SIZE, "%.60s: cannot read: %.40s", path, strerror(-result));
    }
    if (file) {
        fclose(file);
    }
    return result;
}

int usb_choice_save(const struct usb_choice *choice, const char *path)
{
    static const char head[] =
        "# Controllers on USB that play, or rest, as the operator chose in the menu.\n";
    char text[sizeof head + USB_REQUEST_MAX * USB_CHOICE_LINE_SIZE], line[USB_CHOICE_LINE_SIZE];
    size_t length = sizeof head - 1u;
    if (!path[0]) {
        return 0;
    }
    memcpy(text, head, length);
    for (uint32_t i = 0; usb_choice_line(choice, i, line); i++) {
        length += (size_t)snprintf(text + length, sizeof text - length, "%s\n", line);
        CORE_ASSERT(length < sizeof text);
    }
    return file_replace(path, text, length, FILE_REPLACE_DURABLE);
}
