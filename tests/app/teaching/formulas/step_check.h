// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/teaching/formulas/checker.h"
#include "tests/app/teaching/formulas/plane.h"

namespace app::formulas {

/// What is wrong with a step: it becomes a Fault where line and variables are known.
struct Wrong {
    std::string found, told;
};

/// One run on its way through the code. Its functions throw Wrong or Unreadable.
class StepCheck {
public:
    /// Marks each formula that it evaluates, and each line that needs fewer comparisons than it
    /// shows.
    StepCheck(const Code& code, std::vector<char>& evaluated, std::vector<char>& comparedLess,
              const clipping::Segment& segment, const clipping::Window& window);

    void step(const clipping::Step& step);                       ///< the next one
    void end(const clipping::OperationCounts& operations) const; ///< after the last
    const Scope& scope() const { return scope_; }

private:
    using Ends = std::array<double, 4>; ///< x, y, x, y

    void takeFromOtherLines(const clipping::Step& step);
    bool isCopied(int slot, double value) const;
    int slotOfTold(std::string_view name) const;
    bool givesValueTo(int slot) const;

    void condition(bool holds);
    void conditionOfCut();
    void assignments(const clipping::Step& step);
    void arguments(const clipping::Step& step);
    std::optional<Wrong> passed(const Arguments& call, const Parameters& parameters,
                                const clipping::Step& step);
    void turn(const clipping::Step& step, const Arguments& call, const Parameters& parameters);
    void turnBack(const clipping::Step& step);
    void checkGiven(const clipping::Step& step) const;
    void nameOfLet(const clipping::Step& step) const;
    void words(clipping::What what) const;
    void ends(const clipping::Step& step);
    bool isOnItsEdge() const;
    void cost(const clipping::Step& step);

    double valueOf(const Formula& formula);
    std::optional<double> told(const clipping::Step& step, int slot) const;
    int axisOf(int slot) const; ///< of a coordinate, by its name; -1 of another variable
    void setEnds();

    const Code& code_;
    std::vector<char>&evaluated_, &comparedLess_;
    Scope scope_;
    const Line* line_ = nullptr;
    /// A call that is not done yet.
    struct Turn {
        const Line* line;
        Plane before;
        clipping::Window window; ///< before
    };
    std::vector<Turn> turns_;
    Plane plane_;
    clipping::Window windowBefore_{};   ///< of the step
    clipping::Segment left_;            ///< in the picture
    Ends ends_;                         ///< of what is left, in the plane as it is turned
    Ends next_{};                       ///< and as the lit line has them
    bool assignsEnds_ = false;          ///< whether it gives one of them a value
    clipping::OperationCounts cost_{};  ///< so far
    clipping::OperationCounts shown_{}; ///< by the formulas that the step evaluates
};

} // namespace app::formulas
