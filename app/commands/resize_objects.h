// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/transform_objects.h"
#include "app/document/window_frame.h"

namespace app {

/// Moves and scales objects so that the content of the frame `from` fills `to`, which has the same
/// angle. Along an axis on which `from` has no extent, objects are only moved. Strokes are scaled
/// by the root of the factor of areas, or keep their widths.
class ResizeObjects : public EditCommand {
public:
    static constexpr CommandKind row{"resize-objects", "Moves and scales objects"};

    ResizeObjects(EditedDocument& document, const ObjectRanges& objects, const WindowFrame& from,
                  const WindowFrame& to, StrokeScaling strokes = StrokeScaling::Keep);
};

/// The placement that maps the rectangle `from` onto `to`.
Placement fitting(const clipping::Window& from, const clipping::Window& to);

} // namespace app
