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
};

/// The path of the object after the map, and what remains of its recipe.
void transform(ObjectRow& object, const AffineMap& map);

} // namespace app
