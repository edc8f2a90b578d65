// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QDialog>
#include <QLabel>

namespace ui {

class LengthField;

/// A grid with an angle and two spacings of one's own. What is typed is shown at once.
class GridDialog : public QDialog {
    Q_OBJECT

public:
    explicit GridDialog(app::Session& session, QWidget* parent = nullptr);

private:
    LengthField* makeSpacing(const QString& name, double app::Grid::*spacing);
    void change(double app::Grid::*number, double value);
    void follow();

    app::Session& session_;
    LengthField *along_, *across_, *angle_;
    QLabel* refusal_;
};

} // namespace ui
