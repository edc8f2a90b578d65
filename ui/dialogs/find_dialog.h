// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QDialog>

class QLabel;
class QLineEdit;

namespace ui {

/// Asks for an id or a name, and selects what has it. It stays open, so that one can look for
/// something else.
class FindDialog : public QDialog {
    Q_OBJECT

public:
    explicit FindDialog(app::Session& session, QWidget* parent = nullptr);

signals:
    void found(); ///< something is selected

private:
    void search();

    app::Session& session_;
    QLineEdit* text_;
    QLabel* result_;
};

} // namespace ui
