package org.dronewatch.viewer;

import java.awt.Insets;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.render.SiteSkin;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.viewer.beside.ComparisonPanel;
import org.dronewatch.viewer.coverage.CoveragePanel;
import org.dronewatch.viewer.coverage.SkinPainter;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.Playback;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.viewer.run.ViewedRun;
import org.dronewatch.viewer.settings.SettingsPanel;

/** The tabs beside the site: tables, sound rays, coverage, placing, settings, log and comparison. */
final class RunTabs extends JTabbedPane {
    private static final long serialVersionUID = 1L;

    /** Height of the tabs in which the coverage of several sensors can be read, in pixels of a normal screen. */
    private static final int COVERAGE_HEIGHT = 360;

    /** Space around the name of a tab, in pixels of a normal screen: the look and feel scales it itself. */
    private static final int MARGIN = 3;

    private final transient RunTablesPanel tables;
    private final RayPanel rayPanel;
    private final CoveragePanel coverage;
    private final PlacingPanel placing;
    private final SettingsPanel settings;
    private final LogPanel log = new LogPanel();
    private final ComparisonPanel comparison;

    /** The coverage as a skin of the site. */
    private record WorldSkin(WorldPanel world) implements SkinPainter {
        @Override
        public void setSkin(Optional<SiteSkin> skin) {
            world.setStyle(world.style().withSkin(skin));
        }

        @Override
        public boolean isPainting() {
            return !world.isIdle();
        }
    }

    /**
     * Empty tabs.
     *
     * @param threads number of threads that trace rays and compute coverage
     * @param world draws rays and coverage
     * @param stores returns the store of coverages that were computed before, for the settings of a run
     * @param layout where the user has put the sensors
     * @param messages receives a line about each change of a setting
     * @param selection receives the sensor or drone that was clicked on
     * @param failed receives what went wrong
     */
    RunTabs(
            int threads,
            Playback playback,
            WorldPanel world,
            Function<SceneSettings, LayerStore> stores,
            SensorLayout layout,
            Consumer<String> messages,
            Consumer<String> selection,
            Consumer<Throwable> failed) {
        this.tables = new RunTablesPanel(selection);
        this.rayPanel = new RayPanel(
                threads, playback, filter -> world.setStyle(world.style().withFilter(filter)), failed);
        this.coverage = new CoveragePanel(threads, layout, stores, new WorldSkin(world), failed);
        this.placing = new PlacingPanel(layout, coverage, selection);
        this.settings = new SettingsPanel(layout, messages);
        this.comparison = new ComparisonPanel(selection);
        // All tabs have room in one row.
        putClientProperty("JTabbedPane.tabInsets", new Insets(MARGIN, MARGIN, MARGIN, MARGIN));
        world.onPointed(coverage::point);
        world.setGrip(new SensorGrip(world, placing.mover()));
        world.setOverlay(state -> layout.in(state, placing.note()));
        layout.listen(world::redraw);
        addTab("Sensors", tables.sensors());
        addTab("Drones", tables.drones());
        addTab("Sound rays", rayPanel);
        addTab("Coverage", coverage);
        addTab("Placing", placing);
        addTab("Settings", settings);
        addTab("Log", log);
        addTab("Compare", comparison);
    }

    /** Takes the sensors and drones of another run. */
    void show(ViewedRun next) {
        rayPanel.show(next.settings(), next.stage());
        placing.show(next);
        settings.update();
        coverage.show(next);
    }

    /**
     * Selects the coverage, which is computed as soon as the site has been loaded, and makes room for it.
     *
     * @param divider between the cameras and these tabs
     */
    void showCoverage(JSplitPane divider) {
        setSelectedComponent(coverage);
        int missing = Scaled.px(COVERAGE_HEIGHT) - getHeight();
        if (missing > 0) {
            divider.setDividerLocation(
                    Math.max(divider.getMinimumDividerLocation(), divider.getDividerLocation() - missing));
        }
        coverage.computeSoon();
    }

    /** Updates the tables and the log to a given time. */
    void update(ViewedRun viewed, double time) {
        tables.show(viewed, time);
        log.update(viewed.run());
    }

    RayPanel rayPanel() {
        return rayPanel;
    }

    PlacingPanel placing() {
        return placing;
    }

    SettingsPanel settings() {
        return settings;
    }

    CoveragePanel coverage() {
        return coverage;
    }

    ComparisonPanel comparison() {
        return comparison;
    }

    LogPanel log() {
        return log;
    }

    /** Whether everything that was requested is computed. */
    boolean isIdle() {
        return rayPanel.isIdle() && coverage.isIdle();
    }

    /** Ends all threads. */
    void close() {
        rayPanel.close();
        coverage.close();
    }
}
