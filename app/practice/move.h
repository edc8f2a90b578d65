// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace app {

/// What the student does in a move, and what its answer is as a number.
enum class MoveKind : std::uint8_t {
    Bits,  ///< sets bits: their sum
    Edge,  ///< picks an edge of the window: clipping::Edge as a number
    Place, ///< places a cut: its place along the line, 0 at End 1 and 1 at End 2
    Line,  ///< chooses the next line of the pseudo-code: its number, from 1
    Value, ///< computes a variable: its value
    Decide ///< what becomes of the line: Decision as a number
};

/// What a test decides about the line.
enum class Decision : std::uint8_t { Accept, Reject, GoOn };

/// A typical wrong answer.
struct Mistake {
    std::string_view kind; ///< "left-right": what was confused
    double answer = 0;
    QString hint; ///< says what was confused, but not what is right
};

/// One thing that the student does in place of the algorithm.
struct Move {
    MoveKind kind = MoveKind::Bits;
    /// The step of the trace that does it, as an index. The steps before it are shown meanwhile.
    std::size_t step = 0;
    int line = 0;                    ///< of the pseudo-code, from 1: what is run now
    QString name{};                  ///< "code1", "t": of the variable; may be empty
    QString prompt{};                ///< what is to be done
    QString brief{};                 ///< the same in a list, in a few words
    double right = 0;                ///< the answer
    double within = 0;               ///< the answer may be off by so much
    double chance = 0;               ///< the probability that a random answer is right
    QStringList bits{};              ///< of Bits: their names, the highest first
    std::vector<Mistake> mistakes{}; ///< none of them within the tolerance
    QString hint{};                  ///< after any other wrong answer: the way to the right one
    QString reason{};                ///< why the answer is right; shown after it
};

/// The moves of a traced line in the order of the run; empty without a plan (plan.h) or a trace.
std::vector<Move> movesOf(const TracedLine& tracedLine);

bool isRight(const Move& move, double answer);
/// The mistake that an answer is; null if it is right, or wrong in no typical way.
const Mistake* mistakeOf(const Move& move, double answer);
/// An answer in words: "1001", "the top edge", "line 7", "0.25".
QString answerText(const Move& move, double answer, YAxis y);
/// Where else than by keys a move of a kind is answered, in a sentence; empty: nowhere.
QString alsoIn(MoveKind kind);

} // namespace app
