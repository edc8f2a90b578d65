// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "ui/microscope/steps_panel.h"

#include <QSplitter>

namespace ui {

class CodeView;
class MicroscopeBar;
class MicroscopeView;
class OperationsView;
class Overview;
class VariableTable;
class VariablesPanel;
class AnswerCover;

/// The clip microscope: the line enlarged, the steps below, pseudo-code, variables and operations
/// at the right. Left, Right, Space, Home and End step wherever the focus is in the page, except in
/// a field; Esc returns to the drawing.
class MicroscopePage : public QWidget {
    Q_OBJECT

public:
    MicroscopePage(app::Session& session, app::DrawnLine& drawn, QWidget* parent = nullptr);

    /// Puts the lessons at the left side. The page takes ownership and deletes the previous side
    /// widget. Beside lessons the page shows the figure, and of the other parts only those that the
    /// lesson's page names. Null: no lessons; all parts are shown as they were before.
    void setSide(QWidget* side);
    QWidget* side() const { return side_; }

    MicroscopeBar& bar() { return *bar_; }
    MicroscopeView& view() { return *view_; }
    StepsPanel& steps() { return *steps_; }
    CodeView& code() { return *code_; }
    VariableTable& variables();

signals:
    void closeWanted();
    void refused(const QString& sentence);
    void exportWanted();
    void aboutWanted(const clipping::Algorithm* algorithm); ///< asks for its page
    void pointerMoved(std::optional<app::Point> point);     ///< in the drawing
    void hinted(const QString& hint);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeRight();
    void showParts();
    void addKeys();
    void useDigit(int digit);
    void goOnInLesson();
    void showStep();
    void showPlace();
    QList<QWidget*> corner() const;
    void placeOverview();
    bool hasRoomForOverview() const;
    QRect cornerFor(const QSize& size);
    void share();
    void shareAcross();
    void keepShares();
    void restoreShares();

    app::Session& session_;
    app::DrawnLine& drawn_;
    MicroscopeBar* bar_;
    MicroscopeView* view_;
    StepsPanel* steps_;
    CodeView* code_;
    VariablesPanel* variables_;
    OperationsView* operations_;
    Overview* overview_;
    QLabel* place_;
    QToolButton *leave_, *back_, *fit_;
    AnswerCover *variablesCover_, *operationsCover_;
    QSplitter *across_, *down_, *right_;
    QWidget *beside_, *codeBox_, *operationsHeading_; ///< the right column, and parts of it
    Qt::Corner corner_ = Qt::TopLeftCorner; ///< the corner of the view that holds the overview
    QWidget* side_ = nullptr;
    bool ownShares_ = false;                        ///< the person has moved a splitter
    std::optional<QList<QByteArray>> sharesBefore_; ///< the person's own, before the lessons
};

} // namespace ui
