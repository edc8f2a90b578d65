// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/live_picture.h"
#include "ui/canvas/overlay.h"
#include "ui/canvas/pane_widget.h"

#include <QPainter>
#include <QWidget>

namespace ui {
namespace {

/// The paper, the picture of the drawing as far as it is finished, and what lies above it.
class RasterSurface final : public QWidget, public Surface {
public:
    RasterSurface(Controller& controller, const Pane& pane, Report report, QWidget* parent)
        : QWidget(parent), controller_(controller), pane_(pane), report_(std::move(report))
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        connect(&picture_, &app::LivePicture::advanced, this, qOverload<>(&QWidget::update));
        connect(&picture_, &app::LivePicture::timed, this, [this] { report_(picture_.times()); });
        connect(&controller.session(), &app::Session::loaded, this, &RasterSurface::forget);
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
    void paintEvent(QPaintEvent*) override
    {
        want(controller_.frames().patience());
        QPainter painter(this);
        paintPaper(painter, controller_);
        picture_.paint(painter);
        paintOverlay(painter, controller_, pane_, picture_.key());
        report_(picture_.times());
    }

private:
    void want(std::chrono::microseconds patience)
    {
        const double ratio = devicePixelRatioF();
        const QSize pixels = (QSizeF(size()) * ratio).toSize();
        picture_.want(controller_.frames().wish(pane_, ratio, pixels), patience);
    }

    Controller& controller_;
    const Pane& pane_;
    Report report_;
    app::LivePicture picture_;
};

} // namespace

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, const Pane& pane,
                                           Surface::Report report, QWidget* parent)
{
    return std::make_unique<RasterSurface>(controller, pane, std::move(report), parent);
}

} // namespace ui
