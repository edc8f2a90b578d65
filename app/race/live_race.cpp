// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/live_race.h"

#include "app/experiment/ranking.h"
#include "app/scene/compared_window.h"
#include "app/view/frame_times.h"

#include <algorithm>

namespace app {
namespace {

constexpr int tenthOfASecond = 100;
constexpr double sliceMilliseconds = 4; // and a step more
constexpr qint64 longEnough = 10'000;   // milliseconds; for large drawings, whose rounds take long

} // namespace

LiveRace::LiveRace(const EditedDocument& document, const Scene& scene, QObject* parent)
    : QObject(parent), scene_(scene),
      window_(comparedWindow(document.now().windows(), document.now().page()).place())
{
    for (QTimer* timer : {&next_, &show_}) {
        timer->setSingleShot(true);
        timer->setInterval(tenthOfASecond);
    }
    connect(&work_, &QTimer::timeout, this, &LiveRace::work); // when there are no other events
    connect(&next_, &QTimer::timeout, this, &LiveRace::begin);
    connect(&show_, &QTimer::timeout, this, &LiveRace::advanced);
    connect(&document, &EditedDocument::changed, this, &LiveRace::follow);
}

void LiveRace::setVariants(std::vector<Variant> variants)
{
    variants_ = std::move(variants);
    if (running()) {
        stop();
        start();
    }
}

void LiveRace::start()
{
    if (running())
        return;
    race_.emplace(variants_);
    sinceFindings_.invalidate();
    if (window_)
        begin();
}

void LiveRace::stop()
{
    race_.reset();
    for (QTimer* timer : {&work_, &next_, &show_})
        timer->stop();
}

// Paint requests are queued, and a timer waits for all queued events: the frame comes first.
void LiveRace::setWindow(const std::optional<clipping::Window>& window)
{
    const bool was = window_.has_value();
    window_ = window;
    if (!window && was && running()) { // the times are of another place
        stop();
        start();
    }
    if (window && running() && !race_->running() && !isOnWhatIsShown())
        next_.start(0);
}

std::span<const RaceRow> LiveRace::rows() const
{
    if (!running() || race_->rows().empty() || race_->rows().front().milliseconds.empty())
        return {};
    return race_->rows();
}

std::size_t LiveRace::lines() const { return running() ? race_->frame().lines.size() : 0; }

bool LiveRace::upToDate() const
{
    return running() && !race_->running() && race_->rounds() > 0 && isOnWhatIsShown();
}

// The scene handles the change first, so its lines are already the new ones.
void LiveRace::follow(const DocumentChange& change)
{
    if (!change.drawing() || !running() || !window_ || isOnWhatIsShown())
        return;
    race_->drop();
    work_.stop();
    next_.start(tenthOfASecond);
}

bool LiveRace::isOnWhatIsShown() const
{
    return window_ && race_->frame().is(scene_.lines(), *window_);
}

void LiveRace::begin()
{
    next_.stop();
    sinceBegin_.start();
    const bool same = isOnWhatIsShown() && race_->rounds() > 0;
    if (!same)
        sinceNew_.start();
    const bool quick =
        !same && sinceFindings_.isValid() && sinceFindings_.elapsed() < tenthOfASecond;
    if (!quick)
        sinceFindings_.start();
    race_->begin({scene_.lines(), *window_},
                 quick ? Race::Purpose::Times : Race::Purpose::Findings);
    settled_ = false;
    work_.start(0);
}

void LiveRace::work()
{
    QElapsedTimer clock;
    clock.start();
    do
        if (race_->step())
            return finishRound();
    while (double(clock.nsecsElapsed()) * 1e-6 < sliceMilliseconds);
}

void LiveRace::finishRound()
{
    work_.stop();
    if (!show_.isActive())
        show_.start();
    if (!isOnWhatIsShown())
        return begin();
    settled_ = enough();
    if (!settled_)
        next_.start(int(std::max<qint64>(0, tenthOfASecond - sinceBegin_.elapsed())));
}

bool LiveRace::enough() const
{
    const std::size_t rounds = race_->rounds();
    return rounds >= Race::length
           || (rounds >= leastRounds(variants_.size()) && sinceNew_.elapsed() >= longEnough)
           || (rounds >= 2 && lines() < leastLinesToTime);
}

} // namespace app

#include "moc_live_race.cpp"
