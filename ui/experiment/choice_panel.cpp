// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/choice_panel.h"

#include "app/base/text.h"
#include "app/experiment/ranking.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/segments.h"

#include <QGridLayout>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>

namespace ui {

namespace {

constexpr std::uint64_t fewestTimed = 100'000; // a smaller drawing is clipped repeatedly

enum Forms { Published, Corrected, Both };

QSpinBox* numberField(const QString& name, int least, int most)
{
    auto* field = new QSpinBox;
    field->setAccessibleName(name);
    field->setRange(least, most);
    field->setGroupSeparatorShown(true);
    field->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    field->setAlignment(Qt::AlignRight);
    return field;
}

QLabel* caption(const QString& text)
{
    auto* label = new QLabel(text);
    label->setFont(captionFont(label->font()));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

} // namespace

ChoicePanel::ChoicePanel(Drawing drawing, QWidget* parent)
    : QWidget(parent), subjects_(app::subjects()), drawing_(std::move(drawing)),
      subject_(new QComboBox), meaning_(caption({})),
      lines_(numberField(Text::tr("Lines"), 1, 1'000'000'000)),
      runs_(numberField(Text::tr("Runs"), 1, int(app::mostRuns))),
      seed_(numberField(Text::tr("Seed"), 0, std::numeric_limits<int>::max())),
      order_(new Segments(Text::tr("Order"),
                          {Text::tr("As they come"), Text::tr("Shuffled"), Text::tr("By class")})),
      forms_(new Segments(Text::tr("Forms"),
                          {Text::tr("Published"), Text::tr("Corrected"), Text::tr("Both")})),
      drawn_(new QCheckBox(Text::tr("Also draw the visible parts"))),
      explained_(new QCheckBox(Text::tr("Explain the times"))),
      inProcesses_(new QCheckBox(Text::tr("Each run in a new process")))
{
    describeFields();
    own_.assign(clipping::algorithms().size(), true);
    addSubjects();
    layOut();

    connect(runs_, &QSpinBox::valueChanged, this, [this] { runsTyped_ = true; });
    connect(this, &ChoicePanel::changed, this, &ChoicePanel::showRuns);
    connect(subject_, &QComboBox::currentIndexChanged, this, &ChoicePanel::showSubject);
    for (QSpinBox* field : {lines_, runs_, seed_})
        connect(field, &QSpinBox::valueChanged, this, &ChoicePanel::changed);
    for (Segments* segments : {order_, forms_})
        connect(segments, &Segments::picked, this, &ChoicePanel::changed);
    for (QCheckBox* box : {drawn_, explained_, inProcesses_})
        connect(box, &QCheckBox::toggled, this, &ChoicePanel::changed);
    showSubject();
}

void ChoicePanel::describeFields()
{
    const std::size_t all = clipping::algorithms().size();
    runs_->setToolTip(
        Text::tr("The paper used ten runs. Ranking %2 algorithms needs at least %1 runs; "
                 "with fewer there are no ranks.")
            .arg(app::leastRounds(all))
            .arg(all));
    seed_->setValue(1);
    seed_->setGroupSeparatorShown(false);
    lines_->setSpecialValueText(Text::tr("as in the paper"));
    order_->setToolTip(
        Text::tr("As they come: in the drawing's order. Shuffled: the same lines in "
                 "random order. By class: lines grouped into inside, rejected, cut and "
                 "missed, so that the processor predicts branches well."));
    forms_->setToolTip(Text::tr("Published: as the authors printed the algorithm, faults included. "
                                "Corrected: without these faults."));
    drawn_->setChecked(true);
    drawn_->setToolTip(
        Text::tr("The paper timed generating, clipping and drawing the lines together."));
    explained_->setChecked(true);
    explained_->setToolTip(Text::tr(
        "Measure the time for each class of lines, the number of operations and the accuracy."));
    inProcesses_->setToolTip(
        Text::tr("In another process memory lies elsewhere, which changes times by some per cent. "
                 "The confidence intervals then cover this too. Takes about twice as long."));
    meaning_->setMinimumHeight(3 * meaning_->fontMetrics().lineSpacing() + 2);
    meaning_->setAlignment(Qt::AlignTop);
}

void ChoicePanel::layOut()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    const auto row = [&](const QString& name, QWidget* field) {
        auto* label = new QLabel(name);
        label->setBuddy(field);
        grid->addWidget(label, grid->rowCount(), 0);
        const bool wide = qobject_cast<QSpinBox*>(field);
        grid->addWidget(field, grid->rowCount() - 1, 1, wide ? Qt::Alignment() : Qt::AlignLeft);
    };
    row(Text::tr("&Lines"), lines_);
    row(Text::tr("&Runs"), runs_);
    row(Text::tr("&Seed"), seed_);
    row(Text::tr("Order"), order_);
    row(Text::tr("Forms"), forms_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(subject_);
    column->addWidget(meaning_);
    column->addLayout(grid);
    column->addSpacing(space::labelToField);
    column->addWidget(new QLabel(Text::tr("Algorithms")));
    column->addWidget(algorithmBoxes());
    column->addSpacing(space::labelToField);
    column->addWidget(drawn_);
    column->addWidget(explained_);
    column->addWidget(inProcesses_);
}

void ChoicePanel::addSubjects()
{
    subject_->setAccessibleName(Text::tr("What is measured"));
    subject_->setMaxVisibleItems(20);
    bool papers = true;
    for (const app::Subject& subject : subjects_) {
        if (papers && subject.papers.empty())
            subject_->insertSeparator(subject_->count());
        papers = !subject.papers.empty();
        subject_->addItem(subject.name, subject.key);
    }
    subject_->insertSeparator(subject_->count());
    subject_->addItem(Text::tr("Lines of the current drawing"), QStringLiteral("drawing"));
}

QWidget* ChoicePanel::algorithmBoxes()
{
    constexpr int columns = 3;
    auto* boxes = new QWidget;
    auto* grid = new QGridLayout(boxes);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    for (const auto& algorithm : clipping::algorithms()) {
        auto* box = new QCheckBox(app::latin(algorithm.abbreviation));
        box->setToolTip(app::latin(algorithm.name));
        box->setAccessibleName(app::latin(algorithm.name));
        const int i = int(algorithms_.size());
        grid->addWidget(box, i / columns, i % columns);
        connect(box, &QCheckBox::clicked, this, [this, box, i] {
            own_[std::size_t(i)] = box->isChecked();
            emit changed();
        });
        algorithms_ << box;
    }
    return boxes;
}

bool ChoicePanel::ofDrawing() const { return subject_->currentData() == QStringLiteral("drawing"); }

void ChoicePanel::followDrawing(std::size_t lines)
{
    auto* rows = qobject_cast<QStandardItemModel*>(subject_->model());
    rows->item(subject_->count() - 1)->setEnabled(lines > 0);
    taken_.reset();
    if (ofDrawing() && lines == 0)
        subject_->setCurrentIndex(0);
    else if (ofDrawing())
        showSubject();
}

/// Shows the selected subject with its number of lines; the paper's tables have their own
/// algorithms.
void ChoicePanel::showSubject()
{
    const app::Subject& subject = this->subject();
    const bool tables = subject.papers.size() > 1;
    const auto own = std::max(subject.options.lines, fewestTimed);
    meaning_->setText(subject.meaning);
    const QSignalBlocker quiet(lines_);
    const bool typed = ofDrawing_ && ofDrawing() && lines_->value() != usualLines_;
    ofDrawing_ = ofDrawing();
    usualLines_ = tables ? 0 : int(subject.papers.empty() ? own : subject.papers.front().lines);
    lines_->setMinimum(tables ? 0 : 1);
    if (!typed)
        lines_->setValue(usualLines_);
    showAlgorithms();
    emit changed();
}

void ChoicePanel::showAlgorithms()
{
    const auto& papers = subject().papers;
    for (std::size_t i = 0; i < own_.size(); ++i) {
        const auto* algorithm = &clipping::algorithms()[i];
        const bool paper =
            !papers.empty() && std::ranges::any_of(papers.front().columns, [&](const auto& column) {
                return column.algorithm == algorithm;
            });
        algorithms_[qsizetype(i)]->setEnabled(papers.empty());
        algorithms_[qsizetype(i)]->setChecked(papers.empty() ? own_[i] : paper);
    }
}

/// Shows how many runs are needed, unless another number has been typed.
void ChoicePanel::showRuns()
{
    const auto plan = runsTyped_ ? app::Result<app::Plan>{} : app::planOf(choice());
    if (!plan)
        return;
    const QSignalBlocker quiet(runs_);
    runs_->setValue(int(plan.value->trials.front().options.runs));
}

const app::Subject& ChoicePanel::subject() const
{
    if (ofDrawing() && !taken_)
        taken_ = drawing_();
    if (ofDrawing() && taken_)
        return *taken_;
    const auto found =
        std::ranges::find(subjects_, subject_->currentData().toString(), &app::Subject::key);
    return found == subjects_.end() ? subjects_.front() : *found;
}

app::Choice ChoicePanel::choice() const
{
    app::Choice choice;
    choice.subject = subject();
    if (lines_->value() > 0)
        choice.lines = lines_->value();
    if (runsTyped_)
        choice.runs = std::size_t(runs_->value());
    choice.seed = std::uint64_t(seed_->value());
    choice.order = app::Order(order_->chosen());
    choice.forms.clear();
    if (forms_->chosen() != Corrected)
        choice.forms.push_back(clipping::Form::Published);
    if (forms_->chosen() != Published)
        choice.forms.push_back(clipping::Form::Corrected);
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (own_[i])
            choice.algorithms.push_back(&clipping::algorithms()[i]);
    if (drawn_->isChecked())
        choice.target = target_;
    choice.explained = explained_->isChecked();
    choice.inProcesses = inProcesses_->isChecked();
    return choice;
}

} // namespace ui

#include "moc_choice_panel.cpp"
