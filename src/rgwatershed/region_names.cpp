// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_names.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The largest region of each group, of the regions first..end-1; -1 where it has none of them.
static void findLargest(const std::vector<int>& groups, const std::vector<int>& areas, int first, int end,
                        std::vector<int>& largest)
{
    std::fill(largest.begin(), largest.end(), -1);
    for (int i = first; i < end; i++)
    {
        int& best = largest[groups[i]];
        if (best < 0 || areas[i] > areas[best])
            best = i;
    }
}

void nameGroups(const std::vector<int>& parents, const std::vector<int>& areas, const std::vector<int>& names,
                int num_kept, std::vector<int>& labels)
{
    const int NONE = -1;
    std::vector<int> groups;
    const int num_groups = numberRegions(parents, groups), n = int(parents.size());
    std::vector<int> name(num_groups, int(NONE)), largest(num_groups);
    std::vector<uchar> taken(num_groups, uchar(0));
    for (int pass = 0; pass < 2; pass++)
    {
        findLargest(groups, areas, pass ? num_kept : 0, pass ? n : num_kept, largest);
        for (int g = 0; g < num_groups; g++)
            if (name[g] == NONE && largest[g] >= 0 && !taken[names[largest[g]]])
            {
                name[g] = names[largest[g]];
                taken[name[g]] = 1;
            }
    }
    int free = 0; // labels below it are taken
    for (int g = 0; g < num_groups; g++)
    {
        if (name[g] != NONE)
            continue;
        while (taken[free])
            free++;
        name[g] = free++;
    }
    labels.resize(n);
    for (int i = 0; i < n; i++)
        labels[i] = name[groups[i]];
}

}}} // namespace
