// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/repeat.h"

#include "app/base/text.h"
#include "app/experiment/analysis.h"
#include "app/experiment/one_by_one.h"
#include "app/formats/coordinates.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>

namespace app {
namespace {

/// Quoted for a shell.
QString quoted(const QString& word)
{
    static const QRegularExpression plain(QStringLiteral("^[-\\w,.:/=+@%]+$"));
    if (plain.match(word).hasMatch())
        return word;
    return u'\'' + QString(word).replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

/// The words of a command line.
class Words {
public:
    void add(const char* option, const QString& value = {})
    {
        words_ << QStringLiteral("--") + QLatin1StringView(option);
        if (!value.isEmpty())
            words_.back() += u'=' + value;
    }
    void add(const char* option, std::uint64_t number, std::uint64_t usual)
    {
        if (number != usual)
            add(option, QString::number(number));
    }
    const QStringList& all() const { return words_; }

private:
    QStringList words_{QStringLiteral("bench")};
};

void addPaper(Words& words, const Study& study)
{
    std::set<QString> keys;
    for (const Trial& trial : study.trials)
        if (trial.paper)
            keys.insert(trial.paper->key);
    if (!keys.empty())
        words.add("paper", keys.size() == 1 ? *keys.begin() : QStringLiteral("all"));
    if (!keys.empty())
        words.add("against-paper");
}

/// Adds the forms that take part, if they are not the default of `bench`.
void addForms(Words& words, const Study& study)
{
    if (study.trials.front().record.options.precision == Precision::Single)
        return; // there is only one form
    std::set<clipping::Form> forms;
    for (const Trial& trial : study.trials)
        for (const Timing& timing : trial.record.timings)
            forms.insert(timing.variant.form);
    const bool paper = study.trials.front().paper.has_value();
    const QString form = forms.size() == 2 ? QStringLiteral("both") : wordOf(*forms.begin());
    if (form != (paper ? wordOf(clipping::Form::Published) : QStringLiteral("both")))
        words.add("form", form);
}

void addAlgorithms(Words& words, const Record& record)
{
    QStringList names;
    for (const Timing& timing : record.timings)
        if (timing.variant.algorithm != &exactOneByOne()) // implied by `exact`
            names << QString::fromUtf8(timing.variant.algorithm->key);
    names.removeDuplicates();
    if (std::size_t(names.size()) < clipping::algorithms().size())
        words.add("algorithms", names.join(u','));
}

void addScene(Words& words, const ExperimentOptions& options)
{
    const bool drawing = options.scene.lines > 0;
    if (drawing)
        words.add("scene", QStringLiteral("file:") + options.scene.name);
    else if (options.scene.key != testScenes().front().key)
        words.add("scene", options.scene.key);
    if (drawing || options.field.space != paperSpace)
        words.add("space", rectangleText(options.field.space));
    if (drawing || options.field.shape || options.field.window != paperWindow)
        words.add("window", windowText(options.field));
    if (options.order != Order::AsTheyCome)
        words.add("order", latin(nameOf(options.order).key));
}

void addHow(Words& words, const Study& study)
{
    const Trial& trial = study.trials.front();
    const ExperimentOptions& options = trial.record.options;
    const bool areThePapers = std::ranges::all_of(study.trials, [](const Trial& one) {
        return one.paper && one.record.options.lines == one.paper->lines;
    });
    words.add("lines", options.lines, areThePapers ? options.lines : 0);
    words.add("runs", options.runs, usualRounds(trial.record.timings.size()));
    words.add("warmup", options.warmUps, 1);
    if (options.inProcesses)
        words.add("processes");
    words.add("seed", QString::number(options.seed));
    if (options.precision != Precision::Double)
        words.add("precision", wordOf(options.precision));
    words.add("threads", options.threads, 1);
    if (!trial.record.target.isEmpty())
        words.add("draw-with", trial.record.target.startsWith(QStringLiteral("OpenGL"))
                                   ? QStringLiteral("opengl")
                                   : QStringLiteral("raster"));
}

void addMeasures(Words& words, const Study& study)
{
    QStringList keys;
    for (const Measure& measure : study.measures)
        keys << measure.key;
    if (study.explanation)
        for (const Analysis& analysis : analyses())
            keys << analysis.key;
    words.add("measure", keys.join(u','));
}

} // namespace

QStringList wordsToRepeat(const Study& study)
{
    const Trial& first = study.trials.front();
    Words words;
    addPaper(words, study);
    addForms(words, study);
    if (!first.paper)
        addAlgorithms(words, first.record);
    addScene(words, first.record.options);
    addHow(words, study);
    addMeasures(words, study);
    return words.all();
}

QString commandToRepeat(const Study& study)
{
    const QStringList words = wordsToRepeat(study) << QStringLiteral("--report=report.html");
    QStringList command{QStringLiteral("clearcut")};
    for (const QString& word : words)
        command << quoted(word);
    return command.join(u' ');
}

} // namespace app
