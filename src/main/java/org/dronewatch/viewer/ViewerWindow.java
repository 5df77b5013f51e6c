package org.dronewatch.viewer;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.GivenScene;
import org.dronewatch.scene.Scene;
import org.dronewatch.viewer.beside.OtherRun;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.UnsavedMoves;

/**
 * The window around a pane: its menus, its look and feel, its clock, and its position and size, as the user left them.
 * All methods are for the event thread.
 */
final class ViewerWindow {
    /** Update interval of the pane, ms. */
    private static final int TICK = 33;

    /** Maximum time step, s, so that a pause of the machine does not skip simulated time. */
    private static final double LONGEST_TICK = 0.25;

    private static final Dimension FIRST = new Dimension(1280, 800);
    private static final String[] DIVIDERS = {"across", "down"};

    private final ViewerLayout layout;
    private final Optional<SceneOpening> opening;
    private final Runnable closing;
    private final Runnable closed;
    private final JFrame frame = new JFrame();
    private final Timer timer;
    private ViewerPane pane;
    private FilmExport films;
    private UnsavedMoves unsaved;
    private Optional<Again> again = Optional.empty();
    private long lastTick = System.nanoTime();
    private boolean open = true;

    /**
     * A scene that is to run again with changed sensors.
     *
     * @param saved the settings that are in a file, or in the scene that was opened
     */
    private record Again(Scene scene, SceneSettings saved) {}

    /**
     * A window that is not shown yet.
     *
     * @param subject the scene that the pane shows
     * @param layout how the user left the window
     * @param opening opens other scenes; empty where the run is fixed
     * @param closing is called when the user closes the window
     * @param closed is called when the window has been closed and all threads of the pane have ended
     */
    ViewerWindow(
            Viewer.Subject subject,
            ViewerPane pane,
            ViewerLayout layout,
            Optional<SceneOpening> opening,
            Runnable closing,
            Runnable closed) {
        this.layout = layout;
        this.opening = opening;
        this.closing = closing;
        this.closed = closed;
        this.timer = new Timer(TICK, e -> tick());
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                leave();
            }
        });
        fill(subject, pane);
        frame.setMinimumSize(Scaled.size(640, 420));
        place();
    }

    private void fill(Viewer.Subject subject, ViewerPane content) {
        String title = subject.scene().name();
        pane = content;
        frame.setTitle(title + " - dronewatch");
        Exports exports = new Exports(pane, pane::report);
        films = new FilmExport(pane, exports, pane::report);
        SceneSaving saving = new SceneSaving(pane, title, subject.runner()::text);
        pane.placing().onSave(saving::ask);
        pane.tabs().settings().onSave(saving::ask);
        opening.ifPresent(scenes -> pane.tabs().settings().onRun(() -> runAgain(subject.scene(), scenes)));
        unsaved = new UnsavedMoves(
                pane.placing().layoutOfSensors(), saving::ask, moved -> UnsavedMoves.ask(frame, moved));
        pane.placing().onLeaving(unsaved::mayLeave);
        opening.ifPresent(scenes -> scenes.onLeaving(unsaved::mayLeave));
        FileMenu file = new FileMenu(pane, exports, films, saving, opening, this::leave);
        ViewerMenus menus = new ViewerMenus(pane, file, this::setDark, () -> KeysPage.open(frame));
        frame.setJMenuBar(menus.bar(layout.isDark()));
        frame.setContentPane(pane);
    }

    /** Runs the scene with its sensors as they are now; changes that are unsaved remain so. */
    private void runAgain(Scene scene, SceneOpening scenes) {
        SensorLayout sensors = pane.placing().layoutOfSensors();
        Scene changed = new GivenScene(scene.name(), scene.directory(), sensors.settings());
        again = Optional.of(new Again(changed, sensors.saved()));
        scenes.open(changed);
    }

    /**
     * Replaces the displayed scene by another.
     *
     * @return an action that ends the threads of the previous scene; since it may wait for them, it must not run on the
     *     event thread
     */
    Runnable replace(Viewer.Subject subject, ViewerPane content) {
        ViewerPane old = pane;
        FilmExport oldFilms = films;
        int[] locations = pane.dividers().stream()
                .mapToInt(JSplitPane::getDividerLocation)
                .toArray();
        fill(subject, content);
        again.filter(one -> one.scene() == subject.scene()).ifPresent(one -> {
            content.placing().layoutOfSensors().beginWith(one.saved());
            content.comparing().compareWith(runsBefore(old));
        });
        frame.validate();
        for (int i = 0; i < locations.length; i++) {
            pane.dividers().get(i).setDividerLocation(locations[i]);
        }
        pane.world().requestFocusInWindow();
        return () -> {
            oldFilms.close();
            old.close();
        };
    }

    /** The runs with which a changed scene can be compared: those offered before, and its run before it was changed. */
    private static List<OtherRun> runsBefore(ViewerPane old) {
        List<OtherRun> runs = new ArrayList<>(old.comparing().kept());
        // Only the last run is kept: each takes memory.
        runs.removeIf(run -> run.name().equals(Comparing.BEFORE));
        old.viewed().ifPresent(run -> runs.add(new OtherRun(Comparing.BEFORE, run.run())));
        return runs;
    }

    /** Shows the window. */
    void show() {
        frame.setVisible(true);
    }

    /** Puts the dividers where the user left them, and starts the clock. */
    void divide() {
        for (int i = 0; i < DIVIDERS.length; i++) {
            JSplitPane divided = pane.dividers().get(i);
            int first = i == 0 ? (int) (0.6 * divided.getWidth()) : (int) (0.58 * divided.getHeight());
            divided.setDividerLocation((int) layout.divider(DIVIDERS[i]).orElse(first));
        }
        pane.world().requestFocusInWindow();
        timer.start();
    }

    /** Sets the look and feel of all windows that are opened from now on. */
    static void setLook(boolean dark) {
        FlatLaf.registerCustomDefaultsSource(ViewerWindow.class.getPackageName());
        if (dark) {
            FlatDarkLaf.setup();
        } else {
            FlatLightLaf.setup();
        }
    }

    private void place() {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        Dimension first = UIScale.scale(FIRST);
        Rectangle wanted = layout.bounds()
                .filter(screen::intersects)
                .orElse(new Rectangle(
                        screen.x + Math.max(0, (screen.width - first.width) / 2),
                        screen.y + Math.max(0, (screen.height - first.height) / 2),
                        first.width,
                        first.height));
        frame.setBounds(wanted.intersection(screen));
    }

    private void setDark(boolean dark) {
        layout.setDark(dark);
        setLook(dark);
        FlatLaf.updateUI();
    }

    private void tick() {
        long now = System.nanoTime();
        pane.tick(Math.min(LONGEST_TICK, 1e-9 * (now - lastTick)));
        lastTick = now;
    }

    JFrame frame() {
        return frame;
    }

    /** Closes, unless the user wants to keep moves of sensors that were not saved. */
    private void leave() {
        if (unsaved.mayLeave()) {
            close();
        }
    }

    /** Saves the layout and closes; idempotent. */
    void close() {
        if (!open) {
            return;
        }
        open = false;
        closing.run();
        timer.stop();
        layout.setBounds(frame.getBounds());
        for (int i = 0; i < DIVIDERS.length; i++) {
            layout.setDivider(DIVIDERS[i], pane.dividers().get(i).getDividerLocation());
        }
        layout.save();
        frame.dispose();
        // The threads may be in the middle of a picture: the event thread does not wait for them.
        Thread closing = new Thread(
                () -> {
                    opening.ifPresent(SceneOpening::close);
                    films.close();
                    pane.close();
                    closed.run();
                },
                "dronewatch-closing");
        closing.start();
    }
}
