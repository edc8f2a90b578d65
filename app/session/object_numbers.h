// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace app {

/// Numbers for the names of objects that have no name of their own ("Rectangle 3"). An object keeps
/// its number as long as it exists, in whatever order, layer and group, and has it again after an
/// undo. A new object gets a number above all that are in use. The objects of an opened drawing are
/// numbered from the bottom. Not saved. O(objects replaced) for a change, plus moving 4 bytes for
/// each object above it.
class ObjectNumbers : public QObject {
    Q_OBJECT

public:
    explicit ObjectNumbers(EditedDocument& document);

    std::uint32_t of(std::size_t object) const { return numbers_[object]; }

private:
    using Numbers = std::vector<std::uint32_t>;
    /// A change that has replaced objects by another number of them, or by others.
    struct Step {
        std::vector<Splice> splices;
        Numbers before, after; ///< of the objects that it removed, and of those it added
    };

    void begin();
    void follow(const DocumentChange& change);
    Numbers newNumbers(std::span<const Splice> splices, const Numbers& removed) const;
    void replace(std::span<const Splice> splices, const Numbers& added);
    Numbers removedBy(std::span<const Splice> splices) const;

    const EditedDocument& document_;
    Document before_; ///< the last change
    Numbers numbers_; ///< of all objects
    std::deque<Step> done_, undone_;
};

} // namespace app
