// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edit.h"

namespace app {

/// Numbers for the names of objects that have no name of their own ("Rectangle 3"). An object keeps
/// its number as long as it exists, in whatever order, layer and group, and has it again after an
/// undo: the edit that undoes a change brings the numbers with it. A new object gets a number above
/// all that are in use. Not saved; 4 bytes for each object.
class ObjectNumbers {
public:
    ObjectNumbers() = default;
    explicit ObjectNumbers(std::size_t objects); ///< numbered from the bottom

    std::uint32_t of(std::size_t object) const { return numbers_[object]; }

    struct Changed;
    /// Empty: no object comes, goes or changes its place. O(objects); 4 bytes of each are copied.
    std::optional<Changed> after(const Edit& edit) const;

private:
    using Numbers = std::vector<std::uint32_t>;
    Numbers ofAdded(const Edit& edit) const;
    void appendSame(const Edit& edit, Numbers& added) const;

    Numbers numbers_;
};

struct ObjectNumbers::Changed {
    ObjectNumbers numbers{};
    NumberRuns removed{}; ///< of the objects that the edit removes, for the edit that undoes it
};

} // namespace app
