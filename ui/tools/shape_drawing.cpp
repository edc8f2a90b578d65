// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"

#include "app/commands/add_and_remove.h"
#include "app/session/selection_style.h"
#include "app/session/units.h"
#include "app/view/ruler.h"
#include "app/view/visible_colour.h"

#include <QPainterPath>

#include <glm/geometric.hpp>

namespace ui {

app::Object objectOf(const app::Session& session, std::span<const app::Subpath> subpaths,
                     app::Recipe recipe)
{
    return {.path = app::Path(subpaths),
            .style = app::newStyle(session),
            .particulars = {.recipe = std::move(recipe)}};
}

app::ObjectInHand inHand(const Workbench& bench, const app::Subpath& path)
{
    return {{objectOf(bench.session, std::span(&path, 1)), app::containerForNew(bench.session)}};
}

void draw(Workbench& bench, std::vector<app::Subpath> paths, const QString& undoText,
          app::Recipe recipe)
{
    app::Session& session = bench.session;
    app::Objects objects = session.now().objects().slice(0, 0);
    objects.append(objectOf(session, paths, std::move(recipe)));
    session.history.push(
        new app::AddObjects(session.document, objects, app::containerForNew(session), undoText));
    session.select({}); // what follows is for the new object, or for the next one
    const app::Subpath& last = paths.back();
    bench.lastPoint = last.closed || last.segments.empty() ? last.start : last.segments.back().to;
}

void pushKeepingInspected(app::Session& session, app::UndoCommand* step)
{
    const auto inspected = session.inspected();
    const std::size_t lines = session.scene.lines().size();
    session.history.push(step);
    if (session.scene.lines().size() == lines) // otherwise a curve has been divided differently
        session.inspect(inspected);
}

namespace {

/// Segments that are painted as one path: many paths take less time than one that crosses itself
/// thousands of times.
constexpr std::size_t paintedTogether = 100;
constexpr std::size_t mostSmooth = 2000; // more segments are painted without anti-aliasing

void paint(QPainter& painter, const Workbench& bench, const app::Subpath& path)
{
    QPainterPath outline(bench.onScreen(path.start));
    painter.setRenderHint(QPainter::Antialiasing, path.segments.size() <= mostSmooth);
    std::size_t count = 0;
    for (const app::PathSegment& s : path.segments) {
        if (++count % paintedTogether == 0 && !path.closed) {
            painter.drawPath(outline);
            outline = QPainterPath(outline.currentPosition());
        }
        s.curved ? outline.cubicTo(bench.onScreen(s.control1), bench.onScreen(s.control2),
                                   bench.onScreen(s.to))
                 : outline.lineTo(bench.onScreen(s.to));
    }
    if (path.closed)
        outline.closeSubpath();
    painter.drawPath(outline);
    painter.setRenderHint(QPainter::Antialiasing);
}

} // namespace

bool isText(const app::Session& session, std::size_t object)
{
    const auto& recipe = session.now().objects()[object].particulars().recipe;
    return std::holds_alternative<app::TextRecipe>(recipe);
}

QColor shownColour(const app::Colour& colour, const Workbench& bench)
{
    const QColor page = bench.look.paper;
    const app::Colour paper{std::uint8_t(page.red()), std::uint8_t(page.green()),
                            std::uint8_t(page.blue())};
    const app::Colour shown = bench.look.dark ? app::visibleColour(colour, paper) : colour;
    return {shown.red, shown.green, shown.blue, shown.alpha};
}

void preview(QPainter& painter, const Workbench& bench, const app::Subpath& path)
{
    preview(painter, bench, std::span(&path, 1), app::newStyle(bench.session));
}

void preview(QPainter& painter, const Workbench& bench, std::span<const app::Subpath> paths,
             const app::Style& style)
{
    const QColor colour = shownColour(style.stroke.value_or(app::Colour{}), bench);
    const double width = std::max(0.75, style.width * bench.view.zoom);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::SvgMiterJoin));
    painter.setBrush(Qt::NoBrush);
    for (const app::Subpath& path : paths)
        paint(painter, bench, path);
}

void markPoints(QPainter& painter, const Workbench& bench, std::span<const app::Point> points)
{
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.setBrush(bench.look.paper);
    for (const app::Point& point : points)
        painter.drawEllipse(bench.onScreen(point), 3, 3);
}

app::Gauge gaugeFrom(const app::Point& from, const app::GestureMeasure& measure,
                     const Workbench& bench)
{
    const app::Page& page = bench.session.now().page();
    const app::Unit unit = bench.session.display().unit;
    return {&measure, {from}, app::originOf(page, unit), {unit, page.realMillimetresPerUnit()}};
}

app::Gauge gaugeOfStart(const Workbench& bench)
{
    app::Gauge gauge = gaugeFrom({}, app::position(), bench);
    gauge.start.from = gauge.origin;
    gauge.relativeTo = bench.lastPoint;
    return gauge;
}

app::Numbers keptBy(std::string_view tool, const Workbench& bench, const app::Numbers& usual)
{
    const auto kept = bench.kept.find(tool);
    return kept == bench.kept.end() ? usual : kept->second;
}

bool dragged(const app::Point& from, const Pointer& to)
{
    return glm::distance(from, to.screen) >= dragDistance;
}

app::Proportion proportionOf(Qt::KeyboardModifiers modifiers)
{
    return modifiers & Qt::ShiftModifier ? app::Proportion::Square : app::Proportion::Free;
}

app::Anchor anchorOf(Qt::KeyboardModifiers modifiers)
{
    return modifiers & Qt::AltModifier ? app::Anchor::Centre : app::Anchor::Opposite;
}

double nudge(const Workbench& bench, Qt::KeyboardModifiers modifiers)
{
    const double millimetres = modifiers & Qt::ShiftModifier ? 10 : 1;
    return millimetres / bench.session.now().page().millimetresPerUnit();
}

} // namespace ui
