// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut_object.h"
#include "app/document/objects.h"

#include <memory>

namespace app::svg {

/// What a clip path, a mask or a viewport leaves visible of the content around which it lies.
struct ClipArea {
    ClipWindows windows{}; ///< in the document's coordinates; none: nothing is visible
    qint64 line = 0;       ///< of the file, where it is used
};

/// Those around something; what is visible is inside all of them, outermost first.
using ClipAreas = std::vector<std::shared_ptr<const ClipArea>>;

/// The windows of an area that some shapes cover together. Those that lie apart from all others are
/// one window, because many windows take long.
ClipWindows unitedWindows(std::vector<PathShape> shapes);

/// What is left of some objects, and how much work it was, for the limit mostClipWork.
struct ClippedObjects {
    std::vector<CutObject> objects;
    std::size_t work = 0;
    /// The lines meet so often that cutting them would take minutes: all objects are whole.
    bool tooMany = false;
};
ClippedObjects clipped(const Objects& objects, const ClipArea& area, const Page& page);

/// The part of a shape inside all areas. Empty: its lines meet theirs too often.
std::optional<PathShape> clipped(PathShape shape, const ClipAreas& areas, const Page& page,
                                 std::size_t& work);

} // namespace app::svg
