#!/usr/bin/env bash
# Measures the latencies on both runtimes, some 13 minutes each, and writes the tables into
# docs/concepts/performance-measurements.md. For a quiet machine.
# Options go to the runner, for example --rounds 3 or the names of modes.
set -euo pipefail
cd "$(dirname "$0")/.."

document=docs/concepts/performance-measurements.md
status=0
dotnet build benchmarks/Rabit.Latency -c Release -v quiet
dotnet build benchmarks/Rabit.Latency -c Release -p:RabitMono=true -v quiet
artifacts/bin/Rabit.Latency/release/Rabit.Latency "$@" --into $document --json artifacts/latency-net.json || status=$?
mono artifacts-mono/bin/Rabit.Latency/release/Rabit.Latency.exe "$@" --into $document --json artifacts-mono/latency-mono.json || status=$?
exit $status
