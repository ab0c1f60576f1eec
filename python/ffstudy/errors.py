"""What goes wrong, as exceptions."""

import re

_PLACE = re.compile(r"(?P<file>[^:\n]+):(?P<line>\d+):(?:(?P<column>\d+):)? ")


class Error(Exception):
    """Every error of ffstudy."""


class InputError(Error, ValueError):
    """Input that can be corrected: the message says where, what is wrong, why, and what to do.

    `file`, `line` and `column` are those of the message (from 1), or None where it names none.
    """

    def __init__(self, message):
        super().__init__(message)
        place = _PLACE.match(message)
        self.file = place["file"] if place else None
        self.line = int(place["line"]) if place else None
        self.column = int(place["column"]) if place and place["column"] else None


class FileError(Error, OSError):
    """A file that cannot be read or written, or a program that cannot be run."""
