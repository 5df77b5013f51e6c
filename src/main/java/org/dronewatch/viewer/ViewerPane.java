package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.Action;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.render.canvas.SiteLines;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.dronewatch.viewer.part.Divided;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.Notice;
import org.dronewatch.viewer.part.StatusBar;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.run.Playback;
import org.dronewatch.viewer.run.RecordedRun;
import org.dronewatch.viewer.run.Recording;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.ViewedRun;

/**
 * All that the window shows: the site, the cameras, the time line, tables, rays and log. {@link #tick} advances time;
 * all methods must be called on the event thread unless stated otherwise. The pane needs no window: it can also be
 * painted into a picture.
 */
final class ViewerPane extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Update interval of tables and texts, s; shorter intervals would be unreadable. */
    private static final double TABLES = 0.12;

    private final String title;
    private final transient Recording recording;
    private final transient Playback playback = new Playback();
    private final transient SensorLayout layout = new SensorLayout();
    private final transient ViewerActions actions = new ViewerActions(playback);
    private final transient Latest staging;
    private final SiteSection site;
    private final CameraPanel cameras;
    private final TimeLine timeLine = new TimeLine(playback);
    private final ControlBar controls;
    private final Notice notice = new Notice();
    private final StatusBar status = new StatusBar("Reading models and preparing ray tracing ...");
    private final RunTabs tabs;
    private final transient Measuring measuring;
    private final transient Comparing comparing;
    private final JSplitPane across;
    private final JSplitPane down;
    private transient ViewedRun viewed;
    private transient RecordedRun awaited;
    private String selected;
    private transient RecordedRays rays;
    private boolean changed = true;
    private double sinceTables;
    private double shownTime = Double.NaN;

    /**
     * A pane for a scene that is about to run.
     *
     * @param title title of the scene
     * @param recording receives what happens
     * @param threads number of threads that prepare the site, paint it, trace rays and compute coverage
     * @param stores returns the store of coverages that were computed before, for the settings of a run
     */
    ViewerPane(String title, Recording recording, int threads, Function<SceneSettings, LayerStore> stores) {
        super(new BorderLayout());
        this.title = title;
        this.recording = recording;
        this.staging = new Latest("dronewatch-stage", threads, this::report);
        this.site = new SiteSection(threads, this::report);
        this.cameras = new CameraPanel(threads, status::write, this::select, this::report);
        this.tabs = new RunTabs(threads, playback, world(), stores, layout, status::write, this::select, this::report);
        this.measuring = new Measuring(world(), this::placeOf, status::write, line -> log().write(line), this::report);
        world().setTool(measuring);
        this.comparing = new Comparing(site, tabs.comparison(), threads, this::select, status::write, this::report);
        this.controls = new ControlBar(playback, actions, number -> {
            if (placing().mayLeave()) {
                show(recording.runs().get(number));
            }
        });
        world().onSelection(this::select);
        world().onHint(text ->
                status.write(coverage().hint().map(words -> text + "; " + words).orElse(text)));
        site.onFocus(() -> {
            if (selected == null) {
                status.write("Click on a sensor or a drone first: Focus zooms in on the selection");
            } else {
                placeOf(selected).ifPresent(site::focusOn);
            }
        });
        rayPanel().onTraced(traced -> {
            rays = traced.orElse(null);
            changed = true;
        });
        playback.listen(() -> changed = true);
        placing().onTold(status::write);

        down = Divided.split(JSplitPane.VERTICAL_SPLIT, cameras, tabs, 0.6);
        across = Divided.split(JSplitPane.HORIZONTAL_SPLIT, site, down, 0.62);
        add(Divided.below(controls, notice), BorderLayout.NORTH);
        add(across, BorderLayout.CENTER);
        add(Divided.below(timeLine.scrolling(), status), BorderLayout.SOUTH);
    }

    /** Where the sensor or drone with a given name is now, m. */
    private Optional<Position> placeOf(String id) {
        return viewed().flatMap(run -> run.positionOf(id, layout.settings(), playback.time()));
    }

    /** The views, for a menu. */
    List<Action> views() {
        return site.views();
    }

    /** Selects a sensor or drone; null for none. */
    void select(String id) {
        selected = id;
        placing().select(id);
        tabs.settings().select(id);
        changed = true;
        sinceTables = TABLES;
    }

    /** Advances by some seconds of real time, and updates the display. */
    void tick(double seconds) {
        List<RecordedRun> runs = recording.runs();
        if (awaited == null && !runs.isEmpty()) {
            show(runs.get(0));
        }
        if (viewed == null) {
            return;
        }
        playback.advance(seconds);
        sinceTables += seconds;
        coverage().tick();
        if (changed) {
            changed = false;
            showTime();
        }
        if (sinceTables >= TABLES) {
            sinceTables = 0.0;
            showTables(runs);
        }
    }

    private void showTime() {
        double time = playback.time();
        world().show(viewed.state(time, selected(), rays()));
        comparing.showTime(time, selected());
        if (time != shownTime) {
            shownTime = time;
            cameras.show(time);
        }
        timeLine.repaint();
    }

    private void showTables(List<RecordedRun> runs) {
        double time = playback.time();
        RecordedRun run = viewed.run();
        controls.update(runs);
        timeLine.update();
        tabs.update(viewed, time);
        if (comparing.update(run, runs, time)) {
            changed = true;
        }
        cameras.mark(sensor -> viewed.readings(sensor, time), selected);
        boolean all = recording.isFinished();
        status.progress(run.reached() / run.duration(), all);
        if (!all) {
            // Detections up to the time shown may only just have been recorded.
            changed = true;
        }
    }

    /** Shows another run, once its site has been loaded. */
    void show(RecordedRun run) {
        awaited = run;
        staging.ask(outdated -> {
            ViewedRun next = new ViewedRun(title, run);
            Optional<Cut> cut = next.picture().openRoof(0.0);
            SwingUtilities.invokeLater(() -> {
                if (awaited == run) {
                    show(next, cut);
                }
            });
        });
    }

    private void show(ViewedRun next, Optional<Cut> cut) {
        boolean first = viewed == null;
        viewed = next;
        rays = null;
        playback.show(next.run());
        cameras.show(next);
        tabs.show(next);
        site.show(next, cut);
        measuring.show(next.stage());
        shownTime = Double.NaN;
        changed = true;
        sinceTables = TABLES;
        status.write("Drag to turn, right-drag to move, wheel to zoom, double-click to centre on a point; "
                + "Space plays and pauses; F1 lists all keys");
        if (first) {
            playback.play();
        }
    }

    /** Shows the coverage, computed with the defaults as soon as the site has been loaded. */
    void showCoverage() {
        tabs.showCoverage(down);
    }

    /** Draws lines through the site, in place of the paths of drones. */
    void showLines(SiteLines lines) {
        world().setStyle(world().style().withLines(lines));
    }

    /** Shows an error; callable from any thread. */
    void report(Throwable problem) {
        String text = Texts.problem(problem);
        SwingUtilities.invokeLater(() -> {
            notice.show(text);
            log().write(text);
            if (viewed == null) {
                status.end("Failed to load the scene.");
            }
        });
    }

    /** Writes a line into the log; from any thread. */
    void note(String line) {
        SwingUtilities.invokeLater(() -> {
            log().write(line);
            if (viewed == null) {
                status.write(line);
            }
        });
    }

    Recording recording() {
        return recording;
    }

    Playback playback() {
        return playback;
    }

    ViewerActions actions() {
        return actions;
    }

    WorldPanel world() {
        return site.world();
    }

    CameraPanel cameras() {
        return cameras;
    }

    Measuring measuring() {
        return measuring;
    }

    Comparing comparing() {
        return comparing;
    }

    RayPanel rayPanel() {
        return tabs.rayPanel();
    }

    CoveragePanel coverage() {
        return tabs.coverage();
    }

    PlacingPanel placing() {
        return tabs.placing();
    }

    TimeLine timeLine() {
        return timeLine;
    }

    LogPanel log() {
        return tabs.log();
    }

    Notice notice() {
        return notice;
    }

    RunTabs tabs() {
        return tabs;
    }

    /** The divider between site and cameras, and the one below the cameras. */
    List<JSplitPane> dividers() {
        return List.of(across, down);
    }

    /** The displayed run, if its site is loaded. */
    Optional<ViewedRun> viewed() {
        return Optional.ofNullable(viewed);
    }

    Optional<String> selected() {
        return Optional.ofNullable(selected);
    }

    Optional<RecordedRays> rays() {
        return Optional.ofNullable(rays);
    }

    /** Whether everything that was requested is drawn. */
    boolean isIdle() {
        return !changed
                && world().isIdle()
                && cameras.isIdle()
                && tabs.isIdle()
                && measuring.isIdle()
                && comparing.isIdle()
                && staging.isIdle();
    }

    /** Ends all threads. */
    void close() {
        staging.close();
        world().close();
        cameras.close();
        tabs.close();
        measuring.close();
        comparing.close();
    }
}
