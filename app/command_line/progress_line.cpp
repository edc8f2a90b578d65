// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/progress_line.h"

#include "app/base/text.h"
#include "app/command_line/refusal.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <unistd.h>

namespace app {
namespace {

using namespace std::string_view_literals;

constexpr auto empty = "\r\x1b[K"sv; // to the line's start, and erase it
constexpr qint64 patience = 500;     // milliseconds

std::atomic<bool> isShown = false; // a signal handler reads it
static_assert(decltype(isShown)::is_always_lock_free);

} // namespace

Follower ProgressLine::follower()
{
    return {{}, [this](const Progress& progress) { show(progress); }};
}

void ProgressLine::erase()
{
    if (isShown.exchange(false)) [[maybe_unused]]
        const auto written = ::write(STDERR_FILENO, empty.data(), empty.size());
}

void ProgressLine::show(const Progress& progress)
{
    const int percent = int(100 * progress.share);
    if (percent == shown_ || clock_.elapsed() < patience || ::isatty(STDERR_FILENO) == 0)
        return;
    shown_ = percent;
    const QString text =
        Text::tr("%1 %, %2 s left").arg(percent).arg(qint64(std::ceil(progress.secondsLeft)));
    isShown = true;
    std::fputs((QLatin1StringView(empty) + text).toUtf8().constData(), stderr);
}

} // namespace app
