// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/inspection.h"

#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>

namespace ui {

/// The inspected line: where its ends lie, what the algorithm that is explained leaves of it,
/// what that costs, and its steps as text.
class LinePanel : public QWidget {
    Q_OBJECT

public:
    explicit LinePanel(app::Session& session, QWidget* parent = nullptr);

    QString verdict() const { return verdict_->text(); } ///< with the algorithm's name
    QString steps() const { return steps_->toPlainText(); }
    void showNow(); ///< what is to be shown soon

signals:
    void microscopeWanted();
    void titled(const QString& title, const QString& remark);

private:
    void show();
    void showLine(const app::Inspection& line);
    void put(int row, int column, const QString& text, Qt::Alignment alignment = Qt::AlignLeft);
    QLabel* cell(int row, int column);

    app::Session& session_;
    QLabel* nothing_;
    QWidget* table_;
    QGridLayout* grid_;
    QLabel *verdict_, *cost_;
    QPlainTextEdit* steps_;
    QPushButton* microscope_;
    QTimer soon_; ///< many changes in one event are shown once
};

} // namespace ui
