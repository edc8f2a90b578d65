// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAbstractButton>
#include <QImage>
#include <QPushButton>
#include <QToolButton>

#include <string_view>

namespace ui {

/// A small flat button of a panel with an icon (`resources/icons`) and a tooltip.
inline QToolButton* iconButton(std::string_view key, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(icon(key));
    button->setIconSize({16, 16});
    button->setFixedSize(24, 24);
    button->setAutoRaise(true);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

/// The switch beside fields for width and height.
inline QToolButton* ratioButton()
{
    QToolButton* button = iconButton("chain", Text::tr("Keep the ratio of width to height"));
    button->setCheckable(true);
    return button;
}

/// A button for a window made of a QDialog: Enter presses it only while it has the focus.
inline QPushButton* plainButton(const QString& text, std::string_view iconKey = {})
{
    auto* button = new QPushButton(text);
    button->setAutoDefault(false);
    if (!iconKey.empty())
        button->setIcon(icon(iconKey));
    return button;
}

/// A large button: an icon, a verb, and below it a description of what it opens.
class StartButton : public QAbstractButton {
    Q_OBJECT

public:
    StartButton(std::string_view icon, const QString& verb, const QString& what,
                QWidget* parent = nullptr);

    QSize sizeHint() const override { return {140, 58}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString what_;
};

/// A button with a picture and its name below.
class SampleButton : public QAbstractButton {
    Q_OBJECT

public:
    SampleButton(const QString& title, QWidget* parent);

    static int heightFor(int width);
    QSize pictureSize() const { return pictureBox().size(); }
    void setPicture(const QImage& picture);
    void setMarked(bool marked); ///< marks the open sample

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect pictureBox() const;

    QImage picture_;
    bool marked_ = false;
};

} // namespace ui
