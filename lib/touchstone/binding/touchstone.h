/* SPDX-License-Identifier: MIT */
/**
 * \file
 * Touchstone from C, and so from any language: certified values of a quantity by its name.
 *
 *     touchstone_value* v = NULL;
 *     char why[256];
 *     if (touchstone_eval("contact.area", "n=3 load=1/10 G=2.5", 30, "nearest", &v, why, sizeof why) == TOUCHSTONE_OK)
 *         puts(touchstone_decimal(v));
 *     else
 *         fputs(why, stderr);
 *     touchstone_free(v);
 *
 * Units: pressures in p*_0, lengths in lambda_0; `touchstone_quantity_text(name, "unit")` says which for each quantity.
 * Texts are UTF-8 and end with a zero byte. Every function may be called from any thread at any time; handles are
 * immutable, and belong to the caller until touchstone_free. No C++ exception leaves the library.
 *
 * Names and types here keep their meaning as long as touchstone_abi() stays the same.
 */
#ifndef TOUCHSTONE_H
#define TOUCHSTONE_H

#include <stddef.h>

#if defined(__GNUC__)
#define TOUCHSTONE_API __attribute__((visibility("default")))
#else
#define TOUCHSTONE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What a call came to; the same numbers as the program's exit codes. */
enum touchstone_code {
    TOUCHSTONE_OK = 0,         /**< exact or certified; or estimated: see touchstone_status */
    TOUCHSTONE_UNDECIDED = 2,  /**< there is a value, with fewer digits than asked for, perhaps none */
    TOUCHSTONE_USAGE = 64,     /**< unknown quantity or input, a missing one, a null pointer */
    TOUCHSTONE_BAD_INPUT = 65, /**< no number, or out of the quantity's domain */
    TOUCHSTONE_INTERNAL = 70   /**< out of memory, or an error of this library */
};

/** How a value is known. */
enum touchstone_how {
    TOUCHSTONE_EXACT = 0,          /**< the digits are the value */
    TOUCHSTONE_CERTIFIED = 1,      /**< every digit is proven */
    TOUCHSTONE_ESTIMATED = 2,      /**< two methods agree on the digits; no proof */
    TOUCHSTONE_STATUS_UNDECIDED = 3,
    TOUCHSTONE_REFUSED = 4         /**< only in arrays: the row is out of domain */
};

/** A value with all that is known of it. */
typedef struct touchstone_value touchstone_value;

/** 1. A caller built against another number must not go on. */
TOUCHSTONE_API int touchstone_abi(void);
/** "0.1.0" */
TOUCHSTONE_API const char* touchstone_version(void);

/**
 * The true value, rounded.
 * \param quantity  as `touchstone list` names it: "contact.area"
 * \param inputs    "n=3 load=1/10 G=sqrt(10)", in any order, exact: 0.1 is 1/10; also 0x1.8p-3; D= and gamma= for G=
 * \param digits    significant digits, 1 to 10000
 * \param rounding  "nearest" (or NULL), "up", "down", "zero", "away"
 * \param value     set to a new handle for TOUCHSTONE_OK and TOUCHSTONE_UNDECIDED, else to NULL
 * \param message   set to one line that says what is wrong, or why a value is not certified, or ""; may be NULL
 * \returns a touchstone_code
 */
TOUCHSTONE_API int touchstone_eval(const char* quantity, const char* inputs, long digits, const char* rounding, touchstone_value** value,
                                   char* message, size_t message_size);

/**
 * Many rows of binary64 inputs, each taken as the number it is. Rows that share a surface share its work; order them so.
 * Half-width, exceedance and density of one wave (westergaard.*) take less than a microsecond a row: 106 bits with their error carried along
 * prove nearly every row, once; the few others are evaluated as touchstone_eval does, in balls and twice.
 * \param inputs  row after row, in the order of touchstone_quantity_input; `columns` of them a row
 * \param values  for each row the binary64 number nearest to the true value, nan where there is none or it is not decided
 * \param how     for each row a touchstone_how; may be NULL
 * \returns TOUCHSTONE_OK; TOUCHSTONE_UNDECIDED or TOUCHSTONE_BAD_INPUT if any row is, with the first such row in the message
 */
TOUCHSTONE_API int touchstone_eval_rows(const char* quantity, const double* inputs, size_t rows, size_t columns, double* values, int* how,
                                        char* message, size_t message_size);

/** Allows NULL. */
TOUCHSTONE_API void touchstone_free(touchstone_value*);

/** The value in decimal, every digit proven if certified; "nan" if none is. Texts live as long as the handle. */
TOUCHSTONE_API const char* touchstone_decimal(const touchstone_value*);
/** A bound of |value - true value| in decimal, proven unless the value is estimated. */
TOUCHSTONE_API const char* touchstone_error(const touchstone_value*);
/** A touchstone_how. */
TOUCHSTONE_API int touchstone_status(const touchstone_value*);
/** Why the value is undecided or only estimated, else "". */
TOUCHSTONE_API const char* touchstone_note(const touchstone_value*);
/** The binary64 number nearest to the true value; nan if that is not decided. */
TOUCHSTONE_API double touchstone_double(const touchstone_value*);
/** Significant digits in the value. */
TOUCHSTONE_API long touchstone_digits(const touchstone_value*);

/** The quantities there are, from 0; NULL past the last. */
TOUCHSTONE_API const char* touchstone_quantity(size_t index);
/** \param what "equation", "unit", "domain" or "description" \returns NULL if either is unknown */
TOUCHSTONE_API const char* touchstone_quantity_text(const char* quantity, const char* what);
/** The inputs of a quantity, from 0, in their order; NULL past the last. */
TOUCHSTONE_API const char* touchstone_quantity_input(const char* quantity, size_t index);

#ifdef __cplusplus
}
#endif
#endif
