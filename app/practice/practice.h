// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/course.h"
#include "app/practice/move.h"

namespace app {

/// The answers to a move.
struct MoveAnswer {
    std::vector<double> tries{}; ///< in order; at most two
    bool right = false;          ///< the last one was right
    bool shown = false;          ///< the student asked for the answer

    bool settled() const { return right || shown || tries.size() >= 2; }
    bool rightAtOnce() const { return right && tries.size() == 1; }
};

/// An attempt at *Do it yourself*: the student plays an algorithm on a line that is drawn for the
/// attempt. Until the end the microscope has only the steps before the open move (openCovered), in
/// plain sentences, whoever opens it, and always the attempt's line. At the end it shows the whole
/// trace.
class Practice : public QObject {
    Q_OBJECT

public:
    Practice(Microscope& microscope, Course& course, QObject* parent = nullptr);

    /// Draws every further line with this seed, for tests and pictures.
    void setSeed(std::uint64_t seed) { seed_ = seed; }
    /// Begins an attempt with another line, and opens the microscope. The lesson in progress is
    /// left; it is remembered.
    void begin(const Variant& variant);
    /// Ends the attempt. While a move is open this closes the microscope, which would show it.
    void end();
    /// The student looks at the list of lessons; the attempt stays as it is.
    void pause();
    void goOn();
    bool isOn() const { return on_; }
    bool isPaused() const { return paused_; }

    const TracedLine& tracedLine() const { return traced_; }
    const std::vector<Move>& moves() const { return moves_; }
    std::size_t index() const
    {
        return index_;
    } ///< of the current move; moves().size(): at the end
    /// Null at the end and without an attempt.
    const Move* move() const { return index_ < moves_.size() ? &moves_[index_] : nullptr; }
    const MoveAnswer& answerTo(std::size_t move) const { return answers_[move]; }
    bool atEnd() const { return on_ && index_ == moves_.size(); }
    /// Whether the current move was neither answered correctly, nor tried twice, nor shown.
    bool isOpen() const { return on_ && move() && !answers_[index_].settled(); }
    /// Whether the student sees an open move, which can be answered.
    bool asks() const { return isOpen() && !paused_; }

    /// What the student has set but not yet checked: the bits, a place, a line; empty: nothing.
    std::optional<double> draft() const { return draft_; }
    void setDraft(double draft); ///< ignored unless a move is asked
    void check();                ///< answers with what is set
    /// A digit key: changes a bit, picks an edge or decides, in the order of the choices; false if
    /// the move has no choices.
    bool useDigit(int digit);
    /// Tries an answer. Ignored unless a move is asked, or if it was tried already. A line of the
    /// pseudo-code that no step runs is no answer: verdict() says so.
    void answer(double answer);
    void showAnswer();
    void next(); ///< the next move; no effect while one is open
    /// What is said of the last try or the settled move; empty before the first try.
    QString verdict() const;

    int rightAtOnce() const; ///< moves so far
    int needed() const;      ///< to pass
    bool isPassed() const { return atEnd() && rightAtOnce() >= needed(); }
    QString ending() const; ///< at the end: the result in words
    /// Where the student went wrong: the moves that were not right at the first try.
    std::vector<std::size_t> wrongMoves() const;
    /// What was answered to a settled move, what is right, and why.
    QString correction(std::size_t move) const;
    /// Shows the step of a move in the microscope; at the end only.
    void lookAt(std::size_t move);
    /// The parts beside the figure.
    LessonParts shows() const;

signals:
    void changed();
    void draftChanged();

private:
    void follow();
    void turnTo(std::size_t move);
    void show();
    std::size_t stepsShown() const;
    void leave();

    Microscope& microscope_;
    Course& course_;
    std::optional<std::uint64_t> seed_;
    bool on_ = false, paused_ = false;
    bool showing_ = false; ///< the microscope changes by this class
    TracedLine traced_;
    std::vector<Move> moves_;
    std::vector<MoveAnswer> answers_; ///< one for each move
    std::vector<char> isStep_;        ///< of each line of the pseudo-code: a step runs it
    std::size_t index_ = 0;
    std::optional<double> draft_;
    QString note_; ///< on what was no answer
};

} // namespace app
