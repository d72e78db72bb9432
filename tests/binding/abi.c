/* SPDX-License-Identifier: MIT */
/* touchstone.h from C99: values, errors, null pointers, short buffers, threads. Prints the first thing that is wrong. */
#include "touchstone.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(what)                                                            \
    do {                                                                       \
        if (!(what)) {                                                         \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #what); \
            exit(1);                                                           \
        }                                                                      \
    } while (0)

static void one_value(void)
{
    touchstone_value* v = NULL;
    char why[256] = "x";
    CHECK(touchstone_eval("archard.K", "n=3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_OK);
    CHECK(strcmp(touchstone_decimal(v), "0.416550371832813487722720256733") == 0);
    CHECK(strcmp(touchstone_error(v), "5e-31") == 0);
    CHECK(touchstone_status(v) == TOUCHSTONE_CERTIFIED && touchstone_digits(v) == 30);
    CHECK(touchstone_double(v) == 0x1.aa8c2e40a2612p-2);
    CHECK(strcmp(why, "") == 0 && strcmp(touchstone_note(v), "") == 0);
    touchstone_free(v);
    CHECK(touchstone_eval("archard.K", "n=3", 6, "up", &v, NULL, 0) == TOUCHSTONE_OK && strcmp(touchstone_decimal(v), "0.416551") == 0);
    touchstone_free(v);
    CHECK(touchstone_eval("peaks.fixed_point", "G=sqrt(4)", 5, "nearest", &v, why, sizeof why) == TOUCHSTONE_OK && touchstone_status(v) == TOUCHSTONE_EXACT);
    touchstone_free(v);
}

static void errors(void)
{
    touchstone_value* v = (touchstone_value*)&v;
    char why[256], tiny[4];
    CHECK(touchstone_eval("archard.J", "n=3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_USAGE && v == NULL && strstr(why, "archard.K") != NULL);
    CHECK(touchstone_eval("archard.K", "m=3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval("archard.K", "3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval("archard.K", NULL, 30, NULL, &v, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval(NULL, "n=3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval("archard.K", "n=3", 30, "sideways", &v, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval("archard.K", "n=3", 30, NULL, NULL, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval("archard.K", "n=-3", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_BAD_INPUT && strstr(why, "n = -3") != NULL);
    CHECK(touchstone_eval("archard.K", "n=nan", 30, NULL, &v, why, sizeof why) == TOUCHSTONE_BAD_INPUT);
    CHECK(touchstone_eval("archard.K", "n=3", 0, NULL, &v, why, sizeof why) == TOUCHSTONE_BAD_INPUT);
    CHECK(touchstone_eval("archard.K", "n=3", -5, NULL, &v, tiny, sizeof tiny) == TOUCHSTONE_BAD_INPUT && strlen(tiny) == 3);
    CHECK(strcmp(touchstone_decimal(NULL), "nan") == 0 && isnan(touchstone_double(NULL)) && touchstone_digits(NULL) == 0);
    touchstone_free(NULL);
}

static void rows(void)
{
    const double load[4] = {0.25, -1.0, 1.0, NAN};
    double values[4];
    int how[4];
    char why[256];
    CHECK(touchstone_eval_rows("westergaard.half_width", load, 4, 1, values, how, why, sizeof why) == TOUCHSTONE_BAD_INPUT);
    CHECK(strncmp(why, "row 2: load = -1", 16) == 0);
    CHECK(values[0] == 1.0 / 6.0 && isnan(values[1]) && values[2] == 0.5 && isnan(values[3]));
    CHECK(how[0] == TOUCHSTONE_CERTIFIED && how[1] == TOUCHSTONE_REFUSED && how[2] == TOUCHSTONE_EXACT);
    CHECK(touchstone_eval_rows("westergaard.half_width", load, 1, 1, values, NULL, NULL, 0) == TOUCHSTONE_OK);
    CHECK(touchstone_eval_rows("westergaard.half_width", load, 2, 2, values, NULL, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval_rows("westergaard.half_width", NULL, 1, 1, values, NULL, why, sizeof why) == TOUCHSTONE_USAGE);
    CHECK(touchstone_eval_rows("westergaard.half_width", NULL, 0, 1, NULL, NULL, why, sizeof why) == TOUCHSTONE_OK);
}

static void names(void)
{
    size_t count = 0;
    while (touchstone_quantity(count) != NULL) {
        const char* name = touchstone_quantity(count++);
        CHECK(touchstone_quantity_text(name, "unit") != NULL && touchstone_quantity_text(name, "equation") != NULL);
        CHECK(touchstone_quantity_text(name, "colour") == NULL && touchstone_quantity_text(name, NULL) == NULL);
    }
    CHECK(count > 20 && touchstone_quantity_text("no", "unit") == NULL && touchstone_quantity_input(NULL, 0) == NULL);
    CHECK(strcmp(touchstone_quantity_input("contact.area", 1), "load") == 0 && touchstone_quantity_input("contact.area", 3) == NULL);
    CHECK(touchstone_abi() == 1 && touchstone_version()[0] != '\0');
}

static void* in_a_thread(void* wanted)
{
    for (int k = 0; k < 20; ++k) {
        touchstone_value* v = NULL;
        char inputs[64];
        snprintf(inputs, sizeof inputs, "n=%d load=1/%d G=3", k % 4, 2 + k % 3);
        CHECK(touchstone_eval("contact.area", inputs, 12, NULL, &v, NULL, 0) == TOUCHSTONE_OK);
        ((double*)wanted)[k] = touchstone_double(v);
        touchstone_free(v);
    }
    return NULL;
}

static void threads(void)
{
    pthread_t thread[4];
    double found[4][20];
    for (int k = 0; k < 4; ++k) CHECK(pthread_create(&thread[k], NULL, in_a_thread, found[k]) == 0);
    for (int k = 0; k < 4; ++k) CHECK(pthread_join(thread[k], NULL) == 0);
    for (int k = 1; k < 4; ++k) CHECK(memcmp(found[0], found[k], sizeof found[0]) == 0);
}

int main(void)
{
    one_value();
    errors();
    rows();
    names();
    threads();
    return 0;
}
