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
#define PACK_SIZE_MAX (256u * 1024u) /* Two meshes with every table full are 222 KiB. */
#define PACK_SUFFIX ".kfish"

/* Storage for any species with its tables, about 260 KiB. `species` points into `tables`, so a slot
 * must be copied with pack_copy(), not by assignment. */
struct species_slot {
    struct species species;
    struct mesh_tables tables[SPECIES_LOD_COUNT];
};

enum pack_result {
    PACK_OK = 0,
    PACK_BAD = -1, /* The bytes are not a valid species. */
    PACK_IO = -2,  /* The file cannot be read or written, or does not exist. */
};

/* Reads a species from `size` bytes and validates it. On PACK_BAD `slot` is incomplete and must not
 * be used, and `why` is "field: reason". Accepts any bytes; time and memory are bounded by
 * PACK_SIZE_MAX. */
enum pack_result pack_decode(const uint8_t *bytes, size_t size, struct species_slot *slot,
                             char why[VALIDATE_WHY_SIZE]);

/* Serializes the species of the slot, which is unchanged. Returns the number of bytes written. */
size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX]);

/* Read and write a file in the same way; `why` does not contain the file's name. pack_write()
 * writes a temporary file and renames it, so that a kiosk never reads an incomplete species. */
enum pack_result pack_read(const char *path, struct species_slot *slot,
                           char why[VALIDATE_WHY_SIZE]);
/* Same as pack_read(), for a file in the data folder: rejects a symbolic link. */
enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VALIDATE_WHY_SIZE]);
enum pack_result pack_write(const char *path, struct species_slot *slot,
                            char why[VALIDATE_WHY_SIZE]);

/* Lofts a species text that was read without error. Numbers that are each in range may still not
 * form a valid fish, so a caller that shows the species must call species_validate(). */
void pack_text(const struct species_text *text, struct species_slot *slot);

/* Copies `species` to `slot` with tables of its own. `species` must be within the tables' maximum
 * sizes. */
void pack_copy(const struct species *species, struct species_slot *slot);

#endif
