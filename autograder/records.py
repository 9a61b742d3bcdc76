"""Convert dataclasses to plain data for JSON. msgspec reads what is stored in files again."""

from __future__ import annotations

from dataclasses import MISSING, fields, is_dataclass
from enum import Enum
from typing import Any


def to_json(value: Any) -> Any:
    """Convert a dataclass to plain lists and dictionaries for json.dumps.

    Fields that have their default value are omitted, to keep the JSON short.
    """
    if is_dataclass(value) and not isinstance(value, type):
        data = {}
        for field in fields(value):
            made = field.default_factory
            own = getattr(value, field.name)
            if own != (field.default if made is MISSING else made()):
                data[field.name] = to_json(own)
        return data
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, (list, tuple)):
        return [to_json(item) for item in value]
    if isinstance(value, dict):
        return {key: to_json(item) for key, item in value.items()}
    if type(value) is float and value.is_integer():
        return int(value)  # 3 and 3.0 are equal, and a result that was read again has 3.0
    return value
