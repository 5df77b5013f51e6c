package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.GroundPoint;

/**
 * The warning that the sensors give of a drone that flies straight in, from every bearing and at several heights above
 * the ground, to the middle of the protected zone or, without one, of the sensors, at its cruise speed. The drone is
 * detected where a sensor covers it; it is assessed once per cell of its path, but not inside something solid. Where a
 * sensor has some time to detect it, it counts as detected that time after the first place at which a sensor covers it.
 * Immutable.
 *
 * @param target point towards which the drone flies, m
 * @param reach horizontal distance from that point at which the flight begins, m
 * @param response the time that is required after a detection, s; 0 if none is
 * @param isZone whether there is a protected zone
 * @param all by height, then bearing
 */
public record InboundWarnings(Position target, double reach, double response, boolean isZone, List<Warning> all) {
    /** The number of bearings. */
    public static final int BEARINGS = 36;

    /** How far beyond the farthest corner of an area or zone flights begin, m: half the default side of a grid. */
    private static final double BEYOND = 250.0;

    /** How accurately the entry into a zone is found, m. */
    private static final double ACCURACY = 1e-3;

    /** Into how many steps a flight is divided to find where it enters a zone. */
    private static final int STEPS = 4000;

    /** Copies the list: later changes by the caller have no effect. */
    public InboundWarnings {
        all = List.copyOf(all);
    }

    /**
     * The warnings of the enabled sensors of a scene, on the {@link Workers} of the calling thread; the same for any
     * number of them. Flights begin half a side of the grid away from their target; if the grid is that of an area,
     * 250 m beyond its farthest corner; if any of them would begin in a protected zone, 250 m beyond the farthest
     * corner of all zones.
     *
     * @param drone name of the drone
     * @param terms on which it counts as detected
     * @param covered the probability with which a sensor has to detect it
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     */
    public static InboundWarnings of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            FieldTerms terms,
            double covered,
            IntConsumer progress) {
        return of(settings, stage, drone, grid, terms, covered, LayerStore.NONE, progress);
    }

    /**
     * The same.
     *
     * @param store of assessments that were made before
     */
    static InboundWarnings of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            FieldTerms terms,
            double covered,
            LayerStore store,
            IntConsumer progress) {
        Position target = InboundTarget.of(settings, stage.protection(), grid);
        Drone sample = DetectionField.droneOf(stage, drone);
        Flights flights = new Flights(target, reach(grid, target, stage.protection()), grid.cell(), grid.heights());
        List<SensorLayer> layers = layers(settings, stage, sample, flights, terms, store.about(grid), progress);
        double delay = terms.within().orElse(0.0) * sample.settings().speed();
        int needed = CellCode.stepsToCover(covered);
        List<Warning> all = new ArrayList<>();
        for (int height = 0; height < grid.heights().size(); height++) {
            for (int bearing = 0; bearing < BEARINGS; bearing++) {
                double arrival = arrival(flights, bearing, stage.protection());
                OptionalDouble range = firstDetection(layers, flights, height, bearing, arrival + delay, needed);
                all.add(new Warning(
                        angle(bearing),
                        grid.heights().get(height),
                        arrival,
                        range.isPresent() ? OptionalDouble.of(range.getAsDouble() - delay) : range,
                        range.isPresent()
                                ? OptionalDouble.of((range.getAsDouble() - delay - arrival)
                                        / sample.settings().speed())
                                : OptionalDouble.empty()));
            }
        }
        return new InboundWarnings(
                target,
                flights.reach(),
                settings.alert().response(),
                !stage.protection().isEmpty(),
                all);
    }

    private static List<SensorLayer> layers(
            SceneSettings settings,
            Stage stage,
            Drone sample,
            Flights flights,
            FieldTerms terms,
            LayerStore store,
            IntConsumer progress) {
        FieldColumns paths = new FieldColumns(
                stage.world(), flights.steps(), BEARINGS, flights.heights().size(), flights);
        List<SensorLayer> layers = new ArrayList<>();
        for (Map.Entry<String, SensorSettings<?>> sensor :
                settings.enabledSensors().entrySet()) {
            FieldProbe probe = new FieldProbe(
                    stage.world(),
                    sample,
                    sensor.getKey(),
                    sensor.getValue(),
                    settings.run().seed(),
                    List.of(Course.inbound(flights.target())),
                    terms);
            SensorLayer layer = SensorLayer.empty(paths);
            for (int height = 0; height < paths.levels(); height++) {
                store.assess(layer, probe, paths, flights.toString(), height, "inbound " + height, progress);
            }
            layers.add(layer);
        }
        return layers;
    }

    /** The distance at which flights begin, m. */
    private static double reach(FieldGrid grid, Position target, Protection protection) {
        double asked =
                grid.area().map(area -> beyond(target, area.outline().stream())).orElse(0.5 * grid.side());
        for (int bearing = 0; bearing < BEARINGS; bearing++) {
            if (protection.distance(at(target, asked, bearing)) == 0.0) {
                double sphere = protection
                        .zone()
                        .map(ball -> Math.ceil(BEYOND + horizontally(target, ball.centre()) + ball.radius()))
                        .orElse(0.0);
                return Math.max(
                        sphere, beyond(target, protection.areas().stream().flatMap(area -> area.outline().stream())));
            }
        }
        return asked;
    }

    private static double beyond(Position target, Stream<GroundPoint> corners) {
        return Math.ceil(BEYOND
                + corners.mapToDouble(corner -> Math.hypot(corner.x() - target.x(), corner.y() - target.y()))
                        .max()
                        .orElse(0.0));
    }

    private static double horizontally(Position a, Position b) {
        return Math.hypot(a.x() - b.x(), a.y() - b.y());
    }

    /** A place of a flight in plan view, at the height of the target. */
    private static Position at(Position target, double distance, int bearing) {
        return new Position(
                target.x() + distance * StrictMath.sin(angle(bearing)),
                target.y() + distance * StrictMath.cos(angle(bearing)),
                target.z());
    }

    /**
     * How many cells a sensor looks at.
     *
     * @param target as in {@link #of}
     * @param protection the protected zones
     */
    static long cells(FieldGrid grid, Position target, Protection protection) {
        Flights flights = new Flights(target, reach(grid, target, protection), grid.cell(), grid.heights());
        return (long) flights.steps() * BEARINGS * grid.heights().size();
    }

    private static double angle(int bearing) {
        return 2.0 * Math.PI * bearing / BEARINGS;
    }

    private static OptionalDouble firstDetection(
            List<SensorLayer> layers, Flights flights, int height, int bearing, double last, int needed) {
        for (int step = 0; step < flights.steps() && flights.distance(step) > last; step++) {
            for (SensorLayer layer : layers) {
                if (layer.steps(height, step, bearing, 0) >= needed) {
                    return OptionalDouble.of(flights.distance(step));
                }
            }
        }
        return OptionalDouble.empty();
    }

    /** Where a flight enters a zone, whatever its height: its horizontal distance from the target, m. */
    private static double arrival(Flights flights, int bearing, Protection protection) {
        if (protection.isEmpty()) {
            return 0.0;
        }
        double outside = flights.reach();
        for (int step = 0; step <= STEPS; step++) {
            double distance = flights.reach() * (STEPS - step) / STEPS;
            if (protection.distance(flights.at(distance, bearing)) == 0.0) {
                return entry(flights, bearing, protection, distance, outside);
            }
            outside = distance;
        }
        return 0.0;
    }

    private static double entry(Flights flights, int bearing, Protection protection, double inside, double outside) {
        double low = inside;
        double high = outside;
        while (high - low > ACCURACY) {
            double middle = 0.5 * (low + high);
            if (protection.distance(flights.at(middle, bearing)) == 0.0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** The plan of all flights: a row for each bearing, a column for each step inward. */
    private record Flights(Position target, double reach, double step, List<Double> heights)
            implements FieldColumns.Plan {
        int steps() {
            return (int) Math.floor(reach / step) + 1;
        }

        double distance(int number) {
            return Math.max(0.0, reach - number * step);
        }

        Position at(double distance, int bearing) {
            return InboundWarnings.at(target, distance, bearing);
        }

        @Override
        public double x(int column, int row) {
            return at(distance(column), row).x();
        }

        @Override
        public double y(int column, int row) {
            return at(distance(column), row).y();
        }

        @Override
        public double above(int level, int column, int row) {
            return heights.get(level);
        }
    }
}
