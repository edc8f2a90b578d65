// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/examination.h"

#include "app/plug_in/child.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <cstring>

namespace app::plug_in {
namespace {

struct PlugIn {
    Q_DECLARE_TR_FUNCTIONS(PlugIn)
};

constexpr std::size_t atOnce = 1024; ///< questions on their way
constexpr int mostDeaths = 6;        ///< crashes and lines without end, before it is given up
constexpr int mostOfACategory = 2;   ///< of them, before the next category is asked about
constexpr std::size_t mostShown = 8; ///< findings of a category

/// Why there was no answer.
QString deathText(const ChildProcess& child)
{
    return child.crashed() ? signalText(child.exitCode())
                           : PlugIn::tr("exit code %1").arg(child.exitCode());
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
    taken_.start();
}

bool Examination::run()
{
    if (!QFileInfo(case_.library).isFile())
        return unusable(Unusable::NoFile, {}) != Went::Stopped;
    Went went = open();
    std::vector<std::vector<Question>> all;
    if (went == Went::On)
        for (const Category& category : categories()) {
            all.push_back(
                category.questions({case_.seed, case_.contract.strictness, case_.randomLines}));
            verdict_.categories.push_back({.lines = all.back().size()});
        }
    for (std::size_t i = 0; i < all.size() && went == Went::On; ++i)
        went = ask(i, all[i]);
    leave();
    if (verdict_.judged() > 0)
        verdict_.nanoseconds = 1e9 * processorSeconds_ / double(verdict_.judged());
    return went != Went::Stopped;
}

/// What the child has used and printed is known only as long as it is there.
void Examination::leave()
{
    if (!child_)
        return;
    processorSeconds_ += child_->processorSeconds();
    if (verdict_.printed.isEmpty())
        verdict_.printed = child_->printed();
    child_.reset();
}

bool Examination::isTimeUp() const
{
    constexpr double wall = 10; // of what is processor's time at most, or it sleeps
    return processorSeconds_ + child_->processorSeconds() > case_.seconds
           || double(taken_.elapsed()) > 1000 * wall * case_.seconds;
}

Examination::Went Examination::unusable(Unusable why, const QString& more)
{
    verdict_.unusable = why;
    verdict_.more = more;
    leave();
    return Went::Over;
}

Examination::Went Examination::open()
{
    const QString path = QFileInfo(case_.library).absoluteFilePath();
    child_ = std::make_unique<ChildProcess>(
        programOf(case_), QStringList{QLatin1StringView(childKey), QStringLiteral("answer"), path});
    // The child's own start takes some, too.
    const auto news = child_->waitForLine({4, 30}, follower_.stop);
    if (news == ChildProcess::News::Stopped)
        return Went::Stopped;
    if (news == ChildProcess::News::Stuck)
        return unusable(Unusable::Broken, PlugIn::tr("it did not end"));
    if (news == ChildProcess::News::Ended)
        return unusable(Unusable::Broken, deathText(*child_));
    const QString line = QString::fromUtf8(child_->readLine());
    const QString word = line.section(u' ', 0, 0), more = line.section(u' ', 1);
    if (word == QLatin1StringView(hello::notLoadable))
        return unusable(Unusable::NotLoadable, more);
    if (word == QLatin1StringView(hello::noFunction))
        return unusable(Unusable::NoFunction, more);
    if (word == QLatin1StringView(hello::otherVersion))
        return unusable(Unusable::OtherVersion, more);
    if (!more.isEmpty())
        verdict_.name = more;
    return Went::On;
}

Examination::Went Examination::ask(std::size_t category, std::span<const Question> questions)
{
    const int enough = deaths_ + mostOfACategory;
    while (!questions.empty() && deaths_ < enough) {
        if (isTimeUp())
            return Went::Over;
        std::size_t answered = 0;
        const auto some = questions.first(std::min(atOnce, questions.size()));
        if (const Went went = askSome(category, some, answered); went != Went::On)
            return went;
        questions = questions.subspan(answered);
        tell();
    }
    return Went::On;
}

Examination::Went Examination::askSome(std::size_t category, std::span<const Question> questions,
                                       std::size_t& answered)
{
    child_->write(
        {reinterpret_cast<const char*>(questions.data()), qsizetype(questions.size_bytes())});
    for (const Question& question : questions) {
        const auto news = child_->waitFor(sizeof(Answer), {}, follower_.stop);
        if (news != ChildProcess::News::Came) {
            ++answered;
            return mourn(news, category, question);
        }
        Answer answer{};
        std::memcpy(&answer, child_->read(sizeof answer).constData(), sizeof answer);
        hear(category, question, answer);
        ++answered;
    }
    return Went::On;
}

void Examination::hear(std::size_t category, const Question& question, const Answer& answer)
{
    CategoryCount& count = verdict_.categories[category];
    const auto found =
        judged(question, answer, case_.contract, categories()[category].visibilityUlps);
    ++count.judged;
    if (found.fault)
        return add(category, {*found.fault, category, question, expected(question), answer.piece(),
                              std::max(found.off, found.outside)});
    count.outside += found.outside > 0;
    verdict_.mostOff = std::max({verdict_.mostOff, found.off, found.outside});
}

/// The line that had no answer is the one to blame; the others are asked again of a new child.
Examination::Went Examination::mourn(ChildProcess::News news, std::size_t category,
                                     const Question& question)
{
    if (news == ChildProcess::News::Stopped)
        return Went::Stopped;
    const bool stuck = news == ChildProcess::News::Stuck;
    const Fault fault = stuck               ? Fault::DidNotEnd
                        : child_->crashed() ? Fault::Crashed
                                            : Fault::LeftProgram;
    ++verdict_.categories[category].judged;
    add(category, {fault, category, question, expected(question), std::nullopt, 0,
                   stuck ? QString() : deathText(*child_)});
    leave();
    if (++deaths_ >= mostDeaths)
        return Went::Over;
    return open();
}

void Examination::add(std::size_t category, Finding finding)
{
    CategoryCount& count = verdict_.categories[category];
    ++verdict_.byFault[std::size_t(finding.fault)];
    if (count.wrong++ < mostShown || infoOf(finding.fault).fatal)
        verdict_.findings.push_back(std::move(finding));
}

void Examination::tell()
{
    if (!follower_.progress)
        return;
    const double share = double(verdict_.judged()) / double(verdict_.lines());
    const double seconds = 1e-3 * double(taken_.elapsed());
    follower_.progress({share, share > 0 ? seconds * (1 - share) / share : 0});
}

} // namespace app::plug_in
