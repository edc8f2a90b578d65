// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/report/study_files.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QObject>

#include <memory>

class QMenu;

namespace ui {

/// Writes a study, or one of its charts, to files that a person names, and tells what was written.
class Exports : public QObject {
    Q_OBJECT

public:
    explicit Exports(QWidget& window);

    /// What answers instead of dialogs (tests).
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    /// Every row of app::studyFiles(), in groups, for the study that there is then.
    using Current = std::function<std::shared_ptr<const app::Study>()>;
    QMenu* menu(Current current);
    void exportChart(const app::Chart& chart);

signals:
    void told(const ui::Message& message);

private:
    QString askedPath(const QString& name, const QString& kind, const QString& ending);
    void exportAs(const app::StudyFile& row, const std::shared_ptr<const app::Study>& study);
    void tell(const app::Result<QStringList>& written);

    QWidget& window_;
    std::unique_ptr<Questions> questions_;
};

} // namespace ui
