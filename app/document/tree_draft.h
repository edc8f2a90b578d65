// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace app {

/// What a container holds: objects, or a container.
struct TreeItem {
    ContainerId id = 0;    ///< 0: objects
    ObjectRange objects{}; ///< of the document or, if `added`, of the added objects
    bool added = false;
    bool chosen = false; ///< all of it
};
using TreeItems = std::vector<TreeItem>; ///< from bottom to top

/// An edit that arranges objects and containers anew.
struct Rearranged {
    Edit edit;
    ObjectRanges chosen; ///< the chosen objects, as numbered after the edit
    ObjectRanges added;  ///< the added objects
    bool changes() const { return !edit.splices.empty() || edit.containers.has_value(); }
};

/// A document taken apart, so that its objects, groups and layers can be put together in another
/// order. What is chosen is marked in the lists: runs of objects, and groups as a whole.
class TreeDraft {
public:
    /// A group is chosen if all its objects that may be edited are, but not `entered` or a group
    /// around it. O(containers + ranges).
    explicit TreeDraft(const Document& document, const ObjectRanges& chosen = {},
                       ContainerId entered = 0);

    TreeItems& in(ContainerId id) { return lists_[id]; } ///< what the container holds
    const Container& operator[](ContainerId id) const;
    /// Calls visit(container, its items) for every container around or beside what is chosen, not
    /// for those inside; inner containers come first. `visit` may change the items.
    using Visit = std::function<void(ContainerId, TreeItems&)>;
    void forEachList(const Visit& visit);
    /// The chosen items, from bottom to top.
    TreeItems chosen() const;

    /// Makes a container that no list holds yet. The id in `container` is ignored.
    ContainerId make(Container container);
    /// A copy of the item, with everything in it. Ids for SVG are not copied.
    TreeItem copied(const TreeItem& item, const std::function<void(ObjectRow&)>& change);
    /// An item with new objects. It is put into a list by the caller.
    TreeItem adding(const Objects& objects);

    /// The edit that makes the document like this draft. It moves as few objects as possible.
    /// Groups that have lost all objects are gone. Empty: there would be too many containers, or
    /// they would be nested too deeply.
    std::optional<Rearranged> rearranged() const;

private:
    struct Layout;

    void takeApart(const Containers::Parts& parts, const ObjectRanges& chosen);
    void chooseGroups(ContainerId entered);
    void visit(ContainerId id, const Visit& visit);
    void collect(ContainerId id, TreeItems& chosen) const;
    void lay(ContainerId id, Layout& layout) const;
    std::optional<Containers> treeOf(Layout layout) const;

    Document document_;
    ObjectRanges chosen_;
    std::unordered_map<ContainerId, TreeItems> lists_;
    std::vector<Container> made_;
    ContainerId firstMade_;
    Objects added_;
};

} // namespace app
