# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""What pickle and copy call."""
from ._native import SuperpixelGWatershed


def restore(parameters: str) -> SuperpixelGWatershed:
    """A new object with the parameters that write() gave."""
    gws = SuperpixelGWatershed()
    gws.read(parameters)
    return gws
