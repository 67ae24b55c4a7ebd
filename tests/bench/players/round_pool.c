/* round_pool.c -- implementation of round_pool.h: worker threads that take the next round until all
 * rounds are played. */
#include "tests/bench/players/round_pool.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/game/rules.h"
#include "platform/cpu.h"
#include "platform/ctl/play/rounds.h"

struct round_pool {
    const struct pool_round *rounds;
    uint32_t count;
    uint8_t level;
    pthread_mutex_t lock; /* Protects the members below. */
    uint32_t next;        /* Index of the next round that a worker takes. */
    bool failed;
    struct progress progress;
};

static void *work(void *self)
{
    struct round_pool *pool = self;
    struct round_worker *worker = malloc(sizeof *worker);
    cpu_set_float();
    pthread_mutex_lock(&pool->lock);
    pool->failed |= worker == NULL;
    while (!pool->failed && pool->next < pool->count) {
        const struct pool_round *round = &pool->rounds[pool->next++];
        pthread_mutex_unlock(&pool->lock);
        const bool is_played =
            round_play(worker, round->habits, pool->level, round->seed, round->result);
        pthread_mutex_lock(&pool->lock);
        pool->failed |= !is_played;
        progress_add(&pool->progress);
    }
    pthread_mutex_unlock(&pool->lock);
    free(worker);
    return NULL;
}

bool round_pool_level(const char *name, uint8_t *level)
{
    for (uint32_t i = 0; i < LEVEL_COUNT; i++) {
        if (strcmp(name, rules_of_level((uint8_t)i)->name) == 0) {
            *level = (uint8_t)i;
            return true;
        }
    }
    return false;
}

bool round_pool_play(const char *prefix, const struct pool_round *rounds, uint32_t count,
                     uint8_t level, double *took_s)
{
    struct round_pool pool = { .rounds = rounds,
                               .count = count,
                               .level = level,
                               .lock = PTHREAD_MUTEX_INITIALIZER,
                               .progress = progress_begin(prefix, count) };
    pthread_t threads[ROUNDS_WORKERS_MAX];
    uint32_t started = 0;
    while (started + 1u < rounds_workers() &&
           pthread_create(&threads[started], NULL, work, &pool) == 0) {
        started++;
    }
    work(&pool);
    for (uint32_t i = 0; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
    *took_s = progress_end(&pool.progress);
    if (pool.failed) {
        fprintf(stderr, "%s: a round did not come to its end\n", prefix);
    }
    return !pool.failed;
}
