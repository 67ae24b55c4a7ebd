/* pack.h -- a species as one file, NAME.kfish, which a kiosk can load beside its built-in species.
 *
 * Little endian, packed, no pointers:
 *   8 bytes  "KFISH\r\n\032"  (a line end conversion, as by a mail program, invalidates the file)
 *   u32      version          PACK_VERSION
 *   u32      size             bytes after the CRC
 *   u32      CRC-32           checksum of those bytes (IEEE 802.3, as in zip and PNG)
 *   then the card, the coats of card.key_count keys, and the near and the far mesh
 *
 * The fields have the order of core/morph/species.h: counts first, then the tables. pack.c visits
 * the fields in one place for reading and writing. */
#ifndef KINGYO_PLATFORM_SPECIES_PACK_H
#define KINGYO_PLATFORM_SPECIES_PACK_H

#include <stddef.h>

#include "platform/species/drawing.h"
#include "platform/species/validate.h"

#define PACK_VERSION 1u
/* Maximum file size. Two meshes with every table full have 222 KiB. */
#define PACK_SIZE_MAX (256u * 1024u)
#define PACK_SUFFIX ".kfish"

/* Storage for any species with its tables, about 260 KiB. `species` points to `tables`, so that a
 * slot must be copied with pack_copy() and not by assignment. */
struct species_slot {
    struct species species;
    struct mesh_tables tables[SPECIES_LOD_COUNT];
};

enum pack_result {
    PACK_OK = 0,
    PACK_BAD = -1, /* The bytes are not a valid species. */
    PACK_IO = -2,  /* The file cannot be read or written, or does not exist. */
};

/* Reads a species from `size` bytes and validates it. Returns PACK_OK, or PACK_BAD if the bytes are
 * not a valid species. `slot` is then incomplete and must not be used, and `why` is "field:
 * reason". The bytes may come from an untrusted source. Time and memory are limited by
 * PACK_SIZE_MAX. */
enum pack_result pack_decode(const uint8_t *bytes, size_t size, struct species_slot *slot,
                             char why[VALIDATE_WHY_SIZE]);

/* Serializes the species of the slot, which stays unchanged. Returns the number of bytes
 * written. */
size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX]);

/* Reads a species file as pack_decode() reads its bytes. Returns PACK_IO if the file cannot be
 * read. `why` does not contain the file's name. */
enum pack_result pack_read(const char *path, struct species_slot *slot,
                           char why[VALIDATE_WHY_SIZE]);
/* Same as pack_read(), for a file in the data folder. Rejects a symbolic link. */
enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VALIDATE_WHY_SIZE]);
/* Writes a species file. Returns PACK_IO and the reason in `why` if the file cannot be written.
 * Writes a temporary file and renames it, so that a kiosk never reads an incomplete species. */
enum pack_result pack_write(const char *path, struct species_slot *slot,
                            char why[VALIDATE_WHY_SIZE]);

/* Lofts a species text that species_read() accepted. Numbers that are each in their range may still
 * not form a valid fish. A caller that shows the species must therefore call species_validate(). */
void pack_text(const struct species_text *text, struct species_slot *slot);

/* Copies `species` to `slot` and the tables to `slot->tables`. The sizes of `species` must not
 * exceed the tables' maximum sizes. */
void pack_copy(const struct species *species, struct species_slot *slot);

#endif
