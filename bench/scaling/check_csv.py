"""Checks the CSV file of `hooke_scaling --quick`: its columns, its rows, and that each row was checked.

Usage: check_csv.py FILE.csv
"""
import csv
import math
import pathlib
import sys

COLUMNS = ["mesh", "particles", "springs", "mode", "threads", "precision", "springs_per_second",
           "springs_per_second_best", "ns_per_particle_step", "gigabytes_per_second", "gigaflops", "share_of_limit",
           "limit_set_by", "repetitions", "checked"]
MESHES = {"cloth_32", "cloth_64", "jittered10K"}
FIGURES = COLUMNS[6:12]


def faults_of(row):
    """What is wrong with one row."""
    name = "/".join(row[key] for key in ("mesh", "mode", "threads", "precision"))
    if row["checked"] != "yes":
        yield f"{name}: checked is {row['checked']}"
    for column in FIGURES:
        value = float(row[column])
        if not (math.isfinite(value) and value > 0):
            yield f"{name}: {column} is {row[column]}"
    # The same times, said twice.
    by_particles = float(row["springs"]) / float(row["particles"]) * 1e9 / float(row["ns_per_particle_step"])
    if not math.isclose(by_particles, float(row["springs_per_second"]), rel_tol=1e-4):
        yield f"{name}: ns_per_particle_step and springs_per_second differ"
    if float(row["springs_per_second_best"]) < float(row["springs_per_second"]):
        yield f"{name}: the best is slower than the median"


def main():
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    faults = [] if reader.fieldnames == COLUMNS else [f"columns are {reader.fieldnames}"]
    if not faults:
        faults += [fault for row in rows for fault in faults_of(row)]
        threads = {row["threads"] for row in rows}
        expected = {(mesh, mode, thread, precision) for mesh in MESHES for mode in ("gather", "coloured", "atomic")
                    for thread in threads for precision in ("float", "double")}
        found = {(row["mesh"], row["mode"], row["threads"], row["precision"]) for row in rows}
        faults += [f"no row {missing}" for missing in sorted(expected - found)]
        if not rows or len(found) != len(rows):
            faults.append(f"{len(rows)} rows, {len(found)} of them different")
    if "float GFLOP/s" not in pathlib.Path(sys.argv[1]).with_suffix(".machine.txt").read_text(encoding="utf-8"):
        faults.append("the machine's limits are missing")
    print("\n".join(faults) or f"{len(rows)} rows, all checked")
    return 1 if faults else 0


sys.exit(main())
