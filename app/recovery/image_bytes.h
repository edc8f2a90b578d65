// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"
#include "app/recovery/bytes.h"

namespace app {

/// The image files that the writer and the reader of the same bytes know, in the same order: each
/// is written once.
struct KnownImages {
    std::vector<std::shared_ptr<const ImageFile>> files{};
};
/// Those of a tree that the reader has, too.
KnownImages imagesOf(const Containers& containers);

void writeUnderlay(ByteWriter& out, const SharedUnderlay& underlay, KnownImages& known);
SharedUnderlay readUnderlay(ByteReader& in, KnownImages& known);

} // namespace app
