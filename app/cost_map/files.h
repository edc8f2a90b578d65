// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/file_kind.h"
#include "app/cost_map/paint.h"
#include "app/tables/table.h"

#include <QImage>

namespace app {

/// One row of the catalogue of formats in which a whole cost map can be saved.
using CostMapFormat = FileKind<CostMap, CostMapLook>;
std::span<const CostMapFormat> costMapFormats();

/// `writeAs`.
std::optional<QString> writeCostMap(const CostMap& map, const QString& path,
                                    const CostMapLook& look);

/// A row for each cell: the moving end, the cost, and in a map of the cheapest the cheapest
/// variants.
Table costTable(const CostMap& map);

/// The map with title, notes and legend, on the ground of `look`.
QImage costPicture(const CostMap& map, const CostMapLook& look);

} // namespace app
