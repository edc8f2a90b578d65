// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>
#include <QWidget>

namespace ui {

/// One cell of the status bar: a text on one line, as wide as the text given to setWidest().
class StatusCell : public QWidget {
    Q_OBJECT

public:
    explicit StatusCell(const QString& name, QWidget* parent = nullptr);

    QString text() const { return text_; }
    void setText(const QString& text);
    void setWidest(const QString& text); ///< reserves room for this text

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString name_, text_;
};

/// The status bar's zoom cell: a button with a menu, painted like the other cells.
class ZoomButton : public QToolButton {
    Q_OBJECT

public:
    explicit ZoomButton(QWidget* parent = nullptr);

    void setWidest(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
};

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
