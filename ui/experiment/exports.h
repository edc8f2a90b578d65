// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart_file.h"
#include "app/report/study_files.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QObject>

#include <memory>

class QAction;
class QMenu;

namespace ui {

/// Writes a study, or one of its tables or charts, to files that a person names, and tells what was
/// written. Nothing that exists is overwritten without a question.
class Exports : public QObject {
    Q_OBJECT

public:
    explicit Exports(QWidget& window);

    /// What answers instead of dialogs (tests).
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    /// A study, and the table or the chart of it that is in front, if one is.
    struct Shown {
        std::shared_ptr<const app::Study> study;
        const app::Table* table;
        const app::Chart* chart;
    };
    using Current = std::function<Shown()>;

    /// The table or chart that is shown then in every format, then every row of app::studyFiles().
    QMenu* menu(const Current& current);
    void exportChart(const app::Chart& chart);

signals:
    void told(const ui::Message& message);

private:
    void addShown(QMenu& menu, const Current& current);
    void addStudy(QMenu& menu, const Current& current);
    void writeTable(const app::Table& table, const app::TableFormat& format);
    void writeChart(const app::Chart& chart, const app::ChartFormat& format);
    void writeStudy(const app::StudyFile& row, const std::shared_ptr<const app::Study>& study);
    QString pathFor(const app::StudyFile& row, const app::Study& study);
    QString remembered(const QString& path);
    void tell(const app::Result<QStringList>& written);

    QWidget& window_;
    std::unique_ptr<Questions> questions_;
};

} // namespace ui
