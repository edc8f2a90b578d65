// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/declarations.h"

#include "app/formats/svg/reader.h"
#include "app/formats/svg/style_text.h"

#include <QBuffer>
#include <QRegularExpression>

namespace app::svg {

QString declarations(const Style& style)
{
    static const QRegularExpression attribute(QStringLiteral("([a-z-]+)=\"([^\"]*)\""));
    QStringList all;
    const QString attributes = QString::fromStdString(styleText(style));
    for (auto found = attribute.globalMatch(attributes); found.hasNext();) {
        const auto match = found.next();
        all << match.captured(1) + u':' + match.captured(2);
    }
    return all.join(u';');
}

std::optional<Style> styleOf(const QString& declarations)
{
    constexpr qsizetype longest = 10'000; // characters
    if (declarations.size() > longest)
        return std::nullopt;
    // Whatever an object may say is read in the same way.
    QByteArray drawing = QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" "
                                        "height=\"9\"><path d=\"M0 0H1V1\" style=\"%1\"/></svg>")
                             .arg(declarations.toHtmlEscaped())
                             .toUtf8();
    QBuffer in(&drawing);
    in.open(QIODevice::ReadOnly);
    const auto read = svg::read(in);
    if (!read || read.value->document.objects().size() != 1)
        return std::nullopt;
    return read.value->document.objects()[0].style();
}

} // namespace app::svg
