// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/question.h"
#include "app/teaching/microscope.h"

namespace app {

/// What the answers to a lesson's questions are worth so far: 2 points for the first try, 1 for the
/// second, none for an answer that was shown.
struct Score {
    int settled = 0; ///< questions that are no longer open
    int points = 0;
    friend bool operator==(const Score&, const Score&) = default;
};

/// What was answered on a page.
struct Answer {
    std::vector<int> tries{}; ///< the choices in their order, all different; two at most
    bool shown = false;       ///< the reader asked for the answer
};

/// A lesson that is being read: the page, its question, and what the microscope shows meanwhile.
/// While the question is open the microscope shows no step that would answer it (stepsShown), and
/// the lesson does not go on.
class Course : public QObject {
    Q_OBJECT

public:
    explicit Course(Microscope& microscope, QObject* parent = nullptr);

    /// Begins a lesson at its first page, and opens the microscope.
    void begin(std::size_t lesson);
    void end();                   ///< leaves the microscope as it is
    const Lesson* lesson() const; ///< null: none is being read
    std::size_t lessonIndex() const { return lesson_.value_or(0); }

    std::size_t page() const { return page_; }
    std::size_t pages() const { return lesson() ? lesson()->pages.size() : 0; }
    const QString& text() const { return lesson()->pages[page_].text; }
    /// What the page tells once its question is settled; empty before.
    QString told() const;
    bool atLastPage() const { return page_ + 1 >= pages(); }
    void next();     ///< the next page; after the last, or while a question is open: stays
    void previous(); ///< the page before, with the answer that was given there
    /// Shows again what the page is about, after the reader looked elsewhere.
    void showAgain();

    const std::optional<Question>& question() const { return question_; }
    /// What was answered on this page.
    const Answer& answer() const { return answers_[page_]; }
    /// Whether the page asks something that was neither answered rightly, nor twice, nor shown.
    bool isOpen() const;
    /// Tries an answer. Of a question that is not open, or one that was tried: ignored.
    void choose(int choice);
    /// Gives up: the answer is shown.
    void showAnswer();

    Score score() const; ///< of this lesson so far
    /// Whether the last page is shown and no question is open.
    bool atEnd() const { return lesson() && atLastPage() && !isOpen(); }
    /// At the end: how many answers were right, and whether the lesson is passed. Else empty.
    QString ending() const;

signals:
    void changed();

private:
    void show();
    void settle();
    int rightWorth(int points) const; ///< how many questions brought so many points

    Microscope& microscope_;
    std::optional<std::size_t> lesson_;
    std::size_t page_ = 0;
    std::optional<Question> question_;
    std::vector<Answer> answers_; ///< of each page
    std::vector<int> points_;     ///< of each page
};

} // namespace app
