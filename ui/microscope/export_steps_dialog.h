// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/trace_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>

namespace ui {

/// Options for exporting steps: file type, which steps, and look; with a preview.
class ExportStepsDialog : public QDialog {
    Q_OBJECT

public:
    /// `step` is the current step. By default the exported pictures have the window's look.
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
