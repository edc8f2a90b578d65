// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/inspection.h"

#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedLayout>
#include <QTimer>

namespace ui {

/// The inspected line: its ends, the part that the explained algorithm keeps, the operations this
/// takes, and the algorithm's steps as text.
class LinePanel : public QWidget {
    Q_OBJECT

public:
    explicit LinePanel(app::Session& session, QWidget* parent = nullptr);

    QString verdict() const { return verdict_->text(); } ///< including the algorithm's name
    QString steps() const { return steps_->toPlainText(); }
    /// The same for every line, so that no panel moves when another line is selected.
    QSize minimumSizeHint() const override;
    void showNow(); ///< performs a pending update at once

signals:
    void microscopeWanted();
    void lessonsWanted();
    void titled(const QString& title, const QString& remark);

private:
    QWidget* madeNothing();
    void show();
    void showLine(const app::Inspection& line);
    void put(int row, int column, const QString& text, Qt::Alignment alignment = Qt::AlignLeft);
    QLabel* cell(int row, int column);

    app::Session& session_;
    QStackedLayout* pages_; ///< what to do without a line, and a line
    QWidget* table_;
    QGridLayout* grid_;
    QLabel *verdict_, *cost_;
    QPlainTextEdit* steps_;
    QPushButton* microscope_;
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui
