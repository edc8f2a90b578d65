// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"
#include "app/experiment/study.h"
#include "app/scene/scene_lines.h"

namespace app {

/// One row of what can be measured: tables of the paper, a scene of the catalogue, a drawing.
struct Subject {
    QString key;                      ///< "table1", "all"; of a scene: its own
    QString name;                     ///< translated, as is what follows
    QString meaning;                  ///< one sentence
    std::vector<PaperTable> papers{}; ///< the tables that it repeats; empty: one scene
    ExperimentOptions options{};      ///< of a scene: which, where, and how many lines
};

/// The paper's tables together and one by one, then every scene.
std::vector<Subject> subjects();

/// The lines that a document shows in its page, to be clipped at the window that is compared;
/// nothing if it shows none.
std::optional<Subject> drawingSubject(const QString& name, const SceneLines& lines,
                                      const Document& document);

/// What a person asks for.
struct Choice {
    Subject subject;
    std::optional<std::uint64_t> lines{}; ///< none: as many as the paper or the drawing has
    std::optional<std::size_t> runs{};    ///< none: usualRounds
    std::uint64_t seed = 1;
    Order order = Order::AsTheyCome;
    std::vector<clipping::Form> forms{clipping::Form::Published};
    std::vector<const clipping::Algorithm*> algorithms{}; ///< of a scene; the paper has its own
    EaselMaker easel = nullptr;                           ///< null: nothing is drawn
    bool explained = true; ///< by class, operations and accuracy, too
};

constexpr std::uint64_t mostLines = 4'000'000'000, mostRuns = 10'000;

/// The same as a plan, or a sentence that says what is missing.
Result<Plan> planOf(const Choice& choice);

/// Which of the algorithms have none of the forms, and so take no part; empty: all take part.
QString leftOutText(const Choice& choice);

/// Thirty thousand lines, as often as it takes to tell who differs: some seconds.
Choice quick(Choice choice);

/// "Run: 23,100,000 lines to clip, about 2 minutes." `pace` is what things took here divided by
/// what was thought.
QString effortText(const Plan& plan, double pace = 1);

/// "Quick run: about 6 s."
QString quickEffortText(const Choice& choice, double pace);

} // namespace app
