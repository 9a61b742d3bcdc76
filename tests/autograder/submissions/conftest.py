"""The submissions that these tests make."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from staging import HandIn


@pytest.fixture(params=["make_folder", "make_zip"])
def hand_in(request: pytest.FixtureRequest, tmp_path: Path) -> HandIn:
    """Make a submission of files by path, once as a folder and once as a zip."""
    import staging  # tests/helpers/ is on the path only once pytest is configured

    return lambda files: getattr(staging, request.param)(tmp_path, files)
