// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include "ui/canvas/canvas_colours.h"

#include <QPainter>

namespace ui {

class Canvas::Parts : public QWidget {
public:
    Parts(app::Session& s, QWidget* parent) : QWidget(parent), session(s) {}

    void paintEvent(QPaintEvent*) override
    {
        const CanvasColours colours = canvasColours(palette());
        const auto frame =
            session.scene.clip(session.uses(), session.sheet().window, app::Scene::Removed::Kept);
        QPainter painter(this);
        painter.fillRect(rect(), colours.around);
        const auto at = [&](const app::Point& p) {
            const auto s = view.toScreen(p);
            return QPointF(s.x, s.y);
        };
        const auto page = session.sheet().page.rectangle();
        painter.fillRect(QRectF(at(page.min), at(page.max)), colours.page);
        painter.setRenderHint(QPainter::Antialiasing);
        for (const auto& piece : frame.inside)
            painter.drawLine(at(piece.segment.a), at(piece.segment.b));
        painter.setOpacity(colours.ghost);
        for (const auto& piece : frame.outside)
            painter.drawLine(at(piece.segment.a), at(piece.segment.b));
    }
    void resizeEvent(QResizeEvent*) override
    {
        view.size = {width(), height()};
        view.fit(session.sheet().page.rectangle());
    }

    app::Session& session;
    app::View view;
    std::string_view tool = "select";
};

Canvas::Canvas(app::Session& session, Backend, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(session, this))
{
    connect(&session.scene, &app::Scene::outdated, parts_.get(), qOverload<>(&QWidget::update));
    connect(&session, &app::Session::displayChanged, parts_.get(), qOverload<>(&QWidget::update));
}
Canvas::~Canvas() = default;

void Canvas::resizeEvent(QResizeEvent*) { parts_->setGeometry(rect()); }

Backend Canvas::backend() const { return Backend::Raster; }
QString Canvas::backendReason() const { return tr("Raster canvas"); }
const app::View& Canvas::view() const { return parts_->view; }
double Canvas::zoom() const { return parts_->view.zoom; }
void Canvas::setTool(std::string_view key)
{
    parts_->tool = key;
    emit toolChanged();
}
std::string_view Canvas::tool() const { return parts_->tool; }
void Canvas::fitDrawing() { parts_->view.fit(parts_->session.sheet().page.rectangle()); }
void Canvas::fitSelection() { fitDrawing(); }
void Canvas::fitWindow() { parts_->view.fit(parts_->session.sheet().window); }
void Canvas::zoomBy(double factor) { parts_->view.zoomAt(parts_->view.size * 0.5, factor); }
void Canvas::setZoom(double zoom) { parts_->view.zoom = zoom; }
void Canvas::previousView() {}
void Canvas::nextView() {}
void Canvas::settle() {}

} // namespace ui
