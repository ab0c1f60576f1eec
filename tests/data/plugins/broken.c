/* Plug-ins that are broken on purpose: -DBROKEN_... chooses how. Without one it is sound, and has a sampler of each kind:
 * `whole` makes sets at once, `parts` makes the same points part by part, `fixed` has no random numbers. */
#include <ffstudy/plugin.h>

#include <stddef.h>

static uint32_t word(uint64_t seed, uint64_t i, uint32_t j) {
    uint64_t x = seed + 0x9e3779b97f4a7c15u * (4 * i + j + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(x >> 32);
}

static int whole(double* points, uint64_t n, uint32_t d, uint64_t seed, uint32_t trial) {
    (void)trial;
#ifdef BROKEN_RESULT
    if (trial == 3) return 7;
#endif
    for (uint64_t i = 0; i < n; ++i) {
        for (uint32_t j = 0; j < d; ++j) points[i * d + j] = word(seed, i, j) / 4294967296.0;
    }
#ifdef BROKEN_RANGE
    if (trial == 3) points[5 * d + 1] = 1.0;
#endif
#ifdef BROKEN_MISSING
    if (trial == 3) points[6 * d] = 0.0 / (points[0] - points[0]);
#endif
    return 0;
}

static int parts(uint32_t* const* coordinate, uint64_t first, uint32_t count, uint64_t n, uint32_t d, uint64_t seed,
                 uint32_t trial) {
    (void)n;
    (void)trial;
    for (uint32_t j = 0; j < d; ++j) {
        for (uint32_t i = 0; i < count; ++i) coordinate[j][i] = word(seed, first + i, j);
    }
    return 0;
}

static int fixed(double* points, uint64_t n, uint32_t d, uint64_t seed, uint32_t trial) {
    (void)seed;
    return whole(points, n, d, 1, trial);
}

static const char* error_text(int result) { return result == 7 ? "no such trial" : NULL; }

#ifdef BROKEN_NAME
#define NAME "sobol"
#else
#define NAME "whole"
#endif
#ifdef BROKEN_DIMENSION
#define DIMENSION 5
#else
#define DIMENSION 4
#endif

static const ffstudy_sampler samplers[] = {
    {NAME, "independent points, set by set", NULL, DIMENSION, 0, 0, whole, NULL, error_text},
    {"parts", "independent points, part by part", NULL, 4, 0, 0, NULL, parts, NULL},
    {"fixed", "the same points in every trial", NULL, 2, 2, 1, fixed, NULL, NULL},
};

#ifdef BROKEN_VERSION
static const ffstudy_plugin plugin = {FFSTUDY_PLUGIN_VERSION + 1, 3, samplers};
#else
static const ffstudy_plugin plugin = {FFSTUDY_PLUGIN_VERSION, 3, samplers};
#endif

#ifndef BROKEN_SYMBOL
const ffstudy_plugin* ffstudy_samplers(void) { return &plugin; }
#else
const ffstudy_plugin* another_name(void) { return &plugin; }
#endif
