// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "ui/dialogs/held_input.h"
#include "ui/dialogs/waiting_dialog.h"

#include <QDeadlineTimer>
#include <QTimer>

#include <memory>
#include <new>
#include <optional>

namespace ui {

/// Long work of a window on another thread, one job at a time. During a job no window of the
/// program takes input: what comes in the first 0.5 s is delivered after the job; then a dialog
/// shows a label and a Cancel button. The destructor delivers nothing; it waits for a job that
/// Stops, so that a file is written completely.
class InBackground : public QObject {
    Q_OBJECT

public:
    explicit InBackground(QWidget* window); ///< null: the dialog has no window under it
    ~InBackground() override;

    /// The effect of Cancel.
    enum class Cancel : std::uint8_t {
        Drops, ///< no result at once; the work runs on unseen
        Stops  ///< the work is asked to stop; the dialog stays, and the result is delivered
    };
    /// Runs `Result work(const app::Follower&)`, which must own everything it uses, and may throw
    /// std::bad_alloc alone. An event calls `done(std::optional<Result>)`; empty: cancelled, or
    /// there was not enough memory. No other job may be running.
    template <class Work, class Done>
    void run(const QString& label, Work work, Done done, Cancel cancel);

    /// A turn lasts until the last copy of its token is destroyed.
    using Turn = std::shared_ptr<void>;
    /// Calls `act` at once if idle, otherwise when everything before it has ended. Several jobs and
    /// questions that belong together are one turn, which nothing interrupts.
    void inTurn(std::function<void(const Turn&)> act);
    void whenIdle(std::function<void()> act);
    bool busy() const; ///< a job or a turn has not ended, or input is still held
    /// Blocks until no job runs, whose results are then delivered, or until the deadline.
    void wait(QDeadlineTimer deadline = QDeadlineTimer(QDeadlineTimer::Forever));

signals:
    void ranOutOfMemory(); ///< after `done`

private:
    using Any = std::shared_ptr<void>;
    static const Any noMemory; ///< in place of a result
    using Job = app::Background<Any>;
    using Deliver = std::function<void(Any)>;

    void start(const QString& label, std::function<Any(const app::Follower&)> work, Deliver done,
               Cancel cancel);
    void showDialog();
    void cancel();
    void finish(const Any& result);
    void settle();
    bool working() const { return job_ && job_->active(); }

    QWidget* window_;
    /// A new one each time: a dropped job that runs on must not delay the next.
    std::unique_ptr<Job> job_;
    Deliver done_;
    QString label_;
    Cancel cancel_{};
    QTimer patience_;
    QPointer<WaitingDialog> dialog_;
    HeldInput input_;
    std::weak_ptr<void> turn_;
    std::deque<std::function<void(const Turn&)>> waiting_;
};

template <class Work, class Done>
void InBackground::run(const QString& label, Work work, Done done, Cancel cancel)
{
    using Result = std::invoke_result_t<Work&, const app::Follower&>;
    start(
        label,
        [work = std::move(work)](const app::Follower& follower) mutable -> Any {
            try {
                return std::make_shared<Result>(work(follower));
            } catch (const std::bad_alloc&) {
                return noMemory;
            }
        },
        [done = std::move(done)](const Any& result) mutable {
            auto* const made = result == noMemory ? nullptr : static_cast<Result*>(result.get());
            done(made ? std::optional<Result>(std::move(*made)) : std::nullopt);
        },
        cancel);
}

} // namespace ui
