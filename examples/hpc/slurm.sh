#!/bin/bash
# SPDX-License-Identifier: MIT
# A table as a Slurm job array, one share a task:
#
#     sbatch --array=1-16 slurm.sh contact_area shares           then, when all are done:
#     touchstone merge shares                                    or, if some are missing:
#     sbatch $(touchstone merge shares) --export=ALL,SHARES=16 slurm.sh contact_area shares
#
# A share that is there already and whole is kept, so a task that is started again costs nothing.
#SBATCH --cpus-per-task=1
#SBATCH --requeue
set -eu
table=$1 folder=$2
shares=${SHARES:-${SLURM_ARRAY_TASK_COUNT:?start with sbatch --array=1-N}} # of all, not of the tasks that are made up for
exec touchstone table "$table" --shard "$SLURM_ARRAY_TASK_ID/$shares" --jobs "${SLURM_CPUS_PER_TASK:-1}" --out "$folder"
