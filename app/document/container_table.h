// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"
#include "app/document/underlay.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <vector>

namespace app {

/// Identifies a container during the life of its document; 0 is the document itself.
using ContainerId = std::uint32_t;

/// A layer or a group.
struct Container {
    enum class Kind : std::uint8_t { Layer, Group };
    ContainerId id = 0;
    Kind kind = Kind::Layer;
    QString name{};                 ///< shown to people
    QString svgId{};                ///< the SVG id; unique in a document, may be empty
    QString title{}, description{}; ///< XML, in the form that About describes
    /// The style of new objects as CSS declarations (app/formats/svg/style_text.h); empty: none.
    QString newStyle{};
    bool visible = true;
    bool locked = false;
    SharedUnderlay underlay{}; ///< of a layer: the image below what is in it
    friend bool operator==(const Container&, const Container&) = default;
};

/// The data of each container, by id. Copies share the blocks of entries.
class ContainerTable {
public:
    struct Entry {
        std::shared_ptr<const Container> container{}; ///< null: no container has this id
        ContainerId parent = 0;
        /// The labels of its opening and closing marks. Labels ascend in painting order, so they
        /// locate the marks after any insertion or removal.
        std::uint64_t opens = 0, closes = 0;
        /// The same container with the same parent.
        friend bool operator==(const Entry& a, const Entry& b)
        {
            return a.parent == b.parent
                   && (a.container == b.container || *a.container == *b.container);
        }
    };

    ContainerTable(); ///< contains only id 0, the document

    ContainerId end() const { return end_; } ///< the id that `add` will return
    bool contains(ContainerId id) const
    {
        return id < end_ && blocks_[id / size]->at(id % size).container;
    }
    const Entry& operator[](ContainerId id) const { return (*blocks_[id / size])[id % size]; }
    Entry& own(ContainerId id) { return blocks_[id / size].own()[id % size]; } ///< for writing
    /// The document may hold only layers; a layer holds layers and groups; a group holds only
    /// groups.
    bool mayHold(ContainerId around, Container::Kind kind) const
    {
        const bool isGroup =
            around != 0 && (*this)[around].container->kind == Container::Kind::Group;
        return kind == Container::Kind::Layer ? !isGroup : around != 0;
    }
    void setContainer(Container container); ///< replaces the container with the same id
    ContainerId add(Container container, ContainerId parent);
    void remove(ContainerId id);                         ///< the id is never reused
    std::size_t underlaid() const { return underlaid_; } ///< how many have an underlay
    /// The heap bytes that this table keeps alive and `other`, of the same document, does not.
    std::size_t bytesNotIn(const ContainerTable& other) const;
    void startIdsAt(ContainerId id); ///< `add` returns at least `id` next

private:
    static constexpr std::size_t size = 256;
    using Block = std::vector<Entry>; ///< `size` entries

    static const Shared<Block>& unused(); ///< a block of ids that are not in use

    std::vector<Shared<Block>> blocks_;
    ContainerId end_ = 0;
    std::size_t underlaid_ = 0;
};

} // namespace app
