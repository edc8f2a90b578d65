// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include <string_view>

namespace ui {

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

} // namespace ui
