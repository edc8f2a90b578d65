// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/editor.h"

#include "app/base/replace_file.h"
#include "app/command_line/misnamed.h"
#include "app/session/comparing.h"
#include "app/settings/settings_format.h"
#include "app/teaching/line_text.h"
#include "ui/editor/desk.h"
#include "ui/editor/display.h"
#include "ui/editor/editor_application.h"
#include "ui/editor/running_program.h"
#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/sheets/command_keys.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImageWriter>
#include <QScopeGuard>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <QUrl>

#include <cstdio>
#include <map>

namespace ui {

namespace {

constexpr qint64 quickBytes = 1'000'000; // such a file is read without noticeable delay
constexpr int mostWaiting = 500;         // milliseconds for it, before the window is shown
constexpr int mostPixels = 10'000;       // limit of --size in each direction: a picture of 400 MB
constexpr QSize usualPicture(1280, 800);

struct Options {
    std::optional<Backend> backend;
    std::optional<Theme> theme;
    QStringList files;
    QString screenshot;
    std::optional<QSize> size;
    QString panes;                     ///< 1 to 4, or "all"; empty: unchanged
    std::optional<QString> microscope; ///< the line to open it at, as text; empty: the first line
    std::optional<app::Variant> algorithm; ///< the variant that clips
    std::size_t step = 1;
    bool verbose = false;
    bool ownWindow = false; ///< even if the program is running
    QString refusal; ///< why the arguments were refused, for the window; empty: they were not

    /// Whether a program that is running can do the same: it opens files, and nothing else is
    /// asked.
    bool isPlain() const
    {
        return !backend && !theme && screenshot.isEmpty() && !size && panes.isEmpty() && !microscope
               && !algorithm && !verbose && !ownWindow && refusal.isEmpty();
    }
    /// Whether the drawings of the last run are opened again: not beside a program that has them.
    bool restoresTabs() const { return screenshot.isEmpty() && !ownWindow && !microscope; }
    QStringList absoluteFiles() const
    {
        QStringList paths;
        for (const QString& file : files)
            paths << QFileInfo(file).absoluteFilePath();
        return paths;
    }
};

void complain(const QString& sentence)
{
    std::fprintf(stderr, "clearcut: %s\n", qPrintable(sentence));
}

std::optional<QSize> parsedSize(const QString& text)
{
    const QStringList numbers = text.split(u'x');
    const QSize size(numbers.value(0).toInt(), numbers.value(1).toInt());
    const bool usable = numbers.size() == 2 && std::min(size.width(), size.height()) > 0
                        && std::max(size.width(), size.height()) <= mostPixels;
    return usable ? std::optional(size) : std::nullopt;
}

app::Refusal wrong(const QString& sentence) { return {sentence, app::Exit::Usage}; }

/// Reads one option with its value; returns a sentence if it is wrong.
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
    else if (name == "--algorithm" && app::findVariant(value))
        options.algorithm = app::findVariant(value);
    else if (name == "--step" && value.toUInt() > 0)
        options.step = value.toUInt();
    else if (name == "--screenshot" && !value.isEmpty())
        options.screenshot = value;
    else if (name == "--renderer")
        return Text::tr("--renderer must be auto, opengl or raster.");
    else if (name == "--theme")
        return Text::tr("--theme must be system, light or dark.");
    else if (name == "--panes")
        return Text::tr("--panes must be 1, 2, 4 or all.");
    else if (name == "--microscope")
        return Text::tr("--microscope must be a line, such as \"10, 20 -> 70, 130\", or first.");
    else if (name == "--algorithm")
        return Text::tr("--algorithm must be one that \"clearcut algorithms\" lists.");
    else if (name == "--step")
        return Text::tr("--step must be a number of at least 1.");
    else if (name == "--size")
        return Text::tr(
                   "--size must be a width and a height of at most %1 pixels, such as 1280x800.")
            .arg(mostPixels);
    else
        return Text::tr("There is no option %1 with the value \"%2\". Try --help.")
            .arg(name, value);
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
        } else if (argument == "--new-window" && !onlyFiles) {
            options.ownWindow = true;
        } else if (argument.startsWith("--") && !onlyFiles) {
            const bool joined = argument.contains(u'=');
            const QString value = joined ? argument.section(u'=', 1) : arguments.value(++i);
            if (const auto error = take(options, argument.section(u'=', 0, 0), value))
                return wrong(*error);
        } else {
            const QUrl url(argument);
            options.files << (url.isLocalFile() ? url.toLocalFile() : argument);
            if (auto refusal = app::misnamed(options.files.back()))
                return refusal;
        }
    }
    return std::nullopt;
}

void nameProgram()
{
    QCoreApplication::setOrganizationName(QStringLiteral("Clearcut"));
    QCoreApplication::setApplicationName(QStringLiteral("Clearcut"));
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.clearcut.Clearcut"));
    app::useSafeSettings();
}

/// Returns nothing, or the reason why the file could not be written.
std::optional<QString> savePicture(QWidget& window, const QString& path)
{
    const QPixmap picture = window.grab();
    QString type = QFileInfo(path).suffix();
    if (!QImageWriter::supportedImageFormats().contains(type.toLower().toLatin1()))
        type = QStringLiteral("png");
    return app::replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
        QBuffer buffer;
        if (!picture.save(&buffer, type.toLatin1().constData()))
            return Text::tr("there is not enough memory for the picture.");
        out.write(buffer.data());
        return std::nullopt;
    });
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
        app::TracedLine tracedLine = microscope.tracedLine();
        tracedLine.line = *line;
        microscope.setTracedLine(tracedLine);
    }
    microscope.goTo(options.step - 1);
}

/// Opens what the options request; saves the screenshot when everything is painted.
int show(EditorApplication& application, const Options& options, const QElapsedTimer& clock,
         const QString& socket, bool restores)
{
    // With a style sheet, each widget that gets a parent has everything below it restyled. That
    // would take a quarter of the start, so the complete window gets the sheet at once.
    const QString styleSheet = application.styleSheet();
    application.setStyleSheet({});
    Desk desk(options.backend.value_or(Backend::Automatic));
    application.setStyleSheet(styleSheet);
    const auto follow = [&] { application.setWindow(&desk.current()); };
    QObject::connect(&desk, &Desk::currentChanged, &application, follow);
    follow();
    const auto withoutWindow = qScopeGuard([&] { application.setWindow(nullptr); });
    if (!options.screenshot.isEmpty())
        desk.resize(options.size.value_or(usualPicture)); // independent of the screen
    else if (options.size) {
        desk.resize(*options.size);
        fitToScreens(desk);
    }
    MainWindow& window = desk.current(); // until further drawings are opened
    if (!options.panes.isEmpty())
        showPanes(window.canvas(), options.panes);
    if (const auto& wish = options.algorithm)
        app::useVariant(window.session(), app::usable(*wish));
    // A large file must not delay the window.
    QString file = options.files.value(0);
    if (restores)
        if (const QString shown = desk.restoreTabs(file.isEmpty()); file.isEmpty())
            file = shown;
    const auto open = [&] { window.files().open(file); };
    const bool first = !options.screenshot.isEmpty() || QFileInfo(file).size() < quickBytes;
    if (file.isEmpty())
        window.showStart();
    else if (first) {
        open();
        window.files().wait(options.screenshot.isEmpty() ? QDeadlineTimer(mostWaiting)
                                                         : QDeadlineTimer::Forever);
    }
    const auto begin = [&] {
        if (!file.isEmpty() && !first)
            open();
        desk.open(options.files.mid(1));
        if (!options.refusal.isEmpty())
            window.tell({Message::Kind::Warning, options.refusal});
        CommandKeys::of(window).tellIgnored();
        if (options.screenshot.isEmpty()) // which must not touch unsaved work
            desk.offerRecovery();
    };
    if (options.screenshot.isEmpty())
        desk.keepJournals();
    QMetaObject::invokeMethod(&desk, begin, Qt::QueuedConnection);
    if (options.verbose)
        QObject::connect(&window.canvas(), &Canvas::frameShown, &window,
                         [&clock, once = false]() mutable {
                             if (!std::exchange(once, true))
                                 std::fprintf(stderr, "first frame after %lld ms\n",
                                              static_cast<long long>(clock.elapsed()));
                         });
    Listener listener(socket);
    listener.setAccepting([&desk] { return !desk.isLeaving(); });
    QObject::connect(&listener, &Listener::wanted, &desk, [&desk](const QStringList& files) {
        desk.setWindowState(desk.windowState() & ~Qt::WindowMinimized);
        desk.raise();
        desk.activateWindow();
        desk.open(files);
    });
    desk.show();
    if (options.microscope)
        openMicroscope(window, options);
    if (options.screenshot.isEmpty())
        return application.exec();
    std::optional<QString> error;
    // Milliseconds for thumbnails, which are painted on another thread.
    constexpr int forThumbnails = 1500;
    const auto save = [&] {
        error = savePicture(desk, options.screenshot);
        application.quit();
    };
    QTimer::singleShot(forThumbnails, &window, [&] {
        window.canvas().settle();
        QTimer::singleShot(0, &window, save); // after the events that this has sent
    });
    application.exec();
    if (error)
        complain(Text::tr("Cannot write %1: %2").arg(options.screenshot, *error));
    return int(error ? app::Exit::Failed : app::Exit::Done);
}

} // namespace

int runEditor(int argc, char** argv, const QStringList& arguments)
{
    QElapsedTimer clock;
    clock.start();
    Options options;
    if (const auto refusal = parse(options, arguments)) {
        complain(refusal->sentence);
        const bool forPicture = !arguments.filter(QStringLiteral("--screenshot")).isEmpty();
        if (isErrorRead() || forPicture || !whyNoDisplay().isEmpty())
            return int(refusal->exit);
        options.files.clear(); // whoever started the program from a desktop sees only its window
        options.refusal = refusal->sentence;
    }
    if (!options.screenshot.isEmpty() && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    if (const QString why = whyNoDisplay(); !why.isEmpty()) {
        complain(why);
        return int(app::Exit::Failed);
    }
    nameProgram();
    // Temporary settings: a screenshot neither shows nor changes the user's.
    const QTemporaryDir own;
    if (!options.screenshot.isEmpty()) {
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, own.path());
        qputenv("XDG_RUNTIME_DIR", own.path().toLocal8Bit());
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    const auto application = startApplication(argc, argv);
    QString socket = options.isPlain() ? socketOfProgram() : QString();
    const HandedOver handedOver = handOver(socket, options.absoluteFiles());
    if (handedOver == HandedOver::Taken)
        return int(app::Exit::Done);
    if (handedOver == HandedOver::Refused)
        socket.clear(); // it stays the other program's
    const bool isAlone = options.isPlain() ? handedOver == HandedOver::NobodyIsThere
                                           : !isSomebodyAt(socketOfProgram());
    applyTheme(*application, options.theme.value_or(savedTheme()));
    return show(*application, options, clock, socket, isAlone && options.restoresTabs());
}

} // namespace ui
