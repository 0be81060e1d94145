#!/usr/bin/env python3
"""Turns the CSV of hooke_scaling into the table of docs/benchmarks.md: medians, in million springs updated each second.

    hooke_scaling --csv scaling.csv
    bench/scaling/table.py scaling.csv
"""
import csv
import sys


def main():
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    wrong = [row for row in rows if row["checked"] != "yes"]
    if wrong:
        sys.exit(f"{len(wrong)} rows of {sys.argv[1]} are of runs whose result was wrong")
    columns = sorted({(row["precision"], int(row["threads"])) for row in rows}, key=lambda c: (c[0] == "double", c[1]))
    by_key = {(row["mesh"], row["mode"], row["precision"], int(row["threads"])): row for row in rows}
    most = max(threads for _, threads in columns)
    print("| scene | springs | mode | "
          + " | ".join(f"{precision}, {threads}" for precision, threads in columns)
          + f" | share of the limit, float, {most} |")
    print("|---|---|---|" + "---|" * (len(columns) + 1))
    for mesh in sorted({row["mesh"] for row in rows}, key=[row["mesh"] for row in rows].index):
        for mode in ("gather", "coloured", "atomic"):
            found = [by_key.get((mesh, mode, *column)) for column in columns]
            if not any(found):
                continue
            springs = int(next(row for row in found if row)["springs"])
            cells = [f"{float(row['springs_per_second']) / 1e6:.0f}" if row else "" for row in found]
            widest = by_key.get((mesh, mode, "float", most))
            share = f"{100 * float(widest['share_of_limit']):.0f} % ({widest['limit_set_by']})" if widest else ""
            print(f"| {mesh} | {springs:,} | {mode} | " + " | ".join(cells) + f" | {share} |")


if __name__ == "__main__":
    main()
