// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut_object.h"
#include "app/cut/fresh_ids.h"
#include "app/document/containers_builder.h"

namespace app {

/// Whether an area and its lines become a group, or objects with numbered ids.
enum class Grouping : std::uint8_t { Yes, No };

/// Collects what a cut makes of a document, object by object in ascending order.
class CutEdit {
public:
    CutEdit(const Document& document, Grouping grouping);

    bool isHidden(std::size_t object) const;
    bool isLocked(std::size_t object) const { return locked_.contains(object); }

    void keep(std::size_t object);
    void remove(std::size_t object);
    /// `result` is what the cut leaves of the object.
    void cut(std::size_t object, CutObject result);
    /// Changes an object that is otherwise kept whole.
    void change(std::size_t object, const Object& changed);
    CutCounts& counts() { return cut_.counts; }

    /// The whole cut. Empty if the document cannot hold the groups.
    std::optional<Cut> take();

private:
    void addGroup(std::size_t object, std::size_t parts);

    const Document& document_;
    const Grouping grouping_;
    const ObjectRanges hidden_, locked_;
    FreshIds ids_{document_};
    Cut cut_;
    std::vector<NewGroup> groups_; ///< in the numbering after the cut
    std::ptrdiff_t more_ = 0;      ///< objects added so far, less those removed
};

} // namespace app
