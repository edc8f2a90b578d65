// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

#include <span>

namespace app {

using ImageFiles = std::vector<std::shared_ptr<const ImageFile>>;
ImageFiles imageFilesOf(const Containers& tree);

/// Whether a file of the drawing can hold these images, too, so that it can be read again. What is
/// in several images counts once.
bool hasRoomFor(const ImageFiles& more, const Containers& tree);
/// "A file can hold 500 images …"
QString imageRoomText();

} // namespace app
