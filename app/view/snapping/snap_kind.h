// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <span>
#include <string_view>

namespace app {

struct SnapSurroundings;
class SnapOffers;

/// A better rank wins at any distance within the radius; within a rank the nearest place wins.
enum class SnapRank : std::uint8_t {
    Single, ///< a single point, such as an end
    Along,  ///< any point along something
    Grid    ///< counts only where nothing else is near
};

/// One kind of place that the pointer snaps to: a row of the catalogue.
struct SnapKind {
    std::string_view key;    ///< in the settings
    QString name;            ///< in the list of kinds
    QString word;            ///< at the pointer
    QString cornerWord = {}; ///< at the pointer, at a corner of an edge
    SnapRank rank = SnapRank::Single;
    bool usual = true; ///< on, until a person chooses
    /// The strokes of its glyph, in a square from -1 to 1, y down.
    std::span<const clipping::Segment> glyph = {};
    /// Offers the places near the pointer. Null: `Snapper` finds them.
    void (*find)(const SnapSurroundings&, SnapOffers&) = nullptr;
};

/// Every kind, in the order of the list of kinds. Of places at the same distance the first kind
/// wins.
std::span<const SnapKind> snapKinds();
/// A kind that exists.
const SnapKind& snapKind(std::string_view key);

} // namespace app
