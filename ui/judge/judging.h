// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/judge.h"

#include <QObject>

#include <memory>
#include <thread>

namespace ui {

/// Judges on a thread of its own, which the child process belongs to. Its signals come on the
/// thread that it lives on. When it goes, it stops what goes on and waits for that.
class Judging : public QObject {
    Q_OBJECT

public:
    explicit Judging(QObject* parent = nullptr) : QObject(parent) {}
    ~Judging() override { cancel(); }

    bool active() const { return thread_.joinable(); }
    /// Not while one is active.
    void start(app::plug_in::Case which);
    /// Nothing comes of it any more.
    void cancel();

signals:
    void progressed(const app::Progress& progress); ///< at most twenty times a second
    void finished(const std::shared_ptr<const app::plug_in::Verdict>& verdict);

private:
    void run(const std::stop_token& stop, const app::plug_in::Case& which, int number);

    std::jthread thread_;
    int number_ = 0; ///< of the last one that was begun or cancelled
};

} // namespace ui
