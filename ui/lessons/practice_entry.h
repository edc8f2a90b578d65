// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/practice.h"

#include <QLabel>
#include <QPushButton>

class QComboBox;

namespace ui {

class Segments;

/// *Do it yourself* in the list of lessons: the choice of algorithm and form, and the best result.
class PracticeEntry : public QWidget {
    Q_OBJECT

public:
    explicit PracticeEntry(const app::Practice& practice, QWidget* parent = nullptr);

    void refresh(); ///< the record and the button

signals:
    void chosen(const app::Variant& variant);
    void goOnWanted();

private:
    app::Variant variant() const;

    const app::Practice& practice_;
    QComboBox* algorithm_;
    Segments* form_;
    QLabel* record_;
    QPushButton *begin_, *goOn_;
};

} // namespace ui
