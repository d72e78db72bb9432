#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# ./bootstrap.sh        install what is missing, build, run the main job into out/
# ./bootstrap.sh test   the same, then build and run every test (slow ones and campaigns excepted)
# ./bootstrap.sh prove  install Coq and Gappa, check the theorems of proofs/coq, rows of the closed-form tables and the double forms
set -euo pipefail
cd "$(dirname "$0")"

mode="${1:-run}"
case "$mode" in
  run | test | prove) ;;
  *) echo "usage: ./bootstrap.sh [test | prove]" >&2; exit 64 ;;
esac

say() { printf '\n== %s\n' "$*"; }

# ---- what Debian 12 and Ubuntu 24.04 call what we need
packages=(g++ cmake ninja-build ccache pkg-config
  libgmp-dev libmpfr-dev libflint-dev libboost-dev libginac-dev libcln-dev libgsl-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libssl-dev doctest-dev gnuplot-nox fonts-dejavu-core blahtexml)
if [ "$mode" = test ]; then packages+=(python3 python3-venv python3-pip python3-pytest gfortran parallel slurm-wlm strace tidy mkdocs doxygen); fi
if [ "$mode" = prove ]; then packages=(coq libcoq-interval libcoq-coquelicot libcoq-flocq libcoq-gappa gappa python3); fi
# Arb is a package of its own until FLINT 3 took it in
if [ "$mode" != prove ] && apt-cache show libflint-arb-dev >/dev/null 2>&1; then packages+=(libflint-arb-dev); fi

missing() {
  local p
  for p in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'install ok installed' || echo "$p"
  done
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "bootstrap.sh: this is not a Debian or Ubuntu system; install by hand: ${packages[*]}" >&2
  exit 69
fi
lacking="$(missing)"
if [ -n "$lacking" ]; then
  if [ "$(id -u)" = 0 ]; then sudo=""
  elif command -v sudo >/dev/null && sudo -v; then sudo="sudo"
  else
    echo "bootstrap.sh: neither root nor sudo; ask for these packages: $(echo $lacking)" >&2
    exit 69
  fi
  say "installing $(echo $lacking)"
  $sudo apt-get update -qq
  # the index was perhaps empty before: ask again whether Arb is a package of its own
  if [ "$mode" != prove ] && apt-cache show libflint-arb-dev >/dev/null 2>&1 && [[ " ${packages[*]} " != *" libflint-arb-dev "* ]]; then
    packages+=(libflint-arb-dev)
  fi
  # shellcheck disable=SC2046
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $(missing) >/dev/null
fi

if [ "$mode" = prove ]; then
  say "proving"
  exec proofs/coq/prove.sh build/prove
fi

say "building"
# the tests are part of the build only when they are asked for
if [ "$mode" = test ]; then tests=ON; else tests=OFF; fi
build="build/$mode"
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTOUCHSTONE_TESTS=$tests -DTOUCHSTONE_C_LIBRARY=$tests >/dev/null
cmake --build "$build"

if [ "$mode" = test ]; then
  say "testing"
  status=0
  log="$build/ctest.log"
  ctest --test-dir "$build" -LE 'slow|bench|campaign' -j "$(nproc)" --output-on-failure --no-tests=error | tee "$log" || status=$?
  total=$(sed -n 's/.*tests passed, .* tests failed out of \([0-9]*\).*/\1/p' "$log")
  failed=$(sed -n 's/.*tests passed, \([0-9]*\) tests failed out of .*/\1/p' "$log")
  if [ -z "$total" ]; then echo "bootstrap.sh: no tests were run" >&2; exit 1; fi
  echo "$((total - failed)) passed, $failed failed"
  exit "$status"
fi

say "the paper, checked (out/paper.txt)"
mkdir -p out
"$build/touchstone" paper | tee out/paper.txt
say "reference tables (out/tables)"
"$build/touchstone" table all --skip-slow --out out/tables
say "report (out/report/index.html)"
"$build/touchstone" report --out out/report
cat <<EOF

Done.
  out/report/index.html  the paper's figures from certified values, Table 1, the erratum and the ledger, in one file
  out/paper.txt    one verdict for each checked statement of the paper
  out/tables/      certified tables, $(find out/tables -name '*.txt' | wc -l) files, every printed digit proven
Next:
  $build/touchstone eval archard.K n=3 --digits 50
  $build/touchstone list
  README.md        formulas, map from paper to code, how to test your own code
EOF
