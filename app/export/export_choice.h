// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"
#include "app/formats/format.h"

#include <optional>

namespace app {

/// What of a drawing is exported.
enum class ExportPart : std::uint8_t {
    Cut,       ///< what all clip windows together keep
    Page,      ///< what lies on the page, whatever the windows keep
    Window,    ///< what lies in one clip window
    Selection, ///< the selected objects, whole
    Layer      ///< the objects of a layer, whole
};

struct ExportArea {
    ExportPart part = ExportPart::Cut;
    std::size_t window = 0; ///< the number of the clip window, for Window
    ContainerId layer = 0;  ///< for Layer
    friend bool operator==(const ExportArea&, const ExportArea&) = default;
};

/// The paper in the file: just as large as the area, or the whole page of the drawing.
enum class ExportPaper : std::uint8_t { Area, Page };

constexpr double leastDpi = 1, mostDpi = 1e5; ///< that a person can choose

/// All that a person chooses for an export. A format takes only a part of it (`Format::takes`).
struct ExportChoice {
    std::string format = "svg"; ///< the key of a format that can be written
    ExportArea area{};
    ExportPaper paper = ExportPaper::Area;
    double dpi = 300;
    int precision = -1;                 ///< WriteOptions::precision
    std::optional<Colour> background{}; ///< WriteOptions::background
    DxfVersion dxf = DxfVersion::R2000;
    bool plain = false; ///< WriteOptions::plain
    Projection projection = Projection::PlateCarree;
    friend bool operator==(const ExportChoice&, const ExportChoice&) = default;
};

/// The formats that can be written, in the order of the sheet: tables of lines last.
std::vector<const Format*> exportFormats();
/// The chosen format, or the first one if there is none of that key.
const Format& formatOf(const ExportChoice& choice);

} // namespace app
