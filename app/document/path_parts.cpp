// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path_storage.h"

#include <algorithm>
#include <cassert>

namespace app {

std::optional<Path::Parts> Path::parts() const
{
    if (!data_ || isLine())
        return std::nullopt;
    return Parts{placement(), data_->points(), data_->sizes(), data_->kinds()};
}

std::optional<Path> Path::of(const Parts& parts)
{
    const auto& [placement, points, sizes, kinds] = parts;
    std::uint64_t segments = 0, curves = 0;
    for (const std::uint32_t size : sizes)
        segments += size >> 1;
    for (const std::uint8_t kind : kinds)
        curves += kind;
    const bool fit = !sizes.empty() && points.size() < (std::size_t(1) << 31)
                     && points.size() == sizes.size() + segments + 2 * curves
                     && (kinds.empty() ? curves == 0 : kinds.size() == segments && curves > 0)
                     && std::ranges::all_of(kinds, [](std::uint8_t kind) { return kind <= 1; });
    if (!fit)
        return std::nullopt;
    Path path;
    path.data_ = Data::of(points.size(), sizes.size(), kinds.size());
    path.ends_ = {placement.scale, placement.offset};
    std::ranges::copy(points, path.data_->firstPoint());
    std::ranges::copy(sizes, path.data_->firstSize());
    std::ranges::copy(kinds, path.data_->firstKind());
    return path;
}

Path Path::withPlacement(const Placement& placement) const
{
    assert(data_ && !isLine());
    Path path = *this;
    path.ends_ = {placement.scale, placement.offset};
    return path;
}

} // namespace app
