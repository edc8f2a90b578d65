// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_marks.h"
#include "app/document/container_table.h"
#include "app/document/object_ranges.h"
#include "app/document/splice.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace app {

/// The tree of layers and groups of a document. It says how many objects each container has, in
/// painting order; the objects themselves lie elsewhere.
///
/// The first level are layers, at least one, and only they lie directly in the document. Layers can
/// lie in layers, groups anywhere but on the first level. A container may have objects below,
/// between and above the containers in it.
///
/// A value: the edits give another tree and share with it what they leave alone, so that the trees
/// of a history together cost little. Questions take O(log containers) steps, or O(depth), where
/// nothing else is said; edits O(containers / 256).
class Containers {
public:
    static constexpr std::size_t mostContainers = 100'000;
    static constexpr std::size_t mostLayers = 1000; ///< of a file: more go into the last one
    static constexpr int deepest = 500; ///< containers around an object

    Containers(); ///< one layer, "Drawing", without objects

    std::size_t size() const { return count_; }              ///< the number of containers
    std::size_t objects() const { return marks_.objects(); } ///< in all of them
    bool contains(ContainerId id) const { return table_.contains(id); }
    const Container& operator[](ContainerId id) const { return *table_[id].container; }
    /// The container around it; 0 for layers of the first level. Not for 0.
    ContainerId parentOf(ContainerId id) const { return table_[id].parent; }
    int depthOf(ContainerId id) const; ///< 1 on the first level
    /// Those directly in it, bottom to top; of 0: the first level. O(children · log).
    std::vector<ContainerId> childrenOf(ContainerId id) const;
    std::vector<ContainerId> inOrder() const;  ///< all, each before those in it; bottom to top
    ObjectRange rangeOf(ContainerId id) const; ///< with those of the containers in it
    /// Whether one container ends before another in painting order: the inner before the outer one.
    bool endsBefore(ContainerId a, ContainerId b) const
    {
        return table_[a].closes < table_[b].closes;
    }
    /// The innermost container and layer around an object that is there.
    ContainerId containerOf(std::size_t object) const;
    ContainerId layerOf(std::size_t object) const;
    bool shown(ContainerId id) const;  ///< it is visible, and so are all around it
    bool locked(ContainerId id) const; ///< it is locked, or one around it is
    /// Objects that are not shown because of a container, and those that are locked. For loops over
    /// all objects: O(containers).
    ObjectRanges hiddenRanges() const;
    ObjectRanges lockedRanges() const;

    /// The tree with another name, visibility … of the container of that id. Its kind stays.
    Containers with(const Container& changed) const;
    /// Objects [first, first + removed) leave the tree, then `added` others come to the place
    /// `first`: directly into `into`, which has or touches that place, above the containers without
    /// objects there. Groups that lose their last object vanish; layers stay. O(containers) if
    /// objects of so many are removed.
    Containers spliced(std::size_t first, std::size_t removed, std::size_t added,
                       ContainerId into) const;
    /// The same at many places, ascending and numbered as before. What a splice adds goes to the
    /// container of the first object that it removes; where it removes none, into `into`. As many
    /// as go, all of one container, leave the tree as it is. O(splices · containers / 256), and
    /// never more than O(splices + containers).
    Containers spliced(std::span<const Splice> splices, ContainerId into = 0) const;
    /// The same with a container for each splice. Those at one place ascend by where their
    /// containers end.
    Containers spliced(std::span<const Splice> splices, std::span<const ContainerId> into) const;
    /// With a new container in `parent`, above the first `at` of the containers directly in it. It
    /// takes over the parent's objects [range.first, range.end) and the containers among them:
    /// those from `at` on that begin before range.end. An empty range says where among the objects
    /// it lies. It gets the id `nextId()`; the one in `container` does not matter. Nothing if there
    /// were more than `mostContainers` then, or more than `deepest` around an object. O(children of
    /// the parent + containers taken over).
    std::optional<Containers> inserted(Container container, ContainerId parent, std::size_t at,
                                       const ObjectRange& range) const;
    /// Without the container; what is in it goes to the one around it, to the same place. Not for
    /// a layer of the first level. O(children).
    Containers dissolved(ContainerId id) const;
    /// Without the container and all that is in it, objects too. Not for the last layer of the
    /// first level. O(containers in it).
    Containers removed(ContainerId id) const;
    /// The id that `inserted` gives: above all that this tree has, or its predecessors had.
    ContainerId nextId() const { return table_.end(); }
    /// The next id is at least this one.
    void startIdsAt(ContainerId id) { table_.startIdsAt(id); }

    /// Bytes of the heap that it keeps alive and `other`, of the same document, does not.
    std::size_t bytesNotIn(const Containers& other) const
    {
        return marks_.bytesNotIn(other.marks_) + table_.bytesNotIn(other.table_);
    }

    /// The same containers with the same ids, objects and order.
    friend bool operator==(const Containers& a, const Containers& b);

private:
    friend class ContainersBuilder;
    using At = ContainerMarks::At;

    Containers(const ContainerMarks& marks, ContainerTable table, std::size_t count);

    At opening(ContainerId id) const { return labelled(table_[id].opens); }
    At closing(ContainerId id) const { return labelled(table_[id].closes); }
    At labelled(std::uint64_t label) const;
    std::uint64_t labelOf(const ContainerMark& mark) const;
    ContainerId ownerOf(const ContainerMark& mark) const; ///< of the objects behind it
    int heightOf(ContainerId id) const;                   ///< 1 without containers in it
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

    ContainerMarks marks_; ///< all that open and close in the tree, in painting order
    ContainerTable table_;
    std::size_t count_ = 0;
};

} // namespace app
