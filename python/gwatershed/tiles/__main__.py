# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""python3 -m gwatershed.tiles is the command gwatershed-tiles."""
import sys

from .command import main

if __name__ == "__main__":
    sys.exit(main())
