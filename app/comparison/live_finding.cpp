// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/live_finding.h"

#include "app/scene/compared_window.h"

#include <algorithm>

namespace app {

using clipping::Window;

namespace {

constexpr int idleMilliseconds = 150; // many lines wait until a series of changes is over
constexpr std::chrono::milliseconds patience(3); // for few lines, before the next frame

} // namespace

LiveFinding::LiveFinding(const EditedDocument& document, const Scene& scene, BatchSizes sizes,
                         QObject* parent)
    : QObject(parent), scene_(scene), sizes_(sizes),
      window_(comparedWindow(document.now().windows(), document.now().page()).place())
{
    connect(&document, &EditedDocument::changed, this, &LiveFinding::follow);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &LiveFinding::begin);
}

void LiveFinding::askAnew(bool something)
{
    asking_ = something;
    foundOf_.reset();
    forget();
    restart();
    emit changed();
}

void LiveFinding::setWindow(const std::optional<Window>& window)
{
    if (window == window_)
        return;
    window_ = window;
    const bool was = upToDate_;
    if (!window_) {
        foundOf_.reset();
        forget();
    }
    restart();
    if (!window_) {
        if (asking_)
            emit changed();
        return;
    }
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
    upToDate_ = !asking_ || !window_;
    if (upToDate_)
        return;
    if (many())
        return soon_.start(idleMilliseconds);
    // Queued, not by a timer: paint requests are queued too, with lower priority.
    if (!std::exchange(posted_, true))
        QMetaObject::invokeMethod(this, &LiveFinding::findAtOnce, Qt::QueuedConnection);
}

void LiveFinding::stop()
{
    soon_.stop();
    background_.cancel();
}

void LiveFinding::findAtOnce()
{
    posted_ = false;
    if (upToDate_ || many())
        return;
    begin();
    if (!background_.waitFor(patience))
        emit changed(); // for a while the result is old
}

void LiveFinding::begin()
{
    soon_.stop();
    share_ = 0;
    background_.start(
        [finding = start(*window_), lines = scene_.lines(),
         slice = sizes_.slice](const Follower& follower) mutable {
            for (std::size_t seen = 0; seen < lines.size() && !follower.stop.stop_requested();) {
                const std::size_t more = std::min(slice, lines.size() - seen);
                finding->look(lines, more);
                seen += more;
                follower.progress({double(seen) / double(lines.size()), 0});
            }
            return std::move(finding);
        },
        [this](const std::unique_ptr<Finding>& whole) { keepFound(*whole); },
        [this](const Progress& progress) {
            share_ = progress.share;
            if (many())
                emit progressed();
        });
    if (many())
        emit begun();
}

void LiveFinding::keepFound(Finding& whole)
{
    stop();
    keep(whole);
    foundOf_ = now();
    upToDate_ = true;
    emit changed();
}

double LiveFinding::progress() const { return background_.active() ? share_ : upToDate_ ? 1 : 0; }

void LiveFinding::finish()
{
    if (!upToDate_ && !background_.active())
        begin();
    background_.wait();
}

} // namespace app

#include "moc_live_finding.cpp"
