// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/raster.h"
#include "ui/canvas/overlay.h"
#include "ui/canvas/surface.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QThread>
#include <QThreadPool>
#include <QWidget>

#include <atomic>

namespace ui {
namespace {

constexpr double atOnceMs = 8; // a picture as fast as this is painted in the frame itself
constexpr double expectedMsPerLine = 6e-4; // until it was measured

// One picture being painted, band by band.
struct Job {
    FrameKey key;
    app::Picture picture;
    std::vector<QImage> bands;
    std::atomic<int> left;
    QElapsedTimer clock;
};

// The art, as far as it is painted.
struct Art {
    FrameKey key;
    QImage image;
};

double milliseconds(const QElapsedTimer& clock) { return double(clock.nsecsElapsed()) * 1e-6; }

/// Where a picture takes long, the last one is shown, moved and scaled, until the new one is
/// there: it is painted by all cores meanwhile, and the newest wish is the next to be fulfilled.
class RasterSurface final : public QWidget, public Surface {
public:
    RasterSurface(Controller& controller, Report report, QWidget* parent)
        : QWidget(parent), controller_(controller), report_(std::move(report))
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        pool_.setMaxThreadCount(std::max(1, QThread::idealThreadCount()));
    }
    ~RasterSurface() override { pool_.waitForDone(); }

    QWidget& widget() override { return *this; }

    void settle() override
    {
        repaint();
        while (job_) {
            pool_.waitForDone();
            deliver();
            repaint();
        }
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QElapsedTimer clock;
        clock.start();
        const app::Frame frame = controller_.clip();
        const FrameKey key = controller_.key();
        if (art_.key != key || art_.image.size() != deviceSize())
            renew(frame, key);
        QPainter painter(this);
        paintPaper(painter, controller_);
        painter.drawImage(placeOfArt(), art_.image);
        paintOverlay(painter, controller_);
        const double clipMs = double(frame.nanoseconds) * 1e-6;
        const double waitMs = art_.key == key ? 0 : lastMs_; // painted by others meanwhile
        report_({clipMs, std::max(milliseconds(clock) - clipMs, waitMs), frame.nanoseconds,
                 frame.inside.size(), frame.total});
    }

private:
    QSize deviceSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

    void renew(const app::Frame& frame, const FrameKey& key)
    {
        const bool known = measuredLines_ == frame.total && lastMs_ > 0;
        const double expected = known ? lastMs_ : double(frame.total) * expectedMsPerLine;
        if (job_ && expected > atOnceMs)
            return; // deliver() will ask again
        auto job = std::make_shared<Job>();
        job->clock.start();
        job->key = key;
        job->picture = controller_.picture(frame, devicePixelRatioF());
        measuredLines_ = frame.total;
        const auto bands = app::bandsOf(deviceSize().height(), pool_.maxThreadCount());
        job->bands.resize(bands.size());
        job->left = int(bands.size());
        if (expected <= atOnceMs) {
            for (std::size_t i = 0; i < bands.size(); ++i)
                job->bands[i] = painted(job->picture, bands[i]);
            accept(*job);
            return;
        }
        job_ = job;
        for (std::size_t i = 0; i < bands.size(); ++i)
            pool_.start([this, job, i, band = bands[i], width = deviceSize().width(),
                         ratio = devicePixelRatioF(), ghost = controller_.look().ghost] {
                job->bands[i] = app::rasterised(job->picture, width, band, ratio, ghost);
                if (--job->left == 0)
                    QMetaObject::invokeMethod(
                        this, [this] { deliver(); }, Qt::QueuedConnection);
            });
    }

    QImage painted(const app::Picture& picture, app::Band band) const
    {
        return app::rasterised(picture, deviceSize().width(), band, devicePixelRatioF(),
                               controller_.look().ghost);
    }

    void accept(const Job& job)
    {
        art_ = {job.key, app::joined(job.bands)};
        lastMs_ = milliseconds(job.clock);
    }

    void deliver()
    {
        if (!job_ || job_->left != 0)
            return;
        accept(*job_);
        job_.reset();
        update();
    }

    // In the view of now, the rectangle that the art's view showed.
    QRectF placeOfArt() const
    {
        const app::View& now = controller_.view();
        const clipping::Window then = art_.key.view.visible();
        const app::Point from = now.toScreen(then.min), to = now.toScreen(then.max);
        return art_.key.view == now ? QRectF(rect())
                                    : QRectF(from.x, from.y, to.x - from.x, to.y - from.y);
    }

    Controller& controller_;
    Report report_;
    QThreadPool pool_;
    std::shared_ptr<Job> job_;
    Art art_;
    double lastMs_ = 0;
    std::size_t measuredLines_ = 0;
};

} // namespace

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, Surface::Report report,
                                           QWidget* parent)
{
    return std::make_unique<RasterSurface>(controller, std::move(report), parent);
}

} // namespace ui
