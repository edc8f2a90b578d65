// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QButtonGroup>
#include <QStringList>
#include <QToolButton>

namespace ui {

/// A row of joined buttons of which one is on: a choice whose words are all in sight.
class Segments : public QWidget {
    Q_OBJECT

public:
    /// `name` is what the whole is called to those who do not see it.
    Segments(const QString& name, const QStringList& choices, QWidget* parent = nullptr);

    int chosen() const { return group_.checkedId(); }
    void choose(int index); ///< without a signal
    void chooseNone();      ///< what is so is not among them

signals:
    void picked(int index); ///< by the person

private:
    QButtonGroup group_;
};

} // namespace ui
