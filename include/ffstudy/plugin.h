/* Samplers as a plug-in of ffstudy: a shared library that needs nothing of the program but this header.
 *
 *     cc -shared -fPIC -O2 mine.c -o libmine.so
 *     ffstudy check-sampler mine --plugin ./libmine.so
 *
 * docs/adding-a-sampler.md has an example. C99, or any later C or C++. */
#ifndef FFSTUDY_PLUGIN_H
#define FFSTUDY_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this interface. A plug-in that was built with another is refused. */
#define FFSTUDY_PLUGIN_VERSION 1u

/* One sampler. Every function may be called from several threads at once, and its result must follow from its arguments
 * alone. A result other than 0 ends the study with a message; what was saved stays. Give at least one of `fill` and
 * `fill_block`; a function that is not given, and a text that is not, is a null pointer. */
typedef struct ffstudy_sampler {
    const char* name;    /* lower-case letters, digits and _; no sampler of the program has it */
    const char* summary; /* a line, for `ffstudy list samplers`; may be null */
    const char* details; /* what it is and its limits, for `ffstudy explain`; may be null */

    uint32_t most_dimension; /* coordinates of a point that it can give, 1 to 4 */
    uint32_t base;           /* b >= 2: made for powers of b, others get a warning; 0: for any number of points */
    uint32_t deterministic;  /* 1: every seed and trial gives the same points, so that one trial says all; else 0 */

    /* All n points of a set: coordinate j of point i in points[i * d + j], in [0, 1).
     * The seed differs with study, scene, method, size, patch and trial, so that it suffices to make sets independent;
     * the trial, from 0, is given beside it. */
    int (*fill)(double* points, uint64_t n, uint32_t d, uint64_t seed, uint32_t trial);

    /* The same at full speed, without memory for a whole set: `count` points from `first` on, at most 1024, of the set
     * of n. Coordinate j of point first + i goes to coordinate[j][i] and counts 2^-32. Whatever parts of a set are
     * asked for, a point is the same. Used instead of `fill` where both are given. */
    int (*fill_block)(uint32_t* const* coordinate, uint64_t first, uint32_t count, uint64_t n, uint32_t d,
                      uint64_t seed, uint32_t trial);

    /* What a result of `fill` or `fill_block` means; may be null. */
    const char* (*error_text)(int result);
} ffstudy_sampler;

typedef struct ffstudy_plugin {
    uint32_t version; /* FFSTUDY_PLUGIN_VERSION */
    uint32_t count;   /* of samplers, at least 1 */
    const ffstudy_sampler* samplers;
} ffstudy_plugin;

/* What a plug-in exports. The tables it returns stay as they are until the program ends. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const ffstudy_plugin* ffstudy_samplers(void);

#ifdef __cplusplus
}
#endif

#endif
