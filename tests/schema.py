# SPDX-License-Identifier: MIT
"""Checks a JSON file against one object of a schema: schema.py SCHEMA OBJECT FILE; or only the schema: schema.py SCHEMA

Fails if the file is not strict JSON, is not that object, or is not one of those that the schema as
a whole allows. Fails, too, if the schema would accept a mistake: in turn, every object gets a surplus
member, every member another name, and every value another type; the schema must refuse each.
"""

import copy
import json
import sys

import jsonschema


def members_once(pairs):
    names = [name for name, _ in pairs]
    if len(set(names)) < len(names):
        raise ValueError("a duplicate member")
    return dict(pairs)


def no_constant(word):
    raise ValueError(word + " is not JSON")


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file, object_pairs_hook=members_once, parse_constant=no_constant)


def places(value, path=()):
    """The path of the value and of everything inside; of a list the first three, as all must be alike."""
    yield path
    if isinstance(value, (dict, list)):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value[:3]):
            yield from places(item, path + (key,))


def at(value, path):
    for step in path:
        value = value[step]
    return value


def mistakes(value):
    """Copies with one mistake each, and its path."""
    for path in places(value):
        if isinstance(at(value, path), dict):
            wrong = copy.deepcopy(value)
            at(wrong, path)["surplus"] = 0
            yield path, wrong
        if path:
            wrong = copy.deepcopy(value)
            at(wrong, path[:-1])[path[-1]] = {"no": "such value"}
            yield path, wrong
        if path and isinstance(at(value, path[:-1]), dict):
            wrong = copy.deepcopy(value)
            parent = at(wrong, path[:-1])
            parent[path[-1] + "s"] = parent.pop(path[-1])
            yield path, wrong


def main(schema_path, name=None, path=None):
    schema = read(schema_path)
    if name is None:
        jsonschema.Draft202012Validator.check_schema(schema)
        return 0
    whole = jsonschema.Draft202012Validator(schema)
    one = jsonschema.Draft202012Validator({"$defs": schema["$defs"], "$ref": "#/$defs/" + name})
    value = read(path)
    errors = [e.json_path + ": " + e.message for e in one.iter_errors(value)]
    if not errors and not whole.is_valid(value):
        errors = ["the schema as a whole does not allow " + name + ", or allows more than one object here"]
    if not errors:
        errors = [
            "the schema accepts a mistake at " + "/".join(map(str, path))
            for path, wrong in mistakes(value)
            if one.is_valid(wrong)
        ]
    for error in errors[:5]:
        print(path + ": " + error[:300], file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    try:
        sys.exit(main(*sys.argv[1:]))
    except ValueError as error:
        sys.exit(sys.argv[-1] + ": " + str(error))
