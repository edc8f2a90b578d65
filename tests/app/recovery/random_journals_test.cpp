// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/hidden_objects.h"
#include "app/session/clipboard.h"
#include "app/session/copy_selection.h"

#include <QTest>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/test_class.h"

namespace recovery_random_journals_test {

using namespace app;

namespace {

/// Documents as they are opened, of which many never had an object, and so no style either.
class Openings {
public:
    explicit Openings(RandomDocuments& random) : random_(random) {}

    Document next()
    {
        switch (random_.below(6)) {
        case 0:
            return {};
        case 1: { // clip windows alone
            Document document;
            document.apply({.windows = random_.windows()});
            return document;
        }
        case 2:
            return layers();
        case 3:
            return fileWithoutShapes();
        case 4: { // all objects are gone, their styles are not
            Document document = random_.document(1 + random_.below(20));
            const auto count = std::uint32_t(document.objects().size());
            Edit edit{.splices = {{0, count, 0}}};
            edit.containers = document.containers().spliced(edit.splices);
            document.apply(edit);
            return document;
        }
        default:
            return random_.document(1 + random_.below(150));
        }
    }

private:
    Document layers()
    {
        DocumentBuilder builder;
        for (auto n = 1 + random_.below(3); n > 0; --n) {
            builder.open({.name = random_.text()});
            builder.close();
        }
        return builder.take(random_.page());
    }
    static Document fileWithoutShapes()
    {
        QBuffer file;
        file.setData("<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'>"
                     "<g id='empty'/></svg>");
        file.open(QIODevice::ReadOnly);
        return formats().front().read(file).value->document;
    }

    RandomDocuments& random_;
};

/// What people do with several drawings: copies come from this drawing, from another one, or from
/// another program.
class RandomWork {
public:
    RandomWork(Session& session, unsigned seed)
        : session_(session), random_(seed), openings_(random_), commands_(session.document, seed)
    {
    }
    void open() { session_.load({openings_.next(), {}}); }
    void act()
    {
        chooseSome();
        switch (random_.below(8)) {
        case 0:
        case 1:
            clipboard_ = someOf(random_.below(3) == 0 ? openings_.next() : session_.now());
            break;
        case 2:
        case 3:
            if (const Document drawing = pasted(*clipboard_, session_.now().page()).drawing;
                !drawing.objects().empty()) {
                paste(session_, drawing, PastePlace(random_.below(2)));
                ++pastes_;
            }
            break;
        case 4:
            duplicateInPlace(session_);
            break;
        case 5:
            session_.history.setIndex(
                int(random_.below(std::size_t(session_.history.count() + 1))));
            break;
        default:
            if (session_.now().objects().size() < 2000)
                session_.history.push(commands_.next());
        }
    }
    int pastes() const { return pastes_; }

private:
    ObjectRanges some(const Document& document)
    {
        ObjectRanges chosen;
        const std::size_t count = document.objects().size();
        if (count > 0) {
            const std::size_t first = random_.below(count);
            chosen.insert(ObjectRange{first, std::min(count, first + 1 + random_.below(150))});
        }
        return chosen;
    }
    void chooseSome()
    {
        session_.select(common(some(session_.now()), editableObjects(session_.now())));
    }
    std::unique_ptr<QMimeData> someOf(const Document& document)
    {
        return copied(document, some(document));
    }

    Session& session_;
    RandomDocuments random_;
    Openings openings_;
    RandomCommands commands_;
    std::unique_ptr<QMimeData> clipboard_ = std::make_unique<QMimeData>();
    int pastes_ = 0;
};

} // namespace

class RandomJournalsTest : public QObject {
    Q_OBJECT

private slots:
    // Each drawing begins as another one did, and gets what was copied in it.
    void whatIsMadeOfDrawingsIsRecovered()
    {
        const QTemporaryDir home;
        Session session;
        Journal journal(session.document, session.history, home.filePath("unsaved"),
                        {1'000'000'000, 0.002});
        RandomWork work(session, 5);
        for (int round = 0; round < 150; ++round) {
            work.open();
            for (auto n = 3 + round % 12; n > 0; --n)
                work.act();
            journal.wait();
            const auto found = replayed(journal.folder());
            QVERIFY(found);
            QVERIFY2(found->document == session.now(), qPrintable(QString::number(round)));
            QVERIFY(stateOf(*found) == stateOf(session.now(), session.history));
        }
        QVERIFY2(work.pastes() > 50, qPrintable(QString::number(work.pastes())));
    }
};

} // namespace recovery_random_journals_test

TEST_CLASS(recovery_random_journals_test::RandomJournalsTest, Core)
#include "tests/app/recovery/random_journals_test.moc"
