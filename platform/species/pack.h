/* pack.h -- a species as one file, NAME.kfish, that a kiosk can load beside its built-in ones.
 *
 * Little endian, packed, no pointers:
 *   8 bytes  "KFISH\r\n\032"  (a file that a mail program has been at is no longer one)
 *   u32      version          PACK_VERSION
 *   u32      size             of what follows the CRC, in bytes
 *   u32      CRC-32           of what follows (IEEE 802.3, as zip and PNG use it)
 * then the card, the coats of card.key_count keys, and the near and the far mesh, each field by
 * field in the order of core/morph/species.h: counts first, then tables of so many. pack.c walks
 * the fields in one place for reading and writing. */
#ifndef KINGYO_PLATFORM_SPECIES_PACK_H
#define KINGYO_PLATFORM_SPECIES_PACK_H

#include <stddef.h>

#include "platform/species/drawing.h"
#include "platform/species/vet.h"

#define PACK_VERSION 1u
#define PACK_SIZE_MAX (256u * 1024u) /* Two meshes with every table full are 222 KiB. */
#define PACK_SUFFIX ".kfish"

/* Room for any species, tables inside; about 260 KiB. `species` points into `tables`: a slot is not
 * to be copied by assignment, but with pack_copy(). */
struct species_slot {
    struct species species;
    struct mesh_tables tables[SPECIES_LOD_COUNT];
};

enum pack_result {
    PACK_OK = 0,
    PACK_BAD = -1, /* The bytes are no sound species: bad data. */
    PACK_IO = -2,  /* The file cannot be read, written, or is none. */
};

/* Reads a species from `size` bytes and vets it. On PACK_BAD `slot` is half filled and of no use,
 * and `why` says "field: reason". Takes any bytes; time and memory are bounded by PACK_SIZE_MAX. */
enum pack_result pack_decode(const uint8_t *bytes, size_t size, struct species_slot *slot,
                             char why[VET_WHY_SIZE]);

/* Writes what is in the slot (left as it was) and answers how many bytes that took. */
size_t pack_encode(struct species_slot *slot, uint8_t bytes[PACK_SIZE_MAX]);

/* The same from and to a file; `why` is without the file's name. Writing is to a file beside it
 * that then takes its place, so that a kiosk never meets half a species. */
enum pack_result pack_read(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE]);
/* As pack_read(), for a file in the data folder: a symbolic link is refused. */
enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VET_WHY_SIZE]);
enum pack_result pack_write(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE]);

/* Lofts what a maker wrote. The text has been read without complaint; numbers that each are in
 * their range may still make no fish, so whoever shows it asks species_vet(). */
void pack_text(const struct species_text *text, struct species_slot *slot);

/* Makes `slot` a copy of `species` with tables of its own. The species keeps its maxima. */
void pack_copy(const struct species *species, struct species_slot *slot);

#endif
