"""Exceptions of the package."""

from __future__ import annotations


class InputError(ValueError):
    """A recipe, or an argument in its place, that cannot be used.

    Attributes:
        message: what is wrong.
        file: the file, "<text>" or "<dict>"; None for an argument.
        key: the key in the recipe, as "food[0].size_mm"; None where it is no key's fault.
        remedy: what to write instead.
        line: the line in the file, from 1; None for a dict.
    """

    def __init__(self, message, file=None, key=None, remedy="", line=None):
        self.message, self.file, self.key, self.remedy, self.line = message, file, key, remedy, line
        super().__init__(message, file, key, remedy, line)

    def __str__(self):
        place = self.file or ""
        if self.line is not None:
            place += f":{self.line}"
        if self.key and self.key not in self.message:
            place += f" {self.key}" if place else self.key
        text = f"{place}: {self.message}" if place else self.message
        return f"{text}\n  remedy: {self.remedy}" if self.remedy else text


class RefusedError(RuntimeError):
    """A command that the kitchen does not take; the kitchen is unchanged. The text states why and what to do."""


class SnapshotError(ValueError):
    """Bytes that are no kitchen of this version of saute. The text states why."""


class GraphicsError(RuntimeError):
    """No picture can be drawn: there is no graphics driver. Everything but pictures works without one."""
