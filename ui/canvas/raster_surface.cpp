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

constexpr double atOnceMs = 8; // pictures as fast as this are painted in the frame itself
constexpr double expectedMsPerLine = 6e-4; // until it was measured

// One picture being painted, band by band.
struct Job {
    FrameKey key;
    app::Picture picture;
    std::vector<QImage> bands;
    std::vector<app::Band> places;
    std::atomic<int> left;
    bool begun = false;
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
    RasterSurface(Controller& controller, const Pane& pane, Report report, QWidget* parent)
        : QWidget(parent), controller_(controller), pane_(pane), report_(std::move(report))
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
            begin(job_);
            pool_.waitForDone();
            deliver();
            repaint();
        }
    }

    void forget() override
    {
        job_.reset(); // its threads hold it, and deliver to nobody
        art_ = {};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QElapsedTimer clock;
        clock.start();
        const app::Frame frame = controller_.clip(pane_);
        const FrameKey key = controller_.key(pane_);
        if (art_.key != key || art_.image.size() != deviceSize())
            renew(frame, key);
        QPainter painter(this);
        paintPaper(painter, controller_);
        painter.drawImage(placeOfArt(), art_.image);
        paintOverlay(painter, controller_, pane_);
        const double clipMs = double(frame.nanoseconds) * 1e-6;
        const double waitMs = art_.key == key ? 0 : lastMs_; // painted by others meanwhile
        report_({clipMs, std::max(milliseconds(clock) - clipMs, waitMs), frame.nanoseconds,
                 frame.inside.size(), frame.total, pane_.choice});
    }

private:
    QSize deviceSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

    void renew(const app::Frame& frame, const FrameKey& key)
    {
        const bool known = measuredLines_ == frame.total && lastMs_ > 0;
        const double expected = known ? lastMs_ : double(frame.total) * expectedMsPerLine;
        const bool atOnce = expected * pane_.among <= atOnceMs;
        if (job_ && !atOnce)
            return; // deliver() will ask again
        auto job = std::make_shared<Job>();
        job->clock.start();
        job->key = key;
        job->picture = controller_.picture(frame, pane_, devicePixelRatioF());
        measuredLines_ = frame.total;
        job->places = app::bandsOf(deviceSize().height(), pool_.maxThreadCount());
        job->bands.resize(job->places.size());
        job->left = int(job->places.size());
        if (atOnce) {
            for (std::size_t i = 0; i < job->places.size(); ++i)
                job->bands[i] = painted(job->picture, job->places[i]);
            accept(*job);
            return;
        }
        job_ = job;
        // Not now: other panes are still to be clipped in this frame, and timed.
        QMetaObject::invokeMethod(
            this, [this, job] { begin(job); }, Qt::QueuedConnection);
    }

    void begin(const std::shared_ptr<Job>& job)
    {
        if (job != job_ || std::exchange(job->begun, true))
            return;
        for (std::size_t i = 0; i < job->places.size(); ++i)
            pool_.start([this, job, i, band = job->places[i], width = deviceSize().width(),
                         ratio = devicePixelRatioF(), ghost = controller_.ghostOpacity()] {
                job->bands[i] = app::rasterised(job->picture, width, band, ratio, ghost);
                if (--job->left == 0)
                    QMetaObject::invokeMethod(
                        this, [this] { deliver(); }, Qt::QueuedConnection);
            });
    }

    QImage painted(const app::Picture& picture, app::Band band) const
    {
        return app::rasterised(picture, deviceSize().width(), band, devicePixelRatioF(),
                               controller_.ghostOpacity());
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
    const Pane& pane_;
    Report report_;
    QThreadPool pool_;
    std::shared_ptr<Job> job_;
    Art art_;
    double lastMs_ = 0;
    std::size_t measuredLines_ = 0;
};

} // namespace

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, const Pane& pane,
                                           Surface::Report report, QWidget* parent)
{
    return std::make_unique<RasterSurface>(controller, pane, std::move(report), parent);
}

} // namespace ui
