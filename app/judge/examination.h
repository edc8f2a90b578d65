// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/category.h"
#include "app/judge/child_process.h"
#include "app/judge/verdict.h"

#include <QElapsedTimer>

#include <array>
#include <map>
#include <memory>

namespace app::plug_in {

/// The library to be judged, and how.
struct Case {
    QString library;   ///< a path
    QString program{}; ///< runs as the child (child.h); empty: this program
    std::uint64_t seed = 1;
    Contract contract{};
    std::size_t randomLines = Scope{}.randomLines;
    enum class Race : std::uint8_t { Yes, No } race = Race::Yes;
    /// Limit of the library's processor time, after which no further line is tested; the limit of
    /// wall-clock time is wallFactor times as much. Every category gets a share.
    double seconds = 30;
    /// Wall-clock seconds that the library may sleep in the race before the race is stopped.
    double raceSleep = 20;
};

} // namespace app::plug_in

namespace app::plug_in {

/// The program that runs as the child.
QString programOf(const Case& which);

/// The course of a test: questions and answers.
class Examination {
public:
    Examination(const Case& which, const Follower& follower);

    /// Returns false if it was stopped.
    bool run();
    /// The verdict, after run().
    Verdict take() { return std::move(verdict_); }

private:
    enum class StepResult : std::uint8_t { On, Over, Stopped };
    StepResult open();
    double spent() const;
    double shareOf(std::size_t category) const;
    void unusable(Unusable why, const QString& more);
    void prepare();
    StepResult ask(std::size_t category);
    StepResult askAll(std::size_t category, std::span<const Question> questions, double until);
    /// `answered`: the number of questions that were answered.
    StepResult askSome(std::size_t category, std::span<const Question> questions,
                       std::size_t& answered);
    void recordAnswer(std::size_t category, const Question& question, const Answer& answer);
    void recordRepeatedAnswer(std::size_t category, const Question& question, const Answer& answer);
    StepResult handleFailure(ChildProcess::WaitResult news, std::size_t category,
                             const Question& question);
    void add(std::size_t category, Finding finding);
    void tell();
    void leave();

    const Case& case_;
    const Follower& follower_;
    Verdict verdict_;
    std::unique_ptr<ChildProcess> child_;
    QElapsedTimer taken_;
    /// The questions of each category, and the first answers to questions that are asked again.
    std::vector<std::vector<Question>> questions_;
    std::map<std::array<std::uint64_t, 8>, std::optional<Answer>> first_;
    std::size_t atOnce_ = 1; ///< questions sent at a time: what takes about `someTime`
    int deaths_ = 0;
    double processorSeconds_ = 0;
    bool wasLoaded_ = false;
};

} // namespace app::plug_in
