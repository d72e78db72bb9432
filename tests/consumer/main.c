/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>
#include <touchstone.h>

int main(void)
{
    touchstone_value* v = NULL;
    int right;
    if (touchstone_eval("archard.K", "n=3", 9, NULL, &v, NULL, 0) != TOUCHSTONE_OK) return 1;
    puts(touchstone_decimal(v));
    right = strcmp(touchstone_decimal(v), "0.416550372") == 0;
    touchstone_free(v);
    return right ? 0 : 1;
}
