// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/truth/live_truth.h"
#include "app/document/compared_window.h"

#include <QElapsedTimer>

namespace app {

using clipping::Clipped;
using clipping::Window;

namespace {

constexpr std::size_t sliceLines = 250;
constexpr qint64 sliceMilliseconds = 8;
constexpr int idleMilliseconds = 150; // many lines wait until a series of changes is over

} // namespace

LiveTruth::LiveTruth(const EditedDocument& document, const Scene& scene, QObject* parent)
    : QObject(parent), scene_(scene), window_(comparedWindow(document.now().windows(), document.now().page()).window)
{
    connect(&document, &EditedDocument::changed, this, &LiveTruth::outdate);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &LiveTruth::begin);
    connect(&work_, &QTimer::timeout, this, &LiveTruth::work);
}

void LiveTruth::ask(const std::optional<Question>& question)
{
    if (question == asked_)
        return;
    const bool same = question && asked_ && question->variant == asked_->variant;
    asked_ = question;
    if (same && upToDate_) // only measured otherwise
        return keep(std::move(found_));
    ofTheseLines_ = false;
    found_ = {};
    counts_ = {};
    pieces_.clear();
    restart();
    emit changed();
}

void LiveTruth::setWindow(const Window& window)
{
    if (window == window_)
        return;
    window_ = window;
    if (asked_ && ofTheseLines_ && found_.window == window)
        return keep(std::move(found_)); // a gesture was dropped
    const bool was = upToDate_;
    restart();
    if (asked_ && was && scene_.segments().size() > mostAtOnce)
        emit changed(); // what was found is of another window for a while
}

void LiveTruth::outdate(const DocumentChange& change)
{
    if (!asked_ || !change.drawing())
        return;
    ofTheseLines_ = false;
    restart();
    if (change.everything) {
        found_ = {};
        counts_ = {};
    }
    pieces_.clear();
    emit changed();
}

void LiveTruth::restart()
{
    growing_.reset();
    work_.stop();
    soon_.stop();
    upToDate_ = !asked_;
    if (!asked_)
        return;
    if (scene_.segments().size() > mostAtOnce)
        return soon_.start(idleMilliseconds);
    // Posted, not by a timer: requests to paint are posted, too, with less priority.
    if (!std::exchange(posted_, true))
        QMetaObject::invokeMethod(this, &LiveTruth::findAtOnce, Qt::QueuedConnection);
}

void LiveTruth::findAtOnce()
{
    posted_ = false;
    if (!upToDate_ && scene_.segments().size() <= mostAtOnce)
        keep(extended({window_}, asked_->variant, scene_.segments(), mostAtOnce));
}

void LiveTruth::begin()
{
    soon_.stop();
    growing_ = Truths{window_};
    work_.start(0);
    work();
}

void LiveTruth::work()
{
    QElapsedTimer clock;
    clock.start();
    const auto lines = scene_.segments();
    while (growing_->lines < lines.size() && clock.elapsed() < sliceMilliseconds)
        growing_ = extended(std::move(*growing_), asked_->variant, lines, sliceLines);
    if (growing_->lines == lines.size())
        keep(*std::exchange(growing_, std::nullopt));
    else
        emit progressed();
}

void LiveTruth::keep(Truths found)
{
    growing_.reset();
    soon_.stop();
    work_.stop();
    found_ = std::move(found);
    counts_ = counted(found_, asked_->yardstick);
    pieces_ = piecesOf(found_);
    upToDate_ = ofTheseLines_ = true;
    emit changed();
}

double LiveTruth::progress() const
{
    const std::size_t all = scene_.segments().size();
    return growing_ && all > 0 ? double(growing_->lines) / double(all) : upToDate_ ? 1 : 0;
}

void LiveTruth::finish()
{
    if (upToDate_)
        return;
    if (!growing_)
        begin();
    while (!upToDate_)
        work();
}

LiveTruth::Pieces LiveTruth::piecesOf(const Truths& truths) const
{
    Pieces pieces(errorClasses().size());
    for (const LineTruth& line : truths.list)
        pieces[errorClassOf(line, asked_->yardstick)].push_back({line.piece, line.source, 0});
    return pieces;
}

std::span<const std::vector<Clipped>> LiveTruth::piecesAt(const Window& window) const
{
    if (!asked_ || !upToDate_ || found_.window != window)
        return {};
    return pieces_;
}

} // namespace app
