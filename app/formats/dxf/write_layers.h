// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/write_skeleton.h"

namespace app::dxf::writing {

/// The layers of a drawing as those of DXF, which do not lie in each other: one is off or locked if
/// a layer around it is. Each has the look of its first object.
class DxfLayers {
public:
    DxfLayers(const Document& document, DxfVersion version);

    std::span<const LayerEntry> entries() const { return entries_; } ///< first “0”

    struct Place {
        std::size_t entry = 0;
        bool hidden = false; ///< by a group in that layer
    };
    Place placeOf(std::size_t object) const;

private:
    void addLayers(DxfVersion version);
    void addLooks();

    const Document& document_;
    std::vector<LayerEntry> entries_{{"0"}};
    std::vector<Place> places_; ///< by container
};

} // namespace app::dxf::writing
