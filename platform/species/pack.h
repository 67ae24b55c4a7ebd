/* pack.h -- reads and writes a species as one file, NAME.kfish. A kiosk can load these files in
 * addition to its built-in species.
 *
 * The file is little endian and packed, and contains no pointers:
 *   8 bytes  "KFISH\r\n\032"  (a program that converts line ends destroys this signature)
 *   u32      version          PACK_VERSION
 *   u32      size             number of bytes after the CRC-32
 *   u32      CRC-32           checksum of the bytes after this field (IEEE 802.3, as in PNG)
 *   then the card, the coats of card.key_count keys, the near mesh and the far mesh
 *
 * The fields have the order of core/morph/species.h. The counts of a structure come first, then its
 * tables. */
#pragma once

#include <stddef.h>

#include "platform/species/drawing.h"
#include "platform/species/validate.h"

#define PACK_VERSION 1u
/* Maximum file size in bytes. A species whose two meshes have the maximum size needs 222 KiB. */
#define PACK_SIZE_MAX (256u * 1024u)
#define PACK_SUFFIX ".kfish"

/* Storage for any species with its tables, about 260 KiB. `species` points to `tables`. Therefore a
 * slot must be copied with pack_copy() and not by assignment. */
struct species_slot {
    struct species species;
    struct mesh_tables tables[SPECIES_LOD_COUNT];
};

enum pack_result {
    PACK_OK = 0,
    PACK_BAD = -1, /* The bytes of the file are not a valid species. */
    PACK_IO = -2,  /* The file cannot be read, cannot be written, or does not exist. */
};

/* Reads a species from `size` bytes and validates it. Returns PACK_OK on success. If the bytes are
 * not a valid species, returns PACK_BAD and writes "field: reason" to `why`. The content of `slot`
 * is then incomplete and must not be used. The bytes may come from an untrusted source.
 * PACK_SIZE_MAX limits the time and the memory that decoding needs. */
enum pack_result pack_decode(const uint8_t *bytes, size_t size, struct species_slot *slot,
                             char why[VALIDATE_WHY_SIZE]);

/* Serializes the species of `slot` to `bytes`. The content of `slot` does not change. Returns the
 * number of bytes written. */
size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX]);

/* Reads a species file and decodes the file with pack_decode(). Returns the result of
 * pack_decode(), or PACK_IO if the file cannot be read. `why` does not contain the file's name. */
enum pack_result pack_read(const char *path, struct species_slot *slot,
                           char why[VALIDATE_WHY_SIZE]);
/* Same as pack_read(), but rejects a symbolic link. Used for files in the data folder. */
enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VALIDATE_WHY_SIZE]);
/* Writes a species file. If the file cannot be written, returns PACK_IO and writes the reason to
 * `why`. The content is written to a temporary file, which is then renamed, so that a kiosk never
 * reads an incomplete species. */
enum pack_result pack_write(const char *path, struct species_slot *slot,
                            char why[VALIDATE_WHY_SIZE]);

/* Builds the meshes of a species text that species_read() accepted. The resulting species may still
 * be invalid, although each number of the text is within its range. A caller that shows the species
 * must therefore call species_validate(). */
void pack_text(const struct species_text *text, struct species_slot *slot);

/* Sets the pointers of `slot->species` to the tables of `slot`. */
void pack_point(struct species_slot *slot);

/* Copies `species` to `slot` and its tables to `slot->tables`. The counts of `species` must not
 * exceed the sizes of these tables. */
void pack_copy(const struct species *species, struct species_slot *slot);
