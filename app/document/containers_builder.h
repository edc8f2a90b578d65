// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

namespace app {

/// Builds a container tree from bottom to top, for file readers. O(1) a call.
class ContainersBuilder {
public:
    ContainersBuilder();

    /// Whether another container can be opened here without exceeding `Containers::mostContainers`
    /// containers or `Containers::deepest` containers around an object.
    bool canOpen() const;
    /// Opens a container inside the current one and returns its id; the id in `container` is
    /// ignored. Requires `canOpen()`. The first level holds only layers, and groups hold only
    /// groups.
    ContainerId open(Container container);
    /// Adds objects to the current container, above its content; a container must be open.
    void addObjects(std::size_t count = 1);
    void close();                                       ///< closes the current container
    int depth() const { return int(open_.size()) - 1; } ///< the number of open containers
    /// Returns the tree; all containers must be closed. Without a layer it gets the layer that
    /// `Containers()` has. The builder cannot be used afterwards.
    Containers take();

private:
    std::vector<ContainerMark> marks_;
    ContainerTable table_;
    std::vector<ContainerId> open_; ///< 0 and the open containers
    std::size_t count_ = 0;
};

/// A group to be made around consecutive objects, which lie directly in one container and have no
/// other container between them.
struct NewGroup {
    ObjectRange objects;
    Container group; ///< its id is ignored
};

/// The tree with these groups, whose objects ascend. Empty if there would be too many containers,
/// or more around an object than `Containers::deepest`. O(containers + groups).
std::optional<Containers> withGroups(const Containers& tree, std::span<const NewGroup> groups);

} // namespace app
