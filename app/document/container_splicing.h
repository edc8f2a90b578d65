// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_marks.h"
#include "app/document/container_table.h"
#include "app/document/object_ranges.h"

#include <vector>

namespace app {

/// Inserts and removes objects in a run of consecutive marks of a container tree. The places must
/// be visited from last to first, so that the numbers of the objects below do not change. Each mark
/// is passed a bounded number of times, whatever the number of places.
class ContainerSplicing {
public:
    /// The last of `marks` must keep the first object above all places, or be the last mark of the
    /// tree. `end`: the number of objects up to the end of the last mark.
    ContainerSplicing(const ContainerTable& table, std::vector<ContainerMark> marks,
                      std::size_t end);

    /// Added objects go into the container of the first removed object or, if none is removed, into
    /// `into`. The tree does not change if the splice adds as many objects as it removes and all of
    /// them are in one container.
    void splice(const Splice& s, ContainerId into);
    /// Added objects go into `into`, which must contain or touch the place, above the containers
    /// without objects there.
    void exchange(std::size_t first, std::size_t removed, std::size_t added, ContainerId into);

    bool changed() const { return changed_; }
    /// The resulting marks, without the groups that lost their last object. Appends these groups,
    /// and the groups inside them, to `gone`.
    std::vector<ContainerMark> take(std::vector<ContainerId>& gone) const;

private:
    struct Owner {
        ContainerId lowest = 0;
        bool onlyOne = true;
    };

    ContainerId ownerOf(const ContainerMark& mark) const;
    Owner ownerFrom(std::size_t first) const;
    void step();
    void goBelow(std::size_t object);

    const ContainerTable& table_;
    std::vector<ContainerMark> marks_;
    std::vector<bool> lost_;  ///< whether the mark has lost objects
    std::size_t at_;          ///< the mark at the current place
    std::size_t start_, end_; ///< its objects not yet passed, in the old numbering
    std::size_t top_;         ///< the first mark that keeps objects above the current place
    bool changed_ = false;
};

} // namespace app
