package org.dronewatch.sensor.alarm;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;

/**
 * The false alarms of one sensor during a run. Those that begin in a look are drawn from a stream that depends only on
 * the seed, the sensor's name and the index of the look, so that they neither depend on drones and other sensors nor
 * affect their random numbers. A false alarm that lasts for several looks keeps its cell in the field of view. Looks
 * must be given in order. For use by one thread at a time.
 */
public final class FalseAlarmSource {
    /** The purpose of the random numbers that are drawn for false alarms. */
    public static final String PURPOSE = "false";

    /**
     * The name of the figure that holds the cell of a false alarm: its index, from 0. False alarms of a sensor in the
     * same cell are one contact. Sensors from other jars may provide this figure, too.
     */
    public static final String CELL = "cell";

    /** The name of the figure that is 1 for a false alarm that began in an earlier look. */
    public static final String CONTINUED = "continued";

    /** Numbers with a larger mean are drawn in parts, since {@code exp(-mean)} must not underflow to 0. */
    private static final double LARGEST_MEAN = 30.0;

    private final SensorSettings<?> settings;
    private final FalseAlarmRate rate;
    private final int dimensions;
    private final List<Alarm> lasting = new ArrayList<>();
    private boolean begun;

    private FalseAlarmSource(SensorSettings<?> settings, FalseAlarming capability, FalseAlarmRate rate) {
        this.settings = settings;
        this.rate = rate;
        this.dimensions = capability.dimensions();
    }

    /**
     * The source of a sensor's false alarms; empty for a sensor that raises none, or whose rate is not known.
     *
     * @param settings settings of the sensor
     * @param weather weather of its site
     */
    public static Optional<FalseAlarmSource> of(SensorSettings<?> settings, Weather weather) {
        return settings.as(FalseAlarming.class).flatMap(capability -> capability
                .falseAlarmRate(weather)
                .filter(rate -> rate.perLook() > 0.0)
                .map(rate -> new FalseAlarmSource(settings, capability, rate)));
    }

    /** Whether an observation is a false alarm that no earlier look has reported. */
    public static boolean isNew(Observation observation) {
        return observation.isFalse() && !observation.figures().containsKey(CONTINUED);
    }

    /** The false alarms that the sensor reports in a look. */
    public List<Observation> observe(World world, Look look) {
        if (!begun) {
            begun = true;
            for (long before = look.index() - rate.looks() + 1; before < look.index(); before++) {
                begin(look, before);
            }
        }
        lasting.removeIf(alarm -> alarm.began <= look.index() - rate.looks());
        begin(look, look.index());
        if (lasting.isEmpty()) {
            return List.of();
        }
        FalseAlarming pointed = Mounted.pointed(settings, look.pointing())
                .as(FalseAlarming.class)
                .orElseThrow();
        LookId id = look.id(settings.kind());
        return lasting.stream().map(alarm -> alarm.seen(world, id, pointed)).toList();
    }

    /** Draws the false alarms that begin in a look. */
    private void begin(Look look, long index) {
        RandomGenerator random = Draws.stream(look.seed(), look.sensor(), "", index, PURPOSE);
        int count = poisson(rate.perLook(), random);
        for (int i = 0; i < count; i++) {
            long cell = random.nextLong(rate.cells());
            double[] point = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
            CellGrid.locate(cell, rate.cells(), dimensions, point);
            lasting.add(new Alarm(cell, index, point, -Math.log1p(-random.nextDouble())));
        }
    }

    /**
     * A Poisson-distributed number, drawn by adding up probabilities until they exceed a uniformly distributed number.
     */
    static int poisson(double mean, RandomGenerator random) {
        int pieces = Math.max(0, (int) Math.ceil(mean / LARGEST_MEAN) - 1);
        int count = 0;
        for (int i = 0; i < pieces; i++) {
            count += small(LARGEST_MEAN, random);
        }
        return count + small(mean - pieces * LARGEST_MEAN, random);
    }

    private static int small(double mean, RandomGenerator random) {
        double uniform = random.nextDouble();
        double term = Math.exp(-mean);
        double sum = term;
        int count = 0;
        while (uniform >= sum && term > 0.0) {
            count++;
            term *= mean / count;
            sum += term;
        }
        return count;
    }

    private record Alarm(long cell, long began, double[] point, double excess) {
        Observation seen(World world, LookId look, FalseAlarming sensor) {
            Map<String, Double> figures = new LinkedHashMap<>();
            figures.put(CELL, (double) cell);
            // An alarm that began before the run is new to anyone who watches the run.
            if (began < look.index() && look.index() > 0) {
                figures.put(CONTINUED, 1.0);
            }
            return Observation.ofNothing(
                            look,
                            sensor.falseReading(world, excess),
                            sensor.falseSighting(point[0], point[1], point[2]))
                    .withFigures(figures);
        }
    }
}
