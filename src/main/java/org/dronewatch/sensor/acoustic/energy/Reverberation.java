package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.RayRecorder;

/**
 * The reverberation time of sound from a drone at a microphone: groups of rays are traced until its standard error is
 * small, estimated by the jackknife over the groups (Tukey 1958; Efron and Stein, Annals of Statistics 9, 1981).
 */
final class Reverberation {
    /** Number of rays of one group. */
    private static final int RAYS = 2_000;

    private static final int FEWEST_GROUPS = 10;
    private static final int MOST_GROUPS = 30;

    /** Groups are added until the relative standard error of the reverberation time is below this. */
    private static final double ACCURATE = 0.02;

    /** Fraction of its initial energy down to which every ray is followed: late sound is faint. */
    private static final double PATIENCE = 1e-4;

    private final List<DecayCurve> groups = new ArrayList<>();
    private double escaped;

    /**
     * A reverberation time.
     *
     * @param seconds reverberation time T30, s
     * @param error its standard error, s
     */
    record Time(double seconds, double error) {}

    /**
     * Measures the reverberation time.
     *
     * @param most fraction of the sound that may leave the site: if more does, one group is enough
     */
    static Reverberation measure(EnergyTracer tracer, SoundSource drone, RandomGenerator random, double most) {
        Reverberation found = new Reverberation();
        while (found.groups.size() < MOST_GROUPS && !found.isKnown() && found.escaped <= most) {
            EnergyReading reading = tracer.trace(drone, random, RayRecorder.NONE);
            found.groups.add(reading.decay());
            found.escaped = reading.audit().escaped();
        }
        return found;
    }

    /** A model with which every ray is followed for long enough to {@link #measure} the reverberation time. */
    static EnergyModel patient(EnergyModel model) {
        return model.withRays(RAYS)
                .withRoulette(Math.min(model.roulette(), PATIENCE))
                .withAccuracy(0.0);
    }

    private boolean isKnown() {
        if (groups.size() < FEWEST_GROUPS) {
            return false;
        }
        return time(DecayCurve::t30)
                .map(time -> time.error() <= ACCURATE * time.seconds())
                .orElse(true);
    }

    /** The fraction of the sound that leaves the site. */
    double escaped() {
        return escaped;
    }

    /** The mean of all groups. */
    DecayCurve decay() {
        DecayCurve sum = new DecayCurve();
        groups.forEach(sum::add);
        return sum;
    }

    /** The reverberation time of all bands; empty if the decay does not reach far enough. */
    Optional<Time> time() {
        return time(DecayCurve::t30);
    }

    /** The reverberation time of a band, from 0 for 63 Hz. */
    Optional<Time> time(int band) {
        return time(decay -> decay.t30(band));
    }

    private Optional<Time> time(Function<DecayCurve, OptionalDouble> t30) {
        DecayCurve all = decay();
        OptionalDouble whole = t30.apply(all);
        if (whole.isEmpty() || groups.size() < 2) {
            return Optional.empty();
        }
        int count = groups.size();
        double[] without = new double[count];
        double mean = 0.0;
        for (int i = 0; i < count; i++) {
            OptionalDouble rest = t30.apply(all.without(groups.get(i)));
            if (rest.isEmpty()) {
                return Optional.empty();
            }
            without[i] = rest.getAsDouble();
            mean += without[i] / count;
        }
        double squares = 0.0;
        for (double time : without) {
            squares += (time - mean) * (time - mean);
        }
        return Optional.of(new Time(whole.getAsDouble(), Math.sqrt((count - 1.0) / count * squares)));
    }
}
