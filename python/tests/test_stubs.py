"""The type stubs name what the package has, no less and no more, and everything is documented."""

import ast
import pathlib

import pytest

import saute

STUBS = ast.parse((pathlib.Path(saute.__file__).parent / "__init__.pyi").read_text(encoding="utf-8"))
CLASSES = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}
KEPT = {"__init__", "__getitem__", "__setitem__", "__len__", "__contains__", "__getattr__"}


def stated(name):
    return {node.name for node in CLASSES[name].body if isinstance(node, ast.FunctionDef)} - KEPT


@pytest.mark.parametrize("name", ["Kitchen", "Piece", "KitchenBatch", "Summary"])
def test_the_stubs_of_a_class_name_what_it_has(name):
    found = {member for member in vars(getattr(saute, name)) if not member.startswith("_")}
    assert stated(name) == found


def test_the_stubs_name_every_name_of_the_package():
    functions = {node.name for node in STUBS.body if isinstance(node, ast.FunctionDef)}
    values = {node.target.id for node in STUBS.body if isinstance(node, ast.AnnAssign)}
    assert functions | values | set(CLASSES) == set(saute.__all__)


@pytest.mark.parametrize("name", ["Kitchen", "Piece", "KitchenBatch", "Summary"])
def test_every_member_says_what_it_is(name):
    silent = [member for member in stated(name) if not getattr(getattr(saute, name), member).__doc__]
    assert silent == []
