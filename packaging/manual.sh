#!/bin/sh
# SPDX-License-Identifier: MIT
# Manual pages from what the program says of itself: manual.sh TOUCHSTONE FOLDER (needs help2man)
set -eu
program=$1
folder=$2
mkdir -p "$folder"
version=$("$program" --version | sed 's/touchstone //')
page() {
  output=$1 name=$2
  shift 2
  help2man --no-info --no-discard-stderr --section=1 --version-string="$version" --name="$name" --output="$folder/$output.1" "$*"
}
page touchstone "certified reference values for contact mechanics" "$program"
for command in $("$program" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z]*\) .*/\1/p'); do
  wrapper=$folder/touchstone-$command
  printf '#!/bin/sh\nexec "%s" %s "$@"\n' "$program" "$command" > "$wrapper"
  chmod +x "$wrapper"
  page "touchstone-$command" "$command, a command of touchstone" "$wrapper"
  rm "$wrapper"
done
