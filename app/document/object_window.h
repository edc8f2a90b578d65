// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/object_view.h"

#include <optional>

namespace app {

/// The clip window with the shape, the fill rule and the id of an object, or the first line of a
/// text, as its name; empty if the object encloses nothing, such as a single line.
std::optional<ClipWindow> windowOf(const ObjectView& object);

} // namespace app
