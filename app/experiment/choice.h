// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"
#include "app/experiment/study.h"
#include "app/scene/scene_lines.h"

namespace app {

/// One thing that can be measured: tables of the paper, a scene of the catalogue, or a drawing.
struct Subject {
    QString key;                      ///< "table1", "all"; for a scene: the scene's key
    QString name;                     ///< translated, like the next text
    QString meaning;                  ///< one sentence
    std::vector<PaperTable> papers{}; ///< the tables that it repeats; empty: one scene
    ExperimentOptions options{};      ///< for a scene: which, where, and how many lines
};

/// All tables of the paper together, each table, then every scene.
std::vector<Subject> subjects();

/// The visible lines of a document's page, clipped at the compared window; empty if there are none.
std::optional<Subject> drawingSubject(const QString& name, const SceneLines& lines,
                                      const Document& document);

/// The settings of an experiment that a person chooses.
struct Choice {
    Subject subject;
    std::optional<std::uint64_t> lines{}; ///< empty: as many as the paper or the drawing has
    std::optional<std::size_t> runs{};    ///< empty: usualRounds
    std::uint64_t seed = 1;
    Order order = Order::AsTheyCome;
    std::vector<clipping::Form> forms{clipping::Form::Published};
    std::vector<const clipping::Algorithm*> algorithms{}; ///< for a scene, not for the paper
    DrawTargetMaker target = nullptr;                     ///< null: nothing is drawn
    bool inProcesses = false; ///< each run is made by a process of its own
    bool explained = true;    ///< also explained by class, operations and accuracy
};

constexpr std::uint64_t mostLines = 4'000'000'000, mostRuns = 10'000;

/// The plan for a choice, or a sentence that says what is missing.
Result<Plan> planOf(const Choice& choice);

/// Which algorithms have none of the chosen forms and so are left out; empty: none are.
QString leftOutText(const Choice& choice);

/// The choice with 30,000 lines and as many runs as the tests for differences need: some seconds.
Choice quick(Choice choice);

/// "Run: 23,100,000 lines to clip, about 2 minutes." `durationRatio`: measured ÷ estimated time of
/// earlier runs on this machine.
QString effortText(const Plan& plan, double durationRatio = 1);

/// "Quick run: about 6 s."
QString quickEffortText(const Choice& choice, double durationRatio);

} // namespace app
