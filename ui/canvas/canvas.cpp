// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas.h"

#include "ui/canvas/backend.h"
#include "ui/canvas/ruler.h"
#include "ui/canvas/surface.h"

#include <QEvent>

namespace ui {

struct Canvas::Parts {
    Parts(app::Session& session, Backend wish, Canvas& canvas)
        : controller(session),
          choice(chooseBackend(wish, wish == Backend::Raster ? GlProbe{} : probeGl())),
          corner(controller, &canvas), top(controller, Qt::Horizontal, &canvas),
          left(controller, Qt::Vertical, &canvas),
          surface((choice.backend == Backend::OpenGL ? makeGlSurface : makeRasterSurface)(
              controller, [&canvas](const FrameTimes& times) { emit canvas.frameShown(times); },
              &canvas))
    {
    }

    void repaint()
    {
        surface->widget().update();
        surface->widget().setCursor(controller.cursor());
        top.update();
        left.update();
        corner.update();
    }

    Controller controller;
    Choice choice;
    RulerCorner corner;
    Ruler top, left;
    std::unique_ptr<Surface> surface;
};

Canvas::Canvas(app::Session& session, Backend backend, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(session, backend, *this))
{
    QWidget& surface = parts_->surface->widget();
    surface.setFocusPolicy(Qt::StrongFocus);
    surface.setMouseTracking(true);
    surface.setAccessibleName(tr("Drawing"));
    surface.installEventFilter(this);
    setFocusProxy(&surface);
    const Controller& controller = parts_->controller;
    connect(&controller, &Controller::changed, this, [this] { parts_->repaint(); });
    connect(&controller, &Controller::viewChanged, this, &Canvas::viewChanged);
    connect(&controller, &Controller::pointerMoved, this, &Canvas::pointerMoved);
    connect(&controller, &Controller::toolChanged, this, &Canvas::toolChanged);
    connect(&controller, &Controller::hintChanged, this,
            [this] { emit hint(parts_->controller.hint()); });
}

Canvas::~Canvas() = default;

Backend Canvas::backend() const { return parts_->choice.backend; }
QString Canvas::backendReason() const { return parts_->choice.reason; }
const app::View& Canvas::view() const { return parts_->controller.view(); }
clipping::Window Canvas::window() const { return parts_->controller.window(); }
double Canvas::zoom() const { return parts_->controller.zoom(); }
void Canvas::setTool(std::string_view key) { parts_->controller.setTool(key); }
std::string_view Canvas::tool() const { return parts_->controller.toolInfo().key; }
QString Canvas::toolHint() const { return parts_->controller.hint(); }
void Canvas::setSnapping(app::SnapTo to) { parts_->controller.setSnapping(to); }
void Canvas::setPointingDevice(PointingDevice device)
{
    parts_->controller.navigation().device = device;
}
void Canvas::fitDrawing() { parts_->controller.fitDrawing(); }
void Canvas::fitSelection() { parts_->controller.fitSelection(); }
void Canvas::fitWindow() { parts_->controller.fitWindow(); }
void Canvas::fit(const clipping::Window& place) { parts_->controller.navigation().show(place); }
void Canvas::setZoom(double zoom) { parts_->controller.setZoom(zoom); }
void Canvas::previousView() { parts_->controller.navigation().back(); }
void Canvas::nextView() { parts_->controller.navigation().forth(); }
void Canvas::settle() { parts_->surface->settle(); }

void Canvas::zoomBy(double factor)
{
    const app::Point size = view().size;
    parts_->controller.navigation().zoomAt({size.x / 2, size.y / 2}, factor);
}

void Canvas::resizeEvent(QResizeEvent*)
{
    const QRect inner = rect().adjusted(rulerWidth, rulerWidth, 0, 0);
    parts_->corner.setGeometry(0, 0, rulerWidth, rulerWidth);
    parts_->top.setGeometry(rulerWidth, 0, inner.width(), rulerWidth);
    parts_->left.setGeometry(0, rulerWidth, rulerWidth, inner.height());
    parts_->surface->widget().setGeometry(inner);
    parts_->controller.navigation().resize(
        {std::max(1, inner.width()), std::max(1, inner.height())});
}

void Canvas::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        parts_->controller.setLook(lookOf(palette()));
    QWidget::changeEvent(event);
}

bool Canvas::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        parts_->corner.setFocused(event->type() == QEvent::FocusIn);
    return parts_->controller.handle(*event) || QWidget::eventFilter(watched, event);
}

} // namespace ui
