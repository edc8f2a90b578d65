// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/truth/live_truth.h"

#include <QElapsedTimer>

namespace app {

using clipping::Clipped;
using clipping::Window;

namespace {

constexpr std::size_t sliceLines = 250;
constexpr qint64 sliceMilliseconds = 8;
constexpr int idleMilliseconds = 150; // many lines wait until a series of changes is over

} // namespace

LiveTruth::LiveTruth(const Drawing& drawing, const Scene& scene, QObject* parent)
    : QObject(parent), drawing_(drawing), scene_(scene)
{
    connect(&drawing, &Drawing::changed, this, &LiveTruth::outdate);
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
    found_ = {};
    counts_ = {};
    pieces_.clear();
    restart();
    emit changed();
}

void LiveTruth::outdate(const Change& change)
{
    if (!asked_)
        return;
    restart();
    if (change.kind == Change::Kind::Everything) {
        found_ = {};
        counts_ = {};
    }
    pieces_.clear();
    emit changed();
}

void LiveTruth::restart()
{
    passing_.reset();
    growing_.reset();
    work_.stop();
    soon_.stop();
    upToDate_ = !asked_;
    if (asked_)
        soon_.start(scene_.segments().size() <= mostAtOnce ? 0 : idleMilliseconds);
}

void LiveTruth::begin()
{
    soon_.stop();
    growing_ = Truths{drawing_.sheet().window};
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
    work_.stop();
    found_ = std::move(found);
    counts_ = counted(found_, asked_->yardstick);
    pieces_ = piecesOf(found_);
    passing_.reset();
    upToDate_ = true;
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

std::span<const std::vector<Clipped>> LiveTruth::piecesAt(const Window& window)
{
    if (!asked_)
        return {};
    if (upToDate_ && found_.window == window)
        return pieces_;
    const auto lines = scene_.segments();
    if (lines.size() > mostAtOnce)
        return {};
    if (!passing_ || passing_->first != window)
        passing_ = {window, piecesOf(extended({window}, asked_->variant, lines, lines.size()))};
    return passing_->second;
}

} // namespace app
