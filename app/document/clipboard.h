// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/sheet.h"

#include <QMimeData>

#include <memory>

namespace app {

/// Shapes as other programs and this one take them: SVG, as such and as text.
std::unique_ptr<QMimeData> copied(const Sheet& sheet, const ObjectRanges& shapes);

/// The shapes in there, on `layer`, at the size on paper that they had; none if there are none.
std::vector<Shape> pasted(const QMimeData& data, const Page& page, std::uint32_t layer);

} // namespace app
