#!/bin/bash
# SPDX-License-Identifier: MIT
# A table with GNU parallel, here or on several machines (--sshloginfile): parallel.sh TABLE SHARES FOLDER [options of parallel]
# The same command again makes only what failed or is missing, and then the table.
set -eu
table=$1 shares=$2 folder=$3
shift 3
mkdir -p "$folder"
seq "$shares" | parallel --resume-failed --joblog "$folder/joblog" "$@" touchstone table "$table" --jobs 1 --shard "{}/$shares" --out "$folder"
touchstone merge "$folder"
