// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/permanent_cuts.h"
#include "app/document/object_ranges.h"
#include "app/export/export_choice.h"

namespace app {

/// What exports are made of: a snapshot of the drawing, and how it is cut.
struct ExportSource {
    Document document{};
    ObjectRanges selection{};
    ClipAll clipAll = nullptr; ///< of the algorithm; not null
    CutChoices cutting{};
};

/// One kind of area, for menus, settings and the command line.
struct ExportPartInfo {
    ExportPart part;
    std::string_view key;
    const char* name; ///< to be translated
    const char* what; ///< what is exported, for a tooltip; to be translated
    QString (*fault)(const ExportSource& source, const ExportArea& area); ///< as `faultOf`
};
/// All of them, in the order of the sheet, which is that of `ExportPart`.
std::span<const ExportPartInfo> exportParts();

/// Why there is nothing to export in this area, as the end of a sentence or a remark without a full
/// stop: "nothing is selected". Empty: something can be exported.
QString faultOf(const ExportSource& source, const ExportArea& area);

/// The area if it can be exported; otherwise the cut drawing, or, if no window cuts it, the page.
ExportArea usableArea(const ExportSource& source, const ExportArea& area);

/// The windows at which the drawing is cut for this area; without a window nothing is cut. The
/// area can be exported.
ClipWindows windowsOf(const ExportSource& source, const ExportArea& area);

/// The box around what these windows keep; empty: it has no bounds.
std::optional<clipping::Window> boxAround(const ClipWindows& windows);

/// The rectangle of an area that is known without its objects; empty for Selection and Layer, whose
/// size is that of what is drawn. Windows that keep the outside, or everything but a part, have the
/// page.
std::optional<clipping::Window> rectangleOf(const ExportSource& source, const ExportArea& area);

/// The objects of a Selection or a Layer that are seen; empty for other areas: all objects.
std::optional<ObjectRanges> objectsOf(const ExportSource& source, const ExportArea& area);

} // namespace app
