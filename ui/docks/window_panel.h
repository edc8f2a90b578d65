// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QStackedLayout>
#include <QToolButton>

#include <array>

class QMenu;

namespace ui {

class LengthField;
class ToolList;
class UnitBox;
class WindowList;

/// The list of clip windows, and the one that tools act on in numbers, also during a gesture. Each
/// edit is one undo step.
class WindowPanel : public QWidget {
    Q_OBJECT

public:
    explicit WindowPanel(app::Session& session, QWidget* parent = nullptr);

signals:
    void entered(); ///< a number or a unit was entered: the focus returns to the canvas
    void refused(const QString& sentence); ///< the typed text is not a length
    void taken();                          ///< a field's value is valid again

private:
    QWidget* makeFields();
    QWidget* makeTools();
    QWidget* makeOffer(); ///< shown if there is no clip window
    QToolButton* makeAdd();
    QMenu* makeAddMenu();
    void follow();
    void edit(std::size_t field, double length, app::Merging merging);

    app::Session& session_;
    WindowList* list_;
    ToolList* operation_;
    std::array<LengthField*, 4> fields_; ///< X Y W H
    QToolButton* chain_;                 ///< checked: W and H keep their ratio
    UnitBox* unit_;
    QStackedLayout* pages_; ///< the fields, or the offer
};

} // namespace ui
