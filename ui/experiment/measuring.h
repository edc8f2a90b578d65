// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

#include <QObject>

#include <memory>
#include <thread>

namespace ui {

/// Measures on a thread of its own. Its signals come on the thread that it lives on. When it goes,
/// it stops what goes on and waits for that: no thread outlives it.
class Measuring : public QObject {
    Q_OBJECT

public:
    explicit Measuring(QObject* parent = nullptr);
    ~Measuring() override;

    void start(app::Plan plan); ///< nothing may be going on
    void cancel();              ///< nothing is told of it any more; waits for the thread's end
    bool active() const { return thread_.joinable(); }
    static constexpr auto threadName = "measuring"; ///< as debuggers and tests see it

signals:
    void progressed(const app::Progress& progress); ///< at most 20 times a second
    void finished(const std::shared_ptr<const app::Study>& study);

private:
    void run(const std::stop_token& stop, const app::Plan& plan, int number);

    std::jthread thread_;
    int number_ = 0; ///< of the run: what an old one has posted comes too late
};

} // namespace ui
