#!/usr/bin/env python3
"""check_sarif.py FILE: that a log is SARIF 2.1.0 as far as graze-fuzz writes it.

Against the members that OASIS' schema requires and the values that it allows (the schema is not kept here),
by jsonschema where that is installed, by hand otherwise."""
import json
import sys

TEXT = {"type": "object", "required": ["text"], "properties": {"text": {"type": "string", "minLength": 1}}}
LEVEL = {"enum": ["none", "note", "warning", "error"]}
RESULT = {
    "type": "object",
    "required": ["message", "ruleId"],
    "additionalProperties": False,
    "properties": {
        "ruleId": {"type": "string"},
        "ruleIndex": {"type": "integer", "minimum": -1},
        "kind": {"enum": ["notApplicable", "pass", "fail", "review", "open", "informational"]},
        "level": LEVEL,
        "message": TEXT,
        "locations": {"type": "array", "items": {
            "type": "object", "required": ["physicalLocation"], "properties": {"physicalLocation": {
                "type": "object", "required": ["artifactLocation"], "properties": {
                    "artifactLocation": {"type": "object", "properties": {
                        "uri": {"type": "string", "pattern": r"^[A-Za-z0-9._~/%:-]+$"}}},
                    "region": {"type": "object", "properties": {
                        "startLine": {"type": "integer", "minimum": 1}}}}}}}},
        "partialFingerprints": {"type": "object", "additionalProperties": {"type": "string"}},
        "baselineState": {"enum": ["new", "unchanged", "updated", "absent"]},
        "properties": {"type": "object"},
    },
}
SCHEMA = {
    "type": "object",
    "required": ["version", "runs"],
    "additionalProperties": False,
    "properties": {
        "$schema": {"type": "string"},
        "version": {"enum": ["2.1.0"]},
        "runs": {"type": "array", "minItems": 1, "items": {
            "type": "object",
            "required": ["tool"],
            "additionalProperties": False,
            "properties": {
                "tool": {"type": "object", "required": ["driver"], "properties": {"driver": {
                    "type": "object", "required": ["name"], "properties": {
                        "name": {"type": "string"},
                        "version": {"type": "string"},
                        "rules": {"type": "array", "uniqueItems": True, "items": {
                            "type": "object", "required": ["id"], "properties": {
                                "id": {"type": "string"}, "shortDescription": TEXT,
                                "defaultConfiguration": {"type": "object", "properties": {"level": LEVEL}}}}}}}}},
                "invocations": {"type": "array", "items": {
                    "type": "object", "required": ["executionSuccessful"],
                    "properties": {"executionSuccessful": {"type": "boolean"}}}},
                "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
                "results": {"type": "array", "items": RESULT},
                "properties": {"type": "object"},
            },
        }},
    },
}
TYPES = {"object": dict, "array": list, "string": str, "integer": int, "boolean": bool}


def wrong(value, schema, place):
    """What is wrong with it, by the few words of a schema that are used above."""
    if "enum" in schema:
        return [] if value in schema["enum"] else [f"{place}: {value!r} is none of {schema['enum']}"]
    if not isinstance(value, TYPES[schema["type"]]):
        return [f"{place}: not of type {schema['type']}"]
    faults = [f"{place}: no {m}" for m in schema.get("required", []) if m not in value]
    if isinstance(value, dict):
        known = schema.get("properties", {})
        for member, inner in value.items():
            if member in known:
                faults += wrong(inner, known[member], f"{place}.{member}")
            elif schema.get("additionalProperties") is False:
                faults.append(f"{place}: a member {member} that it has not")
    if isinstance(value, list):
        for i, inner in enumerate(value):
            faults += wrong(inner, schema.get("items", {"enum": [inner]}), f"{place}[{i}]")
    if isinstance(value, int) and value < schema.get("minimum", value):
        faults.append(f"{place}: {value} is too small")
    return faults


log = json.load(open(sys.argv[1], encoding="utf-8"))
faults = wrong(log, SCHEMA, "log")
try:
    import jsonschema
    faults += [e.message for e in jsonschema.Draft7Validator(SCHEMA).iter_errors(log)]
except ImportError:
    pass
print("\n".join(faults[:20]) or "valid")
sys.exit(1 if faults else 0)
