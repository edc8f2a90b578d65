// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/first_traced_line.h"
#include "ui/microscope/export_steps.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace microscope_export_steps_test {

using namespace ui;

/// Learn > Export steps…, without its file dialogs.
class ExportStepsTest : public QObject {
    Q_OBJECT

    TestWindow stage_;
    QTemporaryDir folder_;
    std::unique_ptr<StepExports> exports_;
    PreparedAnswers* answers_ = nullptr;

    app::Session& session() { return stage_.window->session(); }
    app::TraceExport trace()
    {
        return {.tracedLine = session().microscope.tracedLine(),
                .narration = session().microscope.narration()};
    }
    static const app::TraceFormat& format(const char* key)
    {
        return *app::findTraceFormat(QString::fromLatin1(key));
    }
    /// Writes the files, and waits for them.
    void write(const app::TraceFormat& format)
    {
        exports_->write(format, trace());
        QTRY_VERIFY_WITH_TIMEOUT(!exports_->busy(), 60000);
    }

private slots:
    void initTestCase()
    {
        stage_.show();
        session().microscope.open(app::firstTracedLine(session()));
        session().microscope.next();
    }
    void init()
    {
        exports_ = std::make_unique<StepExports>(*stage_.window, session().microscope);
        auto answers = std::make_unique<PreparedAnswers>(*stage_.window);
        answers_ = answers.get();
        exports_->setQuestions(std::move(answers));
    }

    void everyFormatIsWritten()
    {
        for (const app::TraceFormat& row : app::traceFormats()) {
            const QString name = QString::fromLatin1(row.ending.data());
            answers_->save = folder_.filePath("steps." + name);
            QSignalSpy told(exports_.get(), &StepExports::told);
            write(row);
            QCOMPARE(told.count(), 1);
            QCOMPARE(told.front().front().value<Message>().kind, Message::Kind::Done);
            const auto files = QDir(folder_.path()).entryList({"steps*." + name});
            const bool several = row.files == app::TraceFormat::Files::OneAStep;
            QCOMPARE(files.size(),
                     several ? qsizetype(session().microscope.narration().steps.size()) : 1);
        }
    }

    void asksBeforeNumberedFilesAreReplaced()
    {
        answers_->save = folder_.filePath("talk.svg");
        write(format("svg"));
        QVERIFY(answers_->existing.isEmpty());
        const QString first = folder_.filePath("talk-01.svg");
        QVERIFY(QFile::remove(first));
        QFile own(first);
        QVERIFY(own.open(QIODevice::WriteOnly) && own.write("own") == 3);
        own.close();
        QSignalSpy told(exports_.get(), &StepExports::told);
        write(format("svg")); // and the answer is no
        QCOMPARE(answers_->existing.size(),
                 qsizetype(session().microscope.narration().steps.size()));
        QVERIFY(told.isEmpty());
        QCOMPARE(QFileInfo(first).size(), 3);
        answers_->overwrite = true;
        write(format("svg"));
        QCOMPARE(told.count(), 1);
        QVERIFY(QFileInfo(first).size() > 1000);
    }

    void cancellingWritesNothing()
    {
        QSignalSpy told(exports_.get(), &StepExports::told);
        write(format("pdf"));
        QVERIFY(told.isEmpty());
    }

    void anUnwritableFileIsReported()
    {
        answers_->save = folder_.filePath("none/steps.pdf");
        QSignalSpy told(exports_.get(), &StepExports::told);
        write(format("pdf"));
        const auto message = told.front().front().value<Message>();
        QCOMPARE(message.kind, Message::Kind::Warning);
        QVERIFY(message.sentence.startsWith("Cannot write " + answers_->save));
    }

    void theMenuOpensTheDialog()
    {
        auto* action = stage_.window->findChild<QAction*>("export-steps");
        QVERIFY(action && action->isEnabled());
        action->trigger();
        auto* dialog = stage_.window->findChild<ExportStepsDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        for (auto* exports : stage_.window->findChildren<StepExports*>())
            if (exports != exports_.get())
                emit exports->told({Message::Kind::Done, "Exported."});
        QCOMPARE(stage_.window->message(), "Exported.");
        const auto boxes = dialog->findChildren<QCheckBox*>();
        QCOMPARE(boxes.size(), 2);
        QVERIFY(boxes[0]->text().contains("2 of "));
        boxes[0]->click();
        boxes[1]->click();
        const app::TraceExport chosen = dialog->trace();
        QCOMPARE(chosen.only, std::optional<std::size_t>(1));
        QCOMPARE(chosen.parts, app::SlideParts::Picture);
        auto* type = dialog->findChildren<QComboBox*>().front();
        QCOMPARE(type->count(), int(app::traceFormats().size()));
        type->setCurrentIndex(type->count() - 1);
        QCOMPARE(dialog->format().key, app::traceFormats().back().key);
        QVERIFY(!boxes[1]->isEnabled()); // data has no picture
        dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
        QVERIFY(!dialog->isVisible());
        session().microscope.close();
        QVERIFY(!action->isEnabled());
    }
};

} // namespace microscope_export_steps_test

TEST_CLASS(microscope_export_steps_test::ExportStepsTest, Widgets)
#include "tests/ui/microscope/export_steps_test.moc"
