package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.EnergyModel;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The energy model. {@link ExactPaths} finds what needs no chance. The rest is found by rays that run backward, from the
 * sensor: what they meet is what the sensor can hear, however far away the source is, and by reciprocity the share of the
 * energy that they bring to the source is the share that the source would have sent to the sensor. A surface absorbs its
 * share; the rest goes on as one ray, reflected like a mirror, scattered by Lambert's law or passed on through the wall,
 * chosen by chance so that the mean is right. Where a ray is scattered, it is joined to the source; where it comes by the
 * source after a mirror reflection, it is counted in a ball. One per thread.
 */
public final class EnergyTracer {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double STAND_OFF = 1e-9;
    private static final double SURVIVAL = 0.5;

    /** Up to this order every surface that scatters is joined to the source, later ones when chance scatters there. */
    private static final int ALWAYS_JOINED = 2;

    /** Rays before the first look at the standard error, which a few may deceive, and from one look to the next. */
    private static final int FEWEST = 1000;

    private static final int BATCH = 500;

    /** How far rays that meet nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    private final EnergyModel model;
    private final Position sensor;
    private final TriangleMesh mesh;
    private final KDTraversal traversal;
    private final BandSurfaces surfaces;
    private final WallPlanes planes;
    private final Air air;
    private final ExactPaths exact;
    private final EnergyTally tally;
    private final ReceiverBall ball;
    private final DiffuseConnection connection;
    private final FirstScattering firstScattering;
    private final EnergyBooks books = new EnergyBooks();
    private final AcousticRay ray = new AcousticRay();
    private final double[] energy = new double[BANDS];
    private final double[] scattered = new double[BANDS];
    private final double[] normal = new double[3];

    private long traced;
    private SoundSource source;
    private RandomGenerator random;
    private RayRecorder recorder;

    /** Whether the last thing that turned the ray was a mirror: such rays cannot be joined to a point. */
    private boolean fromMirror;

    /** How many mirrors the ray has met, if it met nothing else; {@link #NOT_EXACT} once its path is not an exact one. */
    private int mirrors;

    private static final int NOT_EXACT = -1;

    /** Whether all mirrors so far were large walls. */
    private boolean largeWallsOnly;

    /**
     * A tracer to one sensor.
     *
     * @param sensor where it is, m
     * @param radius of the ball about the source in which rays from mirrors are counted, m
     */
    public EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        this.model = model;
        this.sensor = sensor;
        this.mesh = world.mesh();
        this.traversal = world.newTraversal();
        this.surfaces = new BandSurfaces(world.surfaces());
        this.planes = new WallPlanes(mesh, surfaces);
        this.air = new Air(world.atmosphere());
        this.exact = new ExactPaths(model, world, planes, surfaces, air);
        this.tally = new EnergyTally(air);
        this.ball = new ReceiverBall(radius, air, tally);
        this.firstScattering = new FirstScattering(world, surfaces, air, tally);
        this.connection = new DiffuseConnection(world, surfaces, air, tally);
    }

    /**
     * One look.
     *
     * @param from the drone's sound
     * @param chance the random numbers of the rays
     * @param told every piece of every ray, from the sensor on
     */
    public EnergyReading trace(SoundSource from, RandomGenerator chance, RayRecorder told) {
        source = from;
        random = chance;
        recorder = told;
        books.clear();
        tally.clear();
        traced = 0;
        exact.find(source, sensor);
        for (int i = 0; i < model.rays() && !isAccurate(i); i++) {
            follow();
            traced += firstScattering.add(source, sensor, random);
            tally.endRay();
        }
        return reading();
    }

    /** Looks now and then only: to stop at the first chance prefers low values. */
    private boolean isAccurate(int rays) {
        return rays >= FEWEST && rays % BATCH == 0 && errorLevel() <= model.accuracy();
    }

    /** Standard error of the level of all that is heard so far, dB; infinity as long as that is nothing. */
    private double errorLevel() {
        double all = exact.heard() + tally.received();
        return all > 0.0 ? Levels.ofRatio(1.0 + tally.standardError() / all) : Double.POSITIVE_INFINITY;
    }

    private EnergyReading reading() {
        List<Double> direct = energies(exact.direct()::heard);
        List<Double> diffracted = energies(exact.diffracted()::heard);
        List<Double> mirrored = energies(exact.mirrored()::heard);
        List<Double> reverberant = energies(tally::received);
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
    private List<Double> energies(IntToDoubleFunction intensities) {
        List<Double> energies = new ArrayList<>(BANDS);
        for (int band = 0; band < BANDS; band++) {
            energies.add(intensities.applyAsDouble(band) * source.emitted());
        }
        return energies;
    }

    private double left() {
        double sum = 0.0;
        for (double inBand : energy) {
            sum += inBand;
        }
        return sum;
    }

    /** Follows one ray to its end. */
    private void follow() {
        start();
        double first = left();
        while (true) {
            boolean hit = traversal.closestHit(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ,
                    0.0,
                    Double.POSITIVE_INFINITY);
            traced++;
            double distance = hit ? traversal.distance() : Double.POSITIVE_INFINITY;
            if (fromMirror && !isExact()) {
                ball.count(ray, energy, distance, source);
            }
            record(Math.min(distance, DRAWN));
            if (!hit) {
                books.escape(left());
                return;
            }
            fly(distance);
            if (ray.order >= model.maxOrder()) {
                books.giveUp(left());
                return;
            }
            meet(traversal.triangle(), distance);
            if (!survives(first)) {
                return;
            }
        }
    }

    private void start() {
        for (int band = 0; band < BANDS; band++) {
            energy[band] = source.share(band);
        }
        ray.originX = sensor.x();
        ray.originY = sensor.y();
        ray.originZ = sensor.z();
        Directions.draw(random, ray);
        ray.travelled = 0.0;
        ray.order = 0;
        ray.medium = AcousticRay.AIR;
        fromMirror = false;
        mirrors = 0;
        largeWallsOnly = true;
    }

    /** Whether a path straight on to the source is one of those that are computed exactly. */
    private boolean isExact() {
        return mirrors == 1 || mirrors > 1 && largeWallsOnly && mirrors <= model.mirrorOrder();
    }

    /** The level of a piece is that of the share of the source's power which it carries. */
    private void record(double length) {
        if (recorder != RayRecorder.NONE) {
            recorder.record(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.originX + length * ray.directionX,
                    ray.originY + length * ray.directionY,
                    ray.originZ + length * ray.directionZ,
                    Levels.ofRatio(left() * source.emitted() / model.rays()),
                    ray.order,
                    false);
        }
    }

    private void recordConnection() {
        if (recorder != RayRecorder.NONE) {
            Position place = source.place();
            recorder.record(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    place.x(),
                    place.y(),
                    place.z(),
                    Levels.ofRatio(left() * source.emitted() / model.rays()),
                    ray.order,
                    true);
        }
    }

    private void fly(double distance) {
        double before = left();
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= air.left(band, distance);
        }
        books.leaveToAir(before - left());
        ray.travelled += distance;
    }

    private void meet(int triangle, double distance) {
        int material = mesh.material(triangle);
        Normals.facing(mesh, triangle, ray, normal);
        ray.originX += distance * ray.directionX;
        ray.originY += distance * ray.directionY;
        ray.originZ += distance * ray.directionZ;
        ray.order++;
        if (ray.medium == material) {
            // Out of a solid: its loss was taken on the way in.
            ray.medium = AcousticRay.AIR;
            mirrors = NOT_EXACT;
            standOff(-1.0);
            return;
        }
        if (passes(material)) {
            ray.medium = surfaces.isSheet(material) ? ray.medium : material;
            mirrors = NOT_EXACT;
            standOff(-1.0);
        } else {
            standOff(1.0);
            reflect(triangle, material);
        }
    }

    /** Absorbs the surface's share; chance decides whether the rest goes through or back. */
    private boolean passes(int material) {
        double before = left();
        double reflected = 0.0;
        double transmitted = 0.0;
        for (int band = 0; band < BANDS; band++) {
            reflected += energy[band] * surfaces.reflected(material, band);
            transmitted += energy[band] * surfaces.transmitted(material, band);
        }
        double onward = reflected + transmitted;
        books.absorb(before - onward);
        double chance = onward > 0.0 ? transmitted / onward : 0.0;
        boolean passes = surfaces.transmits(material) && random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= passes
                    ? surfaces.transmitted(material, band) / chance
                    : surfaces.reflected(material, band) / (1.0 - chance);
        }
        books.exchange(onward, left());
        return passes;
    }

    private void reflect(int triangle, int material) {
        double before = left();
        double sum = 0.0;
        for (int band = 0; band < BANDS; band++) {
            scattered[band] = energy[band] * surfaces.scattered(material, band);
            sum += scattered[band];
        }
        double chance = before > 0.0 ? sum / before : 0.0;
        boolean always = ray.order <= ALWAYS_JOINED && chance > 0.0;
        if (always) {
            join(scattered);
        }
        boolean diffuse = random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            double share = surfaces.scattered(material, band);
            energy[band] *= diffuse ? share / chance : (1.0 - share) / (1.0 - chance);
        }
        books.exchange(before, left());
        if (diffuse) {
            if (!always) {
                join(energy);
            }
            Directions.drawLambert(random, normal, ray);
            fromMirror = false;
            mirrors = NOT_EXACT;
        } else {
            mirror();
            fromMirror = true;
            mirrors = mirrors == NOT_EXACT ? NOT_EXACT : mirrors + 1;
            largeWallsOnly &= planes.wallOf(triangle) != WallPlanes.NONE;
        }
    }

    private void join(double[] leaving) {
        traced++;
        if (connection.add(ray, normal, leaving, source)) {
            recordConnection();
        }
    }

    private void mirror() {
        double twice = 2.0 * (ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2]);
        ray.directionX -= twice * normal[0];
        ray.directionY -= twice * normal[1];
        ray.directionZ -= twice * normal[2];
    }

    private void standOff(double side) {
        double far = 1.0 + Math.abs(ray.originX) + Math.abs(ray.originY) + Math.abs(ray.originZ);
        double step = side * STAND_OFF * far;
        ray.originX += step * normal[0];
        ray.originY += step * normal[1];
        ray.originZ += step * normal[2];
    }

    /** Ends faint rays by chance and strengthens those that survive, which leaves the mean as it is. */
    private boolean survives(double first) {
        double left = left();
        if (left >= model.roulette() * first) {
            return true;
        }
        if (left == 0.0 || random.nextDouble() >= SURVIVAL) {
            books.exchange(left, 0.0);
            return false;
        }
        for (int band = 0; band < BANDS; band++) {
            energy[band] /= SURVIVAL;
        }
        books.exchange(left, left());
        return true;
    }
}
