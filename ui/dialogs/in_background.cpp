// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/in_background.h"

#include <cassert>

namespace ui {

namespace {

constexpr std::chrono::milliseconds patience{500};

} // namespace

const InBackground::Any InBackground::noMemory = std::make_shared<char>();

InBackground::InBackground(QWidget* window) : window_(window)
{
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, &InBackground::showDialog);
}

InBackground::~InBackground()
{
    waiting_.clear();
    done_ = {};
    if (working() && cancel_ == Cancel::Stops)
        job_->wait();
    delete dialog_;
}

void InBackground::start(const QString& label, std::function<Any(const app::Follower&)> work,
                         Deliver done, Cancel cancel)
{
    assert(!working());
    label_ = label;
    done_ = std::move(done);
    cancel_ = cancel;
    input_.hold();
    patience_.start(patience);
    job_ = std::make_unique<Job>();
    job_->start(
        std::move(work), [this](const Any& result) { finish(result); },
        [this](const app::Progress& progress) {
            if (dialog_)
                dialog_->showProgress(progress);
        });
}

void InBackground::showDialog()
{
    input_.drop(); // the dialog interrupts what the person was doing
    dialog_ = new WaitingDialog(label_, window_);
    connect(dialog_, &WaitingDialog::cancelled, this, &InBackground::cancel);
    dialog_->show();
}

void InBackground::cancel()
{
    if (cancel_ == Cancel::Stops) {
        dialog_->showStopping();
        return job_->requestStop();
    }
    job_->cancel();
    finish({});
}

/// The receiver of the result may start the next job, or destroy this object.
void InBackground::finish(const Any& result)
{
    patience_.stop();
    if (dialog_) {
        dialog_->hide();
        dialog_->deleteLater(); // it may be handling its own event
        dialog_.clear();
    }
    QMetaObject::invokeMethod(this, &InBackground::settle, Qt::QueuedConnection);
    const QPointer self(this);
    if (const auto done = std::exchange(done_, {}))
        done(result);
    if (self && result == noMemory)
        emit ranOutOfMemory();
}

bool InBackground::busy() const
{
    return working() || !turn_.expired() || !waiting_.empty() || input_.holding();
}

void InBackground::whenIdle(std::function<void()> act)
{
    inTurn([act = std::move(act)](const Turn&) { act(); });
}

void InBackground::inTurn(std::function<void(const Turn&)> act)
{
    const bool idle = !busy();
    waiting_.push_back(std::move(act));
    if (idle)
        settle();
}

/// Begins the next turn, or gives the input back.
void InBackground::settle()
{
    if (working() || !turn_.expired())
        return;
    if (waiting_.empty())
        return input_.release();
    const auto act = std::move(waiting_.front());
    waiting_.pop_front();
    const Turn turn(this, [self = QPointer(this)](void*) {
        if (self)
            QMetaObject::invokeMethod(self, &InBackground::settle, Qt::QueuedConnection);
    });
    turn_ = turn;
    act(turn);
}

void InBackground::wait(QDeadlineTimer deadline)
{
    do {
        while (working())
            if (deadline.isForever())
                job_->wait();
            else if (!job_->waitFor(std::chrono::milliseconds(deadline.remainingTime())))
                return;
        settle();
    } while (working());
}

} // namespace ui

#include "moc_in_background.cpp"
