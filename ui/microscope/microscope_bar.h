// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>

namespace ui {

class LineField;

/// Selects what the microscope shows: algorithm, form and line. If it is narrow, the bar drops its
/// captions and the texts of its buttons.
class MicroscopeBar : public QWidget {
    Q_OBJECT

public:
    MicroscopeBar(app::Microscope& microscope, app::DrawnLine& drawn, QWidget* parent = nullptr);

    LineField& lineField() { return *line_; }
    void follow(); ///< shows what is traced, in the language of numbers

signals:
    void refused(const QString& sentence);
    void exportWanted();
    void closeWanted();
    void lineDone(); ///< the line is typed: the microscope's step keys work again

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addAlgorithm();
    void addLine();
    void addEnd();
    QLabel* addCaption(const QString& text);
    QToolButton* addButton(const char* icon, const QString& name);
    void choose(clipping::Form form);
    void setLine(const clipping::Segment& line);
    void arrange();

    app::Microscope& microscope_;
    app::DrawnLine& drawn_;
    QHBoxLayout* row_;
    QComboBox* algorithm_;
    QRadioButton *corrected_, *published_;
    LineField* line_;
    QList<QLabel*> captions_;
    QToolButton *previous_ = nullptr, *next_ = nullptr;
    QPushButton *export_ = nullptr, *close_ = nullptr;
};

} // namespace ui
