package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Encounter;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Looks of an observer, look by look, against the mean over the observer's draws computed anew for each look. */
class MissedLooksTest {
    private static final double RATE = 25.0;

    private static final String OBSERVER =
            """
              watched: {kind: camera, position: [0, 0, 4], fov: 60 deg, width: 640, height: 480, rate: 25,
                detection: {kind: target-task, task: detection, byChance: true}}
            """;

    @TempDir
    private Path directory;

    private SensorSettings<?> observer;
    private Drone drone;

    @BeforeEach
    void load() throws IOException {
        FieldSite site = FieldSite.in(directory, OBSERVER);
        observer = site.settings().sensors().get("watched");
        drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
    }

    private ScheduledLook look(long index, double time, double probability, double begin) {
        Look look = Look.of(0, "watched", index, time);
        return new ScheduledLook(0, look, drone, RayEstimate.exact(probability), time >= begin);
    }

    /** The drone is visible for some seconds, hidden for as many, and visible again, half of the time as before. */
    private List<ScheduledLook> random(int count, SplittableRandom random) {
        List<ScheduledLook> looks = new ArrayList<>();
        double begin = 40.0 * random.nextDouble();
        double likely = random.nextDouble();
        while (looks.size() < count) {
            int visible = random.nextInt(400);
            int hidden = random.nextInt(600);
            for (int i = 0; i < visible + hidden && looks.size() < count; i++) {
                double changed = random.nextBoolean() ? likely : likely * random.nextDouble();
                double probability = i < visible ? changed : 0.0;
                looks.add(look(looks.size(), looks.size() / RATE, probability, begin));
            }
        }
        return looks;
    }

    /** By the definition: a new encounter begins once the drone was out of sight for more than 10 s. */
    private static double direct(List<ScheduledLook> looks, MissedLooks.Wait wait) {
        double missed = 1.0;
        List<ScheduledLook> encounter = new ArrayList<>();
        double visible = Double.POSITIVE_INFINITY;
        for (ScheduledLook look : looks) {
            if (look.probability() > 0.0) {
                if (look.time() - visible > Encounter.GAP) {
                    missed *= wait == MissedLooks.Wait.SEEN ? ofWatched(encounter) : ofEncounter(encounter);
                    encounter.clear();
                }
                visible = look.time();
                if (look.counts() || wait == MissedLooks.Wait.SEEN) {
                    encounter.add(look);
                }
            }
        }
        return missed * (wait == MissedLooks.Wait.SEEN ? ofWatched(encounter) : ofEncounter(encounter));
    }

    private static double ofEncounter(List<ScheduledLook> looks) {
        List<ScheduledLook> easiest = new ArrayList<>(looks);
        easiest.sort(Comparator.comparingDouble(look -> -look.probability()));
        double missed = 0.0;
        double above = 1.0;
        double exponent = 0.0;
        for (ScheduledLook look : easiest) {
            missed += (above - look.probability()) * Math.exp(-exponent);
            above = look.probability();
            exponent += look.probability() * Math.min(1.0 / RATE, look.time()) / Encounter.SEARCH_TIME;
        }
        return missed + above * Math.exp(-exponent);
    }

    /** For each u between two probabilities: detected on the route if found, then or before, and seen on the route. */
    private static double ofWatched(List<ScheduledLook> looks) {
        double[] steps = looks.stream()
                .mapToDouble(ScheduledLook::probability)
                .sorted()
                .distinct()
                .toArray();
        double highest = looks.stream()
                .filter(ScheduledLook::counts)
                .mapToDouble(ScheduledLook::probability)
                .max()
                .orElse(0.0);
        double missed = 1.0 - highest;
        double below = 0.0;
        for (double step : steps) {
            double exponent = 0.0;
            for (ScheduledLook look : looks) {
                double searched = Math.min(1.0 / RATE, look.time());
                exponent += look.probability() >= step ? look.probability() * searched / Encounter.SEARCH_TIME : 0.0;
            }
            missed += step <= highest ? (step - below) * Math.exp(-exponent) : 0.0;
            below = step;
        }
        return missed;
    }

    @Test
    void afterEachLookAsComputedAnew() {
        long seed = 12;
        SplittableRandom random = new SplittableRandom(seed);
        int decided = 0;
        for (int i = 0; i < 40; i++) {
            List<ScheduledLook> looks = random(1 + random.nextInt(3000), random);
            MissedLooks.Wait wait = i % 2 == 0 ? MissedLooks.Wait.UNSEEN : MissedLooks.Wait.SEEN;
            double[] after = MissedLooks.afterEach(looks, observer, wait);
            for (int j = 0; j < 5; j++) {
                int last = random.nextInt(looks.size());
                double expected = direct(looks.subList(0, last + 1), wait);
                assertThat(after[last])
                        .as("seed %d, flight %d, look %d", seed, i, last)
                        .isCloseTo(expected, within(1e-12 * expected));
                decided += expected < 0.99 ? 1 : 0;
            }
        }
        assertThat(decided).isGreaterThan(80);
    }

    /** At 25 looks a second, a route of seven minutes has ten thousand. */
    @Test
    void tenThousandLooks() {
        List<ScheduledLook> looks = random(10_000, new SplittableRandom(13));
        double[] after = MissedLooks.afterEach(looks, observer, MissedLooks.Wait.UNSEEN);

        assertThat(after).isSortedAccordingTo(Comparator.reverseOrder());
        assertThat(MissedLooks.probability(looks, observer, MissedLooks.Wait.UNSEEN))
                .isEqualTo(after[9999]);
        assertThat(after[9999]).isCloseTo(direct(looks, MissedLooks.Wait.UNSEEN), within(1e-12 * after[9999]));
    }

    @Test
    void withoutALookNothingIsDetected() {
        assertThat(MissedLooks.probability(List.of(), observer, MissedLooks.Wait.UNSEEN))
                .isEqualTo(1.0);
        assertThat(MissedLooks.afterEach(List.of(look(0, 0.0, 0.0, 0.0)), observer, MissedLooks.Wait.UNSEEN))
                .containsExactly(1.0);
    }
}
