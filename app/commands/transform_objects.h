// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/document/affine_map.h"

namespace app {

/// Whether widths and dashes of strokes are scaled with the objects.
enum class StrokeScaling : std::uint8_t { Keep, Scale };

/// Rotates, scales, mirrors or skews objects. Shapes stay shapes where their kind allows it.
class TransformObjects : public EditCommand {
public:
    static constexpr CommandKind row{"transform-objects", "Rotates, scales or skews objects"};

    /// The map must be finite.
    TransformObjects(EditedDocument& document, const ObjectRanges& objects, const AffineMap& map,
                     StrokeScaling strokes, const QString& text, Merging merging = Merging::Never);
    /// A map for each object, in their order.
    TransformObjects(EditedDocument& document, const ObjectRanges& objects,
                     std::span<const AffineMap> maps, StrokeScaling strokes, const QString& text);
};

/// The path of the object after the map, and what remains of its recipe.
void transform(ObjectRow& object, const AffineMap& map);

constexpr std::size_t mostCopied = 1'000'000; ///< objects that one step may add

/// Adds a copy of each object for each map, in one step.
class CopyObjects : public EditCommand {
public:
    static constexpr CommandKind row{"copy-objects", "Adds transformed copies of objects"};

    CopyObjects(EditedDocument& document, Edit copying, const QString& text);
};

/// The edit that adds the copies, each on top of its original's container and without its id. All
/// copies of one map are in the order of the objects. The copy of a group that is chosen as a whole
/// is a group (TreeDraft), unless the drawing would have too many groups.
Edit copying(const Document& document, const ObjectRanges& objects, std::span<const AffineMap> maps,
             ContainerId entered = 0);

} // namespace app
