// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/judge.h"

#include <QObject>

#include <memory>
#include <thread>

namespace ui {

/// Judges on a thread of its own, which owns the child process. Signals are emitted on the thread
/// of this object. The destructor cancels a running judgement and waits for it.
class Judging : public QObject {
    Q_OBJECT

public:
    explicit Judging(QObject* parent = nullptr) : QObject(parent) {}
    ~Judging() override { cancel(); }

    bool active() const { return thread_.joinable(); }
    /// Precondition: !active().
    void start(app::plug_in::Case which);
    /// Stops the judgement; no signal follows.
    void cancel();

signals:
    void progressed(const app::Progress& progress); ///< at most twenty times a second
    void finished(const std::shared_ptr<const app::plug_in::Verdict>& verdict);

private:
    void run(const std::stop_token& stop, const app::plug_in::Case& which, int number);

    std::jthread thread_;
    int number_ = 0; ///< of the last run that was started or cancelled
};

} // namespace ui
