package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/** Assesses looks, and repeats this with other rays where the result depends on them. */
final class LookEstimates {
    /**
     * The least number of estimates of a level that depends on its rays, unless one estimate of each look is enough.
     * They are counted: rare rays make levels so skewed that a normal distribution of the same mean and deviation is
     * off by ten points.
     */
    private static final int LEVELS = 64;

    /** The greatest number of estimates of a look that one thread makes at a time. */
    private static final int TOGETHER = 16;

    private final List<String> names;
    private final List<SensorSettings<?>> sensors;
    private final World world;

    /** Some estimates of one look, beginning with the one of a given number. */
    private record Part(int look, int first, int count) {}

    LookEstimates(List<String> names, List<SensorSettings<?>> sensors, World world) {
        this.names = names;
        this.sensors = sensors;
        this.world = world;
    }

    /**
     * Assesses looks, on the {@link Workers} of the calling thread.
     *
     * @param estimates number of assessments where the level model estimates a probability. If there is only one, each
     *     look is assessed once
     */
    List<ScheduledLook> of(List<ScheduledLook> taken, int estimates) {
        ScheduledLook[] once = new ScheduledLook[taken.size()];
        Workers.forEach(taken.size(), this::assessors, (assessors, i) -> {
            ScheduledLook look = taken.get(i);
            once[i] = look.with(RayEstimate.first(assess(assessors, look, 0)));
        });
        int[] counts = Arrays.stream(once)
                .mapToInt(look -> look.estimate().isLevel() ? LEVELS : estimates)
                .toArray();
        return estimates > 1 ? more(List.of(once), counts) : List.of(once);
    }

    /**
     * Repeats the assessment of looks that depend on their rays, on the {@link Workers} of the calling thread.
     *
     * @param counts for each look, the minimum number of estimates
     */
    List<ScheduledLook> more(List<ScheduledLook> looks, int[] counts) {
        List<Part> parts = new ArrayList<>();
        for (int i = 0; i < counts.length; i++) {
            RayEstimate estimate = looks.get(i).estimate();
            for (int from = estimate.count(); estimate.isRandom() && from < counts[i]; from += TOGETHER) {
                parts.add(new Part(i, from, Math.min(TOGETHER, counts[i] - from)));
            }
        }
        RayEstimate[] theirs = new RayEstimate[parts.size()];
        Workers.forEach(theirs.length, this::assessors, (assessors, i) -> {
            Part part = parts.get(i);
            ScheduledLook look = looks.get(part.look());
            theirs[i] = IntStream.range(part.first(), part.first() + part.count())
                    .mapToObj(estimate -> RayEstimate.one(assess(assessors, look, estimate)))
                    .reduce(RayEstimate::and)
                    .orElseThrow();
        });
        List<ScheduledLook> estimated = new ArrayList<>(looks);
        for (int i = 0; i < theirs.length; i++) {
            ScheduledLook look = estimated.get(parts.get(i).look());
            estimated.set(parts.get(i).look(), look.with(look.estimate().and(theirs[i])));
        }
        return estimated;
    }

    private Assessor[] assessors() {
        return new Assessor[sensors.size()];
    }

    /** Makes an estimate: the first one with the rays of the look itself, the others with those of other seeds. */
    private Assessment assess(Assessor[] assessors, ScheduledLook look, int estimate) {
        int sensor = look.number();
        if (assessors[sensor] == null) {
            assessors[sensor] = new Assessor(names.get(sensor), sensors.get(sensor), world);
        }
        Look its = look.look();
        long seed = Draws.derivedSeed(its.seed(), "estimate", estimate);
        String drone = look.drone().id();
        return assessors[sensor].assess(
                look.drone(), its.pointing(), Draws.stream(seed, its.sensor(), drone, its.index(), RaySensor.RAYS));
    }
}
