// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace ui {

/// A cell of the status bar that warns as long as something is wrong, and is hidden otherwise. Its
/// tooltip is the whole warning.
class WarningButton : public QToolButton {
    Q_OBJECT

public:
    explicit WarningButton(QWidget* parent = nullptr);

    void warn(const QString& words, const QString& sentence); ///< empty: nothing is wrong
    QString sentence() const { return isHidden() ? QString() : toolTip(); }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace ui
