// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Moves and scales objects so that the content of the rectangle `from` fills `to`. Stroke widths
/// stay. Along an axis on which `from` has no extent, objects are only moved.
class ResizeObjects : public EditCommand {
public:
    static constexpr CommandKind row{"resize-objects", "Moves and scales objects"};

    ResizeObjects(EditedDocument& document, const ObjectRanges& objects,
                  const clipping::Window& from, const clipping::Window& to);
};

/// The placement that maps the rectangle `from` onto `to`.
Placement fitting(const clipping::Window& from, const clipping::Window& to);

} // namespace app
