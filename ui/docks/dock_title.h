// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/look_label.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

/// The title bar of a dock: name, remark, and buttons that are visible while the pointer or the
/// focus is in the dock (they keep their room, so that nothing jumps).
class DockTitle : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget& dock);

    void setName(const QString& name);
    void setRemark(const QString& remark);

    void setFoldable(bool foldable); ///< with a button at the left
    void showFolded(bool folded);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void foldWanted(bool folded);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void addButton(QAction* action);
    void showButtons();

    QDockWidget& dock_;
    QLabel* name_;
    ElidedLabel* remark_;
    QHBoxLayout* row_;
    QToolButton* chevron_;
    QList<QToolButton*> buttons_;
};

} // namespace ui
