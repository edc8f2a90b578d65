// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_svg.h"
#include "app/teaching/trace_file.h"
#include "app/teaching/trace_page_parts.h"

#include <QFile>

#include <map>
#include <set>

// A trace as one web page that needs nothing else: no network, no other file. Its look and its
// steps are in resources/trace_page/.

namespace app {

namespace {

/// The page stays below 300 kB, also with a script and a style that grow.
constexpr qsizetype mostBytesOfSteps = 230'000;
constexpr QSizeF figureSize(480, 340);

QByteArray resource(const char* name)
{
    QFile file(QStringLiteral(":/trace_page/") + QLatin1StringView(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The page's figures. Many steps have the same one, which then is on the page once.
class Figures {
public:
    /// The number of a step's figure.
    std::size_t add(const TraceStep& at)
    {
        const auto [found, isNew] = numbers_.try_emplace(figureSvg(at, figureSize), all_.size());
        if (isNew)
            all_.push_back(found->first);
        return found->second;
    }
    std::size_t count() const { return all_.size(); }
    const QByteArray& operator[](std::size_t number) const { return all_[number]; }

private:
    std::map<QByteArray, std::size_t> numbers_;
    std::vector<QByteArray> all_;
};

/// A step of the page, and the number of its figure.
struct PageStep {
    QByteArray html;
    std::size_t figure;
};

std::vector<PageStep> pageSteps(const TraceExport& trace, std::span<const std::size_t> steps,
                                Figures& figures)
{
    std::vector<PageStep> all;
    for (const std::size_t step : steps) {
        const TraceStep at{trace.tracedLine, trace.narration, step};
        const std::size_t figure = figures.add(at);
        all.push_back({stepHtml(at, figureSize, figure), figure});
    }
    return all;
}

/// How many steps from the beginning and from the end have room on the page.
std::pair<std::size_t, std::size_t> stepsWithRoom(const std::vector<PageStep>& steps,
                                                  const Figures& figures)
{
    std::vector<bool> has(figures.count());
    qsizetype used = 0;
    const auto takes = [&](const PageStep& step) {
        used += step.html.size() + (has[step.figure] ? 0 : figures[step.figure].size() + 60);
        has[step.figure] = true;
        return used <= mostBytesOfSteps;
    };
    std::size_t first = 0, last = 0;
    while (first + last < steps.size()) {
        const bool isLast = last < first / 2; // most of what is to be learned is at the beginning
        if (!takes(steps[isLast ? steps.size() - 1 - last : first]))
            break;
        ++(isLast ? last : first);
    }
    return {first, last};
}

/// The figures of these steps.
QByteArray figuresHtml(const Figures& figures, const std::vector<PageStep>& steps)
{
    QByteArray html = "<svg width=\"0\" height=\"0\" aria-hidden=\"true\" "
                      "style=\"position:absolute\"><defs>\n";
    std::set<std::size_t> used;
    for (const PageStep& step : steps)
        used.insert(step.figure);
    for (const std::size_t number : used)
        html += "<g id=\"f" + QByteArray::number(qulonglong(number)) + "\">\n" + figures[number]
                + "</g>\n";
    return html + "</defs></svg>\n";
}

/// The steps that have room, and between them a sentence about those that have none.
QByteArray stepsHtml(const TraceExport& trace, std::span<const std::size_t> steps)
{
    Figures figures;
    auto all = pageSteps(trace, steps, figures);
    const auto [first, last] = stepsWithRoom(all, figures);
    const auto from = all.begin() + std::ptrdiff_t(first), to = all.end() - std::ptrdiff_t(last);
    const QString leftOut =
        from == to ? QString() : leftOutText(steps[first], steps[steps.size() - last - 1]);
    all.erase(from, to);
    QByteArray html = figuresHtml(figures, all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == first)
            html += paragraphHtml("left-out", leftOut);
        html += all[i].html;
    }
    return html;
}

QByteArray coloursCss(Ground ground)
{
    QByteArray css = ":root{";
    for (const auto& [name, colour] : figureClasses(ground))
        css += QByteArray("--") + name + ':' + colour.name().toLatin1() + ';';
    return css + '}';
}

/// The colours on both grounds, and the classes of the figures.
QByteArray styleCss()
{
    QByteArray css = coloursCss(Ground::Light) + "\n@media screen and (prefers-color-scheme:dark){"
                     + coloursCss(Ground::Dark) + "}\n";
    for (const auto& [name, colour] : figureClasses(Ground::Light))
        css += QByteArray(".f-") + name + "{fill:var(--" + name + ")}.s-" + name + "{stroke:var(--"
               + name + ")}\n";
    return css + resource("page.css");
}

} // namespace

QByteArray pageHeadHtml(const QString& title, const QByteArray& more)
{
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
           "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n<title>"
           + title.toHtmlEscaped().toUtf8() + "</title>\n<style>\n" + styleCss() + more
           + "</style>\n</head>\n";
}

QByteArray traceHtml(const TraceExport& trace, std::span<const std::size_t> steps)
{
    const bool isRefused = trace.narration.steps.empty();
    return pageHeadHtml(titleOf(trace.tracedLine.variant)) + "<body>\n" + headerHtml(trace)
           + (isRefused ? QByteArray() : stepsBarHtml()) + "<main>\n" + "<div>\n"
           + (isRefused ? paragraphHtml("sentence", trace.narration.refusal)
                        : stepsHtml(trace, steps))
           + "</div>\n" + codeHtml(trace.narration.code) + "</main>\n" + dataHtml(trace, figureSize)
           + "<script>\n" + resource("interpreter.js") + resource("page.js") + resource("drag.js")
           + "</script>\n</body>\n</html>\n";
}

} // namespace app
