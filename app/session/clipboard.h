// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QMimeData>

#include <memory>

namespace app {

/// Objects for this program, which reads them back bit for bit, and for others: SVG as image and as
/// text, in pixels, because Inkscape ignores the unit of what it pastes; PDF and a PNG picture
/// (300 dpi, at most 4,000 pixels a side), on paper as large as what is seen of them. Groups are
/// copied if they are chosen as a whole (TreeDraft), and the image below a layer if all objects are
/// that can be selected in the layer; if it has none, in one around it or in the whole drawing.
std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered = 0);

/// A file of a format for other programs: as this kind of file and, where it is a text, as text.
std::unique_ptr<QMimeData> copiedFile(std::string_view format, const QByteArray& content);

/// What a clipboard holds, or another program's drag.
struct Pasted {
    Document drawing{}; ///< at its original size on paper, without ids of objects
    std::vector<Loss> losses{};
    QString fault{}; ///< why the drawing that another program offers cannot be read

    /// Whether there is a drawing: objects or images.
    bool holdsDrawing() const
    {
        return !drawing.objects().empty() || drawing.containers().isUnderlaid();
    }
};
Pasted pasted(const QMimeData& data, const Page& page);

} // namespace app
