// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/live_picture.h"
#include "ui/canvas/overlay.h"
#include "ui/canvas/pane_widget.h"
#include "ui/canvas/renderer.h"

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
        connect(&picture_, &app::LivePicture::advanced, this, qOverload<>(&QWidget::update));
        connect(&picture_, &app::LivePicture::timed, this, [this] { report_(picture_.times()); });
        connect(&controller.session(), &app::Session::loaded, this, &GlSurface::forget);
    }
    ~GlSurface() override
    {
        makeCurrent();
        renderer_.reset();
        doneCurrent();
    }

    QWidget& widget() override { return *this; }
    void forget() override { picture_.forget(); }
    // Not by repaint(), which paints later if this window was composed less than a frame ago.
    void settle() override
    {
        want({});
        picture_.settle();
    }

protected:
    // Called again if the widget moves to another window, which has another context.
    void initializeGL() override { renderer_ = Renderer::make(); }

    // Not QPainter(this), whose output is missing from QWidget::grab().
    void paintGL() override
    {
        const double ratio = devicePixelRatioF();
        want(controller_.frames().patience());
        QOpenGLPaintDevice device((QSizeF(size()) * ratio).toSize());
        device.setDevicePixelRatio(ratio);
        QPainter painter(&device);
        painter.setFont(font());
        paintPaper(painter, controller_);
        const auto art = std::static_pointer_cast<const GlPicture>(picture_.frame().made);
        picture_.paint(painter);
        if (renderer_ && art) {
            painter.beginNativePainting();
            renderer_->paint(*art, placed(picture_.key()->view), {width(), height()}, ratio,
                             controller_.frames().ghostOpacity());
            painter.endNativePainting();
        }
        paintOverlay(painter, controller_, pane_, picture_.key());
        painter.end();
        report_(picture_.times());
    }

private:
    void want(std::chrono::microseconds patience)
    {
        const double ratio = devicePixelRatioF();
        app::FrameWish wish =
            controller_.frames().wish(pane_, ratio, (QSizeF(size()) * ratio).toSize());
        wish.make = [size = wish.key.view.size](const app::Picture& picture) {
            return std::make_shared<const GlPicture>(glPicture(picture, size));
        };
        picture_.want(std::move(wish), patience);
    }
    /// Where the picture of a view is in the current one.
    Placed placed(const app::View& then) const
    {
        const app::View& now = controller_.view();
        return {now.zoom / then.zoom, (then.centre - now.centre) * now.zoom};
    }

    Controller& controller_;
    const Pane& pane_;
    Report report_;
    std::unique_ptr<Renderer> renderer_;
    app::LivePicture picture_;
};

} // namespace

std::unique_ptr<Surface> makeGlSurface(Controller& controller, const Pane& pane,
                                       Surface::Report report, QWidget* parent)
{
    return std::make_unique<GlSurface>(controller, pane, std::move(report), parent);
}

} // namespace ui
