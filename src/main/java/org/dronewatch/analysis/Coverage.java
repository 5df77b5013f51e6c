package org.dronewatch.analysis;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.dronewatch.drone.Drone;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Spelling;

/**
 * The coverage of a site: where each sensor detects a drone, and why it does not elsewhere. The drone is placed at
 * every point of a grid, with its nose and velocity pointing towards the sensor, and the sensor looks once:
 * obstructions, pixel counts, levels and echoes are computed as in a run.
 */
public final class Coverage {
    private final CoverageGrid grid;
    private final SurfaceHeights heights;
    private final Map<String, SensorSettings<?>> sensors;
    private final Map<String, Prober> probers;
    private final Map<String, Prober.Findings> findings;
    private final CellTotals totals;

    private Coverage(
            CoverageGrid grid,
            SurfaceHeights heights,
            Map<String, SensorSettings<?>> sensors,
            Map<String, Prober> probers,
            Map<String, Prober.Findings> findings,
            CellTotals totals) {
        this.grid = grid;
        this.heights = heights;
        this.sensors = sensors;
        this.probers = probers;
        this.findings = findings;
        this.totals = totals;
    }

    /**
     * Evaluates all sensors of a scene at all points, on the {@link Workers} of the calling thread; the result does not
     * depend on their number.
     *
     * @param settings settings of one run
     * @param stage world and drones of that run
     * @param drone id of the drone that is placed at the points
     * @param progress receives the number of points that a sensor has looked at since the last call; from any thread
     * @throws IllegalArgumentException when there is no such drone
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static Coverage of(
            SceneSettings settings, Stage stage, String drone, CoverageGrid grid, IntConsumer progress) {
        Drone sample = stage.dronesAt(0.0).stream()
                .filter(one -> one.id().equals(drone))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Spelling.unknown(
                        "drone", drone, "the scene", settings.individualDrones().keySet())));
        SurfaceHeights heights = new SurfaceHeights(stage.world(), grid);
        Map<String, Prober> probers = new LinkedHashMap<>();
        Map<String, Prober.Findings> findings = new LinkedHashMap<>();
        settings.enabledSensors().forEach((id, sensor) -> {
            Prober prober = new Prober(
                    grid,
                    heights,
                    stage.world(),
                    sample,
                    sensor,
                    id,
                    settings.run().seed());
            probers.put(id, prober);
            findings.put(id, prober.probe(progress));
        });
        Map<String, SensorSettings<?>> sensors = settings.enabledSensors();
        boolean isKnownEverywhere = stage.world().isKnownEverywhere();
        CellTotals totals = CellTotals.of(sensors, findings, heights.height, isKnownEverywhere);
        return new Coverage(grid, heights, sensors, probers, findings, totals);
    }

    /** The grid. */
    public CoverageGrid grid() {
        return grid;
    }

    /** The sensors by id, in the scene's order. */
    public Map<String, SensorSettings<?>> sensors() {
        return sensors;
    }

    /**
     * Whether a sensor detects the drone in a cell, given by its column from the west and its row from the north. A
     * sensor that decides by chance counts as detecting it where its {@link Assessment#probability} is at least 0.5;
     * for a microphone that traces random rays, a single look decides.
     */
    public boolean isReached(String sensor, int column, int row) {
        return findings.get(sensor).answers()[row * grid.cells() + column] == Prober.Answer.DETECTED;
    }

    /** Whether any sensor detects the drone in a cell. */
    public boolean isReached(int column, int row) {
        return totals.reached()[row * grid.cells() + column];
    }

    /**
     * Whether detection in a cell is unknown: no sensor is known to detect the drone there, and the ground in the cell,
     * or below the line of sight from some sensor, is not known. In a world built from models, cells without ground are
     * empty, not unknown.
     */
    public boolean isUnknown(int column, int row) {
        return totals.unknown()[row * grid.cells() + column];
    }

    /** The area of the cells that are {@link #isUnknown unknown}, m2. */
    public double unknownArea() {
        int cells = 0;
        for (int row = 0; row < grid.cells(); row++) {
            for (int column = 0; column < grid.cells(); column++) {
                cells += isUnknown(column, row) ? 1 : 0;
            }
        }
        return cells * grid.cellArea();
    }

    /**
     * A sensor's assessment of the drone in a cell, using the same random rays as the sensor's look there; empty where
     * there is no ground. For use by one thread at a time.
     */
    public Optional<Assessment> assess(String sensor, int column, int row) {
        return probers.get(sensor).assess(column, row);
    }

    /**
     * The number of cells in which a sensor does not detect the drone, for each cause, excluding cells without ground.
     * Microphones trace no rays for this. For use by one thread at a time.
     */
    public Map<Cause, Integer> causes(String sensor) {
        Prober prober = probers.get(sensor);
        Prober.Findings found = findings.get(sensor);
        int[] counts = new int[Cause.values().length];
        for (int row = 0; row < grid.cells(); row++) {
            Workers.checkInterrupted();
            for (int column = 0; column < grid.cells(); column++) {
                int cell = row * grid.cells() + column;
                if (found.answers()[cell] == Prober.Answer.DETECTED) {
                    continue;
                }
                Cause known = found.causes()[cell];
                if (known != null) {
                    counts[known.ordinal()]++;
                } else {
                    prober.explain(column, row)
                            .ifPresent(why -> counts[why.cause().ordinal()]++);
                }
            }
        }
        Map<Cause, Integer> causes = new EnumMap<>(Cause.class);
        for (Cause cause : Cause.values()) {
            if (counts[cause.ordinal()] > 0) {
                causes.put(cause, counts[cause.ordinal()]);
            }
        }
        return causes;
    }

    /**
     * The number of cells for each cause, by sensor, as given by {@link #causes(String)}; computed on the
     * {@link Workers} of the calling thread; the result does not depend on their number.
     */
    public Map<String, Map<Cause, Integer>> causes() {
        List<String> ids = List.copyOf(sensors.keySet());
        List<Map<Cause, Integer>> found = new ArrayList<>(Collections.nCopies(ids.size(), Map.of()));
        Workers.forEach(ids.size(), i -> found.set(i, causes(ids.get(i))));
        Map<String, Map<Cause, Integer>> bySensor = new LinkedHashMap<>();
        ids.forEach(id -> bySensor.put(id, found.get(bySensor.size())));
        return bySensor;
    }

    /** Number of cells with ground, above which the drone is placed. */
    public int groundCells() {
        return heights.count();
    }

    /** Number of cells in which a sensor detects the drone. */
    public int reachedCells(String sensor) {
        int cells = 0;
        for (Prober.Answer answer : findings.get(sensor).answers()) {
            cells += answer == Prober.Answer.DETECTED ? 1 : 0;
        }
        return cells;
    }

    /** Whether any sensor of a kind detects the drone, for each cell, row by row from the north. */
    public boolean[] cellsOfKind(String kind) {
        return totals.byKind()
                .getOrDefault(kind, new boolean[grid.cells() * grid.cells()])
                .clone();
    }

    /** The area in which a sensor detects the drone, m2. */
    public double area(String sensor) {
        return reachedCells(sensor) * grid.cellArea();
    }

    /** The area in which any sensor of a kind detects the drone, m2. */
    public double areaOfKind(String kind) {
        int cells = 0;
        for (boolean isReached : cellsOfKind(kind)) {
            cells += isReached ? 1 : 0;
        }
        return cells * grid.cellArea();
    }
}
