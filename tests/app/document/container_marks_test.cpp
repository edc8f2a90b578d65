// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_marks.h"

#include <QTest>

#include <algorithm>

#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace document_container_marks_test {

using namespace app;
using At = ContainerMarks::At;

class ContainerMarksTest : public QObject {
    Q_OBJECT

private slots:
    void randomReplacementsAreThoseOfAVector()
    {
        Random random(1);
        std::vector<ContainerMark> model;
        ContainerMarks marks;
        std::size_t mostBlocks = 0;
        for (int i = 0; i < 3'000; ++i) {
            const bool grows = i / 500 % 2 == 0;
            const auto first = std::size_t(random.whole(0, int(model.size())));
            const auto removed =
                std::min(model.size() - first, std::size_t(random.whole(0, grows ? 3 : 200)));
            std::vector<ContainerMark> added(std::size_t(random.whole(0, grows ? 60 : 9)));
            for (ContainerMark& mark : added)
                mark = {std::uint32_t(random.whole(0, 9999)), std::uint32_t(random.whole(0, 1)),
                        std::uint32_t(std::max(0, random.whole(-5, 5)))};
            const ContainerMarks before = marks;
            const auto oldModel = model;
            const auto at = model.begin() + std::ptrdiff_t(first);
            model.insert(model.erase(at, at + std::ptrdiff_t(removed)), added.begin(), added.end());
            marks.replace(placeOf(marks, first), placeOf(marks, first + removed), added);
            QVERIFY(agrees(marks, model));
            if (i % 100 == 0)
                QVERIFY(agrees(before, oldModel)); // it shares blocks with what was replaced
            mostBlocks = std::max(mostBlocks, marks.end().block);
        }
        QVERIFY(mostBlocks > 20);
    }

private:
    static At placeOf(const ContainerMarks& marks, std::size_t index)
    {
        At at = marks.begin();
        for (; index > 0; --index)
            at = marks.next(at);
        return at;
    }

    static bool agrees(const ContainerMarks& marks, const std::vector<ContainerMark>& model)
    {
        constexpr std::size_t most = ContainerMarks::mostInBlock;
        std::vector<std::size_t> sizes(marks.end().block);
        std::size_t objects = 0;
        At at = marks.begin(), last = at;
        for (const ContainerMark& mark : model) {
            if (at == marks.end() || marks[at] != mark || marks.objectsBefore(at) != objects
                || (mark.objects > 0 && !(marks.before(objects + mark.objects - 1) == at))
                || (at != marks.begin() && !(marks.previous(at) == last)))
                return false;
            objects += mark.objects;
            ++sizes[at.block];
            last = std::exchange(at, marks.next(at));
        }
        return at == marks.end() && marks.objects() == objects
               && std::ranges::all_of(sizes, [&](std::size_t size) {
                      return size <= most && (size >= most / 2 || sizes.size() == 1);
                  });
    }
};

} // namespace document_container_marks_test

TEST_CLASS(document_container_marks_test::ContainerMarksTest, Gui)
#include "tests/app/document/container_marks_test.moc"
