// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"
#include "app/teaching/trace_file.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <memory>

namespace ui {

/// The steps under the microscope as files: asks what and where, writes while the window stays
/// alive, and tells what came of it.
class StepExports : public QObject {
    Q_OBJECT

public:
    StepExports(QWidget& window, const app::Microscope& microscope);

    /// What answers instead of dialogs (tests).
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    /// Opens the dialog about what is under the microscope now.
    void ask();
    /// Asks where to write, and writes.
    void write(const app::TraceFormat& format, const app::TraceExport& trace);

signals:
    void told(const ui::Message& message);

private:
    QStringList pathsFor(const app::TraceFormat& format, const app::TraceExport& trace);

    QWidget& window_;
    const app::Microscope& microscope_;
    std::unique_ptr<Questions> questions_;
};

} // namespace ui
