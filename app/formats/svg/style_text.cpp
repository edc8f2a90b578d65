// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/style_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/colour.h"
#include "app/formats/svg/reader.h"

#include <QBuffer>
#include <QRegularExpression>

#include <algorithm>

namespace app::svg {

void appendPaint(std::string& text, std::string_view name, const std::optional<Colour>& colour)
{
    if (!colour) {
        appendAttribute(text, name, "none");
        return;
    }
    appendAttribute(text, name, hexOf({colour->red, colour->green, colour->blue}));
    if (colour->alpha != 255) {
        std::string alpha;
        appendNumber(alpha, colour->alpha / 255.0, 3, 0, 1); // precise enough to give the same byte
        appendAttribute(text, std::string(name) + "-opacity", alpha);
    }
}

std::string styleText(const Style& style)
{
    const Style usual{.fill = Colour{}};
    std::string text;
    if (style.fill != usual.fill)
        appendPaint(text, "fill", style.fill);
    if (style.stroke)
        appendPaint(text, "stroke", style.stroke);
    if (style.width != usual.width)
        appendAttribute(text, "stroke-width", style.width);
    if (style.cap != usual.cap)
        appendAttribute(text, "stroke-linecap", style.cap == Cap::Round ? "round" : "square");
    if (style.join != usual.join)
        appendAttribute(text, "stroke-linejoin", style.join == Join::Round ? "round" : "bevel");
    if (style.miterLimit != usual.miterLimit)
        appendAttribute(text, "stroke-miterlimit", style.miterLimit);
    if (std::ranges::any_of(style.dashes, [](double dash) { return dash > 0; }))
        appendAttribute(text, "stroke-dasharray", style.dashes);
    if (style.dashOffset != usual.dashOffset)
        appendAttribute(text, "stroke-dashoffset", style.dashOffset);
    if (style.fillRule != usual.fillRule)
        appendAttribute(text, "fill-rule", "evenodd");
    return text;
}

} // namespace app::svg

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
