/* test_proportions.c -- each drawn key, measured on its mesh, beside what is known of the fish.
 *
 * The table is the makers' brief: lengths as fractions of standard length (snout to tail root), of
 * fork length for the tuna and of total length for the conger. Numbers with a source are the
 * goldfish's (eye, peduncle, where fins sit) and the stages' lengths; all others are general
 * knowledge of these fish, so an adult may differ by 15 % and a larva or young fish by 25 %, and no
 * place is held to less than 1 % of the length. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/morph/morph.h"

#define ADULT 0.15f
#define YOUNG 0.25f
#define FLOOR 0.01f
#define FLOOR_DEG 10.0f
#define GILL_U 0.30f /* Body coordinate of the gill cover's edge in every key that draws one. */
#define STALK_FROM 0.70f /* The tail's stalk lies behind this part of the body. */

/* depth_at: where the body is deepest; waist: depth of the tail half way back, of hatchlings; a
 * fin's base from start to end, its longest ray as height; turn_deg: how far the right eye has
 * gone round over the back. */
#define FIELDS(X)                                                                                  \
    X(depth) X(depth_at) X(width) X(head) X(eye) X(eye_x) X(eye_y) X(stalk) X(waist)               \
    X(dorsal_start) X(dorsal_end) X(dorsal_height)                                                 \
    X(dorsal2_start) X(dorsal2_end) X(dorsal2_height)                                              \
    X(anal_start) X(anal_end) X(anal_height) X(pectoral_at) X(pectoral) X(pelvic_at) X(pelvic)     \
    X(tail) X(fork) X(span) X(turn_deg)

enum field {
#define ENUM(name) F_##name,
    FIELDS(ENUM)
#undef ENUM
    FIELD_COUNT,
};

static const char *const field_names[FIELD_COUNT] = {
#define NAME(name) #name,
    FIELDS(NAME)
#undef NAME
};

/* 0: not known. */
struct known {
    const char *species, *key;
    float tolerance;
    float of[FIELD_COUNT];
};

#define DEPTH(d, x) [F_depth] = d, [F_depth_at] = x
#define EYE_AT(x, y) [F_eye_x] = x, [F_eye_y] = y
#define DORSAL(a, b, h) [F_dorsal_start] = a, [F_dorsal_end] = b, [F_dorsal_height] = h
#define DORSAL_2(a, b, h) [F_dorsal2_start] = a, [F_dorsal2_end] = b, [F_dorsal2_height] = h
#define ANAL(a, b, h) [F_anal_start] = a, [F_anal_end] = b, [F_anal_height] = h
#define PECTORAL(x, l) [F_pectoral_at] = x, [F_pectoral] = l
#define PELVIC(x, l) [F_pelvic_at] = x, [F_pelvic] = l
#define BODY(w, h, e) [F_width] = w, [F_head] = h, [F_eye] = e

static const struct known table[] = {
    { "wakin", "larva", YOUNG,
      { DEPTH(.17f, .20f), BODY(.14f, .19f, .08f), EYE_AT(.09f, .01f), [F_stalk] = .05f,
        DORSAL(.30f, 1.f, .05f), ANAL(.60f, 1.f, .04f), PECTORAL(.20f, .08f), [F_tail] = .06f } },
    { "wakin", "aoko", YOUNG,
      { DEPTH(.31f, .38f), BODY(.16f, .30f, .090f), EYE_AT(.13f, .03f), [F_stalk] = .12f,
        DORSAL(.48f, .80f, .17f), ANAL(.75f, .85f, .13f), PECTORAL(.28f, .16f),
        PELVIC(.47f, .14f), [F_tail] = .25f } },
    { "wakin", "kuroko", YOUNG,
      { DEPTH(.35f, .39f), BODY(.18f, .30f, .087f), EYE_AT(.13f, .03f), [F_stalk] = .14f,
        DORSAL(.47f, .81f, .19f), ANAL(.75f, .86f, .15f), PECTORAL(.28f, .18f),
        PELVIC(.47f, .16f), [F_tail] = .26f } },
    { "wakin", "koaka", ADULT,
      { DEPTH(.37f, .40f), BODY(.19f, .29f, .085f), EYE_AT(.13f, .03f), [F_stalk] = .15f,
        DORSAL(.47f, .82f, .20f), ANAL(.75f, .86f, .16f), PECTORAL(.28f, .19f),
        PELVIC(.46f, .17f), [F_tail] = .27f, [F_fork] = .35f } },
    { "wakin", "adult", ADULT,
      { DEPTH(.41f, .40f), BODY(.21f, .29f, .080f), EYE_AT(.13f, .04f), [F_stalk] = .17f,
        DORSAL(.47f, .83f, .20f), ANAL(.75f, .86f, .17f), PECTORAL(.28f, .19f),
        PELVIC(.46f, .18f), [F_tail] = .27f } },

    { "kurodai", "hatchling", YOUNG,
      { DEPTH(.33f, .25f), BODY(.20f, .16f, .09f), [F_stalk] = .05f, [F_waist] = .10f,
        [F_dorsal_start] = .15f, [F_dorsal_end] = 1.f, [F_anal_start] = .5f, [F_anal_end] = 1.f } },
    { "kurodai", "larva", YOUNG,
      { DEPTH(.24f, .27f), BODY(.15f, .27f, .11f), [F_stalk] = .07f, [F_anal_start] = .52f,
        PECTORAL(.28f, .07f) } },
    { "kurodai", "juvenile", YOUNG,
      { DEPTH(.30f, .33f), BODY(.16f, .33f, .11f), [F_stalk] = .09f, DORSAL(.38f, .86f, .10f),
        ANAL(.60f, .84f, .09f), PECTORAL(.32f, .17f), PELVIC(.36f, .12f), [F_tail] = .2f } },
    { "kurodai", "adult", ADULT,
      { DEPTH(.43f, .35f), BODY(.17f, .31f, .075f), EYE_AT(.12f, .07f), [F_stalk] = .115f,
        DORSAL(.36f, .87f, .14f), ANAL(.64f, .84f, .13f), PECTORAL(.30f, .33f),
        PELVIC(.35f, .20f), [F_tail] = .27f, [F_fork] = .35f } },

    { "shimafugu", "hatchling", YOUNG,
      { DEPTH(.27f, .25f), BODY(.24f, .23f, .11f), [F_stalk] = .07f, PECTORAL(.25f, .07f) } },
    { "shimafugu", "juvenile_b", YOUNG,
      { DEPTH(.40f, .42f), BODY(.38f, .38f, .13f), [F_stalk] = .11f, DORSAL(.71f, .81f, .12f),
        ANAL(.72f, .81f, .11f), PECTORAL(.36f, .13f), [F_tail] = .22f } },
    { "shimafugu", "juvenile_c", YOUNG,
      { DEPTH(.37f, .42f), BODY(.35f, .37f, .11f), [F_stalk] = .11f, DORSAL(.70f, .81f, .14f),
        ANAL(.72f, .81f, .12f), PECTORAL(.35f, .14f), [F_tail] = .22f } },
    { "shimafugu", "adult", ADULT,
      { DEPTH(.29f, .42f), BODY(.27f, .33f, .06f), EYE_AT(.17f, .07f), [F_stalk] = .09f,
        DORSAL(.68f, .79f, .15f), ANAL(.70f, .79f, .13f), PECTORAL(.34f, .15f), [F_tail] = .21f } },

    { "kuroanago", "leaf", YOUNG,
      { DEPTH(.12f, .55f), BODY(.010f, .06f, .012f), [F_dorsal_start] = .80f,
        [F_anal_start] = .88f } },
    { "kuroanago", "long_leaf", YOUNG,
      { DEPTH(.11f, .55f), BODY(.012f, .045f, .010f), [F_dorsal_start] = .75f,
        [F_anal_start] = .88f } },
    { "kuroanago", "shrinking", YOUNG,
      { DEPTH(.09f, .50f), BODY(.020f, .07f, .015f), [F_dorsal_start] = .50f,
        [F_anal_start] = .60f, PECTORAL(.08f, .02f) } },
    { "kuroanago", "young", YOUNG,
      { DEPTH(.060f, .30f), BODY(.055f, .15f, .022f), [F_dorsal_start] = .20f,
        [F_anal_start] = .40f, PECTORAL(.15f, .05f) } },
    { "kuroanago", "adult", ADULT,
      { DEPTH(.060f, .30f), BODY(.056f, .15f, .017f), [F_dorsal_start] = .20f,
        [F_anal_start] = .40f, PECTORAL(.15f, .045f) } },

    { "hirame", "upright", YOUNG,
      { DEPTH(.33f, .38f), BODY(.10f, .29f, .085f), DORSAL(.20f, .92f, .25f),
        [F_anal_start] = .42f, [F_anal_end] = .90f, PECTORAL(.30f, .09f), [F_tail] = .18f } },
    { "hirame", "crossing", YOUNG,
      { DEPTH(.37f, .38f), BODY(.10f, .29f, .075f), [F_turn_deg] = 90.f,
        DORSAL(.10f, .92f, .15f), [F_anal_start] = .38f, [F_anal_end] = .91f,
        PECTORAL(.30f, .10f), [F_tail] = .18f } },
    { "hirame", "settling", YOUNG,
      { DEPTH(.41f, .38f), BODY(.09f, .29f, .070f), [F_turn_deg] = 165.f,
        DORSAL(.07f, .92f, .08f), ANAL(.33f, .91f, .08f), PECTORAL(.29f, .12f),
        [F_tail] = .18f } },
    { "hirame", "adult", ADULT,
      { DEPTH(.40f, .38f), BODY(.10f, .28f, .045f), EYE_AT(.11f, .035f), [F_turn_deg] = 180.f,
        DORSAL(.07f, .93f, .10f), ANAL(.29f, .93f, .10f), PECTORAL(.29f, .13f), [F_tail] = .16f,
        [F_stalk] = .095f } },

    { "mebachi", "larva", YOUNG,
      { DEPTH(.30f, .25f), BODY(.17f, .38f, .13f), [F_stalk] = .06f, PECTORAL(.35f, .05f),
        [F_span] = .10f } },
    { "mebachi", "young", YOUNG,
      { DEPTH(.26f, .40f), BODY(.18f, .32f, .075f), [F_stalk] = .03f, DORSAL(.33f, .54f, .12f),
        DORSAL_2(.56f, .62f, .10f), [F_anal_start] = .61f, [F_anal_end] = .66f,
        PECTORAL(.30f, .25f), [F_span] = .28f } },
    { "mebachi", "adult", ADULT,
      { DEPTH(.28f, .42f), BODY(.20f, .29f, .055f), [F_stalk] = .025f, DORSAL(.31f, .53f, .12f),
        DORSAL_2(.55f, .61f, .14f), ANAL(.60f, .66f, .14f), PECTORAL(.29f, .24f),
        [F_span] = .33f } },
};

#define ROW_COUNT (sizeof table / sizeof table[0])

/* The fish as it lies on the bench: near mesh, one key, snout at z 0, `unit` long. */
struct specimen {
    const struct species_mesh *mesh;
    uint32_t key;
    float unit;
    vec3 at[MESH_VERTEX_MAX];
};

static const struct species *species_named(const char *id)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(species_table[i]->card.id, id) == 0) {
            return species_table[i];
        }
    }
    fail_msg("no species %s", id);
    return NULL;
}

static uint32_t key_named(const struct species_card *card, const char *name)
{
    for (uint32_t key = 0; key < card->key_count; key++) {
        if (strcmp(card->key_names[key], name) == 0) {
            return key;
        }
    }
    fail_msg("%s has no key %s", card->id, name);
    return 0;
}

static vec3 grid(const struct specimen *fish, uint32_t ring, uint32_t spoke)
{
    const struct species_mesh *mesh = fish->mesh;
    return fish->at[mesh->grid_first + ring * (mesh->grid_spokes + 1u) + spoke];
}

static float ring_depth(const struct specimen *fish, uint32_t ring)
{
    return grid(fish, ring, 0).y - grid(fish, ring, fish->mesh->grid_spokes / 2u).y;
}

static float ring_width(const struct specimen *fish, uint32_t ring)
{
    float right = 0.0f, left = 0.0f;
    for (uint32_t spoke = 0; spoke < fish->mesh->grid_spokes; spoke++) {
        right = f_max(right, grid(fish, ring, spoke).x);
        left = f_min(left, grid(fish, ring, spoke).x);
    }
    return right - left;
}

static struct specimen *specimen_of(const struct known *known)
{
    static struct specimen fish;
    static struct morph_pose pose;
    const struct species *species = species_named(known->species);
    const uint32_t key_count = species->card.key_count;
    fish.mesh = &species->lod[0];
    fish.key = key_named(&species->card, known->key);
    morph_key_pose(fish.mesh, key_count, fish.key, &pose);
    morph_shape(fish.mesh, key_count, &pose, fish.at, NULL);
    for (uint32_t i = 0; i < fish.mesh->vertex_count; i++) {
        fish.at[i].z += 0.5f;
    }
    const uint8_t measure = species->card.measure;
    fish.unit = 1.0f;
    if (measure == MEASURE_TOTAL && species->card.form != FORM_EEL) {
        fish.unit = grid(&fish, fish.mesh->grid_rings - 1u, 0).z;
    }
    return &fish;
}

static void measure_body(const struct specimen *fish, float of[FIELD_COUNT])
{
    const uint32_t rings = fish->mesh->grid_rings, row = fish->mesh->grid_spokes + 1u;
    const float root = grid(fish, rings - 1u, 0).z;
    of[F_stalk] = of[F_waist] = 1.0f;
    for (uint32_t ring = 0; ring < rings; ring++) {
        const float depth = ring_depth(fish, ring), z = grid(fish, ring, 0).z;
        if (depth > of[F_depth]) {
            of[F_depth] = depth;
            of[F_depth_at] = z;
        }
        of[F_width] = f_max(of[F_width], ring_width(fish, ring));
        if (z > STALK_FROM * root) {
            of[F_stalk] = f_min(of[F_stalk], depth);
        }
        if (z < 0.6f * root) {
            of[F_waist] = depth;
        }
        const float u = fish->mesh->vertices[fish->mesh->grid_first + ring * row].u;
        if (u <= GILL_U + 1e-5f) {
            of[F_head] = z;
        }
    }
}

static bool of_right_eye(const struct species_vertex *vertex)
{
    return vertex->part == PART_EYE && vertex->side == SIDE_RIGHT;
}

/* How far the right eye has gone round: from where the first key has it, over the midline of the
 * back, to the mirror image of that place, by its anchor's own coordinate round the girth. */
static float turn_deg(const struct specimen *fish, uint8_t anchor)
{
    const float *round = fish->mesh->anchors[anchor].v;
    return 90.0f * (1.0f - round[fish->key] / round[0]);
}

/* An eye is a ball in rings about its gaze: the widest tells its size and centre. */
static void measure_eye(const struct specimen *fish, float of[FIELD_COUNT])
{
    const struct species_vertex *vertices = fish->mesh->vertices;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        for (uint32_t j = 0; of_right_eye(&vertices[i]) && j < i; j++) {
            const float across = v3_length(v3_sub(fish->at[i], fish->at[j]));
            if (of_right_eye(&vertices[j]) && vertices[i].u == vertices[j].u &&
                across > of[F_eye]) {
                of[F_eye] = across;
                of[F_eye_x] = 0.5f * (fish->at[i].z + fish->at[j].z);
                of[F_eye_y] = 0.5f * (fish->at[i].y + fish->at[j].y);
            }
        }
        if (of_right_eye(&vertices[i]) && vertices[i].u == 0.0f) {
            of[F_turn_deg] = turn_deg(fish, vertices[i].anchor);
        }
    }
}

/* The fin's base along the body and its longest ray. */
static void measure_fin(const struct specimen *fish, uint8_t part, float *start, float *end,
                        float *length)
{
    vec3 root = v3(0.0f, 0.0f, 0.0f);
    *start = 10.0f;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        const struct species_vertex *vertex = &fish->mesh->vertices[i];
        if (vertex->part != part || vertex->side == SIDE_LEFT) {
            continue;
        }
        if (vertex->v == 0.0f) {
            root = fish->at[i];
            *start = f_min(*start, root.z);
            *end = f_max(*end, root.z);
        }
        *length = f_max(*length, v3_length(v3_sub(fish->at[i], root)));
    }
}

static void measure_tail(const struct specimen *fish, float of[FIELD_COUNT])
{
    const float root = grid(fish, fish->mesh->grid_rings - 1u, 0).z;
    float tip = 0.0f, notch = 10.0f, top = -1.0f, bottom = 1.0f;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        const struct species_vertex *vertex = &fish->mesh->vertices[i];
        if (vertex->part == PART_TAIL && vertex->v == 1.0f) {
            tip = f_max(tip, fish->at[i].z);
            notch = f_abs(vertex->u - 0.5f) < 0.01f ? fish->at[i].z : notch;
            top = f_max(top, fish->at[i].y);
            bottom = f_min(bottom, fish->at[i].y);
        }
    }
    of[F_tail] = tip - root;
    of[F_fork] = (tip - notch) / (tip - root) * fish->unit; /* A share of the tail, not a length. */
    of[F_span] = top - bottom;
}

static void measure(const struct specimen *fish, float of[FIELD_COUNT])
{
    float end = 0.0f;
    memset(of, 0, FIELD_COUNT * sizeof *of);
    measure_body(fish, of);
    measure_eye(fish, of);
    measure_fin(fish, PART_DORSAL, &of[F_dorsal_start], &of[F_dorsal_end], &of[F_dorsal_height]);
    measure_fin(fish, PART_DORSAL_2, &of[F_dorsal2_start], &of[F_dorsal2_end],
                &of[F_dorsal2_height]);
    measure_fin(fish, PART_ANAL, &of[F_anal_start], &of[F_anal_end], &of[F_anal_height]);
    measure_fin(fish, PART_PECTORAL, &of[F_pectoral_at], &end, &of[F_pectoral]);
    measure_fin(fish, PART_PELVIC, &of[F_pelvic_at], &end, &of[F_pelvic]);
    measure_tail(fish, of);
    for (uint32_t i = 0; i < FIELD_COUNT; i++) {
        of[i] /= i == F_turn_deg ? 1.0f : fish->unit;
    }
}

/* How many of the known numbers `fish` misses; each is told. */
static uint32_t count_missed(const struct known *known, const struct specimen *fish, bool tell)
{
    float of[FIELD_COUNT];
    uint32_t missed = 0;
    measure(fish, of);
    for (uint32_t i = 0; i < FIELD_COUNT; i++) {
        const float want = known->of[i];
        const float leave = f_max(known->tolerance * want, i == F_turn_deg ? FLOOR_DEG : FLOOR);
        if (want != 0.0f && !(f_abs(of[i] - want) <= leave)) {
            missed++;
            if (tell) {
                print_message("# %s %s: %s is %.3f, should be %.3f within %.3f\n", known->species,
                              known->key, field_names[i], (double)of[i], (double)want,
                              (double)leave);
            }
        }
    }
    return missed;
}

static void check_species(const char *id)
{
    uint32_t missed = 0, rows = 0;
    for (uint32_t i = 0; i < ROW_COUNT; i++) {
        if (strcmp(table[i].species, id) == 0) {
            missed += count_missed(&table[i], specimen_of(&table[i]), true);
            rows++;
        }
    }
    assert_true(rows >= 3);
    assert_int_equal(missed, 0);
}

static void test_wakin_has_a_goldfish_s_proportions(void **state)
{
    (void)state;
    check_species("wakin");
}

static void test_kurodai_has_a_sea_bream_s_proportions(void **state)
{
    (void)state;
    check_species("kurodai");
}

static void test_shimafugu_has_a_puffer_s_proportions(void **state)
{
    (void)state;
    check_species("shimafugu");
}

static void test_kuroanago_has_a_conger_s_proportions(void **state)
{
    (void)state;
    check_species("kuroanago");
}

static void test_hirame_has_a_flatfish_s_proportions(void **state)
{
    (void)state;
    check_species("hirame");
}

static void test_mebachi_has_a_tuna_s_proportions(void **state)
{
    (void)state;
    check_species("mebachi");
}

/* A fish that is a third too deep, or a third too short before its tail, misses numbers. */
static void test_a_fish_out_of_proportion_is_found_out(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < ROW_COUNT; i++) {
        struct specimen *fish = specimen_of(&table[i]);
        for (uint32_t j = 0; j < fish->mesh->vertex_count; j++) {
            fish->at[j].y *= 1.4f;
        }
        assert_true(count_missed(&table[i], fish, false) >= 1);
        fish = specimen_of(&table[i]);
        fish->unit *= 1.4f;
        assert_true(count_missed(&table[i], fish, false) >= 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wakin_has_a_goldfish_s_proportions),
        cmocka_unit_test(test_kurodai_has_a_sea_bream_s_proportions),
        cmocka_unit_test(test_shimafugu_has_a_puffer_s_proportions),
        cmocka_unit_test(test_kuroanago_has_a_conger_s_proportions),
        cmocka_unit_test(test_hirame_has_a_flatfish_s_proportions),
        cmocka_unit_test(test_mebachi_has_a_tuna_s_proportions),
        cmocka_unit_test(test_a_fish_out_of_proportion_is_found_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
