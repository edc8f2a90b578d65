// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/export_name.h"

#include "app/base/text.h"
#include "app/export/export_area.h"
#include "app/session/window_words.h"

namespace app {

static QString ownName(const Document& document, const ExportArea& area)
{
    const auto& windows = document.windows().list;
    if (area.part == ExportPart::Window && area.window < windows.size())
        return nameOf(windows[area.window]);
    if (area.part == ExportPart::Layer && document.containers().contains(area.layer))
        return document.containers()[area.layer].name;
    return {};
}

QString exportName(const ExportArea& area, const Document& document)
{
    constexpr qsizetype longest = 60; // characters; a layer may be called by a page of text
    const QString allowed = QStringLiteral(" ._()");
    QString name = ownName(document, area).left(longest);
    for (QChar& c : name)
        if (!c.isLetterOrNumber() && !allowed.contains(c))
            c = u'-';
    name = name.trimmed();
    return u'-' + (name.isEmpty() ? latin(exportParts()[std::size_t(area.part)].key) : name);
}

} // namespace app
