"""Checks the schema of scene files, every scene in a folder against it, and that it refuses what it must.

Usage: check_schema.py SCHEMA.json FOLDER. Exit code 77 (skipped) where Python's jsonschema is missing.
"""
import copy
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: no jsonschema 4 for Python")
    sys.exit(77)


def refused(validator, scene, change):
    """Whether the scene is refused once `change` has been done to a copy of it."""
    changed = copy.deepcopy(scene)
    change(changed)
    return not validator.is_valid(changed)


def main():
    schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)

    files = sorted(pathlib.Path(sys.argv[2]).glob("*.json"))
    faults = [f"{file.name}: {error.json_path}: {error.message}"
              for file in files for error in validator.iter_errors(json.loads(file.read_text()))]

    curtain = json.loads((pathlib.Path(sys.argv[2]) / "curtain.json").read_text())
    must_refuse = {
        "no step": lambda s: s.pop("step"),
        "unknown key": lambda s: s.update(colour="red"),
        "unknown field": lambda s: s["cloth_grid"].update(collumns=3),
        "negative stiffness": lambda s: s["cloth_grid"].update(stretch=-1),
        "material without a modulus": lambda s: s["cloth_grid"].update(law={"tensile_sheet": {}}),
        "text for a number": lambda s: s.update(step="short"),
        "pin without a place": lambda s: s["pins"].append({"cloth_grid": 0}),
        "a function": lambda s: s["effects"].update(field={"shape": {"callback": {}}}),
    }
    faults += [f"not refused: {what}" for what, change in must_refuse.items() if not refused(validator, curtain, change)]

    print("\n".join(faults) or f"{len(files)} scenes agree with the schema")
    return 1 if faults or not files else 0


sys.exit(main())
