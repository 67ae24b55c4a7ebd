/* rng.h -- random numbers that are a function of a key; no generator state exists.
 *
 * A random number depends only on (seed, tick, who, purpose), never on the number of earlier calls.
 * Therefore the order of calls cannot change the game. `who` is the index of the fish, player or
 * other object that uses the number. Each use has its own enum rng_purpose. */
#pragma once

#include <stdint.h>

struct rng_key {
    uint32_t seed, tick, who, purpose;
};

uint32_t rng_u32(struct rng_key key);
/* Returns a number from a uniform distribution in [0, 1). */
float rng_unit(struct rng_key key);
/* Returns a number from a uniform distribution in [low, high). */
float rng_range(struct rng_key key, float low, float high);
/* Returns a number from a nearly normal distribution with mean 0 and standard deviation 1, always
 * within [-6, 6]. */
float rng_normal(struct rng_key key);

/* Purpose of a random number, which is a part of its key. Two uses with different purposes get
 * independent numbers. The list covers the whole core, so that no two uses share a purpose by
 * accident. */
enum rng_purpose {
    RNG_FISH_PLACE_X = 1,
    RNG_FISH_PLACE_Y,
    RNG_FISH_PLACE_Z,
    RNG_FISH_YAW,
    RNG_FISH_AGE,
    RNG_FISH_STAMINA,
    RNG_FISH_LOOK,
    RNG_FISH_GAIT,
    RNG_FISH_DURATION,
    RNG_FISH_TURN,
    RNG_FISH_AVOID_SIDE,
    RNG_FISH_ESCAPE,
    RNG_FISH_DEPTH,
    /* The value 14 is unused since its purpose was removed. The later purposes keep their values,
     * because otherwise their random numbers would change. */
    RNG_SHEET_STRENGTH = 15,
    RNG_SHEET_SLAP,
    RNG_SHEET_SPOT,
    RNG_BOT_REACTION,
    RNG_BOT_TREMOR,
    RNG_BOT_CHOICE,
    RNG_ROUND_SEED,
    RNG_WATER_DROP,
    RNG_SOUND,
    RNG_TEST,
    RNG_FISH_START_GAIT,
    /* Random fraction of a fish's first gait that is left when the tank is opened. */
    RNG_FISH_START_LEFT,
    RNG_FISH_SHARP_TURN, /* Sharp turn of a fish at the start of a burst. */
    RNG_ESCAPE_STRAY,
    RNG_ESCAPE_DURATION,
    RNG_ESCAPE_CALM,  /* Duration of swimming after an escape. */
    RNG_CARRIED_REST, /* Time before a newly captured fish slaps the paper for the first time. */
    RNG_BOWL_ROUND,
    RNG_BOWL_POUR,
    RNG_FISH_LENGTH,
    RNG_FISH_AIR,    /* Decision whether a fish rises for surface breathing. */
    RNG_FISH_GULP,   /* Duration of a bout of a fish, a series of gulps at the surface. */
    RNG_ESCAPE_TURN, /* Turn of a fish in the first stage of a C-start (startle.h). */
    RNG_STARTLE_LATENCY,
    RNG_WATER_BUBBLE, /* Position where a bubble of the air pump bursts. */
    RNG_FISH_KICK,    /* Turn of a fish at a kick of its tail. */
    RNG_CONTACT_LOT,  /* Random choice of the contacts that a full contact list keeps. */
    RNG_TANK_SEED,    /* Seed of a tank that a game mode opens. */
    RNG_SESSION,      /* Seed of the next session, which begins with a new call of core_init(). */
    RNG_PIN,          /* Salt of a new PIN. */
};
