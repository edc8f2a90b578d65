// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/image_room.h"

#include "app/base/text.h"
#include "app/formats/svg/limits.h"

#include <algorithm>

namespace app {

ImageFiles imageFilesOf(const Containers& tree)
{
    ImageFiles files;
    for (const ContainerId id : tree.underlaid())
        files.push_back(tree[id].underlay->file);
    return files;
}

bool hasRoomFor(const ImageFiles& more, const Containers& tree)
{
    ImageFiles all = imageFilesOf(tree);
    all.insert(all.end(), more.begin(), more.end());
    if (all.size() > std::size_t(svg::mostImages))
        return false;
    std::ranges::sort(all);
    const auto same = std::ranges::unique(all);
    all.erase(same.begin(), same.end());
    std::int64_t pixels = 0, bytes = 0;
    for (const auto& file : all) {
        pixels += std::int64_t(file->width) * file->height;
        bytes += file->bytes.size();
    }
    return pixels <= svg::mostImagePixels && bytes <= svg::mostImageBytes;
}

QString imageRoomText()
{
    constexpr int million = 1'000'000;
    return Text::tr("A file can hold %1 images with %2 million pixels and %3 MB in all. Remove an "
                    "image first.")
        .arg(svg::mostImages)
        .arg(svg::mostImagePixels / million)
        .arg(svg::mostImageBytes / million);
}

} // namespace app
