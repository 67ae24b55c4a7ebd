/* test_pack.c -- Tests packed species files. A written file must be read back unchanged. An invalid
 * file must be rejected. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/morph/morph.h"
/* The source file is included, so that a test can call its static function crc32(). */
#include "platform/species/pack.c"

static struct species_slot slot, other;
static uint8_t bytes[PACK_SIZE_MAX], again[PACK_SIZE_MAX];
static char why[VALIDATE_WHY_SIZE];

static size_t packed_wakin(void)
{
    pack_copy(&species_wakin, &slot);
    return pack_encode(&slot, bytes);
}

static void test_every_built_in_species_is_unchanged_by_packing(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        pack_copy(species_table[i], &slot);
        const size_t size = pack_encode(&slot, bytes);
        why[0] = '\0';
        memset(&other, 0, sizeof other);
        assert_int_equal(pack_decode(bytes, size, &other, why), PACK_OK);
        assert_string_equal(why, "");
        assert_memory_equal(&other.species.card, &species_table[i]->card,
                            sizeof other.species.card);
        assert_memory_equal(other.species.coats, species_table[i]->coats,
                            sizeof other.species.coats);
        assert_int_equal(pack_encode(&other, again), size);
        assert_memory_equal(bytes, again, size);
    }
}

static void test_an_unpacked_species_blends_to_the_same_shape(void **state)
{
    (void)state;
    static struct morph_rig rig;
    static struct morph_pose pose;
    static vec3 ours[MESH_VERTEX_MAX], theirs[MESH_VERTEX_MAX];
    assert_int_equal(pack_decode(bytes, packed_wakin(), &other, why), PACK_OK);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &species_wakin.lod[lod];
        morph_rig_init(&rig, &species_wakin.card, TEMPLATE_OWN);
        morph_pose(&rig, mesh, 0.3f, &pose);
        morph_shape(mesh, rig.key_count, &pose, ours, NULL);
        morph_rig_init(&rig, &other.species.card, TEMPLATE_OWN);
        morph_pose(&rig, &other.species.lod[lod], 0.3f, &pose);
        morph_shape(&other.species.lod[lod], rig.key_count, &pose, theirs, NULL);
        assert_memory_equal(ours, theirs, mesh->vertex_count * sizeof(vec3));
    }
}

static void test_the_packed_bytes_are_identical_on_every_machine(void **state)
{
    (void)state;
    static const uint8_t head[] = { 'K', 'F', 'I', 'S', 'H', '\r', '\n', 0x1a, 1, 0, 0, 0 };
    const size_t size = packed_wakin();
    assert_memory_equal(bytes, head, sizeof head);
    assert_int_equal(bytes[12] | bytes[13] << 8 | bytes[14] << 16, size - HEAD_SIZE);
    assert_string_equal((const char *)bytes + HEAD_SIZE, "wakin");
}

static void test_a_file_truncated_at_any_byte_is_rejected(void **state)
{
    (void)state;
    const size_t size = packed_wakin();
    for (size_t cut = 0; cut < size; cut += cut < 64 ? 1 : 61) {
        assert_int_equal(pack_decode(bytes, cut, &other, why), PACK_BAD);
    }
    bytes[size] = 0;
    assert_int_equal(pack_decode(bytes, size + 1, &other, why), PACK_BAD);
}

static void test_a_flipped_bit_at_any_position_is_rejected(void **state)
{
    (void)state;
    const size_t size = packed_wakin();
    for (size_t i = 0; i < size; i += i < 64 ? 1 : 97) {
        bytes[i] ^= (uint8_t)(1u << i % 8);
        assert_int_equal(pack_decode(bytes, size, &other, why), PACK_BAD);
        bytes[i] ^= (uint8_t)(1u << i % 8);
    }
    assert_int_equal(pack_decode(bytes, size, &other, why), PACK_OK);
}

static void test_a_different_version_is_reported(void **state)
{
    (void)state;
    const size_t size = packed_wakin();
    bytes[8] = 2;
    assert_int_equal(pack_decode(bytes, size, &other, why), PACK_BAD);
    assert_string_equal(why, "version: 2, but this program reads version 1");
}

/* A change that makes a valid species invalid, and a part of the error message that is expected. */
struct harm {
    void (*change)(struct species_slot *slot);
    const char *why;
};

static struct species_card *card_of(struct species_slot *s)
{
    return &s->species.card;
}

static void harm_id(struct species_slot *s)
{
    card_of(s)->id[0] = '/';
}
/* A control character in a name is an error, because names are printed in tables and pictures. */
static void harm_id_escape(struct species_slot *s)
{
    card_of(s)->id[1] = '\x1b';
}
static void harm_key_control(struct species_slot *s)
{
    memcpy(card_of(s)->key_names[1], "a\xc2\x9b", sizeof "a\xc2\x9b");
}
static void harm_curve_control(struct species_slot *s)
{
    memcpy(card_of(s)->curve_names[0], "a\xc2\x9b", sizeof "a\xc2\x9b");
}
static void harm_two_keys(struct species_slot *s)
{
    card_of(s)->key_count = 2;
}
static void harm_twin_key(struct species_slot *s)
{
    memcpy(card_of(s)->key_names[1], card_of(s)->key_names[0], SPECIES_NAME_SIZE);
}
static void harm_age(struct species_slot *s)
{
    card_of(s)->key_age_days[1] = NAN;
}
static void harm_age_order(struct species_slot *s)
{
    card_of(s)->key_age_days[1] = card_of(s)->key_age_days[0];
}
static void harm_length(struct species_slot *s)
{
    card_of(s)->key_length_m[0] = 1e30f;
}
static void harm_measure(struct species_slot *s)
{
    card_of(s)->measure = 4;
}
static void harm_motion(struct species_slot *s)
{
    card_of(s)->motion = 255;
}
static void harm_thesis(struct species_slot *s)
{
    card_of(s)->thesis_key[2] = 7;
}
static void harm_template(struct species_slot *s)
{
    card_of(s)->thesis_template = 0;
}
static void harm_growth(struct species_slot *s)
{
    card_of(s)->growth.k_per_year = INFINITY;
}
static void harm_fade(struct species_slot *s)
{
    card_of(s)->growth.fade_year = 0.0f;
}
static void harm_points(struct species_slot *s)
{
    card_of(s)->growth.point_count = 0;
}
static void harm_hatching(struct species_slot *s)
{
    card_of(s)->growth.points[0].age_days = 3.0f;
}
static void harm_scale(struct species_slot *s)
{
    card_of(s)->scale_knot_count = 1;
}
static void harm_curves(struct species_slot *s)
{
    card_of(s)->curve_count = 0;
}
static void harm_knots(struct species_slot *s)
{
    card_of(s)->curves[0].knot_count = 1;
}
static void harm_sum(struct species_slot *s)
{
    card_of(s)->curves[0].knots[0].weight[0] += 0.25f;
}
static void harm_negative(struct species_slot *s)
{
    card_of(s)->curves[0].knots[0].weight[1] = -1.0f;
}
static void harm_solved(struct species_slot *s)
{
    /* Marks an ordinary morph graph as computed (solved). The marked graph is invalid, because it
     * gives weights only to the first and the last key shape. */
    struct graph *graph = &card_of(s)->curves[0];
    graph_from_template(graph, TEMPLATE_ORDINARY, card_of(s)->key_count, SIMULTANEOUS_PEAK);
    graph->solved = 1;
}
static void harm_colour(struct species_slot *s)
{
    s->species.coats[0].fin = 0x1000000;
}
static void harm_mark(struct species_slot *s)
{
    s->species.coats[2].mark_count = 1;
    s->species.coats[2].marks[0] = (struct species_mark){ .kind = 200, .part = PART_BODY };
}
static void harm_reach(struct species_slot *s)
{
    s->species.lod[0].reach = 3.0f;
}
static void harm_faces(struct species_slot *s)
{
    s->species.lod[1].index_count -= 1;
}
static void harm_no_faces(struct species_slot *s)
{
    s->species.lod[0].index_count = 0;
}
static void harm_index(struct species_slot *s)
{
    s->tables[0].indices[5] = (uint16_t)s->species.lod[0].vertex_count;
}
static void harm_flat(struct species_slot *s)
{
    s->tables[0].indices[4] = s->tables[0].indices[3];
}
static void harm_mask(struct species_slot *s)
{
    s->tables[1].vertices[3].mask[0] = 254;
}
static void harm_carried(struct species_slot *s)
{
    s->tables[0].vertices[0].anchor = (uint8_t)s->species.lod[0].anchor_count;
}
static void harm_u(struct species_slot *s)
{
    s->tables[0].vertices[9].u = NAN;
}
static void harm_part(struct species_slot *s)
{
    s->tables[0].vertices[9].part = PART_COUNT;
}
static void harm_grid(struct species_slot *s)
{
    s->species.lod[0].grid_first = (uint16_t)s->species.lod[0].vertex_count;
    s->species.lod[0].grid_rings = 2;
    s->species.lod[0].grid_spokes = 8;
}
static void harm_size(struct species_slot *s)
{
    for (uint32_t i = 0; i < s->species.lod[0].vertex_count; i++) {
        struct species_point *point = &s->tables[0].points[1][i];
        point->z = (int16_t)(point->z / 2);
    }
}

/* ---- Growth: the age and length of each key shape must match the growth curve ---------------- */

static void harm_late(struct species_slot *s)
{
    card_of(s)->key_age_days[3] = 200.0f;
}
static void harm_long(struct species_slot *s)
{
    card_of(s)->key_length_m[4] *= 1.03f;
}
static void harm_short(struct species_slot *s)
{
    card_of(s)->key_length_m[0] *= 0.97f;
}
static void draw_scale(struct species_slot *s, float first, float middle, float last)
{
    card_of(s)->scale_knot_count = 3;
    card_of(s)->scale_knots[0] = (struct scale_knot){ first, 0.005f };
    card_of(s)->scale_knots[1] = (struct scale_knot){ middle, 0.045f };
    card_of(s)->scale_knots[2] = (struct scale_knot){ last, 0.15f };
}
static void harm_scale_start(struct species_slot *s)
{
    draw_scale(s, 0.1f, 0.5f, 1.0f);
}
static void harm_scale_middle(struct species_slot *s)
{
    draw_scale(s, 0.0f, 0.0f, 1.0f);
}
static void harm_scale_end(struct species_slot *s)
{
    draw_scale(s, 0.0f, 0.5f, 0.9f);
}

/* ---- Body surface: its vertices must form a grid, as the core requires ---------------------- */

static struct species_vertex *skin_of(struct species_slot *s)
{
    return &s->tables[0].vertices[s->species.lod[0].grid_first];
}
static void harm_one_ring(struct species_slot *s)
{
    s->species.lod[0].grid_rings = 1;
}
static void harm_two_spokes(struct species_slot *s)
{
    s->species.lod[0].grid_rings = 2;
    s->species.lod[0].grid_spokes = 2;
    for (uint32_t i = 0; i < 6; i++) {
        skin_of(s)[i].u = i < 3 ? 0.0f : 1.0f;
        skin_of(s)[i].v = 0.5f * (float)(i % 3);
    }
}
static void harm_no_skin(struct species_slot *s)
{
    s->species.lod[0].grid_rings = 0;
}
static void harm_skin_part(struct species_slot *s)
{
    for (uint32_t i = 0; i < s->species.lod[0].vertex_count; i++) {
        uint8_t *part = &s->tables[0].vertices[i].part;
        *part = *part == PART_BODY ? (uint8_t)PART_TAIL : *part;
    }
}
static void harm_skin_rides(struct species_slot *s)
{
    skin_of(s)[1].anchor = 0;
}
static void harm_skin_u(struct species_slot *s)
{
    const uint32_t row = s->species.lod[0].grid_spokes + 1u;
    skin_of(s)[row + 2].u = skin_of(s)[2].u;
}
static void harm_skin_v(struct species_slot *s)
{
    skin_of(s)[2].v = skin_of(s)[1].v;
}
static void harm_skin_start(struct species_slot *s)
{
    skin_of(s)[0].v = 0.01f;
}
static void harm_skin_end(struct species_slot *s)
{
    skin_of(s)[s->species.lod[0].grid_spokes].v = 0.99f;
}
static void harm_two_parts(struct species_slot *s)
{
    s->tables[0].vertices[s->tables[0].indices[0]].part = PART_EYE;
}
static void harm_anchor_curve(struct species_slot *s)
{
    s->tables[0].anchors[0].curve = card_of(s)->curve_count;
}
static void harm_anchor_place(struct species_slot *s)
{
    s->tables[0].anchors[0].u[2] = NAN;
}

/* ---- Size: the size of each key shape must be 1 -----------------------------------------------
 *
 * The species defines how the size of a key shape is measured (enum species_measure). The functions
 * below change the size of the last key and keep its snout in place. */

/* Multiplies the last key shape by `along` in length, from the snout backwards, and by `across` in
 * width. */
static void stretch(struct species_slot *s, float along, float across)
{
    const uint32_t key = card_of(s)->key_count - 1u;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &s->species.lod[lod];
        const float count = 32767.0f / mesh->reach;
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            struct species_point *point = &s->tables[lod].points[key][i];
            const bool rides = mesh->vertices[i].anchor != ANCHOR_NONE;
            const float front = rides ? 0.0f : -0.5f * count;
            point->z = (int16_t)(front + ((float)point->z - front) * along);
            point->x = (int16_t)((float)point->x * across);
        }
    }
}
static void harm_longer(struct species_slot *s)
{
    stretch(s, 1.06f, 1.0f);
}
static void harm_shorter(struct species_slot *s)
{
    stretch(s, 0.94f, 1.0f);
}
static void harm_longest(struct species_slot *s)
{
    stretch(s, 1.15f, 1.0f);
}
static void harm_stub(struct species_slot *s)
{
    stretch(s, 0.75f, 1.0f);
}
static void harm_wider(struct species_slot *s)
{
    stretch(s, 1.0f, 1.06f);
}
static void harm_narrower(struct species_slot *s)
{
    stretch(s, 1.0f, 0.94f);
}

static const struct harm harms[] = {
    { harm_id, "id: " },
    { harm_id_escape, "id: " },
    { harm_key_control, "key 1/name: " },
    { harm_curve_control, "curve 0/name: " },
    { harm_two_keys, "keys: 2, but" },
    { harm_twin_key, "key 1/name: " },
    { harm_age, "/age_days: nan is outside" },
    { harm_age_order, "is not greater than the age of the previous key" },
    { harm_length, "/length_m: 1e+30 is outside" },
    { harm_measure, "measure: 4 is outside 0 .. 3" },
    { harm_motion, "motion: 255 is outside" },
    { harm_thesis, "thesis keys: 7 is outside" },
    { harm_template, "thesis template: " },
    { harm_growth, "growth/k_per_year: inf is outside" },
    { harm_fade, "growth/fade_year: 0 is outside" },
    { harm_points, "growth/points: 0, but" },
    { harm_hatching, "growth/age_days: " },
    { harm_scale, "scale knots: 1, but" },
    { harm_curves, "curves: 0, but" },
    { harm_knots, "knot 0: the number of knots" },
    { harm_sum, "knot 0: the sum of the weights is not 1 (1.25)" },
    { harm_negative, "knot 0: a weight is negative" },
    { harm_solved, "unsolvable: a key has too little weight" },
    { harm_colour, "/coat: a colour is greater than ffffff" },
    { harm_mark, "/mark: 200 is outside" },
    { harm_reach, "near/reach: 3 is not 1, 2 or 4" },
    { harm_faces, "far/indices: " },
    { harm_no_faces, "near/indices: 0, but" },
    { harm_index, "near/triangle 1: vertex " },
    { harm_flat, "near/triangle 1: two corners are the same vertex" },
    { harm_mask, "far/vertex 3: the sum of the masks is 254" },
    { harm_carried, "near/vertex 0: anchor " },
    { harm_u, "near/vertex 9: nan is outside" },
    { harm_part, "near/vertex 9: " },
    { harm_grid, "near/grid: 2 rings of 9" },
    { harm_size, "/near: snout at z" },
    { harm_late, "koaka/length_m: 0.045 at 200 days, but the growth curve gives 0.07" },
    { harm_long, "adult/length_m: 0.1545 at 545.4 days, but the growth curve gives 0.15" },
    { harm_short, "larva/length_m: 0.00485 at 0 days, but the growth curve gives 0.005" },
    { harm_scale_start, "scale knot/progress: 0.1 breaks the order" },
    { harm_scale_middle, "scale knot/progress: 0 breaks the order" },
    { harm_scale_end, "scale knot/progress: 0.9 breaks the order" },
    { harm_one_ring, "near/grid: 1 rings of " },
    { harm_two_spokes, "near/grid: 2 rings of 3 from vertex " },
    { harm_no_skin, "near/grid: the mesh has anchors, but no grid" },
    { harm_skin_part, "near/grid: ring 0, spoke 0 is not in order" },
    { harm_skin_rides, "near/grid: ring 0, spoke 1 is not in order" },
    { harm_skin_u, "near/grid: ring 1, spoke 2 is not in order" },
    { harm_skin_v, "near/grid: ring 0, spoke 2 is not in order" },
    { harm_skin_start, "near/grid: ring 0, spoke 0 is not in order" },
    { harm_skin_end, "near/grid: ring 0, spoke " },
    { harm_two_parts, "near/triangle 0: the corners belong to different parts" },
    { harm_anchor_curve, "near/anchor 0: " },
    { harm_anchor_place, "near/anchor 0: nan is outside 0 .. 1" },
};

static void expect_refusal(const struct species *species, const struct harm *harm)
{
    pack_copy(species, &slot);
    harm->change(&slot);
    const size_t size = pack_encode(&slot, bytes);
    why[0] = '\0';
    const enum pack_result result = pack_decode(bytes, size, &other, why);
    if (result != PACK_BAD || !strstr(why, harm->why)) {
        fail_msg("%s: '%s' and not '%s'", species->card.id, why, harm->why);
    }
    assert_null(strchr(why, '\n'));
}

static void test_each_kind_of_damage_is_detected_and_reported(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof harms / sizeof harms[0]; i++) {
        expect_refusal(&species_wakin, &harms[i]);
    }
}

static void test_keys_of_a_wrong_size_are_rejected_for_each_measure(void **state)
{
    (void)state;
    static const struct harm total[] = { { harm_longer, "adult/near: size: 1.0" },
                                         { harm_shorter, "adult/near: size: 0.9" } };
    static const struct harm disc[] = { { harm_wider, "adult/near: size: 1.0" },
                                        { harm_narrower, "adult/near: size: 0.9" } };
    static const struct harm root[] = { { harm_longest, "adult/near: size: 1." },
                                        { harm_stub, "adult/near: size: 0.7" } };
    for (uint32_t i = 0; i < species_table_count; i++) {
        const uint8_t measure = species_table[i]->card.measure;
        const struct harm *sizes = measure == MEASURE_TOTAL  ? total
                                   : measure == MEASURE_DISC ? disc
                                                             : root;
        expect_refusal(species_table[i], &sizes[0]);
        expect_refusal(species_table[i], &sizes[1]);
    }
}

static void repair_crc(size_t size)
{
    const uint32_t crc = crc32(bytes + HEAD_SIZE, size - HEAD_SIZE);
    memcpy(bytes + HEAD_SIZE - sizeof crc, &crc, sizeof crc);
}

static void test_too_large_counts_are_rejected_before_reading(void **state)
{
    (void)state;
    const size_t size = packed_wakin();
    assert_int_equal(bytes[HEAD_SIZE + SPECIES_NAME_SIZE], species_wakin.card.key_count);
    /* The byte behind the id is the number of key shapes. */
    bytes[HEAD_SIZE + SPECIES_NAME_SIZE] = 255;
    assert_int_equal(pack_decode(bytes, size, &other, why), PACK_BAD);
    assert_string_equal(why, "crc: the checksum is wrong, so the file is damaged");
    repair_crc(size);
    assert_int_equal(pack_decode(bytes, size, &other, why), PACK_BAD);
    assert_string_equal(why, "keys: more than a species may have");
    /* With fewer key shapes than the file contains, all following data are read at wrong
     * positions. */
    bytes[HEAD_SIZE + SPECIES_NAME_SIZE] = 3;
    repair_crc(size);
    assert_int_equal(pack_decode(bytes, size, &other, why), PACK_BAD);
}

static void test_any_body_after_a_valid_header_gives_a_result(void **state)
{
    (void)state;
    uint32_t random = 2005;
    const size_t size = packed_wakin();
    for (int round = 0; round < 500; round++) {
        random = random * 1664525u + 1013904223u;
        const size_t at = HEAD_SIZE + (random >> 4) % (round % 2 ? 700u : size - HEAD_SIZE);
        const uint8_t held = bytes[at];
        bytes[at] = (uint8_t)(random >> 24);
        repair_crc(size);
        why[0] = '\0';
        const enum pack_result result = pack_decode(bytes, size, &other, why);
        assert_true(result == PACK_OK ? why[0] == '\0' : why[0] != '\0' && !strchr(why, '\n'));
        bytes[at] = held;
    }
}

static void test_a_written_file_is_read_back(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-pack-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    const size_t size = packed_wakin();
    assert_int_equal(pack_write(path, &slot, why), PACK_OK);
    assert_int_equal(pack_read(path, &other, why), PACK_OK);
    assert_int_equal(pack_encode(&other, again), size);
    assert_memory_equal(bytes, again, size);
    unlink(path);
}

static void test_a_non_regular_file_is_an_io_error_and_not_a_data_error(void **state)
{
    (void)state;
    assert_int_equal(pack_read("/nowhere/x.kfish", &other, why), PACK_IO);
    assert_string_equal(why, "No such file or directory");
    assert_int_equal(pack_read("/tmp", &other, why), PACK_IO);
    assert_string_equal(why, "Is a directory");
    /* /dev/zero has no end, so it must be rejected before it is read. */
    assert_int_equal(pack_read("/dev/zero", &other, why), PACK_IO);
    packed_wakin();
    assert_int_equal(pack_write("/nowhere/x.kfish", &slot, why), PACK_IO);
}

static void test_writing_does_not_replace_devices_and_links(void **state)
{
    (void)state;
    char folder[] = "/tmp/kingyo-pack-XXXXXX", path[64], link[64];
    struct stat status;
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/x.kfish", folder);
    snprintf(link, sizeof link, "%s/link.kfish", folder);
    packed_wakin();
    /* The FIFO stands for a device such as /dev/full. A write must not replace it. */
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_int_equal(pack_write(path, &slot, why), PACK_IO);
    assert_int_equal(lstat(path, &status), 0);
    assert_true(S_ISFIFO(status.st_mode));
    unlink(path);
    assert_int_equal(pack_write(path, &slot, why), PACK_OK);
    assert_int_equal(truncate(path, 0), 0);
    assert_int_equal(symlink(path, link), 0);
    assert_int_equal(pack_write(link, &slot, why), PACK_OK);
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    /* The write through the link has changed the target of the link. */
    assert_int_equal(pack_read(path, &other, why), PACK_OK);
    assert_int_equal(pack_read(link, &other, why), PACK_OK);
    assert_int_equal(pack_read_data(path, &other, why), PACK_OK);
    assert_int_equal(pack_read_data(link, &other, why), PACK_IO);
    assert_string_equal(why, "is a symbolic link");
    assert_int_equal(truncate(path, PACK_SIZE_MAX + 1), 0);
    assert_int_equal(pack_read_data(path, &other, why), PACK_BAD);
    assert_string_equal(why, "is too large");
    assert_int_equal(pack_read_data(folder, &other, why), PACK_IO);
    assert_int_equal(pack_write(folder, &slot, why), PACK_IO);
    assert_string_equal(why, "Is a directory");
    unlink(link);
    unlink(path);
    assert_int_equal(rmdir(folder), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_built_in_species_is_unchanged_by_packing),
        cmocka_unit_test(test_an_unpacked_species_blends_to_the_same_shape),
        cmocka_unit_test(test_the_packed_bytes_are_identical_on_every_machine),
        cmocka_unit_test(test_a_file_truncated_at_any_byte_is_rejected),
        cmocka_unit_test(test_a_flipped_bit_at_any_position_is_rejected),
        cmocka_unit_test(test_a_different_version_is_reported),
        cmocka_unit_test(test_each_kind_of_damage_is_detected_and_reported),
        cmocka_unit_test(test_keys_of_a_wrong_size_are_rejected_for_each_measure),
        cmocka_unit_test(test_too_large_counts_are_rejected_before_reading),
        cmocka_unit_test(test_any_body_after_a_valid_header_gives_a_result),
        cmocka_unit_test(test_a_written_file_is_read_back),
        cmocka_unit_test(test_a_non_regular_file_is_an_io_error_and_not_a_data_error),
        cmocka_unit_test(test_writing_does_not_replace_devices_and_links),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
