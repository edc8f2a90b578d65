// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"
#include "app/lessons/question.h"
#include "app/teaching/microscope.h"

class QSettings;

namespace app {

/// The answers to a lesson's questions so far. Only first tries count: a second try and an answer
/// that was shown teach, and earn nothing.
struct Score {
    int settled = 0; ///< questions that are no longer open
    int right = 0;   ///< right at the first try
    friend bool operator==(const Score&, const Score&) = default;
};

/// The answers that were given on a page.
struct Answer {
    /// The line that the reader was asked about; empty before the first try.
    std::optional<TracedLine> about{};
    std::vector<int> tries{}; ///< the choices about this line in order, all different
    int wrong = 0;            ///< the number of wrong tries, also about other lines; at most two
    bool right = false;       ///< the last try was right
    bool shown = false;       ///< the reader asked for the answer

    bool settled() const { return right || shown || wrong >= 2; }
    bool rightAtOnce() const { return right && wrong == 0; }
};

/// The lesson in progress: its page, its question, and the traced line in the microscope. Each
/// attempt has other lines and another order of the choices (attempt.h), and so has an open
/// question after the lesson was left. The question is about the line that the microscope shows,
/// also after the reader has dragged an end of it or shown another line. While the question is open
/// the microscope shows no step that would reveal the answer (stepsShown), whoever opens it, and
/// the next page is not available.
class Course : public QObject {
    Q_OBJECT

public:
    explicit Course(Microscope& microscope, QObject* parent = nullptr);

    /// Begins every further attempt with this seed, for tests and pictures; with 0 lines and
    /// choices are as the lesson's file has them. Without it each attempt has a seed of its own.
    void setSeed(std::uint64_t seed) { seed_ = seed; }
    /// Starts a lesson at its first page and opens the microscope.
    void begin(std::size_t lesson);
    /// Leaves the microscope unchanged, but closes it while a question is open, whose answer it
    /// would reveal. A lesson that is not at its end is remembered with its page and answers.
    void end();
    /// The same, but leaves the microscope open: for what covers its steps itself.
    void setAside();
    const Lesson* lesson() const; ///< null: no lesson is in progress
    /// The reader looks at the list of lessons; the lesson stays at its page.
    void pause();
    bool isPaused() const { return paused_; }
    /// Starts the lesson, or goes on with it if it was left or paused before its end.
    void beginOrGoOn(std::size_t lesson);
    /// The lesson that goes on where it was left or paused; empty: none.
    std::optional<std::size_t> lessonToGoOn() const;
    /// The page at which that lesson goes on.
    std::size_t pageToGoOn() const { return lesson() ? page_ : left_ ? left_->page : 0; }
    std::size_t lessonIndex() const { return lesson_.value_or(0); }

    std::size_t page() const { return page_; }
    std::size_t pages() const { return lesson() ? lesson()->pages.size() : 0; }
    /// The parts that the page shows beside the figure; none if no page is open.
    LessonParts shows() const;
    const QString& text() const { return here().text; }
    /// The current page as this attempt has it.
    const LessonPage& here() const { return drawn_[page_]; }
    /// The page's explanation after its question is settled; empty before. It is about the page's
    /// own line, and says so if the reader answered about another.
    QString told() const;
    bool atLastPage() const { return page_ + 1 >= pages(); }
    void next();     ///< the next page; no effect on the last page or while a question is open
    void previous(); ///< the previous page, with the answer that was given there
    /// Shows the page's traced line again after the reader looked at something else.
    void showAgain();
    /// Whether the microscope shows another line than the page's, or another algorithm.
    bool isAway() const;

    /// The question about the line that is shown, or of a settled page about the line that was
    /// asked about. Empty if the page asks nothing, or if it cannot ask about the line.
    const std::optional<Question>& question() const { return question_; }
    /// The line that the question is about.
    const TracedLine& asked() const { return asked_; }
    /// Whether the microscope shows another line than that.
    bool isElsewhere() const { return microscope_.tracedLine() != asked_; }
    /// The answers given on this page.
    const Answer& answer() const { return answers_[page_]; }
    /// Whether the page has a question that was neither answered correctly, nor tried twice, nor
    /// shown.
    bool isOpen() const;
    /// Whether the reader sees an open question, which can be answered.
    bool asks() const { return !paused_ && question_ && isOpen(); }
    /// Tries an answer. Ignored unless the question is asked, or if this choice was tried already.
    void choose(int choice);
    /// Gives up the question and shows the answer; if the question cannot be about the line that is
    /// shown, for the page's own line.
    void showAnswer();

    /// Gives up an open question and goes on. On the last page the answer is shown.
    void skip();

    Score score() const; ///< of this lesson so far
    /// Whether the last page is shown and its question is not open.
    bool atEnd() const { return lesson() && atLastPage() && !isOpen(); }
    /// At the end: how many answers were right, and whether the lesson is passed. Empty before.
    QString ending() const;

signals:
    void changed();

private:
    const TracedLine& ownLine() const;
    void follow();
    void leave();
    void show(const TracedLine& tracedLine);
    void ask(const TracedLine& tracedLine);
    void settle();
    std::uint64_t newSeed() const;
    void setPages(const std::vector<LessonPage>& pages);
    void draw();

    /// A lesson that was left before its end.
    struct Left {
        std::size_t lesson, page;
        std::vector<Answer> answers;
        std::vector<std::uint64_t> seeds;
    };

    Microscope& microscope_;
    std::optional<Left> left_; ///< only while no lesson is in progress
    std::optional<std::size_t> lesson_;
    std::size_t page_ = 0;
    std::optional<Question> question_;
    TracedLine asked_; ///< the question is about it
    bool paused_ = false;
    bool away_ = false;                 ///< isAway() as last signalled
    bool showing_ = false;              ///< the microscope changes by this class
    std::vector<Answer> answers_;       ///< one for each page
    std::optional<std::uint64_t> seed_; ///< of every attempt
    std::vector<std::uint64_t> seeds_;  ///< one for each page of this attempt
    std::vector<LessonPage> drawn_;     ///< one for each page; drawn when it is first shown
    std::vector<char> isDrawn_;
};

} // namespace app

// The scores of lessons, stored between program starts.

namespace app {

int questionsOf(const Lesson& lesson); ///< how many there are
/// How many of them must be right at the first try to pass the lesson: at least two thirds, and so
/// many that keys pressed at random pass with a probability of at most 0.65 %.
int neededRight(const Lesson& lesson);
bool isPassed(int right, const Lesson& lesson);

/// The most questions of a lesson that were right at the first try, 0 to questionsOf(); empty: it
/// was never started.
std::optional<int> bestRight(const QSettings& settings, const Lesson& lesson);
/// Stores the result of a lesson, unless a better one is stored already.
void keepRight(QSettings& settings, const Lesson& lesson, int right);

} // namespace app
