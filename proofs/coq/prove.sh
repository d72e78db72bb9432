#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# prove.sh FOLDER [ROWS]: checks, in FOLDER, the theorems of this folder, ROWS rows (20 unless told) of each closed-form table, and the
# double forms of ../gappa. Ends with 1 if a theorem, a row or a form is not proved, if one rests on an axiom other than those of Coq's real
# numbers, or if what is wrong passes.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
tables="$here/../../data/reference"
work="$1"
rows="${2:-20}"
mkdir -p "$work"
cp "$here"/*.v "$work"
cd "$work"

say() { printf '%s\n' "$*"; }
fail() { echo "prove.sh: $*" >&2; exit 1; }

# ---- theorems, in the order in which they rest on each other
if grep -nE '\b(Admitted|Axiom|Parameter|admit|Conjecture|Hypothesis)\b' "$here"/*.v; then fail "a proof above is not finished"; fi
for file in Peaks Wave Operator Areas Equilibrium Archard Numbers Conditions; do
  say "proving $file.v"
  coqc -w none -q "$file.v"
done

# ---- rows of the tables, at the digits printed
coqc -w none -q Rows.v
proved=0
for table in peaks_f peaks_fixed_point hertz_half_width westergaard_half_width westergaard_pressure westergaard_exceedance \
  westergaard_density hertz_pressure hertz_gap westergaard_gap westergaard_mean_gap westergaard_energy weierstrass_bound \
  archard_delta archard_alpha peaks_iterate segments_max_half_width; do
  python3 "$here/rows.py" "$tables/$table.txt" "$rows" > "rows_$table.v"
  count="$(grep -c '^Theorem' "rows_$table.v")"
  say "proving $count rows of $table"
  coqc -w none -q "rows_$table.v" || fail "a row of $table is not proved"
  proved=$((proved + count))
done

# ---- a check that can't fail proves nothing: a last digit moved by three must be refused, by both tactics
for table in westergaard_half_width westergaard_gap archard_delta; do
  python3 "$here/rows.py" "$tables/$table.txt" 2 --spoil > spoilt.v
  if coqc -w none -q spoilt.v > /dev/null 2>&1; then fail "a row of $table with a wrong last digit was proved"; fi
done

# ---- double forms: each quotes the code that it is about, Gappa finds the proof, Coq checks it, and bounds a quarter lower are refused
forms=0
python3 "$here/../gappa/forms.py" quotes "$here/../.." "$here"/../gappa/*.g ||
  fail "the code of a double form has changed: its proof is about the old one"
for file in "$here"/../gappa/*.g; do
  name="$(basename "$file" .g)"
  say "proving $name.g"
  gappa -Bcoq "$file" > "gappa_$name.v" 2> "gappa_$name.txt" || fail "Gappa does not prove $file"
  coqc -w none -q "gappa_$name.v" || fail "Coq does not check Gappa's proof of $file"
  python3 "$here/../gappa/forms.py" tighter "$file" > spoilt.g
  if gappa -Eno-auto-dichotomy spoilt.g > /dev/null 2>&1; then fail "$name.g is proved with bounds a quarter lower"; fi
  forms=$((forms + 1))
done
mkdir -p quoted
sed 's/std::asin(std::sqrt/std::acos(std::sqrt/' "$here/../gappa/westergaard_half_width_low.g" > quoted/changed.g
if python3 "$here/../gappa/forms.py" quotes "$here/../.." quoted/changed.g 2> /dev/null; then
  fail "a quote that is not in the code was found there"
fi

# ---- what a form's proof says of the functions themselves
say "proving Forms.v"
coqc -w none -q Forms.v

# ---- no theorem rests on more than Coq's real numbers
coqc -w none -q Theorems.v > assumptions.txt
# what the lines of Print Assumptions may name: how Coq builds its real numbers
allowed='ClassicalDedekindReals.sig_not_dec|ClassicalDedekindReals.sig_forall_dec|FunctionalExtensionality.functional_extensionality_dep|Classical_Prop.classic|ClassicalEpsilon.constructive_indefinite_description'
foreign="$(grep -oE '^[A-Za-z_]+\.[A-Za-z_.0-9]+' assumptions.txt | sort -u | grep -vE "^($allowed)$" | grep -vE '^(PrimInt63|PrimFloat|FloatAxioms|Uint63|Int63|Sint63)\.' || true)"
[ -z "$foreign" ] || fail "a theorem rests on $foreign"
theorems="$(grep -c '^Print Assumptions' Theorems.v)"

say "$theorems theorems, $proved rows and $forms double forms proved by Coq; a wrong last digit, bounds too small and a stale quote were refused"
