package org.dronewatch.viewer;

import java.awt.GridLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.ProgressMonitor;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.dronewatch.parallel.Workers;
import org.dronewatch.render.CameraView;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.PlainText;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.ViewedRun;

/** Exports videos of a run: of the site from the current viewpoint, or of a camera's view. */
final class FilmExport implements AutoCloseable {
    private static final long PATIENCE_SECONDS = 5;

    private final ViewerPane pane;
    private final Exports exports;
    private final Consumer<Throwable> failed;
    private Thread writing;
    private volatile boolean closed;

    /**
     * The export of films of a pane.
     *
     * @param failed receives what went wrong
     */
    FilmExport(ViewerPane pane, Exports exports, Consumer<Throwable> failed) {
        this.pane = pane;
        this.exports = exports;
        this.failed = failed;
    }

    /** Asks for times and a file, and writes a video of the site from the current viewpoint. */
    void saveSite() {
        pane.viewed().ifPresent(viewed -> ask(viewed, "the site").ifPresent(film -> save(site(viewed, film), "site")));
    }

    /**
     * Asks for times and a file, and writes a video of the selected camera's view, or of the first camera's if none is
     * selected.
     */
    void saveCamera() {
        pane.viewed().ifPresent(viewed -> {
            Optional<String> id = camera(viewed);
            if (id.isEmpty()) {
                pane.notice().show("The scene has no camera.");
                return;
            }
            ask(viewed, id.get()).ifPresent(film -> save(camera(viewed, id.get(), film), id.get()));
        });
    }

    private Optional<String> camera(ViewedRun viewed) {
        List<String> cameras = CameraView.cameras(viewed.settings().enabledSensors());
        return pane.selected().filter(cameras::contains).or(() -> cameras.stream()
                .findFirst());
    }

    /** A film of the site. */
    FilmMaker site(ViewedRun viewed, Film film) {
        return new FilmMaker(film, exports.pictures(viewed));
    }

    /** A film of a camera's looks. */
    static FilmMaker camera(ViewedRun viewed, String id, Film film) {
        SensorSettings<?> camera = viewed.settings().sensors().get(id);
        CameraView view =
                new CameraView(id, camera, viewed.stage(), time -> viewed.run().pointing(id, time));
        return new FilmMaker(
                film, time -> view.draw(CameraView.lookTime(camera, time)).toImage());
    }

    private Optional<Film> ask(ViewedRun viewed, String name) {
        JTextField from = new JTextField("0");
        JTextField to =
                new JTextField(String.format(Locale.ROOT, "%.2f", viewed.run().reached()));
        JTextField fps = new JTextField("25");
        JTextField speed = new JTextField("1");
        JPanel form = new JPanel(new GridLayout(0, 2, Scaled.px(6), Scaled.px(4)));
        row(form, "From [s]", from);
        row(form, "To [s]", to);
        row(form, "Frames per second", fps);
        row(form, "Playback speed (x real time)", speed);
        int answer = JOptionPane.showConfirmDialog(
                pane, form, "Video of " + name, JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE);
        if (answer != JOptionPane.OK_OPTION) {
            return Optional.empty();
        }
        try {
            return Optional.of(film(viewed, from.getText(), to.getText(), fps.getText(), speed.getText()));
        } catch (IllegalArgumentException e) {
            pane.notice().show("video: " + e.getMessage());
            return Optional.empty();
        }
    }

    private static void row(JPanel form, String name, JTextField field) {
        JLabel label = new JLabel(name);
        label.setLabelFor(field);
        form.add(label);
        form.add(field);
    }

    /**
     * The video that a user requests, within the simulated time.
     *
     * @throws IllegalArgumentException when a value is not a number or out of range
     */
    static Film film(ViewedRun viewed, String from, String to, String fps, String speed) {
        double end = number("end time", to);
        // The end time is offered with two digits.
        double reached = viewed.run().reached();
        if (end > reached + 0.01) {
            throw new IllegalArgumentException(
                    String.format(Locale.ROOT, "end time %s s: only %.2f s have been simulated", to.strip(), reached));
        }
        return new Film(
                number("start time", from),
                Math.min(end, reached),
                wholeNumber("frames per second", fps),
                number("playback speed", speed));
    }

    private static double number(String name, String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " '" + PlainText.value(text) + "': must be a number", e);
        }
    }

    private static int wholeNumber(String name, String text) {
        try {
            return Integer.parseInt(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(name + " '" + PlainText.value(text) + "': must be a whole number", e);
        }
    }

    private void save(FilmMaker maker, String name) {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter("MP4 videos", "mp4"));
        chooser.setSelectedFile(new java.io.File(name + ".mp4"));
        if (chooser.showSaveDialog(pane) == JFileChooser.APPROVE_OPTION) {
            String file = chooser.getSelectedFile().getPath();
            start(maker, file.toLowerCase(Locale.ROOT).endsWith(".mp4") ? file : file + ".mp4");
        }
    }

    /** Writes a film on a separate thread, one at a time, with a progress bar that can cancel it. */
    void start(FilmMaker maker, String file) {
        if (isBusy()) {
            pane.notice().show("Another video is still being written: wait until it finishes, or cancel it.");
            return;
        }
        ProgressMonitor monitor = new ProgressMonitor(
                pane, "Writing " + file, " ", 0, maker.film().frames());
        monitor.setMillisToPopup(300);
        writing = new Thread(
                () -> {
                    try {
                        write(
                                maker,
                                file,
                                done -> SwingUtilities.invokeLater(() -> monitor.setProgress(done)),
                                () -> closed || monitor.isCanceled());
                        pane.note(Counted.of(maker.film().frames(), "frame") + " written to " + file);
                    } catch (CancellationException e) {
                        pane.note("video export to " + file + " cancelled; no file written");
                    } catch (RuntimeException e) {
                        failed.accept(e);
                    } finally {
                        SwingUtilities.invokeLater(monitor::close);
                    }
                },
                "dronewatch-film");
        writing.setDaemon(true);
        writing.start();
    }

    /** Writes a film, whole or not at all. */
    static void write(FilmMaker maker, String file, IntConsumer progress, BooleanSupplier cancelled) {
        try (Workers workers = new Workers(Runtime.getRuntime().availableProcessors())) {
            workers.call(() -> {
                new WholeFile("video", file)
                        .writeFile(partial -> maker.write(partial, FilmFormat.MP4, progress, cancelled));
                return null;
            });
        }
    }

    /** Whether a film is being written. */
    boolean isBusy() {
        return writing != null && writing.isAlive();
    }

    /** Abandons the film that is being written, and waits until its thread has ended. */
    @Override
    public void close() {
        closed = true;
        if (writing != null) {
            try {
                writing.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
