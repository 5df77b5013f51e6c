package org.dronewatch.analysis;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/**
 * Where over a site each sensor detects a drone, and why not elsewhere. The drone is put at every point of a grid, its nose and
 * its speed towards the sensor, and the sensor looks once: what stands in the way, pixels, levels and echoes are those of a run.
 */
public final class Coverage {
    private final CoverageGrid grid;
    private final Map<String, SensorSettings<?>> sensors;
    private final Map<String, boolean[]> reached = new LinkedHashMap<>();
    private final Map<String, Prober> probers = new LinkedHashMap<>();

    private Coverage(CoverageGrid grid, Map<String, SensorSettings<?>> sensors) {
        this.grid = grid;
        this.sensors = sensors;
    }

    /**
     * Lets all sensors of a scene look at all points, on the threads of the {@link Workers} that call; the same for any number
     * of them.
     *
     * @param settings of one run
     * @param stage its world and drones
     * @param drone id of the drone that is put at the points
     * @param progress receives how many points a sensor has looked at since the last call; by any thread
     * @throws IllegalArgumentException when there is no such drone
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; it stays so
     */
    public static Coverage of(
            SceneSettings settings, Stage stage, String drone, CoverageGrid grid, IntConsumer progress) {
        Drone sample = stage.dronesAt(0.0).stream()
                .filter(one -> one.id().equals(drone))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no drone '" + drone + "'; the scene has "
                        + String.join(", ", settings.fliers().keySet())));
        Coverage coverage = new Coverage(grid, settings.enabledSensors());
        Heights heights = new Heights(stage.world(), grid);
        List<Supplier<boolean[]>> tasks = new ArrayList<>();
        settings.enabledSensors().forEach((id, sensor) -> {
            Prober prober = new Prober(
                    grid,
                    heights,
                    stage.world(),
                    sample,
                    sensor,
                    id,
                    settings.run().seed(),
                    new Assessor(id, sensor, stage.world()));
            coverage.probers.put(id, prober);
            tasks.add(() -> prober.probe(progress));
        });
        boolean[][] results = new boolean[tasks.size()][];
        Workers.forEach(results.length, i -> results[i] = tasks.get(i).get());
        int next = 0;
        for (String id : settings.enabledSensors().keySet()) {
            coverage.reached.put(id, results[next++]);
        }
        return coverage;
    }

    /** The grid. */
    public CoverageGrid grid() {
        return grid;
    }

    /** The sensors by id, in the scene's order. */
    public Map<String, SensorSettings<?>> sensors() {
        return sensors;
    }

    /** Whether a sensor detects the drone in a cell: columns from the west, rows from the north. */
    public boolean isReached(String sensor, int column, int row) {
        return reached.get(sensor)[row * grid.cells() + column];
    }

    /**
     * What a sensor has of the drone in a cell, with the random rays of its look there; empty where there is no ground. Where
     * the sensor decides by chance, {@link #isReached} is one draw from it. One thread at a time.
     */
    public Optional<Assessment> assess(String sensor, int column, int row) {
        return probers.get(sensor).assess(column, row);
    }

    /**
     * Why a sensor does not detect the drone: in how many cells each cause holds, without those in which it does, and those
     * without ground. Microphones trace nothing for it. One thread at a time.
     */
    public Map<Cause, Integer> causes(String sensor) {
        Map<Cause, Integer> causes = new EnumMap<>(Cause.class);
        for (int row = 0; row < grid.cells(); row++) {
            Workers.checkInterrupted();
            for (int column = 0; column < grid.cells(); column++) {
                if (!isReached(sensor, column, row)) {
                    probers.get(sensor)
                            .explain(column, row)
                            .ifPresent(missed -> causes.merge(missed.cause(), 1, Integer::sum));
                }
            }
        }
        return causes;
    }

    /** How many sensors of a kind detect the drone in a cell. */
    public int count(String kind, int column, int row) {
        int count = 0;
        for (Map.Entry<String, SensorSettings<?>> sensor : sensors.entrySet()) {
            boolean counts = sensor.getValue().kind().equals(kind) && isReached(sensor.getKey(), column, row);
            count += counts ? 1 : 0;
        }
        return count;
    }

    /** The area in which a sensor detects the drone, m2. */
    public double area(String sensor) {
        int cells = 0;
        for (boolean cell : reached.get(sensor)) {
            cells += cell ? 1 : 0;
        }
        return cells * grid.cellArea();
    }

    /** The area in which any sensor of a kind detects the drone, m2. */
    public double areaOfKind(String kind) {
        int cells = 0;
        for (int row = 0; row < grid.cells(); row++) {
            for (int column = 0; column < grid.cells(); column++) {
                cells += count(kind, column, row) > 0 ? 1 : 0;
            }
        }
        return cells * grid.cellArea();
    }

    /** The height of the highest surface in each cell, NaN where there is none. */
    private static final class Heights {
        private final double[] height;

        Heights(World world, CoverageGrid grid) {
            height = new double[grid.cells() * grid.cells()];
            for (int row = 0; row < grid.cells(); row++) {
                Workers.checkInterrupted();
                for (int column = 0; column < grid.cells(); column++) {
                    OptionalDouble surface = world.surfaceHeight(grid.x(column), grid.y(row));
                    height[row * grid.cells() + column] = surface.orElse(Double.NaN);
                }
            }
        }
    }

    /** One sensor that looks at all points, one after the other. */
    private record Prober(
            CoverageGrid grid,
            Heights heights,
            World world,
            Drone drone,
            SensorSettings<?> settings,
            String id,
            long seed,
            Assessor assessor) {

        boolean[] probe(IntConsumer progress) {
            Sensor sensor = settings.create();
            boolean[] cells = new boolean[grid.cells() * grid.cells()];
            for (int row = 0; row < grid.cells(); row++) {
                Workers.checkInterrupted();
                for (int column = 0; column < grid.cells(); column++) {
                    int cell = row * grid.cells() + column;
                    Optional<Drone> there = comingFrom(column, row);
                    cells[cell] = there.isPresent()
                            && sensor.observe(world, List.of(there.get()), look(cell, there.get()))
                                    .get(0)
                                    .isDetected();
                }
                progress.accept(grid.cells());
            }
            return cells;
        }

        Optional<Assessment> assess(int column, int row) {
            return comingFrom(column, row).map(there -> {
                Look look = look(row * grid.cells() + column, there);
                return assessor.assess(there, look.pointing(), look.random(there.id(), RaySensor.RAYS));
            });
        }

        Optional<Explanation> explain(int column, int row) {
            return comingFrom(column, row).map(there -> assessor.explainMiss(there, turnedTo(there)));
        }

        private Look look(int cell, Drone there) {
            return Look.of(seed, id, cell, 0.0).withPointing(turnedTo(there));
        }

        private Optional<Pointing> turnedTo(Drone there) {
            return Mounted.turnedTo(settings, Position.of(there.position()));
        }

        /** The drone in a cell; empty where there is no ground. */
        private Optional<Drone> comingFrom(int column, int row) {
            double ground = heights.height[row * grid.cells() + column];
            if (Double.isNaN(ground)) {
                return Optional.empty();
            }
            Position place = new Position(grid.x(column), grid.y(row), ground + grid.height());
            Position way = settings.position().minus(place);
            double length = Math.max(way.length(), Double.MIN_NORMAL);
            Position velocity = way.times(drone.settings().speed() / length);
            return Optional.of(drone.at(new FlightState(place, velocity, Math.atan2(way.x(), way.y()))));
        }
    }
}
