"""A module a section of the report: NAME, TITLE, TARGETS, measure(context), show(data); see main.py."""
