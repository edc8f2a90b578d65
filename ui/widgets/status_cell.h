// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

} // namespace ui
