# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""What pickle and copy call."""
from typing import Type

from ._native import SuperpixelGWatershed


def restore(kind: Type[SuperpixelGWatershed], parameters: str) -> SuperpixelGWatershed:
    """A new object of the class, or of one that was derived from it, with the parameters that write() gave."""
    gws = SuperpixelGWatershed.__new__(kind)
    SuperpixelGWatershed.__init__(gws)
    SuperpixelGWatershed.read(gws, parameters)
    return gws
