// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/hard_cases/hard_case.h"

#include <QPushButton>
#include <QScrollArea>

namespace ui {

class AnswerTable;
class CasePictureView;
class LookLabel;

/// One hard case: its picture, its source, why it is hard, the right result, and every variant's
/// result. A selected wrong result is painted into the picture.
class CaseView : public QScrollArea {
    Q_OBJECT

public:
    explicit CaseView(QWidget* parent = nullptr);

    void show(const app::HardCase& hard);
    const app::HardCase* hardCase() const { return hard_; }
    AnswerTable& table() { return *table_; }

signals:
    void microscopeWanted(const app::HardCase& hard, const app::Variant& variant);
    void drawingWanted(const app::HardCase& hard, const app::Variant& variant);

private:
    void layOut();
    QWidget* facts();
    void showAnswer();

    const app::HardCase* hard_ = nullptr;
    LookLabel *title_, *origin_, *why_, *numbers_, *expected_, *note_;
    CasePictureView* picture_;
    QPushButton *microscope_, *draw_;
    AnswerTable* table_;
};

} // namespace ui
