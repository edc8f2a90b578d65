// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/overlay.h"
#include "ui/canvas/renderer.h"
#include "ui/canvas/surface.h"

#include <QElapsedTimer>
#include <QOpenGLPaintDevice>
#include <QOpenGLWidget>

namespace ui {
namespace {

class GlSurface final : public QOpenGLWidget, public Surface {
public:
    GlSurface(Controller& controller, const Pane& pane, Report report, QWidget* parent)
        : QOpenGLWidget(parent), controller_(controller), pane_(pane), report_(std::move(report))
    {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        format.setStencilBufferSize(8);
        setFormat(format);
    }
    ~GlSurface() override
    {
        makeCurrent();
        renderer_.reset();
        doneCurrent();
    }

    QWidget& widget() override { return *this; }
    void settle() override { repaint(); }
    void forget() override
    {
        picture_ = {};
        key_ = {};
    }

protected:
    // Called again if the widget moves to another window, which has another context.
    void initializeGL() override { renderer_ = Renderer::make(); }

    // Not QPainter(this), whose output is missing from QWidget::grab().
    void paintGL() override
    {
        QElapsedTimer clock;
        clock.start();
        const app::SceneFrame frame = controller_.clip(pane_);
        if (const FrameKey key = controller_.key(pane_);
            key != key_ || ratio_ != devicePixelRatioF()) {
            picture_ = controller_.picture(frame, pane_, devicePixelRatioF());
            key_ = key;
            ratio_ = devicePixelRatioF();
        }
        QOpenGLPaintDevice device((QSizeF(size()) * ratio_).toSize());
        device.setDevicePixelRatio(ratio_);
        QPainter painter(&device);
        painter.setFont(font());
        paintPaper(painter, controller_);
        if (renderer_) {
            painter.beginNativePainting();
            renderer_->paint(picture_, {width(), height()}, ratio_, controller_.ghostOpacity());
            painter.endNativePainting();
        }
        paintOverlay(painter, controller_, pane_);
        painter.end();
        const double clipMs = double(frame.nanoseconds) * 1e-6;
        report_({clipMs, double(clock.nsecsElapsed()) * 1e-6 - clipMs, frame.visible, frame.total,
                 pane_.choice});
    }

private:
    Controller& controller_;
    const Pane& pane_;
    Report report_;
    std::unique_ptr<Renderer> renderer_;
    app::Picture picture_;
    FrameKey key_;
    double ratio_ = 0;
};

} // namespace

std::unique_ptr<Surface> makeGlSurface(Controller& controller, const Pane& pane,
                                       Surface::Report report, QWidget* parent)
{
    return std::make_unique<GlSurface>(controller, pane, std::move(report), parent);
}

} // namespace ui
