/* bench_sound.c -- benchmark of the sound: cost, loudness and spectrum of a round of bots.
 *
 * Usage: bench_sound [PLAYERS [WAV]]. Plays a festival round of 60 s with PLAYERS bots (1 to 4, by
 * default 4), renders its sound, and writes the sound to the file WAV. Returns exit status 1 if a
 * second of sound costs more than GOAL_MS of CPU time, or if loudness or true peak miss their
 * goals. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/sound/mixer.h"
#include "tests/unit/core/sound/loudness.h"
#include "tests/unit/core/sound/sound_round.h"

#define GOAL_MS 40.0
/* Goals of the loudness in LUFS and of the true peak in dBTP. */
#define GOAL_LUFS_MIN (-19.5)
#define GOAL_LUFS_MAX (-16.5)
#define GOAL_DBTP (-1.0)
#define TRIES                                                                                      \
    3 /* The cost is the least of so many renderings, because other programs disturb it. */
#define FRAMES_PER_TICK (SOUND_RATE_HZ / CORE_TICK_HZ)
#define FRAMES_MAX (SOUND_ROUND_TICKS_MAX * FRAMES_PER_TICK)

static struct sound_round round_of_bots;
static struct mixer mixer;
static int16_t samples[2u * FRAMES_MAX];

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_sound: %s:%d: %s\n", file, line, condition);
    abort();
}

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

/* Renders the round with the given levels, and returns the CPU time in milliseconds. */
static double render(const struct sound_levels *levels)
{
    const struct sound_round *round = &round_of_bots;
    const double begin = now_ms();
    uint32_t next = 0;
    mixer_init(&mixer, 1);
    mixer_set_levels(&mixer, levels);
    for (uint32_t tick = 0; tick < round->ticks; tick++) {
        while (next < round->count && round->events[next].tick == tick) {
            mixer_play(&mixer, &round->events[next++].event);
        }
        mixer_render(&mixer, samples + 2u * FRAMES_PER_TICK * tick, FRAMES_PER_TICK);
    }
    return now_ms() - begin;
}

/* Prints loudness and cost of each source alone. */
static void print_sources(uint32_t frames)
{
    static const struct {
        const char *name;
        struct sound_levels levels;
    } sources[] = {
        { "effects alone", { .effects = 1.0f } },
        { "music alone", { .music = 1.0f } },
        { "surroundings", { .ambience = 1.0f, .has_pump = true } },
    };
    for (uint32_t i = 0; i < sizeof sources / sizeof sources[0]; i++) {
        const double cost_ms = render(&sources[i].levels) * SOUND_RATE_HZ / frames;
        printf("  %-18s %.1f LUFS, %.1f ms a second\n", sources[i].name,
               loudness_integrated(samples, frames), cost_ms);
    }
}

static int write_wav(const char *path, uint32_t frame_count)
{
    const uint32_t size = 4u * frame_count;
    const uint32_t head[11] = { 0x46464952u, size + 36u,  0x45564157u,   0x20746d66u,
                                16u,         0x00020001u, SOUND_RATE_HZ, 4u * SOUND_RATE_HZ,
                                0x00100004u, 0x61746164u, size };
    FILE *file = fopen(path, "wb");
    const int is_written = file && fwrite(head, sizeof head, 1, file) == 1 &&
                           fwrite(samples, 4, frame_count, file) == frame_count;
    return (!file || fclose(file) || !is_written) ? -1 : 0;
}

static void print_spectrum(uint32_t frames)
{
    const double whole = loudness_energy_below(samples, frames, 0.0);
    double below = 0.0;
    for (double hz = 125.0; hz < 20000.0; hz *= 2.0) {
        const double energy = loudness_energy_below(samples, frames, hz);
        printf("  below %5.0f Hz      %5.1f %% of the energy (%4.1f %% in the octave)\n", hz,
               100.0 * energy / whole, 100.0 * (energy - below) / whole);
        below = energy;
    }
}

int main(int count, char **values)
{
    const uint32_t players = count > 1 ? (uint32_t)atoi(values[1]) : 4u;
    if (players < 1 || players > POI_MAX || sound_round_play(&round_of_bots, players, 1) != 0) {
        fprintf(stderr, "usage: bench_sound [PLAYERS [WAV]], PLAYERS from 1 to 4\n");
        return 2;
    }
    const uint32_t frames = round_of_bots.ticks * FRAMES_PER_TICK;
    printf("%u players, %.1f s, %u sounds\n", players, (double)frames / SOUND_RATE_HZ,
           round_of_bots.count);
    print_sources(frames);
    const struct sound_levels levels = { 1.0f, 1.0f, 1.0f, 0, true, false };
    double cost_ms = INFINITY;
    for (int i = 0; i < TRIES && cost_ms > GOAL_MS; i++) {
        cost_ms = fmin(cost_ms, render(&levels) * SOUND_RATE_HZ / frames);
    }
    const double lufs = loudness_integrated(samples, frames);
    const double peak = loudness_true_peak(samples, frames);
    printf("  cost               %.1f ms of CPU time for each second of sound\n", cost_ms);
    printf("  loudness           %.1f LUFS integrated (ITU-R BS.1770-4)\n", lufs);
    printf("  true peak          %.1f dBTP\n", peak);
    printf("  digital silence    %.1f %% of the frames\n",
           100.0 * loudness_silence(samples, frames));
    print_spectrum(frames);
    if (count > 2 && write_wav(values[2], frames) != 0) {
        fprintf(stderr, "bench_sound: %s: cannot write\n", values[2]);
        return 74;
    }
    const int is_good =
        cost_ms <= GOAL_MS && lufs >= GOAL_LUFS_MIN && lufs <= GOAL_LUFS_MAX && peak < GOAL_DBTP;
    printf("  goals              %s: at most %.0f ms, %.1f to %.1f LUFS, below %.1f dBTP\n",
           is_good ? "met" : "MISSED", GOAL_MS, GOAL_LUFS_MIN, GOAL_LUFS_MAX, GOAL_DBTP);
    return !is_good;
}
