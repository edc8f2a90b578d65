// SPDX-License-Identifier: GPL-3.0-or-later
// Layers and groups: which there are after reading, where they are, and what they say of
// themselves.
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_container_stack_test {

namespace {

const QByteArray path = "<path d='M0 0h1'/>";

QByteArray layer(const QByteArray& attributes, const QByteArray& content)
{
    return "<g inkscape:groupmode='layer' " + attributes + ">" + content + "</g>";
}

QByteArray group(const QByteArray& attributes, const QByteArray& content)
{
    return "<g " + attributes + ">" + content + "</g>";
}

QString flags(const app::Container& container)
{
    return QString(container.visible ? "" : " invisible") + (container.locked ? " locked" : "");
}

// "A(2 g[1])": a layer with two objects, above them a group with one.
QString outlineOf(const app::Document& document, app::ContainerId id)
{
    const app::Containers& tree = document.containers();
    QStringList parts;
    std::size_t next = tree.rangeOf(id).first;
    const auto addObjects = [&](std::size_t end) {
        if (end > next)
            parts << QString::number(end - next);
        next = end;
    };
    for (const app::ContainerId inner : tree.childrenOf(id)) {
        addObjects(tree.rangeOf(inner).first);
        const app::Container& container = tree[inner];
        const bool isLayer = container.kind == app::Container::Kind::Layer;
        parts << container.name + (isLayer ? "(" : "[") + outlineOf(document, inner)
                     + (isLayer ? ")" : "]") + flags(container);
        next = tree.rangeOf(inner).end;
    }
    addObjects(tree.rangeOf(id).end);
    return parts.join(' ');
}

app::Document read(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? result.value->document : app::Document();
}

QString outline(const QByteArray& elements) { return outlineOf(read(elements), 0); }

} // namespace

class ContainerStackTest : public QObject {
    Q_OBJECT

private slots:
    void layersNest()
    {
        QCOMPARE(outline(""), "Drawing()");
        QCOMPARE(outline(layer("inkscape:label='A'", "") + layer("id='b'", path)), "A() b(1)");
        QCOMPARE(outline(layer("inkscape:label='A'",
                               path + layer("inkscape:label='B'", path) + path + path)),
                 "A(1 B(1) 2)");
    }
    void objectsOutsideLayersGetALayer()
    {
        QCOMPARE(outline(path + group("", path)), "Drawing(2)");
        QCOMPARE(outline(path + layer("inkscape:label='A'", path) + path + path
                         + layer("inkscape:label='B'", path) + path),
                 "Drawing(1) A(1) Drawing (2)(2) B(1) Drawing (3)(1)");
        QCOMPARE(outline(group("id='g'", path) + path), "Drawing([1] 1)");
    }
    void onlyGroupsWithAnIdNameOrTitleAreKept()
    {
        QCOMPARE(outline(group("", path)), "Drawing(1)");
        QCOMPARE(outline(group("fill='red'", path)), "Drawing(1)");
        QCOMPARE(outline(group("id=''", path)), "Drawing(1)");
        QCOMPARE(outline(group("", "<title> </title>" + path)), "Drawing(1)");
        QCOMPARE(outline(group("id='a'", path)), "Drawing([1])");
        QCOMPARE(outline(group("inkscape:label='G'", path + group("id='b'", path))),
                 "Drawing(G[1 [1]])");
        QCOMPARE(outline(group("", "<title>T</title>" + path)), "Drawing([1])");
        QCOMPARE(outline(group("", "<desc>D</desc>" + path)), "Drawing([1])");
        QCOMPARE(outline(group("c:group='' xmlns:c='urn:clearcut:1'", path)), "Drawing([1])");
        QCOMPARE(outline(group("", group("id='a'", group("", path + path)))), "Drawing([2])");
        QCOMPARE(outline(group("id='a'", "")), "Drawing([])");
    }
    void aLayerInAGroupBecomesAGroup()
    {
        QCOMPARE(outline(group("id='a'", layer("inkscape:label='A'",
                                               path + layer("inkscape:label='B'", path)))),
                 "Drawing([A[1 B[1]]])");
        QCOMPARE(outline(group("", layer("inkscape:label='A'", path))), "A(1)");
        QCOMPARE(outline(layer("inkscape:label='A'",
                               group("inkscape:label='G'", layer("inkscape:label='B'", path))
                                   + layer("inkscape:label='C'", path))),
                 "A(G[B[1]] C(1))");
    }
    void hiddenAndLockedOnes()
    {
        const QByteArray locked =
            " xmlns:s='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' s:insensitive='true'";
        for (const char* hides : {"display='none'", "style='display:none'"}) {
            const auto document = read(group(hides + QByteArray(" id='a'"), path));
            QCOMPARE(outlineOf(document, 0), "Drawing([1] invisible)");
            QVERIFY(!document.objects()[0].hidden() && !document.shown(0));
        }
        QCOMPARE(outline(group("inkscape:label='G'" + locked, path)), "Drawing(G[1] locked)");
        QCOMPARE(outline(layer("inkscape:label='A' display='none'" + locked, path)),
                 "A(1) invisible locked");
        // A hidden one that is no container hides what is in it.
        const auto dissolved = read(group("display='none'", group("id='a'", path)));
        QCOMPARE(outlineOf(dissolved, 0), "Drawing([1])");
        QVERIFY(dissolved.objects()[0].hidden());
        const auto invisible = read(group("id='a' visibility='hidden'", path));
        QCOMPARE(outlineOf(invisible, 0), "Drawing([1])");
        QVERIFY(invisible.objects()[0].hidden());
    }
    // What is drawn elsewhere, or only clips, is no part of the tree.
    void groupsOfOtherElementsDissolve()
    {
        const QByteArray defs = "<defs><g id='a'><g id='b'>" + path + "</g></g><symbol id='s'>"
                                + group("id='c'", path) + "</symbol></defs>";
        QCOMPARE(outline(defs), "Drawing()");
        QCOMPARE(outline(defs + "<use href='#a'/><use href='#s' id='u'/>"), "Drawing(2)");
        QCOMPARE(outline(group("id='d'", defs + "<use href='#a'/>") + "<use href='#d'/>"),
                 "Drawing([1] 1)");
        QCOMPARE(outline("<clipPath id='p'><path id='q' d='M-9-9H99V99H-9z'/></clipPath>"
                         + group("id='d' clip-path='url(#p)'", path)),
                 "Drawing([1])");
        QCOMPARE(outline("<switch>" + group("id='d'", path) + "</switch>"), "Drawing([1])");
        QCOMPARE(outline("<a id='d'>" + path + "</a>"), "Drawing(1)");
    }

    void whatContainersAndObjectsSayIsKept()
    {
        const QByteArray elements =
            layer("id='l'", "<title>L</title><desc>M</desc>"
                                + group("id='g'", "<title>A</title><desc><b>B</b></desc>"
                                                  "<title>C</title><title> </title>"
                                                  "<path id='p' d='M0 0h1'><title>P &amp; Q</title>"
                                                  "<desc/></path>"));
        QCOMPARE(reportOf(elements), "");
        const auto document = read(elements);
        const app::Containers& tree = document.containers();
        const auto all = tree.inOrder();
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(tree[all[0]].svgId, "l");
        QCOMPARE(tree[all[0]].title, "<title>L</title>");
        QCOMPARE(tree[all[0]].description, "<desc>M</desc>");
        QCOMPARE(tree[all[1]].svgId, "g");
        QCOMPARE(tree[all[1]].title, "<title>A</title>\n<title>C</title>");
        QCOMPARE(tree[all[1]].description, "<desc><b>B</b></desc>");
        QVERIFY(document.objects()[0].particulars()
                == (app::Particulars{.id = "p", .title = "<title>P &amp; Q</title>"}));
        QVERIFY(document.about() == app::About{});
    }
    void notesOfWhatIsNotKeptAreALoss()
    {
        const QByteArray title = "<title>T</title>";
        QCOMPARE(reportOf("<a>" + title + path + "</a>"),
                 "1 title, description or metadata of an element");
        QCOMPARE(reportOf("<path d='M0 0h1'><metadata>M</metadata></path><path d=''>" + title
                          + "</path>"),
                 "2 titles, descriptions or metadata of elements");
        // A <use> that draws just one element is that object.
        const QByteArray used = "<defs><path id='p' d='M0 0h1'>" + title + "</path></defs>"
                                + "<use id='u' href='#p'><desc>D</desc></use>";
        QCOMPARE(reportOf(used), "1 title, description or metadata of an element");
        QVERIFY(read(used).objects()[0].particulars()
                == (app::Particulars{.id = "u", .description = "<desc>D</desc>"}));
        const QByteArray deep =
            QByteArray("<b>").repeated(20) + "x" + QByteArray("</b>").repeated(20);
        QCOMPARE(reportOf("<path d='M0 0h1'><desc>" + deep + "</desc></path>"),
                 "1 title, description or metadata of an element");
        const QByteArray much(51'000'000, 'x');
        QCOMPARE(reportOf("<path d='M0 0h1'><desc>" + much + "</desc>" + title + "</path>"),
                 "1 title, description or metadata of an element");
    }

    void repeatedIdsAreRemoved()
    {
        const QByteArray p = "<path id='a' d='M0 0h1'/>";
        QCOMPARE(reportOf(p + p), "1 repeated id was removed");
        QCOMPARE(reportOf(p + p + p), "2 repeated ids were removed");
        const auto document = read(group("id='a'", p) + "<path id='b' d='M0 0h1'/>");
        QCOMPARE(outlineOf(document, 0), "Drawing([1] 1)");
        QCOMPARE(document.containers()[document.containers().inOrder()[1]].svgId, "a");
        QCOMPARE(document.objects()[0].particulars().id, "");
        QCOMPARE(document.objects()[1].particulars().id, "b");
        // Those of what is not drawn do not count, the root's does.
        QCOMPARE(reportOf("<defs>" + p + "</defs>" + p), "");
        QCOMPARE(reportOf("<defs>" + p + "</defs><use href='#a' id='b'/><use href='#a' id='c'/>"),
                 "");
        const auto root =
            readText("<svg id='a' xmlns='http://www.w3.org/2000/svg'>" + p + "</svg>");
        QCOMPARE(root.value->report.size(), std::size_t(1));
        QVERIFY(root.value->report[0].remark);
        QCOMPARE(root.value->document.about().id, "a");
        QCOMPARE(root.value->document.objects()[0].particulars().id, "");
    }
};

} // namespace formats_svg_container_stack_test

TEST_CLASS(formats_svg_container_stack_test::ContainerStackTest, None)
#include "tests/app/formats/svg/container_stack_test.moc"
