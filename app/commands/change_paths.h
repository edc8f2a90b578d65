// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

#include <span>

namespace app {

/// The new path of an object; without subpaths, the object is removed.
struct ChangedPath {
    std::size_t object;
    Path path;
    Recipe recipe{}; ///< what makes the new path
};

/// Replaces the paths of objects, which keep id, style and layer. A rectangle, ellipse, star or
/// text becomes a plain path, unless the change has a recipe.
class ChangePaths : public EditCommand {
public:
    static constexpr CommandKind row{"change-paths", "Changes the paths of objects"};

    /// The objects ascend.
    ChangePaths(EditedDocument& document, std::span<const ChangedPath> paths, const QString& text,
                Merging merging = Merging::Never);
};

} // namespace app
