// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace ui {

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
