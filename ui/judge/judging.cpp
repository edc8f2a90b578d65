// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judge/judging.h"

#include <QElapsedTimer>

namespace ui {

namespace {

constexpr qint64 interval = 50; // milliseconds

} // namespace

void Judging::start(app::plug_in::Case which)
{
    Q_ASSERT(!active());
    ++number_;
    thread_ = std::jthread([this, which = std::move(which), number = number_](
                               const std::stop_token& stop) { run(stop, which, number); });
}

void Judging::cancel()
{
    ++number_;
    if (!active())
        return;
    thread_.request_stop();
    thread_.join();
}

void Judging::run(const std::stop_token& stop, const app::plug_in::Case& which, int number)
{
    const auto later = [this, number](auto what) {
        QMetaObject::invokeMethod(
            this,
            [this, number, what] {
                if (number == number_)
                    what();
            },
            Qt::QueuedConnection);
    };
    QElapsedTimer last;
    auto verdict =
        app::plug_in::judge(which, {stop, [&](const app::Progress& progress) {
                                        if (last.isValid() && last.elapsed() < interval)
                                            return;
                                        last.start();
                                        later([this, progress] { emit progressed(progress); });
                                    }});
    if (!verdict)
        return;
    auto result = std::make_shared<const app::plug_in::Verdict>(std::move(*verdict));
    later([this, result] {
        thread_.join();
        emit finished(result);
    });
}

} // namespace ui
