package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.RandomPlaces.Where;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Sound takes every path both ways (Helmholtz): a drone that sounds alike in all directions and a microphone may change
 * places. Random places in six sites; among them drones that have landed and microphones on walls. Seventy pairs in
 * the build, two hundred in the long form.
 */
class ReciprocityTest {
    private static final long SEED = 20261123;

    /** What two exact readings may differ by, dB: coordinates of single precision. */
    private static final double EXACT = 0.02;

    private final SplittableRandom random = new SplittableRandom(SEED);
    private final List<Double> differences = new ArrayList<>();
    private final List<String> outliers = new ArrayList<>();
    private int pairs;
    private final List<String> unconverged = new ArrayList<>();

    @Test
    void droneAndMicrophoneMayChangePlaces() {
        compare(Where.HILL, LongForm.count(16, 45));
        compare(Where.CANYON, LongForm.count(16, 45));
        compare(Where.SEALED, LongForm.count(8, 20));
        compare(Where.CHURCH, LongForm.count(4, 10));
        compare(Where.ROOM, LongForm.count(13, 40));
        compare(Where.WAVES, LongForm.count(13, 40));

        assertThat(pairs).isEqualTo(LongForm.count(70, 200));
        assertThat(unconverged).as("readings on few rays, seed %d", SEED).hasSizeLessThanOrEqualTo(pairs / 50);
        assertThat(outliers)
                .as("pairs beyond three stated errors, seed %d", SEED)
                .hasSizeLessThanOrEqualTo(pairs / 50);
        double squares = differences.stream().mapToDouble(d -> d * d).sum();
        double ratio = Math.sqrt(squares / differences.size());
        System.out.printf(
                "%d pairs, %d on few rays, %d beyond three stated errors, differences over their stated errors %.3f%n",
                pairs, unconverged.size(), outliers.size(), ratio);
        assertThat(ratio)
                .as("differences over their stated errors, seed %d", SEED)
                .isBetween(0.8, 1.25);
    }

    /**
     * A drone behind a house and a microphone before it, between walls that mirror, over grass that scatters half: ten
     * readings each way, so that their means are within the error of a tenth of a decibel.
     */
    @Thorough
    @Test
    void overGrassThatScattersBetweenWallsThatMirror() {
        SurfaceMaterial grass = SurfaceMaterial.uniform("grass", 0.3, 0.5);
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.05, 0);
        TriangleMesh walls = World.merge(List.of(Sites.box(-10, -15, 0, 0, 15, 10), Sites.box(20, -15, 0, 30, 15, 10)));
        World world = Sites.world(List.of(Sites.square(400, 0), walls), List.of(grass, wall));
        SoundSites site = new SoundSites(world, Collections.nCopies(OctaveBands.COUNT, Sites.LW));
        Position drone = new Position(-40, 5, 12);
        Position microphone = new Position(8, -3, 1.5);
        double[] there = mean(site, drone, microphone);
        double[] back = mean(site, microphone, drone);
        assertThat(there[0]).isCloseTo(back[0], within(4 * Math.hypot(there[1], back[1])));
        assertThat(Math.hypot(there[1], back[1])).isLessThan(0.15);
    }

    /**
     * Over small facets of terrain, rays from one end found mirror paths that those from the other end missed: up to
     * 1.2 dB. Both ends search alike, so that they find the same, even where that is nothing (the last pair). The
     * coordinates are those of an independent check.
     */
    @ParameterizedTest
    @CsvSource({
        "WAVES, -71.8350, -30.2645, 0.1146, 77.6418, -70.3314, 7.9207",
        "WAVES, -40.8503, 67.5706, 14.4521, 40.0025, -32.6629, 0.0073",
        "WAVES, 15.5305, -45.7444, 6.7595, -31.0220, 47.0014, 1.3300",
        "WAVES, -75.8346, -22.2711, 15.3864, 37.0288, -72.3164, -0.9946",
        "WAVES, 77.3766, 3.3949, -1.6457, 83.4493, 30.3472, -0.0650",
        "HILL, -46.4456, 17.7953, 144.1731, 14.3728, 8.7596, 135.3897",
        "HILL, 52.5582, 5.5298, 142.8022, -1.9960, 7.5283, 141.7000"
    })
    void mirrorPathsAreTheSameBothWays(Where where, double x, double y, double z, double u, double v, double w) {
        SoundSites site = where.site();
        Position one = new Position(x, y, z);
        Position other = new Position(u, v, w);
        EnergyReading there = read(site, one, other);
        EnergyReading back = read(site, other, one);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(there.mirrored().get(band)).isCloseTo(back.mirrored().get(band), withinPercentage(0.01));
        }
    }

    /** Level of the mean energy of ten readings, and its error, dB. */
    private double[] mean(SoundSites site, Position drone, Position microphone) {
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < 10; i++) {
            EnergyReading reading = read(site, drone, microphone);
            double energy = Levels.toRatio(reading.aWeightedLevel());
            sum += energy / 10;
            squares += energy * energy / 10;
        }
        double relative = Math.sqrt((squares / (sum * sum) - 1) / 9);
        return new double[] {Levels.ofRatio(sum), Levels.ofRatio(1 + relative)};
    }

    private void compare(Where where, int count) {
        SoundSites site = where.site();
        RandomPlaces places = new RandomPlaces(where, site, random);
        for (int i = 0; i < count; i++, pairs++) {
            Position one = places.next(i % 3 == 0);
            Position other = places.next(i % 3 == 1);
            EnergyReading there = read(site, one, other);
            EnergyReading back = read(site, other, one);
            String what = "%s from %s to %s: %.3f and %.3f dB, stated %.3f and %.3f"
                    .formatted(
                            where,
                            one,
                            other,
                            there.aWeightedLevel(),
                            back.aWeightedLevel(),
                            there.standardError(),
                            back.standardError());

            // Nothing either way is not known to be silence, but agrees.
            if (isNothing(there) && isNothing(back) || there.isConverged() && back.isConverged()) {
                judge(what, there, back);
            } else {
                unconverged.add(what);
            }
        }
    }

    private static boolean isNothing(EnergyReading reading) {
        return reading.aWeightedLevel() == Double.NEGATIVE_INFINITY;
    }

    private void judge(String what, EnergyReading there, EnergyReading back) {
        if (there.aWeightedLevel() == back.aWeightedLevel()) {
            return; // silence both ways, or exact
        }
        double difference = there.aWeightedLevel() - back.aWeightedLevel();
        double stated = Math.hypot(there.standardError(), back.standardError());
        if (stated > EXACT) {
            differences.add(difference / stated);
        }
        if (Math.abs(difference) > 3 * stated + EXACT) {
            outliers.add(what);
        }
    }

    private EnergyReading read(SoundSites site, Position drone, Position microphone) {
        return site.microphone(microphone)
                .trace(site.drone(drone), new SplittableRandom(random.nextLong()), RayRecorder.NONE);
    }
}
