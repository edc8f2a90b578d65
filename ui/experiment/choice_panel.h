// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/choice.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>

#include <functional>

namespace ui {

class Segments;

/// Selects what is measured: the paper's tables, a scene or the drawing; the number of lines and
/// runs, and the algorithms. By default it selects the paper's own experiment.
class ChoicePanel : public QWidget {
    Q_OBJECT

public:
    /// Returns the current lines of the drawing; called at most once after each change, and only if
    /// the drawing is selected.
    using Drawing = std::function<std::optional<app::Subject>()>;
    explicit ChoicePanel(Drawing drawing, QWidget* parent = nullptr);

    app::Choice choice() const;

    /// The drawing has changed and has `lines` lines; if 0, it cannot be selected.
    void followDrawing(std::size_t lines);

signals:
    void changed();

private:
    void describeFields();
    void addSubjects();
    void layOut();
    QWidget* algorithmBoxes();
    void showSubject();
    void showAlgorithms();
    void showRuns();
    bool ofDrawing() const;
    const app::Subject& subject() const;

    std::vector<app::Subject> subjects_;
    Drawing drawing_;
    /// Copy of the drawing since its last change; empty: not copied yet.
    mutable std::optional<app::Subject> taken_;
    bool ofDrawing_ = false; ///< the subject shown is the drawing
    int usualLines_ = 0;     ///< the subject's default number of lines
    app::DrawTargetMaker target_ =
        app::bestDrawTarget(); ///< queried in this thread, called in another
    bool runsTyped_ = false;   ///< false: the number of runs is as many as are needed
    QComboBox* subject_;
    QLabel* meaning_;
    QSpinBox *lines_, *runs_, *seed_;
    Segments *order_, *forms_;
    QList<QCheckBox*> algorithms_;
    QCheckBox *drawn_, *explained_, *inProcesses_;
    std::vector<bool> own_; ///< whether each algorithm is ticked for scenes
};

} // namespace ui
