// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/examination.h"

#include "app/base/text.h"
#include "app/judge/child.h"
#include "app/judge/library_file.h"
#include "app/judge/signal_text.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <bit>
#include <cstring>

namespace app::plug_in {
namespace {

constexpr std::size_t mostAtOnce = 1024; ///< questions sent at a time
constexpr double someTime = 30;          ///< milliseconds between two readings of the time
constexpr int mostDeaths = 6;            ///< crashes and endless lines before the test is given up
constexpr int mostOfACategory = 2;       ///< crashes and endless lines before the next category
constexpr std::size_t mostShown = 8;     ///< findings shown of a category

/// Why the child gave no answer.
QString deathText(const ChildProcess& child)
{
    return child.crashed() ? signalText(child.exitCode())
                           : Text::tr("exit code %1").arg(child.exitCode());
}

/// Why the library cannot be used, by the first word that its process writes.
std::optional<Unusable> whyUnusable(const QString& word)
{
    if (word == QLatin1StringView(hello::notLoadable))
        return Unusable::NotLoadable;
    if (word == QLatin1StringView(hello::noFunction))
        return Unusable::NoFunction;
    if (word == QLatin1StringView(hello::otherVersion))
        return Unusable::OtherVersion;
    return std::nullopt;
}

/// The bits as integers: NaN equals itself, and -0 differs from 0.
template <class Numbers>
auto bitsOf(const Numbers& numbers)
{
    return std::bit_cast<std::array<std::uint64_t, sizeof(Numbers) / sizeof(double)>>(numbers);
}

/// If nothing is visible, the contents of visible[] are ignored.
bool sameAnswer(const Answer& one, const Answer& other)
{
    if ((one.returned != 0) != (other.returned != 0))
        return false;
    return one.returned == 0 || bitsOf(one.visible) == bitsOf(other.visible);
}

} // namespace

QString programOf(const Case& which)
{
    return which.program.isEmpty() ? QCoreApplication::applicationFilePath() : which.program;
}

Examination::Examination(const Case& which, const Follower& follower)
    : case_(which), follower_(follower)
{
    const QFileInfo file(case_.library);
    verdict_.path = case_.library;
    verdict_.name = file.fileName();
    verdict_.contract = case_.contract;
    verdict_.seconds = case_.seconds;
    taken_.start();
}

bool Examination::run()
{
    if (!QFileInfo(case_.library).isFile()) {
        unusable(Unusable::NoFile, {});
        return true;
    }
    if (const auto why = whyNoLibrary(case_.library)) {
        verdict_.command = why->command;
        unusable(Unusable::NotCompiled, why->sentence);
        return true;
    }
    StepResult went = open();
    if (went == StepResult::On)
        prepare();
    for (std::size_t i = 0; i < questions_.size() && went == StepResult::On; ++i)
        went = ask(i);
    leave();
    if (verdict_.judged() > 0)
        verdict_.nanoseconds = 1e9 * processorSeconds_ / double(verdict_.judged());
    return went != StepResult::Stopped;
}

void Examination::prepare()
{
    const Scope scope{case_.seed, case_.contract.strictness, case_.randomLines};
    for (const Category& category : categories()) {
        if (category.asked == Asked::InTheRace)
            continue;
        questions_.push_back(category.questions(scope));
        verdict_.categories.push_back({.lines = questions_.back().size()});
        if (category.asked == Asked::Again)
            for (const Question& question : questions_.back())
                first_[bitsOf(question)] = std::nullopt;
    }
}

/// The child's processor time and output are known only while it exists.
void Examination::leave()
{
    if (!child_)
        return;
    processorSeconds_ += child_->processorSeconds();
    if (verdict_.printed.isEmpty())
        verdict_.printed = child_->printed();
    child_.reset();
}

/// The share of the time limit that is used: 1 or more when the time is up.
double Examination::spent() const
{
    if (case_.seconds <= 0)
        return 1;
    const double processor = processorSeconds_ + (child_ ? child_->processorSeconds() : 0);
    const double wall = 1e-3 * double(taken_.elapsed()) / wallFactor;
    return std::max(processor, wall) / case_.seconds;
}

/// Findings from before a crash are kept, even if the library cannot be loaded again.
void Examination::unusable(Unusable why, const QString& more)
{
    if (wasLoaded_) {
        verdict_.notReloaded = more;
    } else {
        verdict_.unusable = why;
        verdict_.more = more;
    }
    leave();
}

Examination::StepResult Examination::open()
{
    const QString path = QFileInfo(case_.library).absoluteFilePath();
    child_ = std::make_unique<ChildProcess>(
        programOf(case_), QStringList{QLatin1StringView(childKey), QStringLiteral("answer"), path});
    // The child's own start takes time, too.
    constexpr WaitLimits patience{4, 30};
    auto news = child_->waitForStart(patience, follower_.stop);
    if (news == ChildProcess::WaitResult::Came)
        news = child_->waitForLine(patience, follower_.stop);
    if (news == ChildProcess::WaitResult::Stopped)
        return StepResult::Stopped;
    if (news != ChildProcess::WaitResult::Came) {
        unusable(Unusable::Broken, news == ChildProcess::WaitResult::Ended
                                       ? deathText(*child_)
                                       : Text::tr("it did not end"));
        return StepResult::Over;
    }
    const QString line = QString::fromUtf8(child_->readLine());
    const QString more = line.section(u' ', 1);
    if (const auto why = whyUnusable(line.section(u' ', 0, 0))) {
        unusable(*why, more);
        return StepResult::Over;
    }
    if (!more.isEmpty())
        verdict_.name = more;
    wasLoaded_ = true;
    return StepResult::On;
}

/// The share of the remaining time: in proportion to its lines, but at least an equal
/// share among the remaining categories.
double Examination::shareOf(std::size_t category) const
{
    double lines = 0;
    for (std::size_t i = category; i < questions_.size(); ++i)
        lines += double(questions_[i].size());
    return std::max(double(questions_[category].size()) / lines,
                    1.0 / double(questions_.size() - category));
}

Examination::StepResult Examination::ask(std::size_t category)
{
    const double now = spent();
    if (now >= 1)
        return StepResult::Over;
    const double share = shareOf(category);
    auto& questions = questions_[category];
    if (categories()[category].asked == Asked::Again) // the questions that were answered
        std::erase_if(questions, [this](const Question& q) { return !first_.at(bitsOf(q)); });
    return askAll(category, questions, now + (1 - now) * share);
}

Examination::StepResult Examination::askAll(std::size_t category,
                                            std::span<const Question> questions, double until)
{
    const int enough = deaths_ + mostOfACategory;
    while (!questions.empty() && deaths_ < enough && spent() < until) {
        QElapsedTimer took;
        took.start();
        std::size_t answered = 0;
        const auto some = questions.first(std::min(atOnce_, questions.size()));
        if (const StepResult went = askSome(category, some, answered); went != StepResult::On)
            return went;
        questions = questions.subspan(answered);
        atOnce_ = double(took.elapsed()) > someTime ? std::max<std::size_t>(1, atOnce_ / 2)
                                                    : std::min(mostAtOnce, 2 * atOnce_);
        tell();
    }
    return StepResult::On;
}

Examination::StepResult Examination::askSome(std::size_t category,
                                             std::span<const Question> questions,
                                             std::size_t& answered)
{
    child_->write(
        {reinterpret_cast<const char*>(questions.data()), qsizetype(questions.size_bytes())});
    for (const Question& question : questions) {
        const auto news = child_->waitFor(sizeof(Answer), {}, follower_.stop);
        if (news != ChildProcess::WaitResult::Came) {
            ++answered;
            return handleFailure(news, category, question);
        }
        Answer answer{};
        std::memcpy(&answer, child_->read(sizeof answer).constData(), sizeof answer);
        recordAnswer(category, question, answer);
        ++answered;
    }
    return StepResult::On;
}

void Examination::recordAnswer(std::size_t category, const Question& question, const Answer& answer)
{
    if (categories()[category].asked == Asked::Again)
        return recordRepeatedAnswer(category, question, answer);
    if (const auto known = first_.find(bitsOf(question)); known != first_.end())
        known->second = answer;
    CategoryCount& count = verdict_.categories[category];
    const auto found =
        judged(question, answer, case_.contract, categories()[category].visibilityUlps);
    ++count.judged;
    count.visible += expected(question).has_value();
    if (found.fault)
        return add(category, {*found.fault, category, question, expected(question), answer.piece(),
                              std::max(found.off, found.outside)});
    count.outside += found.outside > 0;
    verdict_.mostOff = std::max({verdict_.mostOff, found.off, found.outside});
}

/// Whether the first answer was correct is recorded in its own category.
void Examination::recordRepeatedAnswer(std::size_t category, const Question& question,
                                       const Answer& answer)
{
    ++verdict_.categories[category].judged;
    verdict_.categories[category].visible += expected(question).has_value();
    if (!sameAnswer(*first_.at(bitsOf(question)), answer))
        add(category,
            {Fault::Changed, category, question, expected(question), answer.piece(),
             judged(question, answer, case_.contract, categories()[category].visibilityUlps).off});
}

/// Blames the line without an answer; the other lines are sent again to a new child.
Examination::StepResult Examination::handleFailure(ChildProcess::WaitResult news,
                                                   std::size_t category, const Question& question)
{
    if (news == ChildProcess::WaitResult::Stopped)
        return StepResult::Stopped;
    const bool stuck = news != ChildProcess::WaitResult::Ended;
    const Fault fault = stuck               ? Fault::DidNotEnd
                        : child_->crashed() ? Fault::Crashed
                                            : Fault::LeftProgram;
    ++verdict_.categories[category].judged;
    verdict_.categories[category].visible += expected(question).has_value();
    add(category, {fault, category, question, expected(question), std::nullopt, 0,
                   stuck ? QString() : deathText(*child_)});
    leave();
    if (++deaths_ >= mostDeaths)
        return StepResult::Over;
    return open();
}

void Examination::add(std::size_t category, Finding finding)
{
    CategoryCount& count = verdict_.categories[category];
    ++verdict_.byFault[std::size_t(finding.fault)];
    count.wrongVisible += finding.expected.has_value();
    if (count.wrong++ < mostShown || infoOf(finding.fault).fatal)
        verdict_.findings.push_back(std::move(finding));
}

void Examination::tell()
{
    if (!follower_.progress)
        return;
    const double tested = double(verdict_.judged()) / double(verdict_.lines());
    const double share = std::min(1.0, std::max(tested, spent()));
    const double seconds = 1e-3 * double(taken_.elapsed());
    follower_.progress({share, share > 0 ? seconds * (1 - share) / share : 0});
}

} // namespace app::plug_in
