// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

#include <map>
#include <set>
#include <vector>

namespace app {

/// One row of the tree of layers, groups and objects.
struct TreeRow {
    enum class Kind : std::uint8_t { Layer, Group, Object, More };
    Kind kind = Kind::Layer;
    ContainerId container = 0; ///< the layer or group; of Object and More: the one around it
    std::size_t number = 0;    ///< of Object; of More: how many objects are left out
    int depth = 1;             ///< 1 on the first level
    friend bool operator==(const TreeRow&, const TreeRow&) = default;
};

/// Which layers and groups of a tree are open, and the rows that this gives: what is painted above
/// comes first. Layers are always shown, also those in layers; an open one shows its groups and
/// objects as well, at first some of them.
class ObjectTree {
public:
    static constexpr std::size_t atFirst = 500; ///< groups and objects of one container

    std::vector<TreeRow> rows(const Containers& containers) const;

    bool isOpen(ContainerId id) const { return open_.contains(id); }
    bool isAnyOpen() const { return !open_.empty(); }
    void setOpen(ContainerId id, bool open);
    void showMore(ContainerId id); ///< as many again of its groups and objects

    /// Opens what is around an object, or around a group, and closes what was opened for the one
    /// before. It ends at the first layer or group of which only others are shown: a list of
    /// thousands would hide the layers. Returns whether anything was opened or closed.
    bool revealObject(const Containers& containers, std::size_t object);
    bool revealGroup(const Containers& containers, ContainerId group);
    bool conceal();                  ///< closes what was opened for the last one
    void keep() { opened_.clear(); } ///< or leaves it open
    void forgetGone(const Containers& containers);

private:
    struct Growing;
    void append(Growing& growing, ContainerId id, int depth) const;
    std::size_t most(ContainerId id) const;
    bool reveal(const Containers& containers, ContainerId around, std::size_t object);
    bool shows(const Containers& containers, ContainerId id, std::size_t object) const;

    std::set<ContainerId> open_, opened_;       ///< opened_: for what was revealed last
    std::map<ContainerId, std::size_t> most_{}; ///< where more than at first are shown
};

} // namespace app
