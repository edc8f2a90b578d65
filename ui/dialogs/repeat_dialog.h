// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>

namespace ui {

class LengthField;
class Segments;

/// Repeats the selection in rows and columns, or around a point. While it is open, the copies are
/// the session's preview.
class RepeatDialog : public QDialog {
    Q_OBJECT

public:
    explicit RepeatDialog(app::Session& session, QWidget* parent = nullptr);

    void accept() override;
    void done(int result) override;

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeGrid();
    QWidget* makeCircle();
    LengthField* makeField(const QString& name, double length);
    std::vector<app::AffineMap> maps() const;
    void follow();

    app::Session& session_;
    clipping::Window box_; ///< of the selection
    Segments* kind_;
    QStackedWidget* pages_;
    QSpinBox *rows_, *columns_, *count_;
    LengthField *across_, *down_; ///< gaps
    LengthField *x_, *y_, *angle_;
    QLabel* result_;
    QPushButton* repeat_;
    app::Point gap_, centre_; ///< in user units
    double degrees_ = 360;
};

} // namespace ui
