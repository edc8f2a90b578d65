// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"

#include <functional>
#include <string>
#include <vector>

namespace app::pdf {

/// One object of a PDF file: the entries of its dictionary but its length, and its bytes.
struct Stream {
    std::string entries;
    QByteArray bytes;
};

/// An image as one or two objects: itself, and how opaque its pixels are. JPEG files and most PNG
/// files are taken as they are. `mask`: the number of the second one.
std::vector<Stream> streamsOf(const std::shared_ptr<const ImageFile>& file, std::size_t mask);

/// Numbers the images of a file, each of which has room for two objects.
class Images {
public:
    explicit Images(std::size_t first) : first_(first) {}

    std::size_t numberOf(const std::shared_ptr<const ImageFile>& file);
    const std::vector<std::shared_ptr<const ImageFile>>& files() const { return files_; }

private:
    std::size_t first_;
    std::vector<std::shared_ptr<const ImageFile>> files_;
};

} // namespace app::pdf
