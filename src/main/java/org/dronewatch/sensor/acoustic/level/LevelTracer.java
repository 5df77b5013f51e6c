package org.dronewatch.sensor.acoustic.level;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.world.World;

/**
 * The tracer of the level model: follows rays breadth first, in a fixed order, from a drone to one sensor. Rays end
 * when their level falls below the detection level, at the maximum order, and when the ray budget is exhausted; rays
 * not followed are counted.
 *
 * <p>Rays are queued and traced in chunks of the queue, on the {@link Workers} of the calling thread. Each chunk has a
 * separate random stream, and the results are added in the queue's order, so that they are the same for any number of
 * threads. For use by one caller at a time.
 */
public final class LevelTracer {
    /** Number of queued rays in a chunk. */
    private static final int CHUNK = 256;
    /** Number of chunks per thread: several of them balance the load. */
    private static final int CHUNKS_PER_THREAD = 8;

    private final LevelModel model;
    private final Position sensor;
    private final double detectionLevel;
    private final RayQueue queue = new RayQueue();
    private final AcousticRay ray = new AcousticRay();
    private final Supplier<RayChunk> chunks;

    /** One tracer for each of the chunks that are traced at the same time. */
    private final List<RayChunk> team = new ArrayList<>();

    private double bestLevel;
    private double energy;
    private long received;
    private long traced;
    private long cutByOrder;
    private long cutByBudget;

    /** Maximum number of rays of the last order, kept or not. */
    private long mostOfLastOrder;

    private int cutOrder;

    /**
     * A tracer to one sensor.
     *
     * @param sensor centre of the sensor, m
     * @param radius distance within which a ray must pass the sensor to be received, m
     * @param detectionLevel the level at and above which a sound is detected, dB on the calibrated scale of the level
     *     model
     */
    public LevelTracer(LevelModel model, Position sensor, double radius, double detectionLevel, World world) {
        this.model = model;
        this.sensor = sensor;
        this.detectionLevel = detectionLevel;
        SurfaceLevels surfaces = new SurfaceLevels(world);
        this.chunks = () -> new RayChunk(model, sensor, radius, detectionLevel, world, surfaces);
    }

    /**
     * Takes one look.
     *
     * @param source position of the drone, m
     * @param sourceLevel level of the drone's sound, dB on the calibrated scale of the level model
     * @param fully whether to continue after the first detection
     */
    public LevelReading trace(
            Position source, double sourceLevel, RandomGenerator random, boolean fully, RayRecorder recorder) {
        return trace(source, sourceLevel, random, fully ? TracedRays.ALL : TracedRays.UNTIL_DETECTED, recorder);
    }

    /** Takes one look that traces the given kind of rays. */
    LevelReading trace(
            Position source, double sourceLevel, RandomGenerator random, TracedRays extent, RayRecorder recorder) {
        reset();
        queue.clear();
        emit(source, sourceLevel, random);
        long seed = random.nextLong();
        int emitted = queue.added();
        if (extent != TracedRays.DECISIVE_OF_LOOK) {
            trace(seed, extent, recorder);
        } else if (cutByBudget > 0 || !traceWithinBudget(seed)) {
            queue.shorten(emitted);
            trace(seed, TracedRays.UNTIL_DETECTED, recorder);
        }
        OptionalInt cutAt = cutByBudget > 0 ? OptionalInt.of(cutOrder) : OptionalInt.empty();
        return new LevelReading(
                bestLevel, bestLevel >= detectionLevel, energy, received, traced, cutByOrder, cutByBudget, cutAt);
    }

    /** Traces the decisive rays of a look; returns false if the budget may have ended rays that were left out. */
    private boolean traceWithinBudget(long seed) {
        trace(seed, TracedRays.DECISIVE_OF_LOOK, RayRecorder.NONE);
        boolean isWithin = queue.added() + mostOfLastOrder <= model.rayBudget();
        if (!isWithin) {
            reset();
        }
        return isWithin;
    }

    /**
     * Whether one ray from a drone, or a ray that descends from it, is loud enough; the ray budget must not end any
     * ray.
     *
     * @param seed seed of the directions of scattered rays
     */
    boolean detects(AcousticRay initial, long seed) {
        reset();
        queue.clear();
        queue.add(initial);
        trace(seed, TracedRays.DECISIVE, RayRecorder.NONE);
        return bestLevel >= detectionLevel;
    }

    private void trace(long seed, TracedRays extent, RayRecorder recorder) {
        // A recorder takes one segment at a time; and if there are looks at many positions, each thread takes whole
        // looks.
        boolean isShared =
                recorder == RayRecorder.NONE && (extent == TracedRays.ALL || extent == TracedRays.UNTIL_DETECTED);
        int threads = isShared ? Workers.available() : 1;
        int atOnce = threads == 1 ? 1 : CHUNKS_PER_THREAD * threads;
        while (team.size() < atOnce) {
            team.add(chunks.get());
        }
        int next = 0;
        boolean enough = false;
        while (next < queue.added() && !enough) {
            // Only whole chunks are combined: the positions at which chunks begin must not depend on the number of
            // chunks.
            int first = next;
            int wave = Math.max(1, Math.min(atOnce, (queue.added() - first) / CHUNK));
            Workers.forEach(wave, i -> {
                int from = first + i * CHUNK;
                int to = Math.min(from + CHUNK, queue.added());
                team.get(i).trace(queue, from, to, new SkippableRandom(Draws.mix(seed, from)), extent, recorder);
            });
            int waiting = queue.added();
            for (int i = 0; i < wave && !enough; i++) {
                add(team.get(i));
                next = Math.min(first + (i + 1) * CHUNK, waiting);
                enough = extent != TracedRays.ALL && bestLevel >= detectionLevel;
            }
        }
    }

    /** The number of segments that the last look traced. */
    long traced() {
        return traced;
    }

    private void reset() {
        bestLevel = Double.NEGATIVE_INFINITY;
        energy = 0.0;
        received = 0;
        traced = 0;
        cutByOrder = 0;
        cutByBudget = 0;
        mostOfLastOrder = 0;
        cutOrder = Integer.MAX_VALUE;
    }

    /** Queues the ray straight to the sensor, which is traced first, and the rays in random directions. */
    private void emit(Position source, double sourceLevel, RandomGenerator random) {
        ray.originX = source.x();
        ray.originY = source.y();
        ray.originZ = source.z();
        ray.level = sourceLevel;
        ray.energy = 1.0 / (model.initialRays() + 1);
        ray.travelled = 0.0;
        ray.order = 0;
        ray.medium = AcousticRay.AIR;
        Position vector = sensor.minus(source);
        double length = vector.length();
        ray.directionX = length > 0.0 ? vector.x() / length : 1.0;
        ray.directionY = length > 0.0 ? vector.y() / length : 0.0;
        ray.directionZ = length > 0.0 ? vector.z() / length : 0.0;
        emit();
        for (int i = 0; i < model.initialRays(); i++) {
            Directions.draw(random, ray);
            emit();
        }
    }

    private void emit() {
        if (queue.added() < model.rayBudget()) {
            queue.add(ray);
        } else {
            cutByBudget++;
            cutOrder = 0;
        }
    }

    private void add(RayChunk chunk) {
        bestLevel = Math.max(bestLevel, chunk.bestLevel());
        energy += chunk.energy();
        received += chunk.received();
        traced += chunk.traced();
        cutByOrder += chunk.cutByOrder();
        mostOfLastOrder += chunk.mostOfLastOrder();
        RayQueue branches = chunk.branches();
        int kept = Math.min(branches.added(), model.rayBudget() - queue.added());
        queue.addAll(branches, kept);
        for (int i = kept; i < branches.added(); i++) {
            cutByBudget++;
            cutOrder = Math.min(cutOrder, branches.order(i));
        }
    }
}
