// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_marks.h"
#include "app/document/container_table.h"
#include "app/document/splice.h"

#include <vector>

namespace app {

/// Marks of a tree that follow each other, while objects leave and come among them. The places are
/// visited from the last one to the first, so that the numbers of the objects below stay. However
/// many they are, each mark is passed a few times at most.
class ContainerSplicing {
public:
    /// The last of the marks keeps the first object above all places, or is the last of the tree.
    /// `end`: how many objects there are up to the end of the last mark.
    ContainerSplicing(const ContainerTable& table, std::vector<ContainerMark> marks,
                      std::size_t end);

    /// What the splice adds goes to the container of the first object that it removes; where it
    /// removes none, into `into`. The tree stays as it is if as many come as go, all of one
    /// container.
    void splice(const Splice& s, ContainerId into);
    /// What is added goes `into` a container that has or touches the place, above the containers
    /// without objects there.
    void exchange(std::size_t first, std::size_t removed, std::size_t added, ContainerId into);

    bool changed() const { return changed_; }
    /// The marks without the groups that have lost their last object. Adds to `gone` these groups,
    /// and those in them.
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
    std::vector<bool> lost_;  ///< whether a mark has lost objects
    std::size_t at_;          ///< the mark at the present place
    std::size_t start_, end_; ///< its objects that are not passed yet, as they were numbered before
    std::size_t top_;         ///< the first mark that keeps objects above the present place
    bool changed_ = false;
};

} // namespace app
