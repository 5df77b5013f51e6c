package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import org.dronewatch.geometry.Position;
import org.dronewatch.picture.Cut;
import org.dronewatch.picture.Orbit;
import org.dronewatch.picture.RaySet;
import org.dronewatch.picture.SiteState;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Stage;
import org.dronewatch.setting.InputException;

/**
 * All that the window shows: the site, the cameras, the time line, tables, rays and log. {@link #tick} lets time go on; all
 * methods are for the event thread but those that say otherwise. It needs no window: it paints into a picture as well.
 */
final class ViewerPane extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Tables and texts follow this often, s: more often nobody can read. */
    private static final double TABLES = 0.12;

    private static final int[] PAIR_COLUMNS = {100, 57, 79, 60, 58, 72, 70};

    private final String title;
    private final transient Recording recording;
    private final transient Function<SceneSettings, Stage> stages;
    private final transient Playback playback = new Playback();
    private final transient ViewerActions actions = new ViewerActions(playback);
    private final transient Latest staging;
    private final WorldPanel world;
    private final WorldBar worldBar;
    private final CameraPanel cameras;
    private final TimeLine timeLine = new TimeLine(playback);
    private final PairTable pairs = new PairTable();
    private final DroneTable drones = new DroneTable();
    private final RayPanel rayPanel;
    private final LogPanel log = new LogPanel();
    private final ControlBar controls;
    private final Notice notice = new Notice();
    private final JLabel status = new JLabel(" ");
    private final JProgressBar progress = new JProgressBar(0, 1000);
    private final JTabbedPane tabs = new JTabbedPane();
    private final JSplitPane across;
    private final JSplitPane down;
    private transient ViewedRun viewed;
    private transient RecordedRun awaited;
    private String selected;
    private transient RaySet rays;
    private boolean changed = true;
    private double sinceTables;
    private double shownTime = Double.NaN;

    /**
     * A pane for a scene that is about to run.
     *
     * @param title of the scene
     * @param recording is told what happens
     * @param stages makes the site of a run's settings; asked on a thread of this pane
     * @param threads how many trace
     */
    ViewerPane(String title, Recording recording, Function<SceneSettings, Stage> stages, int threads) {
        super(new BorderLayout());
        this.title = title;
        this.recording = recording;
        this.stages = stages;
        this.staging = new Latest("dronewatch-stage", threads, this::tell);
        this.world = new WorldPanel(threads, this::tell);
        this.cameras = new CameraPanel(threads, status::setText, this::select, this::tell);
        this.rayPanel = new RayPanel(
                threads, playback, filter -> world.setStyle(world.style().withFilter(filter)), this::tell);
        this.worldBar = new WorldBar(world, lookAbout(), lookFromAbove(), lookFromSide(), focus());
        this.controls = new ControlBar(
                playback, actions, number -> show(recording.runs().get(number)));
        world.onSelection(this::select);
        world.onHint(status::setText);
        rayPanel.onTraced(traced -> {
            rays = traced.orElse(null);
            changed = true;
        });
        playback.listen(() -> changed = true);

        JPanel site = new JPanel(new BorderLayout());
        site.add(worldBar, BorderLayout.NORTH);
        site.add(world, BorderLayout.CENTER);
        tabs.addTab("Sensors", scroll(pairTable()));
        tabs.addTab("Drones", scroll(droneTable()));
        tabs.addTab("Rays of sound", rayPanel);
        tabs.addTab("Log", log);
        down = new JSplitPane(JSplitPane.VERTICAL_SPLIT, cameras, tabs);
        down.setResizeWeight(0.6);
        across = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, site, down);
        across.setResizeWeight(0.62);
        JPanel top = new JPanel(new BorderLayout());
        top.add(controls, BorderLayout.NORTH);
        top.add(notice, BorderLayout.SOUTH);
        JPanel bottom = new JPanel(new BorderLayout());
        bottom.add(timeLine, BorderLayout.CENTER);
        bottom.add(statusBar(), BorderLayout.SOUTH);
        add(top, BorderLayout.NORTH);
        add(across, BorderLayout.CENTER);
        add(bottom, BorderLayout.SOUTH);
        progress.setIndeterminate(true);
        status.setText("Reading models and building trees ...");
    }

    private JComponent statusBar() {
        JPanel bar = new JPanel(new BorderLayout());
        bar.setBorder(BorderFactory.createEmptyBorder(3, 10, 3, 10));
        bar.add(status, BorderLayout.CENTER);
        bar.add(progress, BorderLayout.LINE_END);
        return bar;
    }

    private static JScrollPane scroll(JComponent inside) {
        return new JScrollPane(inside);
    }

    private JTable pairTable() {
        JTable table = new JTable(pairs);
        table.setAutoCreateRowSorter(true);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getAccessibleContext().setAccessibleName("sensors");
        for (int i = 0; i < PAIR_COLUMNS.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(PAIR_COLUMNS[i]);
        }
        table.setDefaultRenderer(Object.class, new DetectionRenderer(pairs));
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting() && table.getSelectedRow() >= 0) {
                select(pairs.sensor(table.convertRowIndexToModel(table.getSelectedRow())));
            }
        });
        return table;
    }

    private JTable droneTable() {
        JTable table = new JTable(drones);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.getAccessibleContext().setAccessibleName("drones");
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting() && table.getSelectedRow() >= 0) {
                select(drones.drone(table.getSelectedRow()));
            }
        });
        return table;
    }

    private Action lookAbout() {
        return ViewerActions.action(
                "Orbit",
                "Looks at all sensors and flights in perspective",
                ViewerActions.key('1'),
                () -> look(Orbit.about(viewed.picture().interest(), world.aspect())));
    }

    private Action lookFromAbove() {
        return ViewerActions.action(
                "From above",
                "A plan with north up",
                ViewerActions.key('2'),
                () -> look(Orbit.top(viewed.picture().interest(), world.aspect())));
    }

    private Action lookFromSide() {
        return ViewerActions.action(
                "From the side",
                "From the east, level",
                ViewerActions.key('3'),
                () -> look(Orbit.side(viewed.picture().interest(), world.aspect(), 0.5 * Math.PI)));
    }

    private Action focus() {
        return ViewerActions.action(
                "Focus",
                "Looks at the selected sensor or drone from near",
                ViewerActions.key('F'),
                this::focusOnSelection);
    }

    /** The views, for a menu. */
    List<Action> views() {
        return List.of(lookAbout(), lookFromAbove(), lookFromSide(), focus());
    }

    private void look(Orbit orbit) {
        if (viewed != null) {
            world.move(orbit);
        }
    }

    private void focusOnSelection() {
        if (viewed != null && selected != null) {
            Optional<Position> place = viewed.placeOf(selected, playback.time());
            double high = Math.max(4.0, 0.12 * viewed.picture().interest().diagonal());
            place.ifPresent(at -> world.move(world.orbit().at(at).showing(high)));
        }
    }

    /** Selects a sensor or drone; null for none. */
    void select(String id) {
        selected = id;
        changed = true;
        sinceTables = TABLES;
    }

    /** Lets time go on by so many seconds on the wall, and shows what is new. */
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
        world.show(state(time));
        if (time != shownTime) {
            shownTime = time;
            cameras.show(time);
        }
        timeLine.repaint();
    }

    private SiteState state(double time) {
        return viewed.state(time, Optional.ofNullable(selected), Optional.ofNullable(rays));
    }

    private void showTables(List<RecordedRun> runs) {
        double time = playback.time();
        RecordedRun run = viewed.run();
        controls.update(runs);
        timeLine.update();
        pairs.show(run, time);
        drones.show(run, viewed.stage().dronesAt(time), time);
        log.update(run);
        cameras.mark(sensor -> viewed.readings(sensor, time), selected);
        boolean all = recording.isFinished();
        progress.setVisible(!all);
        progress.setIndeterminate(false);
        progress.setValue((int) (1000.0 * run.reached() / run.duration()));
        if (!all) {
            // Detections up to the time shown may just have come.
            changed = true;
        }
    }

    /** Shows another run, once its site is there. */
    void show(RecordedRun run) {
        awaited = run;
        staging.ask(outdated -> {
            ViewedRun next = new ViewedRun(title, run, stages.apply(run.info().settings()));
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
        cameras.show(next.settings(), next.stage());
        rayPanel.show(next.settings(), next.stage());
        worldBar.show(next.stage().world().bounds(), cut);
        Orbit from = first ? Orbit.about(next.picture().interest(), world.aspect()) : world.orbit();
        world.show(next.picture(), from, cut);
        shownTime = Double.NaN;
        changed = true;
        sinceTables = TABLES;
        status.setText("Drag to turn, right-drag to move, wheel to zoom, double click to look at a place; "
                + "Space plays and pauses");
        if (first) {
            playback.play();
        }
    }

    /** Shows what went wrong; from any thread. */
    void tell(Throwable problem) {
        String text = problem instanceof InputException
                ? problem.getMessage()
                : problem instanceof OutOfMemoryError
                        ? "not enough memory for this picture"
                        : "internal error: " + problem;
        SwingUtilities.invokeLater(() -> {
            notice.tell(text);
            log.write(text);
            if (viewed == null) {
                progress.setVisible(false);
                status.setText("The scene cannot be shown.");
            }
        });
    }

    /** Writes a line into the log; from any thread. */
    void note(String line) {
        SwingUtilities.invokeLater(() -> {
            log.write(line);
            if (viewed == null) {
                status.setText(line);
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
        return world;
    }

    CameraPanel cameras() {
        return cameras;
    }

    RayPanel rayPanel() {
        return rayPanel;
    }

    TimeLine timeLine() {
        return timeLine;
    }

    LogPanel log() {
        return log;
    }

    Notice notice() {
        return notice;
    }

    JTabbedPane tabs() {
        return tabs;
    }

    /** The divider between site and cameras, and the one below the cameras. */
    List<JSplitPane> dividers() {
        return List.of(across, down);
    }

    /** What is shown, if its site is there. */
    Optional<ViewedRun> viewed() {
        return Optional.ofNullable(viewed);
    }

    Optional<String> selected() {
        return Optional.ofNullable(selected);
    }

    Optional<RaySet> rays() {
        return Optional.ofNullable(rays);
    }

    /** Whether all that was asked for is drawn. */
    boolean isIdle() {
        return !changed && world.isIdle() && cameras.isIdle() && rayPanel.isIdle() && staging.isIdle();
    }

    /** Ends all threads. */
    void close() {
        staging.close();
        world.close();
        cameras.close();
        rayPanel.close();
    }
}
