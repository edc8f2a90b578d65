// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_picture.h"

#include <QPalette>
#include <QWidget>

#include <optional>

namespace ui {

/// The colours for pictures of hard cases that match a palette.
app::CasePictureColours casePictureColours(const QPalette& palette);

/// One hard case, large, with a variant's result if that is wrong.
class CasePictureView : public QWidget {
    Q_OBJECT

public:
    explicit CasePictureView(QWidget* parent = nullptr);

    void show(const app::HardCase& hard, const std::optional<app::CaseAnswer>& answer);
    const std::optional<app::CaseAnswer>& answer() const { return answer_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const app::HardCase* hard_ = nullptr;
    std::optional<app::CaseAnswer> answer_;
};

} // namespace ui
