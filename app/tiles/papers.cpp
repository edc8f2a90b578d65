// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/papers.h"

#include <QPageSize>

namespace app {

QStringList papers()
{
    return {QStringLiteral("A5"),     QStringLiteral("A4"),    QStringLiteral("A3"),
            QStringLiteral("A2"),     QStringLiteral("A1"),    QStringLiteral("A0"),
            QStringLiteral("Letter"), QStringLiteral("Legal"), QStringLiteral("Tabloid")};
}

std::optional<Point> paperSize(const QString& name)
{
    for (int id = 0; id <= QPageSize::LastPageSize; ++id) {
        const auto size = QPageSize::PageSizeId(id);
        if (QPageSize::key(size).compare(name, Qt::CaseInsensitive) != 0)
            continue;
        const QSizeF paper = QPageSize::size(size, QPageSize::Millimeter);
        return paper.isEmpty() ? std::nullopt : std::optional(Point(paper.width(), paper.height()));
    }
    return std::nullopt;
}

} // namespace app
