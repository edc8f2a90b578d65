// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/raster.h"
#include "ui/canvas/overlay.h"
#include "ui/canvas/surface.h"

#include <QElapsedTimer>
#include <QFutureWatcher>
#include <QPainter>
#include <QPromise>
#include <QThreadPool>
#include <QWidget>

#include <atomic>

namespace ui {
namespace {

constexpr double atOnceMs = 8; // pictures that take less are painted in the frame itself
constexpr double expectedMsPerLine = 6e-4; // estimate until it is measured

// A picture being painted, band by band. The painting threads share its ownership and do not use
// widgets.
struct Job {
    FrameKey key;
    app::Picture picture;
    app::RasterOptions options;
    std::vector<QImage> bands;
    std::vector<app::Band> places;
    std::atomic<int> left;
    bool begun = false;
    QElapsedTimer clock;
    QPromise<void> promise; ///< finished with the last band, or cancelled

    void paint(std::size_t band)
    {
        bands[band] = app::rasterised(picture, places[band], options);
        if (--left == 0)
            promise.finish();
    }
};

// The painted picture, possibly out of date.
struct Art {
    FrameKey key;
    QImage image;
};

double milliseconds(const QElapsedTimer& clock) { return double(clock.nsecsElapsed()) * 1e-6; }

/// While a slow picture is being painted on all cores, the last one is shown, moved and scaled.
/// When it is finished, the newest requested picture is painted next.
class RasterSurface final : public QWidget, public Surface {
public:
    RasterSurface(Controller& controller, const Pane& pane, Report report, QWidget* parent)
        : QWidget(parent), controller_(controller), pane_(pane), report_(std::move(report))
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        connect(&watcher_, &QFutureWatcherBase::finished, this, &RasterSurface::deliver);
        connect(&controller.session(), &app::Session::loaded, this, &RasterSurface::forget);
    }
    ~RasterSurface() override { cancel(); }

    QWidget& widget() override { return *this; }

    void settle() override
    {
        repaint();
        while (job_) {
            begin(job_);
            job_->promise.future().waitForFinished();
            deliver();
            repaint();
        }
    }

    void forget() override
    {
        cancel();
        art_ = {};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QElapsedTimer clock;
        clock.start();
        const app::SceneFrame frame = controller_.clip(pane_);
        const FrameKey key = controller_.key(pane_);
        if (art_.key != key || art_.image.size() != deviceSize())
            renew(frame, key);
        QPainter painter(this);
        paintPaper(painter, controller_);
        painter.drawImage(placeOfArt(), art_.image);
        paintOverlay(painter, controller_, pane_);
        const double clipMs = double(frame.nanoseconds) * 1e-6;
        const double waitMs = art_.key == key ? 0 : lastMs_; // painted by other threads
        report_({clipMs, std::max(milliseconds(clock) - clipMs, waitMs), frame.visible, frame.total,
                 pane_.choice, art_.key != key});
    }

private:
    // The program's global pool: QCoreApplication waits for its threads at exit.
    static QThreadPool& pool() { return *QThreadPool::globalInstance(); }
    QSize deviceSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

    void renew(const app::SceneFrame& frame, const FrameKey& key)
    {
        const bool known = measuredLines_ == frame.total && lastMs_ > 0;
        const double expected = known ? lastMs_ : double(frame.total) * expectedMsPerLine;
        const bool atOnce = expected * pane_.among <= atOnceMs;
        if (job_ && !atOnce)
            return; // deliver() will start the next one
        auto job = std::make_shared<Job>();
        job->clock.start();
        job->key = key;
        job->picture = controller_.picture(frame, pane_, devicePixelRatioF());
        job->options = {deviceSize().width(), devicePixelRatioF(), controller_.ghostOpacity(),
                        [wish = job.get()] { return wish->promise.isCanceled(); }};
        measuredLines_ = frame.total;
        job->places = app::bandsOf(deviceSize().height(), pool().maxThreadCount());
        job->bands.resize(job->places.size());
        job->left = int(job->places.size());
        job->promise.start();
        if (atOnce) {
            for (std::size_t i = 0; i < job->places.size(); ++i)
                job->paint(i);
            accept(*job);
            return;
        }
        job_ = job;
        // Queued, because other panes must first be clipped and timed in this frame.
        QMetaObject::invokeMethod(
            this, [this, job] { begin(job); }, Qt::QueuedConnection);
    }

    void begin(const std::shared_ptr<Job>& job)
    {
        if (job != job_ || std::exchange(job->begun, true))
            return;
        watcher_.setFuture(job->promise.future());
        for (std::size_t i = 0; i < job->places.size(); ++i)
            pool().start([job, i] { job->paint(i); });
    }

    // Does not wait for the job's threads, which stop soon.
    void cancel()
    {
        if (job_)
            job_->promise.future().cancel();
        job_.reset();
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

    // The rectangle that the painted picture covers in the current view.
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
    std::shared_ptr<Job> job_;
    QFutureWatcher<void> watcher_; // watches job_
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
