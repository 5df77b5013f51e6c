package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.ExcessMap;
import org.dronewatch.analysis.layer.FieldProbe;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.layer.SensorLayer;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;

/**
 * The warnings that the sensors give of a drone that flies straight in at its cruise speed, from every bearing and at
 * several heights above the ground, to the centre of the grid's area or, if it has none, the centre of the protected
 * zone; without either, to the mean position of the sensors. The drone is detected where a sensor covers it; it is
 * assessed once per cell of its path, but not inside something solid. If the terms give a sensor some time in which to
 * detect the drone, the drone counts as detected that long after the first point at which a sensor covers it.
 * Immutable.
 *
 * @param target point towards which the drone flies, m
 * @param reach horizontal distance from that point at which the flight begins, m
 * @param longest the longest warning time that can be found, that of a flight detected where it begins, s; 0 if none
 *     can be found
 * @param response the time that is required between detection and arrival, s; 0 if none is required
 * @param isZone whether there is a protected zone
 * @param all the warnings by height, then bearing
 */
public record InboundWarnings(
        Position target, double reach, double longest, double response, boolean isZone, List<Warning> all) {
    /** The number of bearings. */
    public static final int BEARINGS = InboundFlights.BEARINGS;

    /** Copies the list: later changes by the caller have no effect. */
    public InboundWarnings {
        all = List.copyOf(all);
    }

    /** The number of flights for which it is unknown whether the required response time is met. */
    public long undecided() {
        return all.stream().filter(one -> one.isUndecided(response)).count();
    }

    /** The number of flights for which the required response time is not met. */
    public long late() {
        return all.stream().filter(one -> one.isLate(response)).count();
    }

    /**
     * The warnings of the enabled sensors of a scene, on the {@link Workers} of the calling thread; the result does not
     * depend on their number. Flights begin half a side of the grid away from their target; if the grid is that of an
     * area, 250 m beyond its farthest corner. Where that is too near for a detection to leave the required response
     * time, they begin farther away, but not beyond the model of the site, and they cross at most 2000 cells. If any
     * flight would begin in a protected zone, all flights begin 250 m beyond the farthest corner of all zones.
     *
     * @param drone name of the drone
     * @param terms terms on which the drone counts as detected
     * @param covered the probability with which a sensor has to detect the drone
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
        return of(settings, stage, drone, grid, terms, covered, LayerStore.NONE, sensor -> Optional.empty(), progress);
    }

    /**
     * The warnings of the enabled sensors of a scene; only what is not yet in the store is assessed.
     *
     * @param store store of earlier assessments
     */
    public static InboundWarnings of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            FieldTerms terms,
            double covered,
            LayerStore store,
            IntConsumer progress) {
        return of(settings, stage, drone, grid, terms, covered, store, sensor -> Optional.empty(), progress);
    }

    /**
     * The warnings of the enabled sensors of a scene, with signals that may be interpolated between cells.
     *
     * @param store store of earlier assessments, of the same grid
     * @param excess what is interpolated between cells in the area of the grid, by the name of a sensor
     */
    public static InboundWarnings of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            FieldTerms terms,
            double covered,
            LayerStore store,
            Function<String, Optional<ExcessMap>> excess,
            IntConsumer progress) {
        InboundFlights flights = InboundFlights.of(settings, stage, drone, grid, terms);
        Drone sample = DetectionField.droneOf(stage, drone);
        double speed = sample.settings().speed();
        double delay = terms.within().orElse(0.0) * speed;
        int needed = ProbabilityStep.toCover(covered);
        List<SensorLayer> layers =
                layers(settings, stage, sample, flights, terms, delay, needed, store, excess, progress);
        List<Warning> all = new ArrayList<>();
        double longest = 0.0;
        for (int height = 0; height < grid.heights().size(); height++) {
            for (int bearing = 0; bearing < BEARINGS; bearing++) {
                double arrival = flights.arrival(bearing, stage.protection());
                First first = First.of(layers, flights, height, bearing, arrival + delay, needed);
                all.add(first.warning(bearing, grid.heights().get(height), arrival, delay, speed));
                longest = Math.max(longest, (flights.reach() - delay - arrival) / speed);
            }
        }
        return new InboundWarnings(
                flights.target(),
                flights.reach(),
                longest,
                settings.alert().response(),
                !stage.protection().isEmpty(),
                all);
    }

    private static List<SensorLayer> layers(
            SceneSettings settings,
            Stage stage,
            Drone sample,
            InboundFlights flights,
            FieldTerms terms,
            double delay,
            int needed,
            LayerStore store,
            Function<String, Optional<ExcessMap>> excess,
            IntConsumer progress) {
        int heights = flights.heights().size();
        int[][] last = flights.lastSteps(stage.protection(), delay);
        List<SensorLayer> layers = new ArrayList<>();
        List<Map.Entry<String, SensorSettings<?>>> sensors =
                new ArrayList<>(settings.enabledSensors().entrySet());
        // Sensors that trace sound cost most by far: they need not listen where others have already detected the drone.
        sensors.sort(Comparator.comparing(
                sensor -> sensor.getValue().as(SoundTracing.class).isPresent()));
        for (Map.Entry<String, SensorSettings<?>> sensor : sensors) {
            FieldColumns paths =
                    new FieldColumns(stage.world(), flights.steps(), BEARINGS, heights, flights.upTo(last));
            FieldProbe probe = new FieldProbe(
                            stage.world(),
                            sample,
                            sensor.getKey(),
                            sensor.getValue(),
                            settings.run().seed(),
                            List.of(Course.inbound(flights.target())),
                            terms)
                    .with(excess.apply(sensor.getKey()))
                    .deciding(needed);
            SensorLayer layer = SensorLayer.empty(paths);
            for (int height = 0; height < paths.levels(); height++) {
                store.assess(layer, probe, paths, flights.toString(), height, "inbound " + height, progress);
            }
            layers.add(layer);
            shorten(last, layer, needed);
        }
        return layers;
    }

    /** What comes after the first detection by a sensor does not matter for the others. */
    private static void shorten(int[][] last, SensorLayer layer, int needed) {
        for (int height = 0; height < last.length; height++) {
            for (int bearing = 0; bearing < BEARINGS; bearing++) {
                for (int step = 0; step < last[height][bearing]; step++) {
                    if (layer.step(height, step, bearing, 0) >= needed) {
                        last[height][bearing] = step;
                    }
                }
            }
        }
    }

    /**
     * Where a drone is first detected.
     *
     * @param range horizontal distance from the target, m; empty if it is not detected before its last chance
     * @param isFromStart whether no earlier point of the flight is known to be a miss
     */
    private record First(OptionalDouble range, boolean isFromStart) {
        static First of(
                List<SensorLayer> layers, InboundFlights flights, int height, int bearing, double last, int needed) {
            boolean isFromStart = true;
            for (int step = 0; step < flights.steps() && flights.distance(step) > last; step++) {
                boolean isKnown = true;
                for (SensorLayer layer : layers) {
                    if (layer.step(height, step, bearing, 0) >= needed) {
                        return new First(OptionalDouble.of(flights.distance(step)), isFromStart);
                    }
                    isKnown &= layer.cause(height, step, bearing, 0) != Cause.UNKNOWN;
                }
                isFromStart &= !isKnown;
            }
            return new First(OptionalDouble.empty(), false);
        }

        Warning warning(int bearing, double height, double arrival, double delay, double speed) {
            double angle = InboundFlights.angle(bearing);
            if (range.isEmpty()) {
                return new Warning(angle, height, arrival, range, range, false);
            }
            double detected = range.getAsDouble() - delay;
            return new Warning(
                    angle,
                    height,
                    arrival,
                    OptionalDouble.of(detected),
                    OptionalDouble.of((detected - arrival) / speed),
                    isFromStart);
        }
    }
}
