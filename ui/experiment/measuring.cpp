// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/measuring.h"

#include <QElapsedTimer>

#include <pthread.h>

namespace ui {

namespace {

constexpr qint64 interval = 50; // milliseconds

} // namespace

Measuring::Measuring(QObject* parent) : QObject(parent) {}

Measuring::~Measuring() { cancel(); }

void Measuring::start(app::Plan plan)
{
    Q_ASSERT(!active());
    ++number_;
    thread_ =
        std::jthread([this, plan = std::move(plan), number = number_](const std::stop_token& stop) {
            ::pthread_setname_np(::pthread_self(), threadName);
            run(stop, plan, number);
        });
}

void Measuring::cancel()
{
    ++number_;
    if (!active())
        return;
    thread_.request_stop();
    thread_.join();
}

void Measuring::run(const std::stop_token& stop, const app::Plan& plan, int number)
{
    QElapsedTimer last;
    const auto tell = [&](const app::Progress& progress) {
        if (last.isValid() && last.elapsed() < interval)
            return;
        last.start();
        QMetaObject::invokeMethod(
            this,
            [this, progress, number] {
                if (number == number_)
                    emit progressed(progress);
            },
            Qt::QueuedConnection);
    };
    auto study = app::study(plan, {stop, tell});
    if (!study)
        return;
    auto result = std::make_shared<const app::Study>(std::move(*study));
    QMetaObject::invokeMethod(
        this,
        [this, result, number] {
            if (number != number_)
                return;
            thread_.join();
            emit finished(result);
        },
        Qt::QueuedConnection);
}

} // namespace ui
