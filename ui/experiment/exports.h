// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart_file.h"
#include "app/report/study_files.h"
#include "ui/dialogs/in_background.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QObject>

#include <memory>

class QMenu;

namespace ui {

/// Writes a study, or one of its tables or charts, to files that the person names, and reports what
/// was written. Asks before it overwrites an existing file.
class Exports : public QObject {
    Q_OBJECT

public:
    explicit Exports(QWidget& window);

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }

    /// A study, and its table or chart in the current tab, if any.
    struct Shown {
        std::shared_ptr<const app::Study> study;
        const app::Table* table;
        const app::Chart* chart;
    };
    using Current = std::function<Shown()>;

    /// A menu of exports: the table or chart shown when the menu opens, in every format, then every
    /// row of app::studyFiles().
    QMenu* menu(const Current& current);
    void exportChart(const app::Chart& chart);
    bool busy() const { return background_.busy(); } ///< a study is being written

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
    InBackground background_;
};

} // namespace ui
