/* SPDX-License-Identifier: MIT */
/* value QUANTITY INPUTS DIGITS ROUNDING: value and bound of the error through the C interface; what same_bytes.py calls where it cannot load the library. */
#include "touchstone.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv)
{
    touchstone_value* v = NULL;
    char why[256] = "";
    if (argc != 5) return 64;
    if (touchstone_eval(argv[1], argv[2], atol(argv[3]), argv[4], &v, why, sizeof why) != TOUCHSTONE_OK) {
        fprintf(stderr, "%s\n", why);
        return 1;
    }
    printf("%s %s\n", touchstone_decimal(v), touchstone_error(v));
    touchstone_free(v);
    return 0;
}
