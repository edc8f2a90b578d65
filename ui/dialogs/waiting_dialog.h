// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"

#include <QDialog>

class QProgressBar;
class QPushButton;

namespace ui {

/// Says what the program's windows wait for, with a Cancel button. Esc and the close button are
/// Cancel too; only its owner closes it.
class WaitingDialog : public QDialog {
    Q_OBJECT

public:
    WaitingDialog(const QString& label, QWidget* window);

    void showProgress(const app::Progress& progress);
    void showStopping(); ///< Cancel was chosen, and the work has not ended yet
    void reject() override;

signals:
    void cancelled();

private:
    QProgressBar* bar_; ///< of unknown length until the first progress
    QPushButton* cancel_;
};

} // namespace ui
