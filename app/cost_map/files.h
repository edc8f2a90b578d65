// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/paint.h"
#include "app/tables/table.h"

#include <QIODevice>
#include <QImage>

namespace app {

/// One row of the catalogue of what a whole cost map can be saved as.
struct CostMapFormat {
    std::string_view key; ///< "png": the file name's ending
    QString name;         ///< translated: "PNG picture"
    bool paints;          ///< needs a QGuiApplication
    /// Nothing, or why it could not be done.
    std::optional<QString> (*write)(const CostMap& map, const CostMapLook& look, QIODevice& out);
};
std::span<const CostMapFormat> costMapFormats();
/// By a file's ending; null if there is none.
const CostMapFormat* findCostMapFormat(const QString& key);

/// Replaces a file only by a whole new one. Nothing, or a sentence that names the file.
std::optional<QString> writeCostMap(const CostMap& map, const QString& path,
                                    const CostMapLook& look);

/// A row a cell: where the moving end is, the cost, and in a map of the cheapest who it is.
Table costTable(const CostMap& map);

/// The map with title, notes and legend, on the look's paper.
QImage costPicture(const CostMap& map, const CostMapLook& look);

} // namespace app
