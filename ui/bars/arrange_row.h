// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QCheckBox>
#include <QToolButton>
#include <QWidget>

#include <vector>

class QHBoxLayout;

namespace app {
struct Arrangement;
}

namespace ui {

class ToolList;

/// What turns, aligns and spreads the selected objects: the options of the tool Select. Each click
/// is one undo step.
class ArrangeRow : public QWidget {
    Q_OBJECT

public:
    explicit ArrangeRow(app::Session& session, QWidget* parent = nullptr);

    /// Where there is no room, what the buttons refer to is chosen in the menu Object alone.
    void showOptions(bool shown);

signals:
    void done(); ///< the focus should return to the canvas

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addButtons(QHBoxLayout& row);
    QToolButton* makeButton(const app::Arrangement& how);
    void addOptions(QHBoxLayout& row);
    void follow();

    app::Session& session_;
    std::vector<std::pair<QToolButton*, const app::Arrangement*>> buttons_;
    ToolList* target_;   ///< what objects are aligned to
    QCheckBox* strokes_; ///< checked: widths of strokes are scaled
};

} // namespace ui
