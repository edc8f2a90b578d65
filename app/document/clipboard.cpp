// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/clipboard.h"

#include "app/document/legacy.h"
#include "app/document/path_points.h"
#include "app/formats/format.h"

#include <QBuffer>

namespace app {
namespace {

const QString svgType = QStringLiteral("image/svg+xml");

// A shape of the drawing it comes from, in the units of another page.
Shape scaled(Shape shape, double factor)
{
    for (Subpath& path : shape.paths)
        forEachPoint(path, [&](Point& point) { point *= factor; });
    shape.style.width *= factor;
    shape.style.dashOffset *= factor;
    for (double& dash : shape.style.dashes)
        dash *= factor;
    return shape;
}

} // namespace

std::unique_ptr<QMimeData> copied(const Sheet& sheet, const ObjectRanges& shapes)
{
    Sheet some = sheet;
    some.shapes.clear();
    for (const std::size_t shape : shapes)
        some.shapes.push_back(sheet.shapes[shape]);
    QBuffer svg;
    svg.open(QIODevice::WriteOnly);
    auto data = std::make_unique<QMimeData>();
    if (formats().front().write(documentOf(some), svg, {}))
        return data;
    data->setData(svgType, svg.data());
    data->setText(QString::fromUtf8(svg.data()));
    return data;
}

std::vector<Shape> pasted(const QMimeData& data, const Page& page, std::uint32_t layer)
{
    QByteArray bytes = data.hasFormat(svgType) ? data.data(svgType) : data.text().toUtf8();
    if (!bytes.contains("<svg"))
        return {};
    QBuffer svg(&bytes);
    svg.open(QIODevice::ReadOnly);
    const auto read = formats().front().read(svg);
    if (!read)
        return {};
    const Sheet sheet = sheetOf(read.value->document);
    const double factor = sheet.page.millimetresPerUnit() / page.millimetresPerUnit();
    std::vector<Shape> shapes;
    for (const Shape& shape : sheet.shapes) {
        shapes.push_back(factor == 1 ? shape : scaled(shape, factor));
        shapes.back().layer = layer;
        shapes.back().id.clear();
    }
    return shapes;
}

} // namespace app
