# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Where the tiles lie, and in which order they may be done.

The image is cut into square tiles. A tile is segmented in its window, which is larger by a margin of several
superpixels on each side. Tiles have four phases, those of a checkerboard with even and odd rows and columns:

    0 1 0 1
    2 3 2 3
    0 1 0 1

A tile waits for its neighbours of earlier phases, and leaves alone what they have labelled. Windows of one phase lie
apart, and so do the chunks of the store that they touch. So which worker does a tile, and when, changes nothing.
"""
from dataclasses import dataclass
from typing import List, Tuple

MARGIN_IN_SUPERPIXELS = 4


@dataclass(frozen=True)
class Window:
    top: int
    left: int
    bottom: int
    right: int

    @property
    def slices(self) -> Tuple[slice, slice]:
        return slice(self.top, self.bottom), slice(self.left, self.right)

    @property
    def shape(self) -> Tuple[int, int]:
        return self.bottom - self.top, self.right - self.left

    def within(self, outer: "Window") -> Tuple[slice, slice]:
        """Its slices in an array that begins where the outer window does."""
        return (slice(self.top - outer.top, self.bottom - outer.top),
                slice(self.left - outer.left, self.right - outer.left))


@dataclass(frozen=True)
class Tiling:
    height: int
    width: int
    tile_size: int
    margin: int

    @staticmethod
    def of(height: int, width: int, tile_size: int, region_size: int) -> "Tiling":
        margin = MARGIN_IN_SUPERPIXELS * region_size
        if tile_size % 4 or tile_size < 4 * margin:
            raise ValueError("tile_size must be a multiple of 4, and at least %d times region_size, not %d"
                             % (4 * MARGIN_IN_SUPERPIXELS, tile_size))
        return Tiling(height, width, tile_size, margin)

    @property
    def chunk(self) -> int:
        """Side of the store's chunks. A margin is no larger, so that windows of one phase share no chunk."""
        return self.tile_size // 4

    @property
    def rows(self) -> int:
        return -(-self.height // self.tile_size)

    @property
    def columns(self) -> int:
        return -(-self.width // self.tile_size)

    def __len__(self) -> int:
        return self.rows * self.columns

    def place(self, tile: int) -> Tuple[int, int]:
        return divmod(tile, self.columns)

    def phase(self, tile: int) -> int:
        row, column = self.place(tile)
        return 2 * (row % 2) + column % 2

    def in_order(self) -> List[int]:
        """All tiles; each comes after those that it waits for."""
        return sorted(range(len(self)), key=lambda tile: (self.phase(tile), tile))

    def earlier_neighbours(self, tile: int) -> List[int]:
        row, column = self.place(tile)
        around = [(r, c) for r in range(max(row - 1, 0), min(row + 2, self.rows))
                  for c in range(max(column - 1, 0), min(column + 2, self.columns))]
        tiles = [r * self.columns + c for r, c in around]
        return [other for other in tiles if self.phase(other) < self.phase(tile)]

    def core(self, tile: int) -> Window:
        return self._window(tile, 0)

    def window(self, tile: int) -> Window:
        return self._window(tile, self.margin)

    def _window(self, tile: int, margin: int) -> Window:
        row, column = self.place(tile)
        size = self.tile_size
        return Window(max(row * size - margin, 0), max(column * size - margin, 0),
                      min((row + 1) * size + margin, self.height), min((column + 1) * size + margin, self.width))
