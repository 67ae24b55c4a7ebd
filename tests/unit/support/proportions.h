/* proportions.h -- known body proportions of the species, for tests of the modelled fish.
 *
 * Lengths are fractions of the standard length, from the snout to the tail root. Exceptions are the
 * tuna (fork length), the conger (total length) and the ray (disc width). The lengths of the stages
 * and three proportions of the goldfish (eye, tail root, places of the fins) have a source. All
 * other numbers are general knowledge of these fish. An adult may therefore differ by 15 %, and a
 * larva or young fish by 25 %. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_PROPORTIONS_H
#define KINGYO_TESTS_UNIT_SUPPORT_PROPORTIONS_H

/* clang-format off */
#define ADULT 0.15f
#define YOUNG 0.25f

/* Names of all proportions. depth_at is the place of the greatest body depth. waist is the depth of
 * a hatchling half way along its tail. A fin extends from start to end, and its height is the
 * length of the longest ray. fork is the depth of the tail's notch as a fraction of the tail.
 * turn_deg is the angle by which the right eye has moved over the back. The ray (fish) has five
 * more: eye_out is the distance of the eye from the midline, disc and whip are lengths, sting is a
 * place on the whip, and snout_deg is an angle. */
#define FIELDS(X)                                                                                  \
    X(depth) X(depth_at) X(width) X(head) X(eye) X(eye_x) X(eye_y) X(stalk) X(waist)               \
    X(dorsal_start) X(dorsal_end) X(dorsal_height)                                                 \
    X(dorsal2_start) X(dorsal2_end) X(dorsal2_height)                                              \
    X(anal_start) X(anal_end) X(anal_height) X(pectoral_at) X(pectoral) X(pelvic_at) X(pelvic)     \
    X(tail) X(fork) X(span) X(turn_deg)                                                            \
    X(eye_out) X(pelvic_end) X(disc) X(whip) X(sting) X(snout_deg)

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

/* Known proportions of one key shape (growth stage) of a species. A value of 0 means that the
 * proportion is unknown. */
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

    { "ray", "newborn", YOUNG,
      { DEPTH(.12f, .35f), EYE_AT(.22f, 0.f), [F_eye_out] = .10f, [F_pelvic_at] = .78f,
        [F_pelvic_end] = .93f, [F_disc] = .90f, [F_whip] = 1.9f, [F_sting] = .35f,
        [F_snout_deg] = 125.f } },
    { "ray", "adult", ADULT,
      { DEPTH(.12f, .35f), EYE_AT(.22f, 0.f), [F_eye_out] = .10f, [F_pelvic_at] = .78f,
        [F_pelvic_end] = .93f, [F_disc] = .85f, [F_whip] = 1.3f, [F_sting] = .35f,
        [F_snout_deg] = 125.f } },
};
/* clang-format on */

#define ROW_COUNT (sizeof table / sizeof table[0])

#endif
