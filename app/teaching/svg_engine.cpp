// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/svg_engine.h"

#include <QPainterPath>

#include <cmath>

namespace app {

namespace {

/// A length or coordinate in the picture: tenths of a pixel are enough.
QByteArray shortNumber(double value)
{
    return QByteArray::number(std::round(value * 10) / 10 + 0.0);
}

QByteArray attribute(const char* name, const QByteArray& value)
{
    return QByteArray(" ") + name + "=\"" + value + '"';
}
QByteArray attribute(const char* name, double value) { return attribute(name, shortNumber(value)); }

QByteArray pointsText(const QPointF* points, int count)
{
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? " " : "") + shortNumber(points[i].x()) + ',' + shortNumber(points[i].y());
    return text;
}

/// The commands of a path; its curves are cubic.
QByteArray pathText(const QPainterPath& path)
{
    QByteArray text;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element element = path.elementAt(i);
        const char* command = element.type == QPainterPath::MoveToElement   ? "M"
                              : element.type == QPainterPath::LineToElement ? "L"
                              : element.type == QPainterPath::CurveToElement
                                  ? "C"
                                  : " "; // the second and third point of a curve
        text += command + shortNumber(element.x) + ',' + shortNumber(element.y);
    }
    return text;
}

} // namespace

void SvgEngine::updateState(const QPaintEngineState& state)
{
    const DirtyFlags changed = state.state();
    if (changed & DirtyPen)
        pen_ = state.pen();
    if (changed & DirtyBrush)
        brush_ = state.brush();
    if (changed & DirtyTransform)
        transform_ = state.transform();
}

void SvgEngine::drawLines(const QLineF* lines, int count)
{
    for (int i = 0; i < count; ++i)
        write("line", attribute("x1", lines[i].x1()) + attribute("y1", lines[i].y1())
                          + attribute("x2", lines[i].x2()) + attribute("y2", lines[i].y2())
                          + stroke());
}

void SvgEngine::drawRects(const QRectF* rects, int count)
{
    for (int i = 0; i < count; ++i)
        write("rect", attribute("x", rects[i].x()) + attribute("y", rects[i].y())
                          + attribute("width", rects[i].width())
                          + attribute("height", rects[i].height()) + area());
}

void SvgEngine::drawEllipse(const QRectF& box)
{
    write("ellipse", attribute("cx", box.center().x()) + attribute("cy", box.center().y())
                         + attribute("rx", box.width() / 2) + attribute("ry", box.height() / 2)
                         + area());
}

void SvgEngine::drawPolygon(const QPointF* points, int count, PolygonDrawMode mode)
{
    const bool isOpen = mode == PolylineMode;
    write(isOpen ? "polyline" : "polygon",
          attribute("points", pointsText(points, count)) + (isOpen ? stroke() : area()));
}

void SvgEngine::drawPath(const QPainterPath& path)
{
    write("path", attribute("d", pathText(path)) + area());
}

/// As wide as it was measured, whatever font the page is read with.
void SvgEngine::drawTextItem(const QPointF& at, const QTextItem& item)
{
    const QString text = item.text();
    if (text.trimmed().isEmpty())
        return;
    QByteArray with = attribute("x", at.x()) + attribute("y", at.y())
                      + attribute("class", "f-" + nameOfColour_(pen_.color()))
                      + attribute("font-size", item.font().pixelSize());
    if (item.font().weight() > QFont::Medium)
        with += attribute("font-weight", QByteArray::number(int(item.font().weight())));
    with += attribute("textLength", item.width());
    write("text", with + attribute("lengthAdjust", "spacingAndGlyphs"),
          text.toHtmlEscaped().toUtf8());
}

void SvgEngine::write(const QByteArray& name, const QByteArray& with, const QByteArray& text)
{
    elements_ += '<' + name + with + place()
                 + (text.isEmpty() ? QByteArray("/>") : '>' + text + "</" + name + '>') + '\n';
}

QByteArray SvgEngine::place() const
{
    if (transform_.isIdentity())
        return {};
    return attribute("transform", "matrix(" + QByteArray::number(transform_.m11(), 'g', 4) + ' '
                                      + QByteArray::number(transform_.m12(), 'g', 4) + ' '
                                      + QByteArray::number(transform_.m21(), 'g', 4) + ' '
                                      + QByteArray::number(transform_.m22(), 'g', 4) + ' '
                                      + shortNumber(transform_.dx()) + ' '
                                      + shortNumber(transform_.dy()) + ')');
}

QByteArray SvgEngine::stroke() const { return attribute("class", strokeClass()) + strokeStyle(); }

QByteArray SvgEngine::area() const
{
    QByteArray names =
        brush_.style() == Qt::NoBrush ? QByteArray() : "f-" + nameOfColour_(brush_.color());
    if (const QByteArray around = strokeClass(); !around.isEmpty())
        names += (names.isEmpty() ? "" : " ") + around;
    QByteArray with = attribute("class", names) + strokeStyle();
    if (brush_.style() != Qt::NoBrush && brush_.color().alpha() < 255)
        with += attribute("fill-opacity", QByteArray::number(brush_.color().alphaF(), 'g', 2));
    return with;
}

QByteArray SvgEngine::strokeClass() const
{
    return pen_.style() == Qt::NoPen ? QByteArray() : "s-" + nameOfColour_(pen_.color());
}

QByteArray SvgEngine::strokeStyle() const
{
    if (pen_.style() == Qt::NoPen)
        return {};
    QByteArray with = attribute("stroke-width", pen_.widthF());
    if (pen_.style() == Qt::CustomDashLine) {
        QByteArray dashes;
        for (const double dash : pen_.dashPattern())
            dashes += (dashes.isEmpty() ? "" : " ") + shortNumber(dash * pen_.widthF());
        with += attribute("stroke-dasharray", dashes);
    }
    if (pen_.capStyle() != Qt::FlatCap)
        with += attribute("stroke-linecap", pen_.capStyle() == Qt::RoundCap ? "round" : "square");
    return with;
}

} // namespace app
