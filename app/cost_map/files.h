// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/paint.h"
#include "app/tables/table.h"

#include <QIODevice>
#include <QImage>

namespace app {

/// One row of the catalogue of formats in which a whole cost map can be saved.
struct CostMapFormat {
    std::string_view key; ///< "png": the file name's ending
    QString name;         ///< translated: "PNG picture"
    bool paints;          ///< needs a QGuiApplication
    /// Empty, or why it failed.
    std::optional<QString> (*write)(const CostMap& map, const CostMapLook& look, QIODevice& out);
};
std::span<const CostMapFormat> costMapFormats();
/// The endings of all formats: ".png or .csv".
QString costMapEndings();
/// Finds a format by a file's ending; null if there is none.
const CostMapFormat* findCostMapFormat(const QString& key);

/// Replaces a file only by a complete new one. Empty, or a sentence that names the file.
std::optional<QString> writeCostMap(const CostMap& map, const QString& path,
                                    const CostMapLook& look);

/// A row for each cell: the moving end, the cost, and in a map of the cheapest the cheapest
/// variants.
Table costTable(const CostMap& map);

/// The map with title, notes and legend, on the ground of `look`.
QImage costPicture(const CostMap& map, const CostMapLook& look);

} // namespace app
