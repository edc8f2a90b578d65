// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QStackedLayout>
#include <QToolButton>

#include <array>

namespace ui {

class ElidedLabel;
class LengthField;
class UnitBox;

/// The clip window in numbers, also during a gesture. Each edit is one undo step.
class WindowPanel : public QWidget {
    Q_OBJECT

public:
    explicit WindowPanel(app::Session& session, QWidget* parent = nullptr);

signals:
    void entered(); ///< a number or a unit was entered: the focus returns to the canvas
    void refused(const QString& sentence); ///< the typed text is not a length
    void taken();                          ///< a field's value is valid again
    void resized();                        ///< the height that it needs has changed

private:
    QWidget* makeFields();
    QWidget* makeOffer(); ///< shown if there is no clip window
    void follow();
    void sayWhich();
    void edit(std::size_t field, double length, app::Merging merging);

    app::Session& session_;
    ElidedLabel* which_; ///< which clip window of how many; hidden if there is only one
    std::array<LengthField*, 4> fields_; ///< X Y W H
    QToolButton* chain_;                 ///< checked: W and H keep their ratio
    UnitBox* unit_;
    QStackedLayout* pages_; ///< the fields, or the offer
};

} // namespace ui
