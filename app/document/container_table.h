// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"
#include "app/document/container.h"

#include <memory>
#include <vector>

namespace app {

/// What is known of each container, by its id. It is kept in blocks that copies share.
class ContainerTable {
public:
    struct Entry {
        std::shared_ptr<const Container> container{}; ///< null: there is none of this id
        ContainerId parent = 0;
        /// Numbers that ascend in painting order, of its two marks: these are found by
        /// them, wherever others come and go.
        std::uint64_t opens = 0, closes = 0;
        /// The same container in the same place.
        friend bool operator==(const Entry& a, const Entry& b)
        {
            return a.parent == b.parent
                   && (a.container == b.container || *a.container == *b.container);
        }
    };

    ContainerTable(); ///< with id 0, the document

    ContainerId end() const { return end_; } ///< the id that `add` gives
    bool contains(ContainerId id) const
    {
        return id < end_ && blocks_[id / size]->at(id % size).container;
    }
    const Entry& operator[](ContainerId id) const { return (*blocks_[id / size])[id % size]; }
    Entry& own(ContainerId id) { return blocks_[id / size].own()[id % size]; } ///< to write to
    /// The document takes layers only, a layer layers and groups, a group groups only.
    bool mayHold(ContainerId around, Container::Kind kind) const
    {
        const bool isGroup =
            around != 0 && (*this)[around].container->kind == Container::Kind::Group;
        return kind == Container::Kind::Layer ? !isGroup : around != 0;
    }
    void setContainer(Container container); ///< of that id
    ContainerId add(Container container, ContainerId parent);
    void remove(ContainerId id) { own(id) = {}; } ///< it is not given again
    /// Bytes of the heap that it keeps alive and `other`, of the same document, does not.
    std::size_t bytesNotIn(const ContainerTable& other) const;
    void startIdsAt(ContainerId id); ///< `add` gives this one next, unless it is beyond it

private:
    static constexpr std::size_t size = 256;
    using Block = std::vector<Entry>; ///< of `size` entries

    static const Shared<Block>& unused(); ///< of ids that were never given, or not by this one

    std::vector<Shared<Block>> blocks_;
    ContainerId end_ = 0;
};

} // namespace app
