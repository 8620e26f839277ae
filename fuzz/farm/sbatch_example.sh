#!/bin/bash
#SBATCH --job-name=graze-fuzz --array=1-64 --cpus-per-task=4 --time=24:00:00 --requeue
#SBATCH --signal=B:TERM@60
# Each array task is a shard with a folder of its own; submitted again, it goes on where it was.
# Then: graze-fuzz summary "$SCRATCH"/graze/shard-*      (exit code 1 of a shard: it has findings)
mkdir -p "$SCRATCH/graze"
exec graze-fuzz campaign "$SCRATCH/graze/shard-$SLURM_ARRAY_TASK_ID" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --threads "$SLURM_CPUS_PER_TASK" \
  --traversal plain --level 1-50 --seed 2026 --rays 1000000000000
