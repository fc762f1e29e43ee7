#!/usr/bin/env bash
# Everything that must hold: all tests as built by GCC, the tests again as built by Clang under the
# address and undefined-behaviour sanitizers, and the format of the sources.
set -uo pipefail
cd "$(dirname "$0")"

passed=0
failed=0
closing="No tests were run"
culprits="" # for the last lines: what a log of thousands ends with

# Counts one step that is no test: step NAME COMMAND...
step() {
  local name=$1
  shift
  echo "== $name"
  if "$@"; then
    passed=$((passed + 1))
    return 0
  fi
  failed=$((failed + 1))
  echo "FAILED: $name"
  culprits+="FAILED: $name"$'\n'
  return 1
}

# Runs the tests of a build and adds up what ctest says: tests FOLDER [CTEST OPTIONS]
tests() {
  local log=$1/ctest.log
  shift
  (cd "$(dirname "$log")" && ctest -j "$(nproc)" --output-on-failure "$@" < /dev/null) | tee "$log"
  closing=$(grep 'tests passed,' "$log" || echo "No tests were run")
  local counts='s/.* \([0-9]*\) tests failed out of \([0-9]*\).*'
  local bad all
  bad=$(sed -n "$counts/\1/p" "$log")
  all=$(sed -n "$counts/\2/p" "$log")
  if [[ -z $all || $all == 0 ]]; then
    bad=1
    all=1
  fi
  failed=$((failed + bad))
  passed=$((passed + all - bad))
  if ((bad > 0)); then
    # ctest's list of them, then what the tests themselves said
    culprits+=$(sed -n '/^The following tests FAILED:/,/^$/p' "$log")$'\n'
    culprits+=$(grep -E -A 8 '^[^ ]+:[0-9]+: Failure|Error: ' "$log" | head -60)$'\n'
  fi
}

build() { cmake --preset "$1" > /dev/null && cmake --build --preset "$1"; }

formatted() {
  find . \( -path './build*' -o -path './out*' -o -name node_modules \) -prune -o \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 clang-format --dry-run -Werror
}

scripts/install.sh test || exit 2
step "the sources are formatted" formatted
step "GCC builds everything" build default && tests build
gcc_closing=$closing
step "Clang builds everything with sanitizers" build sanitize && tests build-sanitize -LE slow

# What docs/results.md quotes.
echo "$SECONDS" > build/test_seconds.txt
printf '%s' "$culprits"
echo "$gcc_closing"
echo "$passed passed, $failed failed"
((failed == 0))
