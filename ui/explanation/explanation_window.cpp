// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/explanation_window.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/hard_cases/hard_case.h"
#include "app/session/first_traced_line.h"
#include "app/teaching/line_text.h"
#include "app/teaching/manual.h"
#include "app/teaching/shown_steps.h"
#include "ui/explanation/help_contents.h"
#include "ui/explanation/page_view.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSettings>
#include <QShortcut>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr QSize usual(660, 802), smallest(560, 360);
constexpr int contentsWidth = 204, fieldWidth = 220;

/// Where the panels are, which are at the right of the editor.
void putOverPanels(QWidget& help, const QWidget& editor)
{
    const QRect there = editor.window()->frameGeometry();
    help.move(there.right() - help.frameGeometry().width(), there.top() + space::rowHeight * 2);
    fitToScreens(help);
}

} // namespace

ExplanationWindow::ExplanationWindow(app::Session& session, QWidget& window)
    : QDialog(&window, Qt::Window), session_(session),
      questions_(std::make_unique<Questions>(*this)), contents_(new HelpContents),
      page_(new PageView), wanted_(new QLineEdit), found_(new ElidedLabel),
      strip_(new MessageStrip), where_(new ElidedLabel)
{
    setObjectName(QStringLiteral("explanation"));
    contents_->setFixedWidth(contentsWidth);
    auto* reading = new QVBoxLayout;
    reading->setSpacing(0);
    reading->addWidget(bar());
    reading->addWidget(page_, 1);
    reading->addWidget(finder());
    reading->addWidget(strip_);
    reading->addWidget(foot());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(contents_);
    row->addWidget(rule(Qt::Vertical));
    row->addLayout(reading, 1);
    connect(contents_, &HelpContents::chosen, page_, &PageView::open);
    connect(page_, &PageView::pageChanged, this, &ExplanationWindow::showPlace);
    connect(page_, &PageView::linkChosen, this, &ExplanationWindow::follow);
    connect(page_, &QTextBrowser::backwardAvailable, back_, &QWidget::setEnabled);
    connect(page_, &QTextBrowser::forwardAvailable, forward_, &QWidget::setEnabled);
    const bool isFirst = !QSettings().contains("explanationGeometry");
    restorePlace(*this, QStringLiteral("explanationGeometry"), usual, smallest);
    if (isFirst)
        putOverPanels(*this, window);
    page_->setZoom(QSettings().value("explanationZoom").toInt());
}

ExplanationWindow::~ExplanationWindow() = default;

void ExplanationWindow::setQuestions(std::unique_ptr<Questions> questions)
{
    questions_ = std::move(questions);
}

QToolButton* ExplanationWindow::button(std::string_view iconKey, const QString& text,
                                       const QKeySequence& keys)
{
    auto* made = new QToolButton;
    if (iconKey.empty())
        made->setText(text.section(u' ', 0, 0));
    else
        made->setIcon(icon(iconKey));
    made->setAutoRaise(true);
    made->setAccessibleName(text);
    made->setToolTip(keys.isEmpty()
                         ? text
                         : Text::tr("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText)));
    made->setFixedHeight(space::toolButton);
    if (!keys.isEmpty())
        connect(new QShortcut(keys, this), &QShortcut::activated, made, &QToolButton::click);
    return made;
}

QWidget* ExplanationWindow::bar()
{
    back_ = button("step-back", Text::tr("Back"), QKeySequence(QStringLiteral("Alt+Left")));
    forward_ = button("step-on", Text::tr("Forward"), QKeySequence(QStringLiteral("Alt+Right")));
    look_ =
        button("microscope", Text::tr("Show this algorithm step by step in the microscope"), {});
    look_->setText(Text::tr("Open microscope"));
    look_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* smaller = button({}, Text::tr("A− Smaller text"), QKeySequence::ZoomOut);
    auto* larger = button({}, Text::tr("A+ Larger text"), QKeySequence::ZoomIn);
    auto* search = button("zoom", Text::tr("Find on this page"), QKeySequence::Find);
    auto* save = button("export", Text::tr("Save as PDF…"), QKeySequence(QStringLiteral("Ctrl+P")));
    back_->setEnabled(false);
    forward_->setEnabled(false);
    connect(back_, &QToolButton::clicked, page_, &QTextBrowser::backward);
    connect(forward_, &QToolButton::clicked, page_, &QTextBrowser::forward);
    connect(smaller, &QToolButton::clicked, this, [this] { page_->setZoom(page_->zoom() - 1); });
    connect(larger, &QToolButton::clicked, this, [this] { page_->setZoom(page_->zoom() + 1); });
    connect(new QShortcut(QKeySequence(QStringLiteral("Ctrl+0")), this), &QShortcut::activated,
            this, [this] { page_->setZoom(0); });
    connect(search, &QToolButton::clicked, this, [this] {
        finder_->show();
        wanted_->setFocus(Qt::ShortcutFocusReason);
        wanted_->selectAll();
    });
    connect(save, &QToolButton::clicked, this, &ExplanationWindow::savePdf);
    connect(new QShortcut(QKeySequence(QStringLiteral("Ctrl+K")), this), &QShortcut::activated,
            contents_, &HelpContents::search);
    connect(look_, &QToolButton::clicked, this, [this] {
        app::TracedLine tracedLine = app::firstTracedLine(session_);
        tracedLine.variant = {page_->algorithm(), clipping::Form::Corrected};
        session_.microscope.open(tracedLine);
        emit editorWanted();
    });
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(space::dockMargin, 4, space::dockMargin, 4);
    row->setSpacing(4);
    for (QToolButton* one : {back_, forward_, look_})
        row->addWidget(one);
    row->addStretch();
    for (QToolButton* one : {smaller, larger, search, save})
        row->addWidget(one);
    return whole;
}

QWidget* ExplanationWindow::finder()
{
    finder_ = new QWidget;
    wanted_->setObjectName(QStringLiteral("find-on-page"));
    wanted_->setPlaceholderText(Text::tr("Find on this page"));
    wanted_->setAccessibleName(Text::tr("Find on this page"));
    wanted_->setClearButtonEnabled(true);
    wanted_->setMinimumWidth(fieldWidth / 2);
    wanted_->setMaximumWidth(fieldWidth);
    found_->setForegroundRole(QPalette::PlaceholderText);
    auto* before = button("step-back", Text::tr("Previous"), {});
    auto* next = button("step-on", Text::tr("Next"), {});
    auto* close = button("close", Text::tr("Close"), {});
    connect(wanted_, &QLineEdit::textChanged, this, [this] {
        page_->moveCursor(QTextCursor::Start);
        find({});
    });
    connect(wanted_, &QLineEdit::returnPressed, this, [this] { find({}); });
    connect(next, &QToolButton::clicked, this, [this] { find({}); });
    connect(before, &QToolButton::clicked, this, [this] { find(QTextDocument::FindBackward); });
    connect(close, &QToolButton::clicked, this, &ExplanationWindow::stopFinding);
    auto* row = new QHBoxLayout(finder_);
    row->setContentsMargins(space::dockMargin, 4, space::dockMargin, 4);
    row->setSpacing(6);
    row->addWidget(wanted_, 3);
    row->addWidget(before);
    row->addWidget(next);
    row->addWidget(found_, 2);
    row->addWidget(close);
    finder_->hide();
    return finder_;
}

/// *Show it to me*, and where.
QWidget* ExplanationWindow::foot()
{
    foot_ = new QWidget;
    auto* show = plainButton(Text::tr("Show it to me"));
    show->setObjectName(QStringLiteral("show-steps"));
    where_->setForegroundRole(QPalette::PlaceholderText);
    connect(show, &QPushButton::clicked, this, [this] {
        strip_->tell({});
        if (const auto page = app::manualPage(page_->topic()))
            emit showWanted(*page);
    });
    auto* row = new QHBoxLayout(foot_);
    row->setContentsMargins(2 * space::dockMargin, space::labelToField, space::dockMargin,
                            space::dockMargin);
    row->setSpacing(space::labelToField);
    row->addWidget(show);
    row->addWidget(where_, 1);
    foot_->hide();
    return foot_;
}

void ExplanationWindow::tell(const QString& warning)
{
    strip_->tell({Message::Kind::Warning, warning});
}

void ExplanationWindow::show(const clipping::Algorithm& algorithm)
{
    if (page_->algorithm() != &algorithm)
        page_->show(algorithm);
    QDialog::show();
}

void ExplanationWindow::showManual(const QString& topic)
{
    page_->showManual(topic);
    QDialog::show();
}

void ExplanationWindow::showInHand(const QString& topic)
{
    showManual(topic);
    inHand_ = topic;
}

void ExplanationWindow::takeInHand(const QString& topic)
{
    if (isVisible() && !inHand_.isEmpty() && !topic.isEmpty())
        showInHand(topic);
}

void ExplanationWindow::setCommands(const app::HelpCommands& commands)
{
    contents_->setCommands(commands);
}

void ExplanationWindow::showPlace()
{
    if (page_->title().isEmpty())
        return;
    setWindowTitle(Text::tr("Help: %1").arg(page_->title()));
    look_->setVisible(page_->algorithm());
    const auto manual = app::manualPage(page_->topic());
    foot_->setVisible(manual && !manual->shows.isEmpty());
    where_->setWhole(foot_->isHidden() ? QString()
                                       : app::placeOfSteps(manual->shows, session_.now()));
    contents_->showPlace(page_->source().path());
    if (page_->topic() != inHand_)
        inHand_.clear();
    if (finder_->isVisible() && !wanted_->text().isEmpty())
        find({});
}

void ExplanationWindow::follow(const QUrl& link)
{
    if (const auto tracedLine = app::tracedLineOf(link)) {
        session_.microscope.open(*tracedLine);
        emit editorWanted();
    } else if (link.scheme() != QStringLiteral("clearcut")) {
        QDesktopServices::openUrl(link);
    } else if (const auto* hard = app::findHardCase(link.path().section(u'/', 1))) {
        emit hardCaseWanted(*hard);
    } else if (link.path().startsWith(QStringLiteral("fails/"))) {
        emit failingWanted(link.path().section(u'/', 1));
    }
}

void ExplanationWindow::find(QTextDocument::FindFlags direction)
{
    const int count = page_->find(wanted_->text(), direction);
    found_->setWhole(
        wanted_->text().isEmpty() ? QString()
        : count == 0              ? Text::tr("Not on this page")
        : count == 1              ? Text::tr("Once on this page")
                     : Text::tr("%1 times on this page").arg(app::countText(std::size_t(count))));
}

void ExplanationWindow::stopFinding()
{
    finder_->hide();
    page_->forgetFound();
    page_->setFocus();
}

void ExplanationWindow::savePdf()
{
    const QString name = (page_->algorithm() ? app::latin(page_->algorithm()->key) : page_->topic())
                         + QStringLiteral(".pdf");
    const QString file = questions_->fileToWrite(Text::tr("Save page as PDF"), name,
                                                 Text::tr("PDF document"), QStringLiteral("pdf"));
    if (file.isEmpty())
        return;
    if (const auto error = page_->saveAsPdf(file))
        strip_->tell({Message::Kind::Warning, *error});
    else
        strip_->tell({});
}

void ExplanationWindow::hideEvent(QHideEvent* event)
{
    rememberPlace(*this, QStringLiteral("explanationGeometry"));
    QSettings().setValue("explanationZoom", page_->zoom());
    QDialog::hideEvent(event);
}

/// Esc first ends the search.
void ExplanationWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && finder_->isVisible())
        return stopFinding();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        return; // there is no default button
    QDialog::keyPressEvent(event);
}

} // namespace ui

#include "moc_explanation_window.cpp"
