/* recipe.c -- defines the parameters of all sounds. The pitches come from the yo scale on D, which
 * is used in Japanese festival music. */
#include "core/sound/recipe.h"

/* clang-format off */
#define TONE(g, delay, attack, decay, from, to, glide)                                             \
    { .kind = LAYER_TONE, .gain = (g), .delay_ms = (delay), .attack_ms = (attack),                 \
      .decay_ms = (decay), .hz_from = (from), .hz_to = (to), .glide_ms = (glide) }
#define NOISE(g, delay, attack, decay, from, to, glide, damp, rough)                               \
    { .kind = LAYER_NOISE, .gain = (g), .delay_ms = (delay), .attack_ms = (attack),                \
      .decay_ms = (decay), .hz_from = (from), .hz_to = (to), .glide_ms = (glide),                  \
      .damping = (damp), .roughness = (rough) }

const struct sound_recipe sound_recipes[SOUND_COUNT] = {
    /* A poi dips into the water ("chapun"): the water closes over an air bubble. The pitch rises as
     * the bubble shrinks. */
    [SOUND_DIP] = { .layer = {
        NOISE(0.50f, 0.0f, 4.0f, 45.0f, 1500.0f, 600.0f, 40.0f, 0.9f, 0.2f),
        TONE(0.34f, 38.0f, 3.0f, 42.0f, 420.0f, 980.0f, 55.0f),
        TONE(0.16f, 115.0f, 3.0f, 28.0f, 760.0f, 1500.0f, 40.0f),
        NOISE(0.16f, 20.0f, 12.0f, 90.0f, 3400.0f, 2600.0f, 90.0f, 1.2f, 0.7f),
    }, .vary = 0.06f, .length_ms = 600.0f },
    /* A poi leaves the water: a short rush of water, followed by three drops. */
    [SOUND_LIFT] = { .layer = {
        NOISE(0.42f, 0.0f, 30.0f, 70.0f, 2600.0f, 3600.0f, 120.0f, 1.0f, 0.4f),
        TONE(0.28f, 130.0f, 2.0f, 22.0f, 1050.0f, 1750.0f, 25.0f),
        TONE(0.20f, 245.0f, 2.0f, 20.0f, 1400.0f, 2200.0f, 22.0f),
        TONE(0.23f, 410.0f, 2.0f, 24.0f, 900.0f, 1500.0f, 28.0f),
    }, .vary = 0.06f, .length_ms = 800.0f },
    /* A fish falls into the bowl: it claps on the water of the bowl, and a koto string (A5 after a
     * grace note on D5) sounds over a wooden knock. */
    [SOUND_CATCH] = { .layer = {
        NOISE(0.30f, 0.0f, 0.5f, 9.0f, 1900.0f, 1900.0f, 0.0f, 0.6f, 0.0f),
        TONE(0.24f, 0.0f, 1.0f, 90.0f, 587.3f, 587.3f, 0.0f),
        TONE(0.10f, 85.0f, 1.0f, 120.0f, 1760.0f, 1760.0f, 0.0f),
        NOISE(0.34f, 0.0f, 1.0f, 38.0f, 1700.0f, 900.0f, 30.0f, 0.9f, 0.3f),
        TONE(0.16f, 30.0f, 2.0f, 34.0f, 520.0f, 1150.0f, 40.0f),
    }, .string_hz = 880.0f, .string_gain = 0.55f, .string_delay_ms = 85.0f,
       .string_keep = 0.9995f, .length_ms = 2000.0f },
    [SOUND_SLAP] = { .layer = {
        NOISE(0.55f, 0.0f, 0.5f, 16.0f, 1300.0f, 800.0f, 20.0f, 1.1f, 0.2f),
        TONE(0.30f, 0.0f, 0.5f, 24.0f, 260.0f, 150.0f, 25.0f),
        NOISE(0.20f, 8.0f, 1.0f, 22.0f, 4200.0f, 3000.0f, 20.0f, 1.0f, 0.8f),
    }, .vary = 0.10f, .length_ms = 300.0f },
    [SOUND_TEAR] = { .layer = {
        NOISE(0.60f, 0.0f, 6.0f, 60.0f, 2600.0f, 4600.0f, 90.0f, 0.8f, 1.0f),
        NOISE(0.40f, 15.0f, 25.0f, 80.0f, 5200.0f, 6400.0f, 90.0f, 1.2f, 0.9f),
    }, .vary = 0.08f, .length_ms = 700.0f },
    /* The paper of a poi becomes useless: a last rip of the paper, and a low plucked string. */
    [SOUND_GONE] = { .layer = {
        NOISE(0.50f, 0.0f, 8.0f, 110.0f, 2200.0f, 4200.0f, 160.0f, 0.8f, 1.0f),
        TONE(0.20f, 180.0f, 4.0f, 200.0f, 293.7f, 277.0f, 300.0f),
    }, .string_hz = 220.0f, .string_gain = 0.50f, .string_delay_ms = 330.0f,
       .string_keep = 0.985f, .length_ms = 2200.0f },
    /* A round starts ("don-don"): a festival drum, struck twice, with the click of the sticks. */
    [SOUND_START] = { .layer = {
        TONE(0.52f, 0.0f, 2.0f, 120.0f, 170.0f, 96.0f, 40.0f),
        TONE(0.30f, 0.0f, 1.5f, 70.0f, 272.0f, 205.0f, 30.0f),
        NOISE(0.30f, 0.0f, 0.5f, 12.0f, 1100.0f, 700.0f, 20.0f, 0.9f, 0.0f),
        TONE(0.46f, 240.0f, 2.0f, 150.0f, 176.0f, 100.0f, 40.0f),
        TONE(0.28f, 240.0f, 1.5f, 80.0f, 281.0f, 212.0f, 30.0f),
        NOISE(0.26f, 240.0f, 0.5f, 12.0f, 1100.0f, 700.0f, 20.0f, 0.9f, 0.0f),
    }, .length_ms = 1400.0f },
    /* The countdown of the round ticks: two sticks struck on wood. */
    [SOUND_TICK] = { .layer = {
        TONE(0.32f, 0.0f, 0.5f, 20.0f, 1244.5f, 1200.0f, 20.0f),
        TONE(0.14f, 0.0f, 0.5f, 9.0f, 2950.0f, 2950.0f, 0.0f),
        NOISE(0.20f, 0.0f, 0.3f, 4.0f, 3200.0f, 3200.0f, 0.0f, 1.0f, 0.0f),
    }, .length_ms = 250.0f },
    /* The result of a round without a fish ("don, ka"): a drum, the rim of the drum, and a low
     * plucked string that continues after both drum sounds. */
    [SOUND_RESULT] = { .layer = {
        TONE(0.50f, 0.0f, 2.0f, 170.0f, 165.0f, 92.0f, 45.0f),
        TONE(0.28f, 0.0f, 1.5f, 80.0f, 270.0f, 200.0f, 30.0f),
        NOISE(0.26f, 0.0f, 0.5f, 14.0f, 900.0f, 600.0f, 20.0f, 1.0f, 0.0f),
        NOISE(0.40f, 260.0f, 0.3f, 11.0f, 1700.0f, 1700.0f, 0.0f, 0.4f, 0.0f),
        TONE(0.46f, 520.0f, 2.0f, 200.0f, 160.0f, 88.0f, 45.0f),
    }, .string_hz = 293.7f, .string_gain = 0.55f, .string_delay_ms = 520.0f,
       .string_keep = 0.994f, .length_ms = 2800.0f },
    /* The hyoshigi, two bars of hard oak, are struck together ("chon, chon"), as a stall keeper
     * does before an announcement. Each stroke has one bright mode and the crack of the edges, and
     * the second stroke has a slightly lower pitch. */
    [SOUND_CALL] = { .layer = {
        TONE(0.34f, 0.0f, 0.3f, 34.0f, 2120.0f, 2090.0f, 12.0f),
        NOISE(0.34f, 0.0f, 0.3f, 6.0f, 4300.0f, 3600.0f, 8.0f, 0.7f, 0.0f),
        TONE(0.36f, 190.0f, 0.3f, 62.0f, 2010.0f, 1985.0f, 12.0f),
        NOISE(0.36f, 190.0f, 0.3f, 7.0f, 4100.0f, 3400.0f, 8.0f, 0.7f, 0.0f),
    }, .length_ms = 600.0f },
    /* An umpire's whistle signals a foul: a short note, followed by a long note with breath noise.
     * Two tones close in pitch beat 36 times per second, which imitates the rolling pea in a
     * whistle. */
    [SOUND_FOUL] = { .layer = {
        TONE(0.24f, 0.0f, 6.0f, 32.0f, 2780.0f, 2820.0f, 20.0f),
        TONE(0.17f, 150.0f, 14.0f, 210.0f, 2790.0f, 2832.0f, 60.0f),
        TONE(0.17f, 150.0f, 14.0f, 210.0f, 2826.0f, 2868.0f, 60.0f),
        NOISE(0.10f, 0.0f, 10.0f, 190.0f, 2800.0f, 2800.0f, 0.0f, 0.5f, 0.5f),
    }, .length_ms = 1300.0f },
    /* The selection moves to another game mode ("ka-ta"): a wooden tag swings around on its cord
     * and knocks against the next tag. */
    [SOUND_CHOOSE] = { .layer = {
        TONE(0.26f, 0.0f, 0.4f, 17.0f, 930.0f, 905.0f, 14.0f),
        NOISE(0.22f, 0.0f, 0.3f, 4.0f, 2400.0f, 2000.0f, 5.0f, 0.9f, 0.0f),
        TONE(0.13f, 64.0f, 0.4f, 13.0f, 1180.0f, 1160.0f, 14.0f),
        NOISE(0.10f, 64.0f, 0.3f, 3.0f, 2900.0f, 2900.0f, 0.0f, 0.9f, 0.0f),
    }, .length_ms = 260.0f },
    /* A coin is accepted ("chirin"): a coin hits the rim of a brass bowl, tips over and hits the
     * rim again. The first hit has two modes, about a musical fourth apart, and the second hit has
     * one higher mode. */
    [SOUND_COIN] = { .layer = {
        TONE(0.30f, 0.0f, 0.4f, 90.0f, 2349.3f, 2349.3f, 0.0f),
        TONE(0.18f, 0.0f, 0.4f, 60.0f, 3135.0f, 3135.0f, 0.0f),
        TONE(0.30f, 85.0f, 0.4f, 260.0f, 3520.0f, 3520.0f, 0.0f),
        NOISE(0.12f, 0.0f, 0.3f, 5.0f, 5200.0f, 5200.0f, 0.0f, 0.8f, 0.0f),
    }, .length_ms = 1200.0f },
    /* The wet paper of a poi creaks ("mishi") before it tears: two short crackles of its fibres
     * over a low tone that rises with the tension. */
    [SOUND_CREAK] = { .layer = {
        NOISE(0.52f, 0.0f, 3.0f, 16.0f, 1500.0f, 1900.0f, 20.0f, 0.5f, 1.0f),
        NOISE(0.48f, 70.0f, 3.0f, 20.0f, 1800.0f, 2400.0f, 25.0f, 0.5f, 1.0f),
        TONE(0.14f, 0.0f, 12.0f, 45.0f, 300.0f, 420.0f, 60.0f),
    }, .vary = 0.10f, .length_ms = 320.0f },
    /* A near miss ("o-shi-i"): a bamboo flute plays two falling notes about a third apart, with a
     * little breath noise, and the stall keeper calls the word. */
    [SOUND_MISS] = { .layer = {
        TONE(0.26f, 0.0f, 14.0f, 60.0f, 784.0f, 760.0f, 60.0f),
        TONE(0.24f, 130.0f, 14.0f, 110.0f, 659.0f, 587.0f, 120.0f),
        NOISE(0.10f, 0.0f, 8.0f, 70.0f, 1600.0f, 1200.0f, 90.0f, 0.6f, 0.2f),
    }, .call = VOCAL_PITY, .length_ms = 920.0f },
    /* Dry paper becomes wet: a soft hiss, which becomes darker as the water fills the fibres. */
    [SOUND_WET] = { .layer = {
        NOISE(0.30f, 0.0f, 6.0f, 90.0f, 5200.0f, 2400.0f, 90.0f, 1.4f, 0.5f),
        NOISE(0.14f, 40.0f, 20.0f, 110.0f, 2600.0f, 1500.0f, 120.0f, 1.0f, 0.8f),
    }, .vary = 0.05f, .apart_ms = 150.0f, .length_ms = 600.0f },
    /* A drop falls from the poi ("pon"): the bubble below its crater. */
    [SOUND_DRIP] = { .layer = {
        TONE(0.42f, 0.0f, 0.8f, 16.0f, 1250.0f, 2300.0f, 22.0f),
        NOISE(0.16f, 0.0f, 0.4f, 4.0f, 5200.0f, 4200.0f, 5.0f, 1.0f, 0.0f),
    }, .vary = 0.22f, .apart_ms = 45.0f, .length_ms = 140.0f },
    /* A fish falls into the tank ("bochan"). */
    [SOUND_PLOP] = { .layer = {
        NOISE(0.50f, 0.0f, 1.5f, 55.0f, 1300.0f, 700.0f, 45.0f, 0.9f, 0.3f),
        TONE(0.36f, 42.0f, 3.0f, 46.0f, 360.0f, 860.0f, 55.0f),
        TONE(0.16f, 140.0f, 2.0f, 22.0f, 900.0f, 1700.0f, 30.0f),
        NOISE(0.20f, 30.0f, 10.0f, 80.0f, 3600.0f, 2800.0f, 80.0f, 1.2f, 0.7f),
    }, .vary = 0.08f, .length_ms = 600.0f },
    /* A fish flees at the surface ("basha"): its tail tears the surface open twice. */
    [SOUND_ESCAPE] = { .layer = {
        NOISE(0.50f, 0.0f, 3.0f, 34.0f, 2400.0f, 1600.0f, 40.0f, 1.0f, 0.6f),
        NOISE(0.34f, 70.0f, 3.0f, 50.0f, 3000.0f, 1900.0f, 60.0f, 1.2f, 0.8f),
        TONE(0.14f, 110.0f, 2.0f, 24.0f, 700.0f, 1400.0f, 35.0f),
    }, .vary = 0.12f, .apart_ms = 90.0f, .length_ms = 450.0f },
    /* A fish gulps air ("pa"): the lips close over the film of the water. */
    [SOUND_GULP] = { .layer = {
        TONE(0.40f, 0.0f, 2.0f, 16.0f, 520.0f, 1050.0f, 14.0f),
        NOISE(0.20f, 0.0f, 0.8f, 8.0f, 1900.0f, 1500.0f, 10.0f, 0.8f, 0.0f),
    }, .vary = 0.15f, .apart_ms = 220.0f, .length_ms = 130.0f },
    /* The selection in the menu moves: a light tap on wood. */
    [SOUND_KEY] = { .layer = {
        TONE(0.30f, 0.0f, 0.4f, 11.0f, 1480.0f, 1440.0f, 12.0f),
        NOISE(0.20f, 0.0f, 0.3f, 3.0f, 3400.0f, 3000.0f, 4.0f, 0.9f, 0.0f),
    }, .length_ms = 120.0f },
    /* The result of a round with a catch: a drum, and three notes of a koto that rise. */
    [SOUND_WIN] = { .layer = {
        TONE(0.44f, 0.0f, 2.0f, 150.0f, 168.0f, 95.0f, 40.0f),
        NOISE(0.28f, 0.0f, 0.5f, 12.0f, 1100.0f, 700.0f, 20.0f, 0.9f, 0.0f),
        TONE(0.24f, 120.0f, 1.0f, 170.0f, 659.3f, 659.3f, 0.0f),
        TONE(0.22f, 240.0f, 1.0f, 190.0f, 784.0f, 784.0f, 0.0f),
        TONE(0.14f, 360.0f, 1.0f, 160.0f, 1975.5f, 1975.5f, 0.0f),
    }, .string_hz = 987.8f, .string_gain = 0.50f, .string_delay_ms = 360.0f,
       .string_keep = 0.9992f, .length_ms = 2600.0f },
    /* The result of a round that enters the ranking: drum, koto and bell, and the stall keeper
     * cheers. */
    [SOUND_RECORD] = { .layer = {
        TONE(0.44f, 0.0f, 2.0f, 150.0f, 168.0f, 95.0f, 40.0f),
        NOISE(0.28f, 0.0f, 0.5f, 12.0f, 1100.0f, 700.0f, 20.0f, 0.9f, 0.0f),
        TONE(0.22f, 120.0f, 1.0f, 150.0f, 784.0f, 784.0f, 0.0f),
        TONE(0.22f, 240.0f, 1.0f, 170.0f, 987.8f, 987.8f, 0.0f),
        TONE(0.16f, 480.0f, 0.4f, 330.0f, 2780.0f, 2780.0f, 0.0f),
        TONE(0.12f, 480.0f, 0.4f, 260.0f, 4090.0f, 4090.0f, 0.0f),
    }, .string_hz = 1318.5f, .string_gain = 0.50f, .string_delay_ms = 360.0f,
       .string_keep = 0.9995f, .call = VOCAL_BRAVO, .length_ms = 2800.0f },
    /* The stall keeper welcomes the players with a call and two claps. */
    [SOUND_WELCOME] = { .layer = {
        NOISE(0.36f, 0.0f, 0.6f, 14.0f, 1500.0f, 1200.0f, 12.0f, 0.6f, 0.0f),
        NOISE(0.36f, 420.0f, 0.6f, 16.0f, 1600.0f, 1200.0f, 12.0f, 0.6f, 0.0f),
    }, .call = VOCAL_WELCOME, .length_ms = 1000.0f },
};
/* clang-format on */
