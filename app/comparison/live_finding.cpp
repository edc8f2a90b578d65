// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/live_finding.h"

#include "app/scene/compared_window.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

using clipping::Window;

namespace {

constexpr qint64 sliceMilliseconds = 8;
constexpr int idleMilliseconds = 150; // many lines wait until a series of changes is over

} // namespace

LiveFinding::LiveFinding(const EditedDocument& document, const Scene& scene, BatchSizes sizes,
                         QObject* parent)
    : QObject(parent), scene_(scene), sizes_(sizes),
      window_(comparedWindow(document.now().windows(), document.now().page()).window)
{
    connect(&document, &EditedDocument::changed, this, &LiveFinding::follow);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &LiveFinding::begin);
    connect(&work_, &QTimer::timeout, this, &LiveFinding::work);
}

void LiveFinding::askAnew(bool something)
{
    asking_ = something;
    foundOf_.reset();
    forget();
    restart();
    emit changed();
}

void LiveFinding::setWindow(const Window& window)
{
    if (window == window_)
        return;
    window_ = window;
    const bool was = upToDate_;
    restart();
    if (asking_ && foundOf_ == now()) { // a drag was cancelled
        stop();
        upToDate_ = true;
        emit changed();
    } else if (was && !upToDate_ && many()) {
        emit changed(); // for a while the result belongs to another window
    }
}

// The scene handles the change first, so its lines are already the new ones.
void LiveFinding::follow(const DocumentChange& change)
{
    if (!asking_ || !change.drawing())
        return;
    if (!change.everything && upToDate_ && foundOf_ == now())
        return; // e.g. a layer was renamed
    const bool was = upToDate_;
    restart();
    if (change.everything) {
        foundOf_.reset();
        forget();
    }
    if (change.everything || (was && many()))
        emit changed();
}

void LiveFinding::restart()
{
    stop();
    upToDate_ = !asking_;
    if (!asking_)
        return;
    if (many())
        return soon_.start(idleMilliseconds);
    // Queued, not by a timer: paint requests are queued too, with lower priority.
    if (!std::exchange(posted_, true))
        QMetaObject::invokeMethod(this, &LiveFinding::findAtOnce, Qt::QueuedConnection);
}

void LiveFinding::stop()
{
    seen_.reset();
    soon_.stop();
    work_.stop();
}

void LiveFinding::findAtOnce()
{
    posted_ = false;
    if (upToDate_ || many())
        return;
    start(window_);
    look(scene_.lines(), scene_.lines().size());
    keepFound();
}

void LiveFinding::begin()
{
    soon_.stop();
    seen_ = 0;
    start(window_);
    work_.start(0);
    if (many())
        emit begun();
    work();
}

void LiveFinding::work()
{
    QElapsedTimer clock;
    clock.start();
    const SceneLines& lines = scene_.lines();
    do {
        const std::size_t more = std::min(sizes_.slice, lines.size() - *seen_);
        look(lines, more);
        *seen_ += more;
    } while (*seen_ < lines.size() && clock.elapsed() < sliceMilliseconds);
    if (*seen_ == lines.size())
        keepFound();
    else
        emit progressed();
}

void LiveFinding::keepFound()
{
    stop();
    keep();
    foundOf_ = now();
    upToDate_ = true;
    emit changed();
}

double LiveFinding::progress() const
{
    const std::size_t all = scene_.lines().size();
    return seen_ && all > 0 ? double(*seen_) / double(all) : upToDate_ ? 1 : 0;
}

void LiveFinding::finish()
{
    if (upToDate_)
        return;
    if (!seen_)
        begin();
    while (!upToDate_)
        work();
}

} // namespace app
