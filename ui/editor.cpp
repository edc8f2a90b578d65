// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor.h"

#include "app/command_line/misnamed.h"
#include "app/teaching/line_text.h"
#include "ui/files.h"
#include "ui/main_window.h"
#include "ui/recovery.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <QUrl>

#include <cstdio>
#include <map>

namespace ui {

namespace {

constexpr qint64 quickBytes = 1'000'000; // read in a blink

struct Options {
    Backend backend = Backend::Automatic;
    std::optional<Theme> theme;
    QString file, screenshot;
    std::optional<QSize> size;
    QString panes; ///< 1 to 4, or "all"; empty: as they were
    std::optional<QString> microscope; ///< open it: at a line that is typed so; empty: at the first
    std::optional<app::Clipper> algorithm; ///< what clips
    std::size_t step = 1;
    bool verbose = false;
};

QString tr(const char* text) { return QCoreApplication::translate("Editor", text); }

void complain(const QString& sentence)
{
    std::fprintf(stderr, "clearcut: %s\n", qPrintable(sentence));
}

std::optional<QSize> parsedSize(const QString& text)
{
    const QStringList numbers = text.split(u'x');
    const QSize size(numbers.value(0).toInt(), numbers.value(1).toInt());
    return numbers.size() == 2 && size.isValid() && !size.isEmpty() ? std::optional(size)
                                                                    : std::nullopt;
}

app::Refusal wrong(const QString& sentence) { return {sentence, app::Exit::Usage}; }

/// One option with its value; the sentence that says what is wrong with it.
std::optional<QString> take(Options& options, const QString& name, const QString& value)
{
    static const std::map<QString, Backend> backends{
        {"auto", Backend::Automatic}, {"opengl", Backend::OpenGL}, {"raster", Backend::Raster}};
    static const std::map<QString, Theme> themes{
        {"system", Theme::System}, {"light", Theme::Light}, {"dark", Theme::Dark}};
    if (name == "--renderer" && backends.contains(value))
        options.backend = backends.at(value);
    else if (name == "--theme" && themes.contains(value))
        options.theme = themes.at(value);
    else if (name == "--size" && parsedSize(value))
        options.size = parsedSize(value);
    else if (name == "--panes" && QStringList{"1", "2", "4", "all"}.contains(value))
        options.panes = value;
    else if (name == "--microscope" && (value == "first" || app::lineFrom(value)))
        options.microscope = value;
    else if (name == "--algorithm" && app::findClipper(value))
        options.algorithm = app::findClipper(value);
    else if (name == "--step" && value.toUInt() > 0)
        options.step = value.toUInt();
    else if (name == "--screenshot" && !value.isEmpty())
        options.screenshot = value;
    else if (name == "--renderer")
        return tr("--renderer is auto, opengl or raster.");
    else if (name == "--theme")
        return tr("--theme is system, light or dark.");
    else if (name == "--panes")
        return tr("--panes is 1, 2, 4 or all.");
    else if (name == "--microscope")
        return tr("--microscope is a line, such as \"10, 20 -> 70, 130\", or first.");
    else if (name == "--algorithm")
        return tr("--algorithm is one of those that clearcut algorithms lists.");
    else if (name == "--step")
        return tr("--step is a number from 1.");
    else if (name == "--size")
        return tr("--size is a width and a height, such as 1280x800.");
    else
        return tr("There is no option %1 with the value \"%2\". Try --help.").arg(name, value);
    return std::nullopt;
}

std::optional<app::Refusal> parse(Options& options, const QStringList& arguments)
{
    bool onlyFiles = false;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const QString& argument = arguments[i];
        if (argument == "--" && !onlyFiles) {
            onlyFiles = true;
        } else if (argument == "--verbose" && !onlyFiles) {
            options.verbose = true;
        } else if (argument.startsWith("--") && !onlyFiles) {
            const bool joined = argument.contains(u'=');
            const QString value = joined ? argument.section(u'=', 1) : arguments.value(++i);
            if (const auto error = take(options, argument.section(u'=', 0, 0), value))
                return wrong(*error);
        } else if (!options.file.isEmpty()) {
            return wrong(tr("Name one file: %1 is one too many.").arg(argument));
        } else {
            const QUrl url(argument);
            options.file = url.isLocalFile() ? url.toLocalFile() : argument;
            if (auto refusal = app::misnamed(options.file))
                return refusal;
        }
    }
    return std::nullopt;
}

/// Whether a window can be shown; asked before Qt ends the program for want of a display.
bool displayAtHand()
{
#if defined(Q_OS_LINUX)
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY")
           || qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

void nameProgram()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Clearcut"));
    QCoreApplication::setApplicationName(QStringLiteral("Clearcut"));
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.clearcut.Clearcut"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
}

bool savedPicture(MainWindow& window, const QString& path)
{
    window.canvas().settle();
    QCoreApplication::processEvents();
    return window.grab().save(path);
}

void showPanes(Canvas& canvas, const QString& count)
{
    app::Panes panes = canvas.panes();
    count == "all" ? panes.showAll() : panes.show(count.toUInt());
    canvas.setPanes(panes);
}

void openMicroscope(MainWindow& window, const Options& options)
{
    app::Microscope& microscope = window.session().microscope;
    window.drawnLine().look();
    if (options.algorithm)
        window.drawnLine().choose(*options.algorithm);
    if (const auto line = app::lineFrom(*options.microscope)) {
        app::Specimen specimen = microscope.specimen();
        specimen.line = *line;
        microscope.setSpecimen(specimen);
    }
    microscope.goTo(options.step - 1);
}

/// Opens what was asked for; the picture is taken when all has been painted.
int show(QApplication& application, const Options& options, const QElapsedTimer& clock)
{
    MainWindow window(options.backend);
    if (options.size)
        window.resize(*options.size);
    if (!options.panes.isEmpty())
        showPanes(window.canvas(), options.panes);
    // What takes long to read must not keep the window from being seen.
    const auto open = [&] { window.files().open(options.file); };
    const bool first = !options.screenshot.isEmpty() || QFileInfo(options.file).size() < quickBytes;
    if (options.file.isEmpty())
        window.showStart();
    else if (first)
        open();
    std::optional<Recovery> recovery; // a picture of the program touches nobody's work
    if (options.screenshot.isEmpty())
        recovery.emplace(window);
    const auto begin = [&] {
        if (!options.file.isEmpty() && !first)
            open();
        if (recovery)
            recovery->offer();
    };
    QMetaObject::invokeMethod(&window, begin, Qt::QueuedConnection);
    if (options.verbose)
        QObject::connect(&window.canvas(), &Canvas::frameShown, &window,
                         [&clock, once = false]() mutable {
                             if (!std::exchange(once, true))
                                 std::fprintf(stderr, "first frame after %lld ms\n",
                                              static_cast<long long>(clock.elapsed()));
                         });
    window.show();
    if (options.microscope)
        openMicroscope(window, options);
    if (options.screenshot.isEmpty())
        return application.exec();
    bool saved = false;
    constexpr int forThumbnails = 1500; // milliseconds; they are painted on another thread
    QTimer::singleShot(forThumbnails, &window, [&] {
        saved = savedPicture(window, options.screenshot);
        application.quit();
    });
    application.exec();
    if (!saved)
        complain(tr("Cannot write %1.").arg(options.screenshot));
    return int(saved ? app::Exit::Done : app::Exit::Failed);
}

} // namespace

int runEditor(int argc, char** argv, const QStringList& arguments)
{
    QElapsedTimer clock;
    clock.start();
    Options options;
    if (const auto refusal = parse(options, arguments)) {
        complain(refusal->sentence);
        return int(refusal->exit);
    }
    if (!options.screenshot.isEmpty() && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    if (!displayAtHand()) {
        complain(tr("There is no display for the editor. Start it from a desktop, or use a command "
                    "that needs none: clearcut clip IN -o OUT (clearcut --help lists them)."));
        return int(app::Exit::Failed);
    }
    nameProgram();
    const QTemporaryDir nobody; // a picture of the program shows nobody's settings, and leaves none
    if (!options.screenshot.isEmpty()) {
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, nobody.path());
        qputenv("XDG_RUNTIME_DIR", nobody.path().toLocal8Bit());
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    const Theme saved = Theme(QSettings().value("theme", int(Theme::System)).toInt());
    applyTheme(application, options.theme.value_or(saved));
    return show(application, options, clock);
}

} // namespace ui
