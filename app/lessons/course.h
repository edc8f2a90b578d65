// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/question.h"
#include "app/teaching/microscope.h"

namespace app {

/// The points for the answers to a lesson's questions so far: 2 for a right first try, 1 for a
/// right second try, 0 for an answer that was shown.
struct Score {
    int settled = 0; ///< questions that are no longer open
    int points = 0;
    friend bool operator==(const Score&, const Score&) = default;
};

/// The answers that were given on a page.
struct Answer {
    std::vector<int> tries{}; ///< the choices in order, all different; at most two
    bool shown = false;       ///< the reader asked for the answer
};

/// The lesson in progress: its page, its question, and the traced line in the microscope. While the
/// question is open the microscope shows no step that would reveal the answer (stepsShown), and the
/// next page is not available.
class Course : public QObject {
    Q_OBJECT

public:
    explicit Course(Microscope& microscope, QObject* parent = nullptr);

    /// Starts a lesson at its first page and opens the microscope.
    void begin(std::size_t lesson);
    void end();                   ///< leaves the microscope unchanged
    const Lesson* lesson() const; ///< null: no lesson is in progress
    std::size_t lessonIndex() const { return lesson_.value_or(0); }

    std::size_t page() const { return page_; }
    std::size_t pages() const { return lesson() ? lesson()->pages.size() : 0; }
    const QString& text() const { return lesson()->pages[page_].text; }
    /// The page's explanation after its question is settled; empty before.
    QString told() const;
    bool atLastPage() const { return page_ + 1 >= pages(); }
    void next();     ///< the next page; no effect on the last page or while a question is open
    void previous(); ///< the previous page, with the answer that was given there
    /// Shows the page's traced line again after the reader looked at something else.
    void showAgain();

    const std::optional<Question>& question() const { return question_; }
    /// The answers given on this page.
    const Answer& answer() const { return answers_[page_]; }
    /// Whether the page has a question that was neither answered correctly, nor tried twice, nor
    /// shown.
    bool isOpen() const;
    /// Tries an answer. Ignored if the question is not open, or if this choice was tried already.
    void choose(int choice);
    /// Gives up the question and shows the answer.
    void showAnswer();

    Score score() const; ///< of this lesson so far
    /// Whether the last page is shown and its question is not open.
    bool atEnd() const { return lesson() && atLastPage() && !isOpen(); }
    /// At the end: how many answers were right, and whether the lesson is passed. Empty before.
    QString ending() const;

signals:
    void changed();

private:
    void show();
    void settle();
    int rightWorth(int points) const; ///< how many questions earned that many points

    Microscope& microscope_;
    std::optional<std::size_t> lesson_;
    std::size_t page_ = 0;
    std::optional<Question> question_;
    std::vector<Answer> answers_; ///< one for each page
    std::vector<int> points_;     ///< one for each page
};

} // namespace app
