// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHBoxLayout>
#include <QWidget>

class QAction;

namespace ui {

/// The commands for nodes in the bar across the top, while the tool Nodes is in hand: a button for
/// each. The tooltip of a disabled button says why.
class NodeRow : public QWidget {
    Q_OBJECT

public:
    explicit NodeRow(QWidget* parent = nullptr);

    /// Adds the button of a command, in the order of app::nodeSteps().
    void add(QAction& action);

private:
    QHBoxLayout* row_;
};

} // namespace ui
