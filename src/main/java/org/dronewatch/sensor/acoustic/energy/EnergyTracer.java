package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathBending;
import org.dronewatch.sensor.acoustic.tone.HeardTone;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.World;

/**
 * The tracer of the energy model. Deterministic paths are computed without random rays. Other paths are found by
 * tracing rays backward from the sensor: the efficiency of this method does not depend on the distance of the source,
 * and by reciprocity, the fraction of the rays' energy that reaches the source is the fraction that the source would
 * have sent to the sensor. The first few surfaces of a path from the source are also sampled by rays from the source,
 * and the two parts of a path are connected. If the source is in a more sheltered position than the sensor, source and
 * sensor exchange roles.
 *
 * <p>Rays are traced in batches, on the {@link Workers} of the calling thread. Each batch has a separate random stream,
 * and batches are counted in order up to the one that makes the reading accurate enough: the reading is the same for
 * any number of threads. For use by one caller at a time.
 */
public final class EnergyTracer {
    /**
     * Number of rays before the first check of the standard error, which is unreliable for a few rays. The next check
     * is a whole batch later: stopping at the earliest opportunity would favour low values.
     */
    static final int FEWEST = 1000;

    /** Characteristic impedance at which levels of sound pressure and of intensity are equal, Pa s/m (ISO 1683). */
    private static final double REFERENCE_IMPEDANCE = 400.0;

    private final EnergyModel model;
    private BandLevels background;
    private final Clearance clearance;
    private final Position sensor;
    private final EndSearch search;
    private final Air air;
    private final PathBending bending;

    /** Squared sound pressure relative to that in the reference air. */
    private final double pressure;

    private final MissedRays missed;
    private final ExactPaths exact;
    private final EnergyTally tally;
    private final Convergence convergence;
    private final EnergyLedger ledger = new EnergyLedger();
    private final BatchTeams batches;

    /**
     * A tracer to one sensor.
     *
     * @param sensor position of the sensor, m; if it lies on a surface, a point just in front of that surface is used
     *     instead
     * @param radius radius of the sphere around the source in which specularly reflected rays are counted, m
     */
    public EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        BandSurfaces surfaces = new BandSurfaces(world.surfaces());
        WallPlanes planes = WallPlanes.of(world);
        this.model = model;
        this.background = world.backgroundNoise().spectrum();
        this.clearance = new Clearance(world);
        this.sensor = clearance.of(sensor);
        this.search = new EndSearch(model, this.sensor, radius, world, planes, surfaces);
        this.air = new Air(world.atmosphere());
        this.bending = new PathBending(world);
        this.pressure = model.pressure() == EnergyModel.Pressure.PHYSICAL
                ? world.atmosphere().impedance() / REFERENCE_IMPEDANCE
                : 1.0;
        this.missed = new MissedRays(radius, surfaces);
        this.exact = new ExactPaths(model, world, planes, surfaces, air);
        this.tally = new EnergyTally(air);
        this.convergence = new Convergence(tally, missed);
        this.batches = new BatchTeams(world, () -> new RayBatch(model, radius, world, planes, surfaces, air));
    }

    /**
     * Takes one look.
     *
     * @param drone the drone's sound
     * @param random the random numbers of the rays
     * @param recorder receives every segment of every ray in the batches that are counted, each ray from its start, and
     *     the straight path if sound arrives along it
     */
    public EnergyReading trace(SoundSource drone, RandomGenerator random, RayRecorder recorder) {
        SoundSource source = drone.at(clearance.of(drone.position()));
        ledger.clear();
        tally.clear();
        Ends ends = search.find(source, exact, bending.between(source.position(), sensor));
        missed.between(ends);
        convergence.begin(exact.isThroughWalls());
        recordStraight(ends, recorder);
        long seed = random.nextLong();
        // A recorder takes one segment at a time.
        int threads = recorder == RayRecorder.NONE ? Workers.available() : 1;
        int together = recorder == RayRecorder.NONE ? batches.mostTogether() : 1;
        long traced = 0;
        int from = 0;
        while (from < model.rays() && !isAccurate(source, from)) {
            int left = batches(model.rays() - from);
            int wave = Math.min(left, Math.max(threads, Math.min(threads * together, likely(source, from))));
            batches.trace(wave, threads, ends, seed, from, model.rays(), recorder);
            for (int i = 0; i < wave && !isAccurate(source, from); i++) {
                RayBatch batch = batches.get(i);
                tally.add(batch.tally());
                ledger.add(batch.ledger());
                traced += batch.traced();
                from = Math.min(from + BatchTeams.BATCH, model.rays());
            }
        }
        return reading(source, traced);
    }

    /** Records the straight path as a separate ray, if sound arrives along it. */
    private void recordStraight(Ends ends, RayRecorder recorder) {
        double arriving = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            arriving += exact.direct().heard(band);
        }
        if (arriving > 0.0) {
            Position from = ends.start();
            Position to = ends.target();
            double level = Levels.ofRatio(ends.source().emitted() / model.rays());
            recorder.record(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), level, 0, true);
        }
    }

    /** The number of batches that will make the reading accurate, as far as can be seen from the rays so far. */
    private int likely(SoundSource source, int rays) {
        if (!(model.accuracy() > 0.0)) {
            return Integer.MAX_VALUE;
        }
        if (rays < FEWEST) {
            return batches(FEWEST - rays);
        }
        int quantity = decisive(source);
        double heard = heard(quantity);
        double excess = convergence.drawnError(quantity, heard) / model.accuracy();
        double more = rays * (excess * excess - 1.0);
        return batches(more > 0.0 ? more : convergence.mostNeeded(quantity, heard) - rays);
    }

    private static int batches(double rays) {
        return (int) Math.ceil(rays / BatchTeams.BATCH);
    }

    /** Sets the noise against which sound must be detected: it determines which band is the best one. */
    void listenIn(BandLevels noise) {
        background = noise;
    }

    /**
     * The reading in the free field, without obstructions and reflections: sound only spreads and is absorbed by the
     * air. Exact.
     *
     * @param drone the drone's sound
     */
    public EnergyReading inTheOpen(SoundSource drone) {
        SoundSource source = drone.at(clearance.of(drone.position()));
        double[] heard = exact.inTheOpen(source, sensor);
        return withoutRays(source, band -> heard[band]);
    }

    /**
     * The reading of those paths that are found without any ray: the straight path, paths around edges, and the
     * specular reflections to which image sources of the sensor lead. Exact.
     *
     * @param drone the drone's sound
     */
    EnergyReading onExactPaths(SoundSource drone) {
        SoundSource source = drone.at(clearance.of(drone.position()));
        search.findWithoutSource(source, exact, bending.between(source.position(), sensor));
        return withoutRays(source, exact::heard);
    }

    private EnergyReading withoutRays(SoundSource source, IntToDoubleFunction intensities) {
        List<Double> nothing = Collections.nCopies(OctaveBands.COUNT, 0.0);
        EnergyAudit unsent = new EnergyAudit(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        return new EnergyReading(
                energies(source, intensities), nothing, nothing, nothing, 0, 0.0, true, unsent, new DecayCurve());
    }

    private boolean isAccurate(SoundSource source, int rays) {
        if (rays < FEWEST) {
            return false;
        }
        int quantity = decisive(source);
        return convergence.isAccurate(quantity, heard(quantity), model.accuracy());
    }

    /** The quantity that is compared with the background: a band of the tally, or all bands with A-weighting. */
    private int decisive(SoundSource source) {
        if (model.criterion() == EnergyModel.Criterion.A_WEIGHTED) {
            return EnergyTally.A_WEIGHTED;
        }
        if (model.criterion() == EnergyModel.Criterion.NARROW_BAND) {
            Optional<HeardTone> tone =
                    source.lines().best(band -> heard(band) * pressure * source.emitted(), background);
            if (tone.isPresent()) {
                return tone.get().band().octave();
            }
        }
        int best = 0;
        double highest = Double.NEGATIVE_INFINITY;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double level = Levels.ofRatio(heard(band) * pressure * source.emitted()) - background.level(band);
            if (level > highest) {
                best = band;
                highest = level;
            }
        }
        return best;
    }

    /** The sum of exact paths and rays, as intensity divided by the source's power, 1/m2. */
    private double heard(int quantity) {
        return exactly(quantity) + tally.received(quantity);
    }

    private double exactly(int quantity) {
        if (quantity != EnergyTally.A_WEIGHTED) {
            return exact.heard(quantity);
        }
        double sum = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            sum += Levels.toRatio(OctaveBands.aWeight(band)) * exact.heard(band);
        }
        return sum;
    }

    private EnergyReading reading(SoundSource source, long traced) {
        List<Double> direct = energies(source, exact.direct()::heard);
        List<Double> diffracted = energies(source, exact.diffracted()::heard);
        List<Double> mirrored = energies(source, exact.mirrored()::heard);
        List<Double> reverberant = energies(source, tally::received);
        int quantity = decisive(source);
        double error = convergence.error(quantity, heard(quantity));
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
                !(source.emitted() > 0.0) || convergence.isReached(quantity, heard(quantity)),
                ledger.audit(tally.rays()),
                decay);
    }

    /** Energies relative to that of 20 uPa, from intensities divided by the source's power. */
    private List<Double> energies(SoundSource source, IntToDoubleFunction intensities) {
        List<Double> energies = new ArrayList<>(OctaveBands.COUNT);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energies.add(intensities.applyAsDouble(band) * pressure * source.emitted());
        }
        return energies;
    }
}
