#!/usr/bin/env python3
"""Turns the JSON of bench_springs into the table of docs/benchmarks.md: medians, in million springs updated each second.

    bench_springs --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true \
        --benchmark_out=springs.json --benchmark_out_format=json
    bench/table.py springs.json
"""
import json
import sys

COLUMNS = [f"{real}/threads:{threads}" for real in ("float", "double") for threads in (1, 2)]
MODES = ["gather", "coloured", "atomic"]


def medians(path):
    """Millions of springs a second, by (scene, mode, column)."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    result = {}
    for run in runs:
        if run.get("error_occurred"):
            sys.exit(f"{run['name']}: {run['error_message']}")
        if run.get("aggregate_name") == "median":
            scene, mode, *column = run["run_name"].removesuffix("/real_time").split("/")
            result[scene, mode, "/".join(column)] = run["springs/s"] / 1e6
    return result


def main():
    rate = medians(sys.argv[1])
    print("| scene | mode | float, 1 thread | float, 2 | double, 1 | double, 2 | float, 2, against naive |")
    print("|---|---|---|---|---|---|---|")
    for scene in sorted({key[0] for key in rate}, key=lambda name: (len(name), name)):
        naive = rate[scene, "naive", ""]
        print(f"| {scene} | naive loop | | | {naive:.0f} | | 1 |")
        for mode in MODES:
            cells = [rate[scene, mode, column] for column in COLUMNS]
            print(f"| {scene} | {mode} | " + " | ".join(f"{cell:.0f}" for cell in cells) + f" | {cells[1] / naive:.1f} |")


if __name__ == "__main__":
    main()
