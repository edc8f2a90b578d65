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

/// What is measured: the paper's tables, a scene or the drawing; how many lines, how often, and by
/// whom. As it comes up it asks for the paper's own experiment.
class ChoicePanel : public QWidget {
    Q_OBJECT

public:
    /// The lines of the drawing as it is now: copied once after each change, and only if chosen.
    using Drawing = std::function<std::optional<app::Subject>()>;
    explicit ChoicePanel(Drawing drawing, QWidget* parent = nullptr);

    app::Choice choice() const;

    /// The drawing has changed, and has so many lines; without any it cannot be chosen.
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
    mutable std::optional<app::Subject> taken_; ///< of the drawing, since its last change
    bool ofDrawing_ = false;                    ///< what is shown is that
    int usualLines_ = 0;                        ///< of the subject, before anybody typed
    app::EaselMaker easel_ = app::bestEasel();  ///< asked in this thread, used in another
    bool runsTyped_ = false;                    ///< else there are as many as are needed
    QComboBox* subject_;
    QLabel* meaning_;
    QSpinBox *lines_, *runs_, *seed_;
    Segments *order_, *forms_;
    QList<QCheckBox*> algorithms_;
    QCheckBox *drawn_, *explained_;
    std::vector<bool> own_; ///< the algorithms that were ticked for scenes
};

} // namespace ui
