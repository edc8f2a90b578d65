// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/overview.h"

#include "app/session/window_in_hand.h"
#include "app/teaching/step_scene.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t mostLines = 20'000;
constexpr double overviewMargin = 4, lineWidth = 0.5; // pixels
// Of the frame around the stage: its least side, and the side from which on the line is seen in it.
constexpr double leastStage = 8, leastWithLine = 20;
// Maximum share of the picture that lines cover, so that it does not become a grey area.
constexpr double mostCoverage = 0.7;

std::optional<QLineF> onScreen(const clipping::Segment& line, const app::View& view)
{
    const auto part = clipping::exactAlgorithm().corrected.clip(line, view.visible());
    if (!part)
        return std::nullopt;
    const app::Point a = view.toScreen(part->a), b = view.toScreen(part->b);
    return QLineF(a.x, a.y, b.x, b.y);
}

} // namespace

Overview::Overview(const app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(Text::tr("Overview of the drawing"));
}

void Overview::showStage(const clipping::Window& stage)
{
    if (stage == std::exchange(stage_, stage))
        return;
    update();
}

void Overview::forget()
{
    drawing_ = {};
    update();
}

app::View Overview::view() const
{
    const app::Page& page = session_.now().page();
    const clipping::Window window = session_.window();
    app::View view;
    view.size = {width(), height()};
    const app::Point corner = page.min + page.size;
    view.fit({{std::min(page.min.x, window.min.x), std::min(page.min.y, window.min.y)},
              {std::max(corner.x, window.max.x), std::max(corner.y, window.max.y)}},
             overviewMargin);
    return view;
}

/// The visible lines, or a sample if there are many.
std::vector<QLineF> Overview::linesIn(const app::View& view) const
{
    const app::SceneLines& lines = session_.scene.lines();
    const std::size_t step = lines.size() / mostLines + 1;
    std::vector<QLineF> shown;
    for (std::size_t i = 0; i < lines.size(); i += step)
        if (const auto line = onScreen(lines[i], view))
            shown.push_back(*line);
    return shown;
}

QPixmap Overview::drawing(const app::View& view) const
{
    const Look& look = lookOnPaper(session_.display().darkPaper);
    QPixmap picture(size() * devicePixelRatioF());
    picture.setDevicePixelRatio(devicePixelRatioF());
    picture.fill(look.paper);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    // An opaque colour, so that overlapping lines do not become darker.
    const auto mixed = [&, share = look.ghost * 0.8](int ink, int paper) {
        return int(ink * share + paper * (1 - share));
    };
    painter.setPen(QPen(QColor(mixed(look.text.red(), look.paper.red()),
                               mixed(look.text.green(), look.paper.green()),
                               mixed(look.text.blue(), look.paper.blue())),
                        lineWidth));
    const auto shown = linesIn(view);
    double length = 0;
    for (const QLineF& line : shown)
        length += line.length();
    const double ink = length * lineWidth / (view.size.x * view.size.y);
    const auto step = std::size_t(ink / mostCoverage) + 1;
    for (std::size_t i = 0; i < shown.size(); i += step)
        painter.drawLine(shown[i]);
    return picture;
}

/// The frame around the stage, large enough to be seen; its corners are kept within reach of a
/// painter.
QPolygonF Overview::stageOn(const app::View& view, const app::WindowFrame& frame) const
{
    const auto& [min, max] = stage_;
    QPolygonF stage;
    for (const app::Point& corner :
         {min, app::Point(max.x, min.y), max, app::Point(min.x, max.y)}) {
        const app::Point on = view.toScreen(outOfFrame(frame, corner));
        stage << QPointF(std::clamp(on.x, -1e5, 1e5), std::clamp(on.y, -1e5, 1e5));
    }
    const QRectF box = stage.boundingRect();
    if (std::max(box.width(), box.height()) >= leastStage)
        return stage;
    const QPointF half(leastStage / 2, leastStage / 2);
    return QRectF(box.center() - half, box.center() + half);
}

/// The frame in whose directions the line is traced, on the drawing.
app::WindowFrame Overview::frameOf(const app::TracedLine& tracedLine) const
{
    const app::TracedWindow window = app::tracedWindow(session_);
    return window.frame.box == tracedLine.window ? window.frame
                                                 : app::WindowFrame{tracedLine.window};
}

void Overview::paintEvent(QPaintEvent*)
{
    const Look& look = lookOnPaper(session_.display().darkPaper);
    const app::View seen = view();
    if (drawing_.isNull())
        drawing_ = drawing(seen);
    QPainter painter(this);
    painter.drawPixmap(0, 0, drawing_);
    painter.setRenderHint(QPainter::Antialiasing);
    const app::TracedLine& tracedLine = session_.microscope.tracedLine();
    const app::WindowFrame frame = frameOf(tracedLine);
    const auto onPaper = [&](const app::Point& p) { return outOfFrame(frame, p); };
    QPolygonF window;
    for (const clipping::Segment& edge : app::edgesOf(tracedLine)) {
        const app::Point corner = seen.toScreen(onPaper(edge.a));
        window << QPointF(corner.x, corner.y);
    }
    QColor inside = look.accent;
    inside.setAlphaF(0.12F);
    painter.setPen(QPen(look.accent, 1.5));
    painter.setBrush(inside);
    painter.drawPolygon(window);
    painter.setPen(QPen(look.selection, 2, Qt::SolidLine, Qt::RoundCap));
    const auto& [a, b] = tracedLine.line;
    const QPolygonF stage = stageOn(seen, frame);
    const QRectF box = stage.boundingRect();
    if (const auto line = onScreen({onPaper(a), onPaper(b)}, seen);
        line && std::max(box.width(), box.height()) > leastWithLine)
        painter.drawLine(*line);
    painter.setPen(QPen(look.selection, 1.5, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(stage);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(look.border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void Overview::resizeEvent(QResizeEvent*) { forget(); }

} // namespace ui

#include "moc_overview.cpp"
