package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.World;

/**
 * The energy model. Deterministic paths come from {@link ExactPaths}. The rest is found by tracing rays backward from
 * the sensor: they reach what the sensor can hear, however far away the source is, and by reciprocity the fraction of
 * their energy that reaches the source is the fraction that the source would have sent to the sensor. Singly scattered
 * paths are also sampled from the source.
 *
 * <p>Rays are traced in batches, on the calling {@link Workers}. Each batch has a separate random stream, and batches
 * count in their order up to the one that makes the reading accurate: the reading is the same for any number of
 * threads. Used by one caller at a time.
 */
public final class EnergyTracer {
    /** Rays before the first check of the standard error, which is unreliable for a few. */
    private static final int FEWEST = 1000;

    /**
     * Rays from one check of the standard error to the next: stopping at the earliest opportunity would favour low
     * values.
     */
    private static final int BATCH = 500;

    private final EnergyModel model;
    private final Clearance clearance;
    private final Position sensor;
    private final Air air;
    private final ExactPaths exact;
    private final EnergyTally tally;
    private final EnergyLedger ledger = new EnergyLedger();
    private final Supplier<RayBatch> batches;

    /** One for each batch that is traced at the same time. */
    private final List<RayBatch> team = new ArrayList<>();

    /**
     * A tracer to one sensor.
     *
     * @param sensor where it is, m; just in front of a surface that it lies on
     * @param radius of the sphere about the source in which specularly reflected rays are counted, m
     */
    public EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        BandSurfaces surfaces = new BandSurfaces(world.surfaces());
        WallPlanes planes = new WallPlanes(world.mesh(), surfaces);
        this.model = model;
        this.clearance = new Clearance(world);
        this.sensor = clearance.of(sensor);
        this.air = new Air(world.atmosphere());
        this.exact = new ExactPaths(model, world, planes, surfaces, air);
        this.tally = new EnergyTally(air);
        this.batches = () -> new RayBatch(model, this.sensor, radius, world, planes, surfaces, air);
    }

    /**
     * One look.
     *
     * @param drone the drone's sound
     * @param random the random numbers of the rays
     * @param recorder receives every segment of every ray that counts, from the sensor on
     */
    public EnergyReading trace(SoundSource drone, RandomGenerator random, RayRecorder recorder) {
        SoundSource source = drone.at(clearance.of(drone.position()));
        ledger.clear();
        tally.clear();
        exact.find(source, sensor);
        long seed = random.nextLong();
        // A recorder takes one segment at a time.
        int atOnce = recorder == RayRecorder.NONE ? Workers.available() : 1;
        while (team.size() < atOnce) {
            team.add(batches.get());
        }
        long traced = 0;
        int from = 0;
        while (from < model.rays() && !isAccurate(from)) {
            int first = from;
            int wave = Math.min(atOnce, (model.rays() - first + BATCH - 1) / BATCH);
            Workers.forEach(wave, i -> {
                int start = first + i * BATCH;
                int count = Math.min(BATCH, model.rays() - start);
                team.get(i).trace(source, count, new SplittableRandom(Draws.mix(seed, start)), recorder);
            });
            for (int i = 0; i < wave && !isAccurate(from); i++) {
                RayBatch batch = team.get(i);
                tally.add(batch.tally());
                ledger.add(batch.ledger());
                traced += batch.traced();
                from = Math.min(from + BATCH, model.rays());
            }
        }
        return reading(source, traced);
    }

    /**
     * What would be heard in the free field, without obstructions and reflections: spreading and air alone. Exact.
     *
     * @param drone the drone's sound
     */
    public EnergyReading inTheOpen(SoundSource drone) {
        SoundSource source = drone.at(clearance.of(drone.position()));
        double[] heard = exact.inTheOpen(source, sensor);
        List<Double> nothing = Collections.nCopies(OctaveBands.COUNT, 0.0);
        EnergyAudit unsent = new EnergyAudit(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        return new EnergyReading(
                energies(source, band -> heard[band]), nothing, nothing, nothing, 0, 0.0, unsent, new DecayCurve());
    }

    /** As long as no ray has contributed anything, the contribution of further rays is unknown. */
    private boolean isAccurate(int rays) {
        return rays >= FEWEST && tally.received() > 0.0 && errorLevel() < model.accuracy();
    }

    /** Standard error of the total level so far, dB; infinity as long as nothing is heard. */
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
                ledger.audit(tally.rays()),
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
