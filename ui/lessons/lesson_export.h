// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"
#include "ui/dialogs/in_background.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <memory>

namespace ui {

/// Exports the lesson in progress as one web page: asks for its path, writes it without blocking
/// the window, and reports the result.
class LessonExport : public QObject {
    Q_OBJECT

public:
    LessonExport(QWidget& window, const app::Course& course);

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    void ask(); ///< nothing without a lesson
    bool busy() const { return background_.busy(); }

signals:
    void told(const ui::Message& message);

private:
    const app::Course& course_;
    std::unique_ptr<Questions> questions_;
    InBackground background_;
};

} // namespace ui
