// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_values.h"

#include <QToolButton>
#include <QWidget>

#include <array>

namespace ui {

class LengthField;
class UnitButton;

/// The clip window that tools act on in numbers: X, Y and the angle of its frame, also during a
/// gesture; and W and H, unless its capsule has them. Each edit is one undo step.
class WindowFields : public QWidget {
    Q_OBJECT

public:
    explicit WindowFields(app::Session& session);

    void startTyping(); ///< at X
    void showSize(bool shown);

signals:
    void entered(); ///< a number or a unit was entered: the focus returns to the canvas
    void refused(const QString& sentence); ///< the typed text is not a length
    void taken();                          ///< a field's value is valid again

private:
    void addRows();
    void follow();
    LengthField& field(app::WindowValue which) { return *fields_[std::size_t(which)]; }

    app::Session& session_;
    std::array<LengthField*, 5> fields_; ///< in the order of app::WindowValue
    QWidget* size_;                      ///< the row of width and height
    QToolButton* chain_;                 ///< checked: W and H keep their ratio
    UnitButton* unit_;
};

} // namespace ui
