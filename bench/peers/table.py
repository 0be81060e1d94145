#!/usr/bin/env python3
"""Turns the CSV files of bench_peers and bench_equal_cost into the tables of docs/benchmarks.md.

    bench_peers --out peers.csv
    bench_equal_cost --out equal_cost
    bench/peers/table.py peers.csv equal_cost/equal_cost.csv
"""
import csv
import sys

NAMES = {
    "naive": "naive loop, array of structures",
    "soa": "structure of arrays",
    "eigen": "Eigen, sparse matrices",
    "hooke": "**Hooke**, gather",
    "bullet": "Bullet, for each projection of a link",
    "lammps": "LAMMPS",
}


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def millions(row):
    return f"{float(row['springs_per_second_median']) / 1e6:.0f}"


def peers_table(rows):
    """Medians in million springs a second, a column for each scene; then both ratios on the largest scene."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    programs = list(dict.fromkeys((row["peer"], row["precision"], row["threads"]) for row in rows))
    by_place = {(row["peer"], row["precision"], row["threads"], row["scene"]): row for row in rows}
    ratios_of = max((scene for scene in scenes if scene.startswith("cloth_")), key=lambda name: int(name[6:]))
    print("| program | precision | threads | " + " | ".join(scenes) + f" | {ratios_of}: against naive | against LAMMPS, 2 |")
    print("|---" * (5 + len(scenes)) + "|")
    for program in programs:
        cells = [by_place[*program, scene] for scene in scenes]
        named = by_place[*program, ratios_of]
        ratios = [f"{float(named[key]):.2f}" if named[key] else "" for key in ("ratio_to_naive", "ratio_to_lammps_2")]
        print("| " + " | ".join([NAMES[program[0]], *program[1:], *map(millions, cells), *ratios]) + " |")


def percent(text):
    return f"{100 * float(text):.3g}"


def equal_cost_table(rows):
    print("| engine | setting | threads | ms a frame | s for each simulated second | largest strain [%] | "
          "99th percentile [%] | median [%] | stretch stiffness [N/m] | mean fall [m] | rms speed [m/s] |")
    print("|---" * 11 + "|")
    for row in rows:
        stiffness = f"{float(row['stretch_stiffness']):.0f}" if row["stretch_stiffness"] else ""
        print(f"| {row['engine'].capitalize()} | {row['setting']} | {row['threads']} | {float(row['ms_per_frame']):.0f} | "
              f"{float(row['seconds_per_simulated_second']):.2f} | {percent(row['strain_largest'])} | "
              f"{percent(row['strain_percentile_99'])} | {percent(row['strain_median'])} | {stiffness} | "
              f"{float(row['mean_fall']):.3f} | {float(row['rms_speed']):.3f} |")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for path in sys.argv[1:]:
        rows = read(path)
        if not rows:
            sys.exit(f"{path}: has no rows; was the benchmark stopped before its end?")
        equal_cost_table(rows) if "setting" in rows[0] else peers_table(rows)
        print()


if __name__ == "__main__":
    main()
