// SPDX-License-Identifier: MIT
/// \file
/// Arb's headers where FLINT 3 puts them, or where Arb 2 (Debian 12) does.
#pragma once
#if __has_include(<flint/arb.h>)
#include <mpfr.h> // first: FLINT 3 declares what takes its numbers only after it
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_hypgeom.h>
#include <flint/arb_calc.h>
#include <flint/arb_hypgeom.h>
#include <flint/fmpq.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <arb_hypgeom.h>
#include <flint/fmpq.h>
#endif
