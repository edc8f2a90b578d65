// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QComboBox>
#include <QStackedLayout>
#include <QToolButton>

#include <array>

namespace ui {

class ElidedLabel;
class LengthField;

/// The clip window in numbers, in the middle of a gesture too. Each edit is one step to undo.
class WindowPanel : public QWidget {
    Q_OBJECT

public:
    explicit WindowPanel(app::Session& session, QWidget* parent = nullptr);

signals:
    void entered(); ///< a number is there: back to the canvas
    void resized(); ///< it needs more height now, or less

private:
    QWidget* makeFields();
    QWidget* makeOffer(); ///< where there is no window
    void follow();
    void sayWhich();
    void edit(std::size_t field, double length, app::Merging merging);

    app::Session& session_;
    ElidedLabel* which_;                 ///< which one of how many; hidden where there is only one
    std::array<LengthField*, 4> fields_; ///< X Y W H
    QToolButton* chain_;                 ///< on: W and H keep their proportion
    QComboBox* unit_;
    QStackedLayout* pages_; ///< the fields; else the offer
};

} // namespace ui
