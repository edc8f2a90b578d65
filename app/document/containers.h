// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_marks.h"
#include "app/document/container_table.h"
#include "app/document/object_ranges.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace app {

/// The tree of layers and groups of a document. It stores how many objects each container has, in
/// painting order; the objects themselves are stored elsewhere.
///
/// The first level consists of layers, at least one, and only layers lie directly in the document.
/// Layers can lie in layers, groups anywhere except on the first level. A container may have
/// objects below, between and above its child containers.
///
/// A value type: each edit returns a new tree that shares all unchanged parts, so the trees of a
/// whole history use little memory. Queries take O(log containers) or O(depth) steps unless stated
/// otherwise; edits take O(containers / 256).
class Containers {
public:
    static constexpr std::size_t mostContainers = 100'000;
    static constexpr std::size_t mostLayers = 1000; ///< readers merge further layers into the last
    static constexpr int deepest = 500; ///< the largest number of containers around an object

    Containers(); ///< one layer, named "Drawing", without objects

    std::size_t size() const { return count_; }              ///< the number of containers
    std::size_t objects() const { return marks_.objects(); } ///< in all of them
    bool contains(ContainerId id) const { return table_.contains(id); }
    const Container& operator[](ContainerId id) const { return *table_[id].container; }
    /// The parent of a container; 0 for layers of the first level. `id` must not be 0.
    ContainerId parentOf(ContainerId id) const { return table_[id].parent; }
    int depthOf(ContainerId id) const; ///< 1 on the first level
    /// The direct children, bottom to top; for 0 the first level. O(children · log containers).
    std::vector<ContainerId> childrenOf(ContainerId id) const;
    std::vector<ContainerId> inOrder() const;  ///< all, each before its children; bottom to top
    ObjectRange rangeOf(ContainerId id) const; ///< including objects of the containers in it
    /// Whether container `a` ends before `b` in painting order. An inner container ends before an
    /// outer one.
    bool endsBefore(ContainerId a, ContainerId b) const
    {
        return table_[a].closes < table_[b].closes;
    }
    /// The innermost container, and the innermost layer, around an existing object.
    ContainerId containerOf(std::size_t object) const;
    ContainerId layerOf(std::size_t object) const;
    bool shown(ContainerId id) const;  ///< whether it and all containers around it are visible
    bool locked(ContainerId id) const; ///< whether it or a container around it is locked
    /// The objects that a container hides, and the objects that a container locks. For loops over
    /// all objects: O(containers).
    ObjectRanges hiddenRanges() const;
    ObjectRanges lockedRanges() const;

    /// The layers with an underlay, in painting order. O(1) if there are none.
    std::vector<ContainerId> underlaid() const;
    bool isUnderlaid() const { return table_.underlaid() > 0; } ///< whether there is one

    /// The tree with `changed` in place of the container with the same id. Its kind must stay the
    /// same.
    Containers with(const Container& changed) const;
    /// Removes objects [first, first + removed), then inserts `added` objects at `first`: directly
    /// into `into`, which must contain or touch that place, above the containers without objects
    /// there. Groups that lose their last object are removed; layers stay. O(number of containers
    /// that lose objects), if that is more.
    Containers spliced(std::size_t first, std::size_t removed, std::size_t added,
                       ContainerId into) const;
    /// Applies many splices, ascending and in the old numbering. Added objects go into the
    /// container of the first removed object or, if none is removed, into `into`. The tree does not
    /// change where a splice adds as many objects as it removes and all of them are in one
    /// container. O(splices · containers / 256), and never more than O(splices + containers).
    Containers spliced(std::span<const Splice> splices, ContainerId into = 0) const;
    /// Like spliced() above, with a container for each splice. Splices at the same place must
    /// ascend by the ends of their containers.
    Containers spliced(std::span<const Splice> splices, std::span<const ContainerId> into) const;
    /// Inserts a new container into `parent`, above the first `at` children. It takes over the
    /// parent's objects [range.first, range.end) and the child containers among them: the children
    /// from `at` on that begin before range.end. An empty range gives the position of the new
    /// container among the objects. Its id is `nextId()`; the id in `container` is ignored. Empty
    /// if there would be more than `mostContainers` containers, or more than `deepest` around an
    /// object. O(children of the parent + containers taken over).
    std::optional<Containers> inserted(Container container, ContainerId parent, std::size_t at,
                                       const ObjectRange& range) const;
    /// Removes the container and moves its content into its parent, at the same place. `id` must
    /// not be a layer of the first level. O(children).
    Containers dissolved(ContainerId id) const;
    /// Removes the container with its content, including objects. `id` must not be the last layer
    /// of the first level. O(containers in it).
    Containers removed(ContainerId id) const;
    /// The id that `inserted` will use: larger than all ids in this tree and in the trees it was
    /// edited from.
    ContainerId nextId() const { return table_.end(); }
    /// Makes the next id at least `id`.
    void startIdsAt(ContainerId id) { table_.startIdsAt(id); }

    /// The heap bytes that this tree keeps alive and `other`, of the same document, does not.
    std::size_t bytesNotIn(const Containers& other) const
    {
        return marks_.bytesNotIn(other.marks_) + table_.bytesNotIn(other.table_);
    }

    /// The whole tree as plain data.
    struct Parts {
        std::vector<ContainerMark> marks{};  ///< in painting order, with those of the document
        std::vector<Container> containers{}; ///< ascending by id
        ContainerId nextId = 1;
    };
    Parts parts() const;
    /// The tree of those parts, with the same ids; empty if they are no tree as described above.
    static std::optional<Containers> of(const Parts& parts);

    /// Compares containers, ids, numbers of objects and order.
    friend bool operator==(const Containers& a, const Containers& b);

private:
    friend class ContainersBuilder;
    using At = ContainerMarks::At;

    Containers(const ContainerMarks& marks, ContainerTable table, std::size_t count);

    At opening(ContainerId id) const { return labelled(table_[id].opens); }
    At closing(ContainerId id) const { return labelled(table_[id].closes); }
    At labelled(std::uint64_t label) const;
    std::uint64_t labelOf(const ContainerMark& mark) const;
    ContainerId ownerOf(const ContainerMark& mark) const; ///< of the objects after it
    int heightOf(ContainerId id) const;                   ///< 1 without child containers
    template <class Holds>
    ObjectRanges rangesWhere(const Holds& holds) const;

    template <class Into>
    Containers splicedInto(std::span<const Splice> splices, const Into& into) const;
    std::pair<At, At> touching(std::size_t first, std::size_t end) const;
    template <class Edit>
    Containers splicedWhere(const std::pair<At, At>& where, const Edit& edit) const;
    void spreadLabels();
    void giveLabels(ContainerId id, const At& opening, const At& closing);
    void insertAt(const At& at, std::size_t object, ContainerMark mark);
    void eraseMark(const At& at);
    void forget(ContainerId id);

    ContainerMarks marks_; ///< all opening and closing marks, in painting order
    ContainerTable table_;
    std::size_t count_ = 0;
};

} // namespace app
