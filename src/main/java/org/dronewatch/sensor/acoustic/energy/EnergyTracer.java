package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.EnergyModel;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The energy model. {@link ExactPaths} finds what needs no chance. The rest is found by rays that run backward, from the
 * sensor: what they meet is what the sensor can hear, however far away the source is, and by reciprocity the share of the
 * energy that they bring to the source is the share that the source would have sent to the sensor. What is scattered once
 * only is looked for from the source, too. One per thread.
 */
public final class EnergyTracer {
    /** Rays before the first look at the standard error, which a few may deceive, and from one look to the next. */
    private static final int FEWEST = 1000;

    private static final int BATCH = 500;

    private final EnergyModel model;
    private final Position sensor;
    private final Air air;
    private final ExactPaths exact;
    private final EnergyTally tally;
    private final RayJourney journey;
    private final FirstScattering firstScattering;
    private final EnergyBooks books = new EnergyBooks();

    /**
     * A tracer to one sensor.
     *
     * @param sensor where it is, m
     * @param radius of the ball about the source in which rays from mirrors are counted, m
     */
    public EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        BandSurfaces surfaces = new BandSurfaces(world.surfaces());
        WallPlanes planes = new WallPlanes(world.mesh(), surfaces);
        this.model = model;
        this.sensor = sensor;
        this.air = new Air(world.atmosphere());
        this.exact = new ExactPaths(model, world, planes, surfaces, air);
        this.tally = new EnergyTally(air);
        this.journey = new RayJourney(model, sensor, radius, world, planes, surfaces, air, tally, books);
        this.firstScattering = new FirstScattering(world, surfaces, air, tally);
    }

    /**
     * One look.
     *
     * @param source the drone's sound
     * @param random the random numbers of the rays
     * @param recorder is told every piece of every ray, from the sensor on
     */
    public EnergyReading trace(SoundSource source, RandomGenerator random, RayRecorder recorder) {
        books.clear();
        tally.clear();
        exact.find(source, sensor);
        long traced = 0;
        for (int i = 0; i < model.rays() && !isAccurate(i); i++) {
            traced += journey.follow(source, random, recorder);
            // What the source's rays find has met one surface, too.
            traced += model.maxOrder() > 0 ? firstScattering.add(source, sensor, random) : 0;
            tally.endRay();
        }
        return reading(source, traced);
    }

    /**
     * Looks now and then only: to stop at the first chance prefers low values. As long as no ray has brought anything,
     * nothing is known of what they might bring.
     */
    private boolean isAccurate(int rays) {
        return rays >= FEWEST && rays % BATCH == 0 && tally.received() > 0.0 && errorLevel() < model.accuracy();
    }

    /** Standard error of the level of all that is heard so far, dB; infinity as long as that is nothing. */
    private double errorLevel() {
        double all = exact.heard() + tally.received();
        return all > 0.0 ? Levels.ofRatio(1.0 + tally.standardError() / all) : Double.POSITIVE_INFINITY;
    }

    private EnergyReading reading(SoundSource source, long traced) {
        List<Double> direct = energies(source, exact.direct()::heard);
        List<Double> diffracted = energies(source, exact.diffracted()::heard);
        List<Double> mirrored = energies(source, exact.mirrored()::heard);
        List<Double> reverberant = energies(source, tally::received);
        double error = errorLevel();
        DecayCurve decay = tally.decay();
        exact.direct().addTo(decay, air.soundSpeed());
        exact.diffracted().addTo(decay, air.soundSpeed());
        exact.mirrored().addTo(decay, air.soundSpeed());
        return new EnergyReading(
                direct,
                diffracted,
                mirrored,
                reverberant,
                traced,
                Double.isFinite(error) ? error : 0.0,
                books.audit(tally.rays()),
                decay);
    }

    /** Energies over that of 20 uPa, from intensities over the source's power. */
    private static List<Double> energies(SoundSource source, IntToDoubleFunction intensities) {
        List<Double> energies = new ArrayList<>(OctaveBands.COUNT);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energies.add(intensities.applyAsDouble(band) * source.emitted());
        }
        return energies;
    }
}
