// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/signal_watch.h"
#include "app/recovery/unsaved_work.h"

#include <QObject>

#include <optional>

namespace ui {

class MainWindow;

/// Keeps unsaved work when a signal ends the program, and offers what earlier runs have left. It
/// goes before its window; what it recovered is then saved or given up.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(MainWindow& window, QString folder = app::leftoverFolder());
    ~Recovery() override;

    /// Asks about each leftover until one is recovered; the others wait for the next start.
    void offer();

private:
    void tell();
    void forgetRecovered();
    void keep(int signal) const;

    MainWindow& window_;
    QString folder_;
    QString file_; ///< where unsaved work goes; the watch knows it from work_
    app::UnsavedWork work_;
    std::optional<app::Leftover> recovered_; ///< as long as it is not saved
    std::optional<app::SignalWatch> watch_;
};

} // namespace ui
