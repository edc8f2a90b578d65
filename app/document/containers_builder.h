// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

namespace app {

/// Puts a tree together from the bottom up, for readers. O(1) a call.
class ContainersBuilder {
public:
    ContainersBuilder();

    /// Whether one more can be opened here: there would be no more than
    /// `Containers::mostContainers`, and no more than `Containers::deepest` around an object.
    bool canOpen() const;
    /// Opens a container in the one that is open. `canOpen()` must hold; the first level takes
    /// layers only, groups take groups only. Gives its id; the one in `container` does not matter.
    ContainerId open(Container container);
    /// Adds objects to the container that is open, above all that is in it; there must be one.
    void addObjects(std::size_t count = 1);
    void close();                                       ///< the container that is open
    int depth() const { return int(open_.size()) - 1; } ///< how many are open
    /// The tree; all must be closed. Without a layer it gets the one that `Containers()` has. Start
    /// with another builder then.
    Containers take();

private:
    std::vector<ContainerMark> marks_;
    ContainerTable table_;
    std::vector<ContainerId> open_; ///< 0 and all that are open
    std::size_t count_ = 0;
};

} // namespace app
