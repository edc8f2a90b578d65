// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/algorithm_panel.h"

#include "app/base/text.h"
#include "app/session/window_in_hand.h"
#include "ui/docks/algorithm_list.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int idleMilliseconds = 400;
constexpr std::size_t mostLinesUnasked = 150'000; // about 60 ms for all algorithms

} // namespace

AlgorithmPanel::AlgorithmPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), corrected_(new QRadioButton(Text::tr("corrected"))),
      published_(new QRadioButton(Text::tr("as published"))), tick_(new IconSign("tick", 16)),
      verdict_(new LookLabel), instead_(new QLabel), remark_(new QStackedLayout),
      ask_(new QPushButton(Text::tr("Compare all algorithms")))
{
    auto* label = new QLabel(Text::tr("Form"));
    label->setForegroundRole(QPalette::PlaceholderText);
    corrected_->setToolTip(Text::tr("With the faults of the published form corrected"));
    verdict_->setWordWrap(true);
    verdict_->setAlignment(Qt::AlignTop);
    // So that the layout does not jump.
    verdict_->setMinimumHeight(2 * verdict_->fontMetrics().lineSpacing());
    verdict_->setAccessibleName(Text::tr("Agreement"));
    instead_->setWordWrap(true);
    instead_->setAlignment(Qt::AlignTop);
    instead_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored); // two lines, as verdict_
    instead_->setContentsMargins(space::dockMargin, 2, space::dockMargin, 0);
    instead_->setAccessibleName(Text::tr("Used instead"));
    setKeyTip(*ask_, Text::tr("Check whether all algorithms give the same result ({agree})"));

    auto* form = new QHBoxLayout;
    form->setContentsMargins(space::dockMargin, 4, space::dockMargin, 0);
    form->addWidget(label);
    form->addSpacing(space::labelToField);
    form->addWidget(corrected_);
    form->addSpacing(space::labelToField);
    form->addWidget(published_);
    form->addStretch();
    auto* agreement = new QWidget;
    auto* agree = new QHBoxLayout(agreement);
    agree->setContentsMargins(space::dockMargin, 2, space::dockMargin, 0);
    agree->setSpacing(6);
    agree->addWidget(tick_, 0, Qt::AlignTop);
    agree->addWidget(verdict_, 1);
    agree->addWidget(ask_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, space::labelToField);
    column->setSpacing(4);
    auto* list = new AlgorithmList(session);
    connect(list, &AlgorithmList::aboutWanted, this, &AlgorithmPanel::aboutWanted);
    connect(list, &AlgorithmList::menuWanted, this, &AlgorithmPanel::menuWanted);
    column->addWidget(list);
    column->addLayout(form);
    column->addLayout(remark_); // one place for both, so that no panel changes its height
    for (QWidget* remark : {agreement, static_cast<QWidget*>(instead_)})
        remark_->addWidget(remark); // now that they have a parent: it shows the first one
    column->addWidget(new PageCaption(session));
    column->addStretch();

    const auto choose = [this](clipping::Form chosen) {
        session_.changeDisplay([chosen](app::Display& display) { display.variant.form = chosen; });
    };
    connect(corrected_, &QRadioButton::clicked, this, [=] { choose(clipping::Form::Corrected); });
    connect(published_, &QRadioButton::clicked, this, [=] { choose(clipping::Form::Published); });
    connect(ask_, &QPushButton::clicked, this, [this] { compare(); });
    connect(&session, &app::Session::displayChanged, this, &AlgorithmPanel::follow);
    connect(&session, &app::Session::previewChanged, this, &AlgorithmPanel::followWindow);
    connect(&session, &app::Session::previewChanged, this, &AlgorithmPanel::followNeeds);
    connect(&session.scene, &app::Scene::outdated, this, &AlgorithmPanel::outdate);
    idle_.setSingleShot(true);
    idle_.setInterval(idleMilliseconds);
    connect(&idle_, &QTimer::timeout, this, [this] { compare(); });
    follow();
}

void AlgorithmPanel::compare(std::function<void()> done)
{
    idle_.stop();
    const auto window = session_.comparedAt();
    verdict_->setVisible(window.has_value()); // the caption says why nothing is compared
    tick_->setVisible(window.has_value());
    ask_->setEnabled(false);
    if (!window)
        return ask_->hide();
    comparing_.start(
        [lines = session_.scene.lines(), window = *window,
         variant = session_.variant()](const app::Follower& follower) {
            return app::disagreements(lines, window, variant, follower.stop);
        },
        [this, done = std::move(done)](std::vector<app::Disagreement> found) {
            disagreements_ = std::move(found);
            showVerdict();
            if (done)
                done();
        });
}

void AlgorithmPanel::showVerdict()
{
    verdict_->setText(app::sentence(disagreements_));
    verdict_->show();
    tick_->setVisible(true);
    ask_->hide();
    ask_->hide();
    const auto window = session_.comparedAt();
    verdict_->setVisible(window.has_value()); // the caption says why nothing is compared
    tick_->setVisible(window.has_value());
    if (!window)
        return;
    disagreements_ = app::disagreements(session_.scene.lines(), *window, session_.variant());
    verdict_->setText(app::sentence(disagreements_));
    paintVerdict();
}

// Other previews, such as a line being drawn, do not change the window.
void AlgorithmPanel::followWindow()
{
    if (window_ == session_.comparedAt())
        return;
    window_ = session_.comparedAt();
    outdate();
}

void AlgorithmPanel::outdate()
{
    comparing_.cancel();
    ask_->setEnabled(true);
    const bool unasked = session_.scene.lines().size() <= mostLinesUnasked || !window_;
    if (unasked && isVisible())
        idle_.start();
    if (!unasked) {
        verdict_->hide();
        tick_->hide();
    }
    ask_->setVisible(!unasked);
}

void AlgorithmPanel::follow()
{
    const app::Variant used = session_.variant();
    const bool both = used.algorithm->published;
    published_->setText(both ? Text::tr("as published") : Text::tr("published: none"));
    (used.form == clipping::Form::Published ? published_ : corrected_)->setChecked(true);
    outdate();
    followNeeds();
}

void AlgorithmPanel::followNeeds()
{
    const QString instead = app::insteadText(app::needsOf(session_.region()), session_.variant());
    const clipping::Algorithm& chosen = *session_.variant().algorithm;
    const bool here = app::needsOf(session_.region()) <= app::WindowNeeds::RotatedRectangle;
    published_->setEnabled(chosen.published && here);
    published_->setToolTip(!chosen.published
                               ? Text::tr("%1 has no published form, so the corrected form is used")
                                     .arg(QLatin1StringView(chosen.name))
                           : here ? Text::tr("As its authors printed it, faults included")
                                  : Text::tr("Published forms clip at rectangles only"));
    instead_->setText(instead);
    remark_->setCurrentIndex(instead.isEmpty() ? 0 : 1);
    emit titled(title());
}

QIcon AlgorithmPanel::sign() const { return markerIcon(session_.variant()); }

QString AlgorithmPanel::abbreviation() const
{
    return app::latin(session_.variant().algorithm->abbreviation);
}

QString AlgorithmPanel::title() const
{
    const app::Variant used = session_.variant();
    const QString name = app::latin(used.algorithm->name);
    const QString form =
        used.form == clipping::Form::Published ? Text::tr("%1, as published").arg(name) : name;
    const QString where = app::headingInHand(session_);
    return where.isEmpty() ? form : form + u' ' + where;
}

void AlgorithmPanel::paintVerdict()
{
    const bool good = disagreements_.empty();
    const auto colour = good ? &Look::good : &Look::differs;
    verdict_->setFont(good ? font() : semiBold(font()));
    verdict_->setColour(colour);
    tick_->show(good ? "tick" : "warning", colour);
}

void AlgorithmPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!comparing_.active())
        outdate();
}

} // namespace ui

#include "moc_algorithm_panel.cpp"
