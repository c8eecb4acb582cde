# SPDX-License-Identifier: MIT
"""Prints the name of each .json file of a folder that a JSON Schema refuses, a tab, and why. Arguments: the schema, the folder.
Exits with 77 where the validator is not installed."""
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for file in sorted(pathlib.Path(sys.argv[2]).glob("*.json")):
    error = jsonschema.exceptions.best_match(validator.iter_errors(json.loads(file.read_text())))
    if error is not None:
        print(f"{file.name}\t/{'/'.join(map(str, error.absolute_path))}: {' '.join(error.message.split())[:300]}")
