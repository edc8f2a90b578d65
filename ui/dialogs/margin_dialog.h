// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_places.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace ui {

class LengthField;

/// Lays a clip window on the page without margins: the same on all sides, or each its own.
class MarginDialog : public QDialog {
    Q_OBJECT

public:
    MarginDialog(app::Session& session, QWidget* parent);

    static void show(app::Session& session, QWidget& parent);
    void accept() override;

private:
    QGridLayout* makeFields();
    void take(double app::PageMargins::*side, double margin);
    void follow();
    void sayHint();

    struct Side {
        LengthField* field;
        double app::PageMargins::*margin;
    };
    app::Session& session_;
    app::PageMargins margins_;
    std::array<Side, 4> sides_;
    QCheckBox* same_;
    QLabel* sentence_; ///< a hint, or why something is refused
};

} // namespace ui
