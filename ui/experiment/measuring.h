// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

#include <QObject>

#include <memory>
#include <thread>

namespace ui {

/// Measures on a thread of its own. Signals are emitted on the thread of this object. The
/// destructor cancels a running measurement and waits for its thread.
class Measuring : public QObject {
    Q_OBJECT

public:
    explicit Measuring(QObject* parent = nullptr);
    ~Measuring() override;

    void start(app::Plan plan); ///< precondition: nothing is running
    void cancel();              ///< no signal follows; waits for the thread's end
    bool active() const { return thread_.joinable(); }
    static constexpr auto threadName = "measuring"; ///< shown in debuggers, used by tests

signals:
    void progressed(const app::Progress& progress); ///< at most 20 times a second
    void finished(const std::shared_ptr<const app::Study>& study);

private:
    void run(const std::stop_token& stop, const app::Plan& plan, int number);

    std::jthread thread_;
    int number_ = 0; ///< of the run: events that an earlier run has posted are ignored
};

} // namespace ui
