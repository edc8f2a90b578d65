// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"
#include "app/teaching/trace_file.h"
#include "ui/dialogs/in_background.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>

#include <memory>

namespace ui {

/// Exports the microscope's steps to files: asks for options and path, writes without blocking the
/// window, and reports the result.
class StepExports : public QObject {
    Q_OBJECT

public:
    StepExports(QWidget& window, const app::Microscope& microscope);

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    /// Opens the export dialog for the microscope's current trace.
    void ask();
    /// Asks for the path and writes the files.
    void write(const app::TraceFormat& format, const app::TraceExport& trace);
    bool busy() const { return background_.busy(); } ///< steps are being painted

signals:
    void told(const ui::Message& message);

private:
    void writePainted(const QStringList& paths,
                      const std::optional<std::vector<QByteArray>>& bytes);
    QStringList pathsFor(const app::TraceFormat& format, const app::TraceExport& trace);

    QWidget& window_;
    const app::Microscope& microscope_;
    std::unique_ptr<Questions> questions_;
    InBackground background_;
};

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
