// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/accuracy.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/operation_profile.h"

#include <QTest>

#include <cmath>

#include "tests/clipping/oracle.h"
#include "tests/test_class.h"

namespace experiment_profiles_test {

using app::Variant;
using clipping::Form;
using clipping::Segment;

namespace {

std::vector<Variant> all()
{
    std::vector<const clipping::Algorithm*> algorithms;
    for (const auto& algorithm : clipping::algorithms())
        algorithms.push_back(&algorithm);
    return app::variantsOf(algorithms);
}

app::ExperimentOptions thePapers(std::uint64_t lines)
{
    app::ExperimentOptions options;
    options.lines = lines;
    options.runs = 3;
    return options;
}

bool is(const Variant& variant, std::string_view abbreviation, Form form)
{
    return variant.algorithm->abbreviation == abbreviation && variant.form == form;
}

template <class Row>
const Row& find(const std::vector<Row>& rows, std::string_view abbreviation, Form form)
{
    for (const Row& row : rows)
        if (is(row.variant, abbreviation, form))
            return row;
    qFatal("no such variant");
}

oracle::Line lineOf(const Segment& s) { return {{s.a.x, s.a.y}, {s.b.x, s.b.y}}; }
oracle::Box boxOf(const clipping::Window& w) { return {{w.min.x, w.min.y}, {w.max.x, w.max.y}}; }

std::optional<oracle::Part> truthOf(const Segment& s, const clipping::Window& w)
{
    return oracle::inside(lineOf(s), boxOf(w));
}

double apart(const glm::dvec2& p, const oracle::Point& q)
{
    return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
}

/// What the oracle says of a variant, line by line.
app::Accuracy byOracle(const Variant& variant, std::span<const Segment> lines)
{
    const auto& w = app::paperWindow;
    const auto& uses = *clipping::functionsOf(*variant.algorithm, variant.form);
    app::Accuracy sum{.variant = variant};
    for (const Segment& line : lines) {
        const auto truth = truthOf(line, w);
        const auto found = uses.clip(line, w);
        sum.visible += truth.has_value();
        sum.lost += truth && !found;
        sum.shown += !truth && found;
        for (const auto& p : found ? std::vector{found->a, found->b} : std::vector<glm::dvec2>())
            if (p.x < w.min.x || p.x > w.max.x || p.y < w.min.y || p.y > w.max.y) {
                ++sum.outside;
                break;
            }
        if (!truth || !found)
            continue;
        const auto& [a, b] = truth->line;
        const double off = std::min(std::max(apart(found->a, a), apart(found->b, b)),
                                    std::max(apart(found->a, b), apart(found->b, a)));
        const double ulps = off / oracle::ulp(lineOf(line), boxOf(w));
        sum.mostUlps = std::max(sum.mostUlps, ulps);
    }
    return sum;
}

} // namespace

class ProfilesTest : public QObject {
    Q_OBJECT

private slots:
    void classesAreWhatTheySay()
    {
        const auto classes = app::linesByClass(*app::findTestScene(u"paper"), {}, 1, 5000).value();
        const std::array shares{0.00011, 0.6418, 0.164, 0.1941}; // algorithms.md, section 12
        for (std::size_t c = 0; c < classes.size(); ++c) {
            QCOMPARE(classes[c].lineClass, app::lineClasses[c]);
            QCOMPARE(classes[c].lines.size(), 5000u);
            QCOMPARE(classes[c].standIn, c == 0 ? "inside" : "");
            QVERIFY(std::abs(classes[c].share - shares[c]) < 0.003);
            for (const Segment& line : classes[c].lines)
                QCOMPARE(app::lineClassOf(line, app::paperWindow), app::lineClasses[c]);
        }
    }

    void aDrawingHasNoStandIns()
    {
        const auto scene =
            app::repeatedScene("two", {{{0, 0}, {1, 1}}, {{-500, 0}, {-400, 2}}, {{0, 0}, {2, 2}}});
        const auto classes = app::linesByClass(scene, {}, 1, 5000).value();
        QCOMPARE(classes[0].lines.size(), 2u);
        QCOMPARE(classes[1].lines.size(), 1u);
        QVERIFY(classes[2].lines.empty() && classes[3].lines.empty());
        QVERIFY(classes[2].standIn.isEmpty());
        QCOMPARE(classes[0].share, 2.0 / 3);
        auto options = thePapers(3);
        options.scene = scene;
        const auto table = app::classTable(*app::classProfile(options, all()));
        QCOMPARE(table.rows.size(), all().size());
        QVERIFY(table.rows[0][2].toDouble() > 0 && table.rows[0][4].isEmpty());
    }

    void theProfileTellsEachClass()
    {
        std::vector<double> shares;
        const auto follow = [&](const app::Progress& now) { shares.push_back(now.share); };
        const auto options = thePapers(1000);
        const auto profile = app::classProfile(options, all(), {{}, follow});
        const auto table = app::classTable(*profile);
        QVERIFY(std::ranges::is_sorted(shares));
        QCOMPARE(shares.back(), 1.0);
        QCOMPARE(table.rows.size(), all().size());
        for (const QStringList& row : table.rows) {
            double weighted = 0;
            for (std::size_t c = 0; c < 4; ++c)
                weighted += profile->classes[c].of.share * row[qsizetype(c) + 2].toDouble();
            QVERIFY(std::abs(weighted - row[6].toDouble()) < 0.02);
        }
        // What each class leaves is known: all, nothing, all, nothing.
        for (std::size_t c = 0; c < 4; ++c)
            QCOMPARE(profile->classes[c].record.timings[0].found.visible,
                     c % 2 == 0 ? app::mostOfAClass(profile->options) : 0u);
    }

    void operationsAreThoseOfSection12()
    {
        // The means of algorithms.md, section 12, over 400,000 lines of the paper's: comparisons,
        // additions, multiplications, divisions of the published forms.
        struct Mean {
            const char* abbreviation;
            std::array<double, 4> counts;
        };
        const std::array means{
            Mean{"CS", {8.8, 2.7, 0.7, 0.68}},    Mean{"LB", {9.2, 5.0, 0.6, 2.78}},
            Mean{"CB", {13.3, 26.6, 16.6, 4.00}}, Mean{"NLN", {5.2, 2.1, 1.1, 0.31}},
            Mean{"Skala", {7.6, 4.9, 5.4, 0.61}}, Mean{"KWC", {10.1, 9.5, 3.8, 3.78}},
            Mean{"MD", {7.4, 4.5, 1.1, 1.13}},
        };
        const auto profile = *app::operationProfile(thePapers(400'000), all());
        QCOMPARE(profile.rows.size(), all().size());
        for (const auto& [abbreviation, expected] : means) {
            const auto counts = find(profile.rows, abbreviation, Form::Published).scene();
            const std::array found{counts.comparisons, counts.additions, counts.multiplications,
                                   counts.divisions};
            for (std::size_t i = 0; i < 4; ++i) {
                const double mean = double(found[i]) / 400'000;
                QVERIFY2(std::abs(mean - expected[i]) < (i == 3 ? 0.011 : 0.06),
                         qPrintable(QStringLiteral("%1: %2 for %3")
                                        .arg(abbreviation)
                                        .arg(mean)
                                        .arg(expected[i])));
            }
        }
    }

    void operationsOfEachClassAreThoseWorkedOutByHand()
    {
        // A line of each class from section 12: a, b, d, f.
        const std::vector<Segment> lines{{{-50, -20}, {60, 30}},
                                         {{-200, 0}, {-150, 50}},
                                         {{-200, -20}, {200, 30}},
                                         {{-200, 0}, {0, 200}}};
        auto options = thePapers(4);
        options.scene = app::repeatedScene("four", lines);
        const auto profile = *app::operationProfile(options, all());
        QCOMPARE(profile.mix, (std::array<std::uint64_t, 4>{1, 1, 1, 1}));
        const auto of = [&](const char* abbreviation, std::size_t c) {
            const auto& counts = find(profile.rows, abbreviation, Form::Published).byClass[c];
            return std::array{counts.comparisons, counts.additions, counts.multiplications,
                              counts.divisions};
        };
        using Counts = std::array<std::uint64_t, 4>;
        QCOMPARE(of("CS", 0), (Counts{8, 0, 0, 0}));
        QCOMPARE(of("CS", 1), (Counts{6, 0, 0, 0}));
        QCOMPARE(of("CS", 2), (Counts{15, 8, 2, 2}));
        QCOMPARE(of("CS", 3), (Counts{11, 4, 1, 1}));
        QCOMPARE(of("KWC", 0), (Counts{12, 6, 2, 2}));
        QCOMPARE(of("MD", 2), (Counts{14, 8, 2, 2}));
        QCOMPARE(of("MD", 3), (Counts{14, 12, 3, 3}));
        const auto table = app::operationTable(profile);
        QCOMPARE(table.rows.size(), 5 * all().size()); // four classes and the scene
        QCOMPARE(table.names.sliced(4).join(' '),
                 "comparisons additions multiplications divisions all");
        const auto cs = [&](qsizetype column) { return table.rows[4][column].toDouble(); };
        QCOMPARE(cs(4) + cs(5) + cs(6) + cs(7), cs(8));
    }

    void accuracyIsWhatTheOracleSays()
    {
        for (const auto& key : {u"paper", u"near-miss", u"long"}) {
            auto options = thePapers(3000);
            options.scene = *app::findTestScene(key);
            std::vector<Segment> lines(options.lines);
            options.scene.begin({}, options.seed)(lines);
            const auto rows = *app::accuracies(options, all());
            for (const app::Accuracy& row : rows) {
                const auto truth = byOracle(row.variant, lines);
                QCOMPARE(row.visible, truth.visible);
                QCOMPARE(row.lost, truth.lost);
                QCOMPARE(row.shown, truth.shown);
                QCOMPARE(row.outside, truth.outside);
                QVERIFY(std::abs(row.mostUlps - truth.mostUlps) <= 1);
                QVERIFY(row.meanUlps <= row.mostUlps);
                if (row.variant.form == Form::Corrected) {
                    QCOMPARE(row.outside, 0u);
                    QVERIFY(row.mostUlps <= row.variant.algorithm->ulps);
                }
            }
        }
    }

    void reversedOrNonFiniteResultsCountAsErrors()
    {
        auto odd = clipping::exactAlgorithm();
        odd.corrected.clipAll = [](std::span<const Segment> in, const clipping::Window& window,
                                   std::span<clipping::Clipped> out) {
            const auto n = clipping::exactAlgorithm().corrected.clipAll(in, window, out);
            std::swap(out[1].segment.a, out[1].segment.b);
            out[2].segment.b.x = std::nan("");
            return n;
        };
        auto options = thePapers(3);
        options.scene =
            app::repeatedScene("three", {{{0, 0}, {1, 1}}, {{0, 0}, {2, 2}}, {{0, 0}, {3, 3}}});
        const Variant who{&odd, Form::Corrected};
        const auto row = app::accuracies(options, {{who}})->front();
        QCOMPARE(row.mostUlps, 2 * 0x1p46);       // one ulp of 100 is 2^-46
        QCOMPARE(row.meanUlps, row.mostUlps / 2); // of two: the third has none
        QCOMPARE(row.outside, 1u);
    }

    void thePapersSceneAsInSection13()
    {
        const auto rows = *app::accuracies(thePapers(100'000), all());
        const auto share = [&](const char* abbreviation, auto member) {
            const auto& row = find(rows, abbreviation, Form::Published);
            return 100.0 * double(row.*member) / double(row.visible);
        };
        const auto near = [](double found, double expected) {
            return std::abs(found - expected) < 0.1 * expected + 0.001;
        };
        QVERIFY(near(share("LB", &app::Accuracy::outside), 8.0));
        QVERIFY(near(share("CB", &app::Accuracy::outside), 28.3));
        QVERIFY(near(share("Skala", &app::Accuracy::outside), 6.1));
        QVERIFY(near(share("KWC", &app::Accuracy::lost), 0.807));
        for (const char* exactlyInside : {"CS", "NLN", "MD", "KWC"})
            QCOMPARE(find(rows, exactlyInside, Form::Published).outside, 0u);
        for (const char* right : {"CS", "LB", "CB", "NLN", "Skala", "MD"})
            QCOMPARE(find(rows, right, Form::Published).wrong(), 0u);
        const auto table = app::accuracyTable(rows, thePapers(100'000));
        QCOMPARE(table.rows.size(), rows.size());
        QCOMPARE(table.names[3], "lost");
    }

    void searchForLinesStopsAtItsLimit()
    {
        std::stop_source source;
        std::size_t made = 0;
        auto options = thePapers(1000);
        options.scene = *app::findTestScene(u"rejected"); // of the others it finds none
        options.scene.begin = [&, begin = options.scene.begin](const app::Field& field,
                                                               std::uint64_t seed) {
            return [&, lines = begin(field, seed)](std::span<Segment> some) {
                lines(some);
                made += some.size();
            };
        };
        const auto stop = [&](const app::Progress&) { source.request_stop(); };
        QVERIFY(!app::classProfile(options, all(), {source.get_token(), stop}));
        QCOMPARE(made, 50'000u); // and not four million
        QVERIFY(!app::classProfile(options, all(), {source.get_token(), {}}));
        QCOMPARE(made, 50'000u);
    }

    void stoppedProfilesHaveNoResult()
    {
        std::stop_source source;
        source.request_stop();
        const app::Follower follower{source.get_token(), {}};
        QVERIFY(!app::classProfile(thePapers(1000), all(), follower));
        QVERIFY(!app::operationProfile(thePapers(1000), all(), follower));
        QVERIFY(!app::accuracies(thePapers(1000), all(), follower));
    }
};

} // namespace experiment_profiles_test

TEST_CLASS(experiment_profiles_test::ProfilesTest, None)
#include "tests/app/experiment/profiles_test.moc"
