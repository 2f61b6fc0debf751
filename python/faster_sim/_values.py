"""Values of keys and options, as the program reads them."""

import json
import os
import re
from numbers import Real
from typing import Iterable, Mapping

import numpy

from faster_sim._core import InputError


def overrides(values: Mapping[str, object]) -> list[str]:
    """As --set has them. "__" stands for "." in names that are written as Python's keyword arguments."""
    return [f"{_key(name)}={as_yaml(value)}" for name, value in values.items()]


def settings(values: Mapping[str, object]) -> list[str]:
    """Options of the program that set keys."""
    return [word for setting in overrides(values) for word in ("--set", setting)]


def words(more: Mapping[str, object]) -> list[str]:
    """Options of the program: names with "." or "__" are keys, for --set; others are options, vcd_samples="0-3" for
    --vcd-samples 0-3."""
    said = []
    for name, value in more.items():
        if _is_key(name):
            said += settings({name: value})
        elif isinstance(value, (bool, numpy.bool_)):
            said += [_option(name)] if value else []
        elif value is not None:
            said += [_option(name), *_texts(value)]
    return said


def number(name: str, value: object, most: int, whole: bool = False) -> float:
    """An argument that is one, from 0 on. A text or a truth value is none."""
    is_one = isinstance(value, Real) and not isinstance(value, bool) and 0 <= value <= most
    if is_one and (not whole or float(value).is_integer()):  # type: ignore[arg-type]
        return float(value)  # type: ignore[arg-type]
    raise InputError(f"{name} = {value!r}, expected a {'whole ' if whole else ''}number from 0 to {most}")


def as_yaml(value: object) -> str:
    """NumPy's scalars are as Python's, its arrays as lists; a number that is whole is written as one."""
    if isinstance(value, numpy.ndarray):
        return as_yaml(value.tolist())
    if isinstance(value, numpy.generic):
        value = value.item() if value.dtype.kind != "f" else float(str(value))
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return str(int(value)) if value.is_integer() and abs(value) < 2**53 else repr(value)
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(_item(one) for one in value) + "]"
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (int, str)):
        return str(value)
    raise InputError(f"{value!r} is of type {type(value).__name__}, expected a number, a boolean, a text, or a list of them")


def _item(value: object) -> str:
    text = as_yaml(value)
    return json.dumps(text) if isinstance(value, str) and not re.fullmatch(r"[\w./-]+", text) else text


def _is_key(name: str) -> bool:
    return "." in name or "__" in name


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise InputError(f"{name!r} is of type {type(name).__name__}, expected the name of a key")
    return name.replace("__", ".")


def _option(name: str) -> str:
    return "--" + name.replace("_", "-")


def _texts(value: object) -> Iterable[str]:
    if isinstance(value, (list, tuple, range, numpy.ndarray)):
        return [",".join(as_yaml(one) for one in value)]
    return [as_yaml(value)]
