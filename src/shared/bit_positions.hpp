// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BIT_POSITIONS_HPP
#define OPENCV_GWATERSHED_BIT_POSITIONS_HPP

#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Of each eight bits: how many are set, and where, one after the other.
struct BitPositions
{
    BitPositions() : positions(), counts()
    {
        for (int bits = 0; bits < 256; bits++)
            for (int i = 0; i < 8; i++)
                if ((bits >> i) & 1)
                    positions[bits][counts[bits]++] = unsigned(i);
    }

    unsigned positions[256][8];
    uchar counts[256];
};

inline const BitPositions& bitPositions()
{
    static const BitPositions table;
    return table;
}

//! Writes first + (p << SHIFT) for the positions p of the bits that are set, in order, and others behind them: eight
//! numbers each time. Returns the end. Lists are made by it without branches that nobody can foresee.
template <int SHIFT> inline int* writePositions(const BitPositions& table, unsigned bits, int first, int* to)
{
    const v_uint32x4 start = v_setall_u32(unsigned(first));
    const unsigned* positions = table.positions[bits];
    v_store(reinterpret_cast<unsigned*>(to), add(start, v_shl<SHIFT>(v_load(positions))));
    v_store(reinterpret_cast<unsigned*>(to + 4), add(start, v_shl<SHIFT>(v_load(positions + 4))));
    return to + table.counts[bits];
}

}}} // namespace

#endif
