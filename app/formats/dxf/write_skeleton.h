// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/write_look.h"

#include <span>

// All of a DXF file but its entities.

namespace app::dxf::writing {

struct LayerEntry {
    std::string name; ///< legal and encoded
    LineLook look{};
    bool on = true, locked = false;
};

/// What the sections around the entities tell of a drawing.
struct Skeleton {
    DxfVersion version;
    int unit; ///< for $INSUNITS
    clipping::Window extents{};
    std::span<const LayerEntry> layers{}; ///< with “0”, which every file has
    std::span<const LineType> lineTypes{};
    std::uint64_t freeHandle = 0; ///< nothing has this handle or a greater one
};

constexpr std::uint64_t modelSpace = 0x1f;  ///< the handle of the owner of all entities
constexpr std::uint64_t firstHandle = 0x30; ///< the handles before are the skeleton's

/// The sections before the entities. The handles of layers and line types follow each other from
/// `firstHandle` on; returns the next one.
std::uint64_t writeBeforeEntities(TagWriter& tags, const Skeleton& skeleton);
void writeAfterEntities(TagWriter& tags, const Skeleton& skeleton);

} // namespace app::dxf::writing
