/* SPDX-License-Identifier: MIT */
/* Lives with the library, in threads that end: values, rows, refusals. Each leaves as much memory in use as the one before, also what FLINT keeps for
   a thread. Under valgrind, which has an allocator of its own, all blocks are released in the end (memory_errors). */
#include "touchstone.h"

#include <malloc.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { lives = 8, tolerated = 256 }; /* bytes a life, for what the C library keeps of a thread */

static void* life(void* nothing)
{
    static const char* const asked[][2] = {
        {"archard.K", "n=3"}, {"contact.area", "n=2 load=1/2 G=3"}, {"contact.exceedance", "n=1 p=1/2 load=1/2 G=3"}, {"limit.area_constant", "G=30"},
        {"westergaard.gap", "load=0.3 x=0.4"}, {"archard.K", "n=-3"}, {"archard.J", "n=3"}, {"contact.area", "n=2 load=2 G=0.5"}};
    enum { refused_from = 5 };
    const double loads[3] = {0.25, -1.0, 0.3};
    double values[3];
    (void)nothing;
    for (size_t k = 0; k < sizeof asked / sizeof *asked; ++k) {
        touchstone_value* v = NULL;
        char why[80];
        touchstone_eval(asked[k][0], asked[k][1], 12, NULL, &v, why, sizeof why);
        if ((v == NULL) != (k >= refused_from)) {
            fprintf(stderr, "%s %s: %s\n", asked[k][0], asked[k][1], why);
            exit(1);
        }
        touchstone_free(v);
    }
    touchstone_eval_rows("westergaard.half_width", loads, 3, 1, values, NULL, NULL, 0);
    return NULL;
}

static size_t in_use_after(int count)
{
    struct mallinfo2 m;
    for (int k = 0; k < count; ++k) {
        pthread_t thread;
        if (pthread_create(&thread, NULL, life, NULL) != 0 || pthread_join(thread, NULL) != 0) exit(1);
    }
    m = mallinfo2();
    return m.uordblks + m.hblkhd;
}

int main(void)
{
    const size_t before = in_use_after(2), after = in_use_after(lives);
    const long grown = (long)after - (long)before;
    printf("%zu bytes in use after 2 lives, %ld more after %d further ones\n", before, grown, lives);
    return grown > (long)tolerated * lives;
}
