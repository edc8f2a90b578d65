// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/question.h"
#include "app/teaching/microscope.h"

namespace app {

/// How many questions were answered, and how many of them rightly at the first try.
struct Score {
    int asked = 0, right = 0;
    friend bool operator==(const Score&, const Score&) = default;
};

/// A lesson that is being read: the page, its question, and what the microscope shows meanwhile.
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
    bool atLastPage() const { return page_ + 1 >= pages(); }
    void next();     ///< the next page; after the last: stays
    void previous(); ///< the page before, with the answer that was given there
    /// Shows again what the page is about, after somebody looked elsewhere.
    void showAgain();

    const std::optional<Question>& question() const { return question_; }
    /// What was chosen first on this page.
    std::optional<int> answer() const { return answers_.empty() ? std::nullopt : answers_[page_]; }
    /// The first answer counts; a later one is ignored.
    void choose(int choice);

    Score score() const;   ///< of this lesson so far
    int questions() const; ///< of the whole lesson

signals:
    void changed();

private:
    void show();

    Microscope& microscope_;
    std::optional<std::size_t> lesson_;
    std::size_t page_ = 0;
    std::optional<Question> question_;
    std::vector<std::optional<int>> answers_; ///< of each page
    std::vector<bool> right_;                 ///< whether it was
};

} // namespace app
