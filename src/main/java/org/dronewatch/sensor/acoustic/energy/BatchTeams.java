package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.dronewatch.bvh.RayPacket;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.world.World;

/**
 * The batches of a reading that are traced at the same time: each thread traces a team of them. If
 * {@linkplain RayPacket packets} of rays are faster, a packet holds one ray of each batch of a team. Each batch has its
 * own random numbers, so its results do not depend on the others.
 */
final class BatchTeams {
    /** Number of rays of a batch. */
    static final int BATCH = 500;

    private final int mostTogether;
    private final Supplier<Team> newTeam;
    private final List<Team> teams = new ArrayList<>();
    private int each = 1;

    BatchTeams(World world, Supplier<RayBatch> newBatch) {
        this.mostTogether = world.newRayPacket().isPresent() ? RayPacket.RAYS : 1;
        this.newTeam = () -> new Team(world.newRayPacket(), mostTogether, newBatch);
    }

    /** The number of batches that a thread can trace together. */
    int mostTogether() {
        return mostTogether;
    }

    /**
     * Traces batches to their ends; discards the results of the previous ones.
     *
     * @param count number of batches, at most as many as the threads can trace together
     * @param threads number of threads that may be used
     * @param seed seed of the reading
     * @param first number of the first ray
     * @param end number of the ray after the last one: the last batch may be smaller
     */
    void trace(int count, int threads, Ends ends, long seed, int first, int end, RayRecorder recorder) {
        while (teams.size() < threads) {
            teams.add(newTeam.get());
        }
        each = (count + threads - 1) / threads;
        Workers.forEach((count + each - 1) / each, team -> {
            int ofTeam = Math.min(each, count - team * each);
            for (int i = 0; i < ofTeam; i++) {
                int start = first + (team * each + i) * BATCH;
                int rays = Math.min(BATCH, end - start);
                get(team * each + i).begin(ends, rays, new SplittableRandom(Draws.mix(seed, start)), recorder);
            }
            teams.get(team).finish(ofTeam);
        });
    }

    /** One of the batches traced last. */
    RayBatch get(int number) {
        return teams.get(number / each).batches[number % each];
    }

    /** The batches of one thread. */
    private static final class Team {
        private final Optional<RayPacket> packet;

        /** An array, since a batch is looked up for each segment of a ray. */
        private final RayBatch[] batches;

        Team(Optional<RayPacket> packet, int most, Supplier<RayBatch> newBatch) {
            this.packet = packet;
            this.batches = Stream.generate(newBatch).limit(most).toArray(RayBatch[]::new);
        }

        void finish(int count) {
            if (packet.isPresent()) {
                finish(count, packet.get());
            } else {
                batches[0].finish();
            }
        }

        private void finish(int count, RayPacket rays) {
            for (int i = 0; i < count; i++) {
                batches[i].put(rays, i);
            }
            int running = count;
            while (running > 0) {
                rays.trace(count);
                running = 0;
                for (int i = 0; i < count; i++) {
                    RayBatch batch = batches[i];
                    if (!batch.isDone()) {
                        batch.take(rays, i);
                        batch.put(rays, i);
                        running++;
                    }
                }
            }
        }
    }
}
