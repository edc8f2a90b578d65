// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/trace_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>

namespace ui {

/// What the steps are exported as: which type of file, which steps, and how they look; with a
/// picture of how they will.
class ExportStepsDialog : public QDialog {
    Q_OBJECT

public:
    /// `step` is the one that is looked at; the look that is proposed is that of the window.
    ExportStepsDialog(app::TraceExport trace, std::size_t step, QWidget* parent);

    const app::TraceFormat& format() const;
    app::TraceExport trace() const;

private:
    void addFields();
    void addButtons();
    void refresh();

    app::TraceExport trace_;
    std::size_t step_;
    QLabel* preview_;
    QComboBox *format_, *ground_;
    QCheckBox *oneStep_, *pictureOnly_;
};

} // namespace ui
