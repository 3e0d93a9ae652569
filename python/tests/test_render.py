"""Pictures by the program's own renderer; a clear error where there is no graphics driver."""

import os
import subprocess
import sys

import numpy as np
import pytest

import saute


def test_a_picture_shows_what_it_is_asked_for(frying):
    try:
        look = frying.render((96, 64))
    except saute.GraphicsError as error:
        pytest.skip(str(error))
    assert look.shape == (64, 96, 3) and look.dtype == np.uint8 and not look.flags.writeable
    assert np.array_equal(look, frying.render(size=(96, 64)))
    others = [
        frying.render((96, 64), view="temperature"),
        frying.render((96, 64), camera="above"),
        frying.render((96, 64), camera=(60, 20, 400)),
        frying.render((96, 64), slice=True),
    ]
    assert all(not np.array_equal(look, other) for other in others)


def test_without_a_driver_only_pictures_fail():
    """A separate process that finds no driver: it cooks, and its picture is refused with what is missing."""
    code = (
        "import saute\n"
        "kitchen = saute.Kitchen('medium', coarseness=6)\n"
        "kitchen.step(3)\n"
        "try:\n"
        "    kitchen.render((64, 48))\n"
        "except saute.GraphicsError as error:\n"
        "    print('refused:', error)\n"
    )
    hidden = {"VK_DRIVER_FILES": "/nowhere.json", "VK_ICD_FILENAMES": "/nowhere.json", "WGPU_BACKEND": "vulkan"}
    environment = {**os.environ, **hidden, "LIBGL_DRIVERS_PATH": "/nowhere", "__EGL_VENDOR_LIBRARY_FILENAMES": "/nowhere"}
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert "refused:" in said.stdout and "Vulkan driver" in said.stdout, said.stdout + said.stderr
