package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.energy.RandomPlaces.Where;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Readings scatter by no more than they state, wherever drone and microphone are: at random places of six sites, and at
 * places where an independent check found stated errors that were too small. The deviations from the mean are not above
 * 1.25 times the stated errors (root mean square), hardly more than one reading in a hundred is off by more than three
 * stated errors, and at most one in fifty has not converged. The deviations are not below 0.8 times the stated errors
 * either, less the {@value ReadingSpread#ALLOWANCE} dB that may be an allowance for rays that were not drawn.
 */
class RandomPlacesErrorTest {
    private static final long SEED = 20261127;

    /** Three or more of a hundred readings are beyond by chance at one place in twelve if one in a hundred is. */
    private static final double TOO_MANY_BY_CHANCE = 0.0794;

    /** With a few strong rays, the deviation of a hundred readings is off by a fifth at one place in twenty. */
    private static final double OUTSIDE_BY_CHANCE = 0.05;

    private final List<String> outside = new ArrayList<>();
    private final List<String> tooMany = new ArrayList<>();
    private final List<String> onFewRays = new ArrayList<>();
    private int spreads;
    private int readings;
    private int beyond;
    private int unconverged;

    /** Places where a ray that one reading in several draws contributes a few per cent of the level. */
    enum Place {
        SHADOW_OF_THE_HILL(SoundSites::hill, new Position(42.94, -58.63, 158.30), new Position(-20.53, 25.24, 131.07)),
        STREET(SoundSites::canyon, new Position(7.08, 38.87, 0.38), new Position(6.53, -14.30, 1.20)),
        BEHIND_A_HOUSE(SoundSites::canyon, new Position(47, 4.4, 3), new Position(-12.5, -2, 1.3)),
        COLUMNS(RandomPlacesErrorTest::columns, new Position(60, 3, 4), new Position(-10, 1, 1.5)),
        BETWEEN_ROWS(RandomPlacesErrorTest::rows, new Position(60, 20, 10), new Position(1, -10, 1.5));

        private final Supplier<SoundSites> site;
        private final Position drone;
        private final Position microphone;

        Place(Supplier<SoundSites> site, Position drone, Position microphone) {
            this.site = site;
            this.drone = drone;
            this.microphone = microphone;
        }
    }

    /** A street 12 m wide between two rows of houses, 15 m high and 80 m long: some sound arrives round their ends. */
    private static SoundSites rows() {
        TriangleMesh houses =
                World.merge(List.of(Sites.box(-20, -40, 0, -6, 40, 15), Sites.box(6, -40, 0, 20, 40, 15)));
        World world = Sites.world(
                List.of(Sites.square(500, 0), houses),
                List.of(SurfaceMaterials.get("asphalt"), SurfaceMaterials.get("brick_rough")));
        return new SoundSites(world, SoundSites.canyon().power());
    }

    /** Forty columns of 12 m on 40 x 20 m. */
    private static SoundSites columns() {
        Random random = new Random(9);
        List<TriangleMesh> parts = new ArrayList<>(List.of(Sites.square(300, 0)));
        for (int i = 0; i < 40; i++) {
            double x = 40 * random.nextDouble();
            double y = 20 * random.nextDouble() - 10;
            parts.add(Sites.box(x, y, 0, x + 1, y + 1, 12));
        }
        World world = Sites.world(World.merge(parts), SurfaceMaterial.uniform("plaster", 0.1, 0.3));
        return new SoundSites(world, Collections.nCopies(OctaveBands.COUNT, Sites.LW));
    }

    /**
     * 25 readings each way, in the long form two hundred: at most as many are beyond three errors as would be in 999 of
     * 1,000 repetitions (binomial) if one in a hundred were. The long form also tells the deviations.
     */
    @Thorough
    @ParameterizedTest
    @EnumSource
    void whereFewRaysContributeMuch(Place place) {
        SoundSites site = place.site.get();
        int count = LongForm.count(25, 200);
        compare(place.toString(), site, place.drone, place.microphone, count, SEED);
        // Other seeds: where both directions are traced from the same end, readings would be the same.
        compare(place + ", places exchanged", site, place.microphone, place.drone, count, SEED + count);
        assertThat(onFewRays).as("places with too many readings on few rays").isEmpty();
        assertThat(beyond).as("readings beyond three stated errors").isLessThanOrEqualTo(mostByChance(readings, 0.01));
        if (LongForm.IS_ON) {
            assertThat(outside).as("deviations over stated errors").isEmpty();
        }
    }

    /**
     * Ten readings each way at nine places tell whether many are beyond three errors or have not converged; in the long
     * form a hundred at forty tell each place. Of so many places some are outside by chance: at most as many as would
     * be in 999 of 1,000 repetitions (binomial) if one reading in a hundred were beyond three errors.
     */
    @Thorough
    @Test
    void atRandomPlaces() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (Where where : Where.values()) {
            SoundSites site = where.site();
            RandomPlaces places = new RandomPlaces(where, site, random);
            for (int i = 0; i < count(where); i++) {
                Position one = places.next(i % 3 == 0);
                Position other = places.next(i % 3 == 1);
                compare(where.toString(), site, one, other, LongForm.count(10, 100), SEED);
                compare(where.toString(), site, other, one, LongForm.count(10, 100), SEED + 100);
            }
        }

        String result =
                ("seed %d: of %d pairs of places %d outside, %d with too many readings beyond three stated errors,"
                                + " %d with too many on few rays; %d readings of %d beyond, %d on few rays")
                        .formatted(
                                SEED,
                                spreads,
                                outside.size(),
                                tooMany.size(),
                                onFewRays.size(),
                                beyond,
                                readings,
                                unconverged);
        System.out.printf("%s%n%s%n%s%n%s%n", result, outside, tooMany, onFewRays);
        assertThat(beyond).as(result).isLessThanOrEqualTo(mostByChance(readings, 0.01));
        assertThat(unconverged).as(result).isLessThanOrEqualTo(mostByChance(readings, 0.02));
        if (LongForm.IS_ON) {
            assertThat(outside).as(result).hasSizeLessThanOrEqualTo(mostByChance(spreads, OUTSIDE_BY_CHANCE));
            assertThat(tooMany).as(result).hasSizeLessThanOrEqualTo(mostByChance(spreads, TOO_MANY_BY_CHANCE));
            assertThat(onFewRays).as(result).hasSizeLessThanOrEqualTo(mostByChance(spreads, TOO_MANY_BY_CHANCE));
        }
    }

    /** How many of a number are not exceeded with a probability of 0.999, each with a probability of its own. */
    private static int mostByChance(int number, double probability) {
        double term = Math.pow(1 - probability, number);
        double sum = term;
        int most = 0;
        while (sum < 0.999) {
            term *= probability / (1 - probability) * (number - most) / (most + 1);
            sum += term;
            most++;
        }
        return most;
    }

    private static int count(Where where) {
        return switch (where) {
            case HILL -> LongForm.count(2, 11);
            case CANYON -> LongForm.count(3, 11);
            case WAVES -> LongForm.count(2, 8);
            case SEALED, ROOM -> LongForm.count(1, 4);
            case CHURCH -> LongForm.count(0, 2);
        };
    }

    private void compare(String what, SoundSites site, Position drone, Position microphone, int count, long seed) {
        ReadingSpread spread = ReadingSpread.of(site, Criterion.A_WEIGHTED, drone, microphone, count, seed);
        if (spread.isSilent()) {
            return;
        }
        String description = "%s, drone %s, microphone %s: ratio %.2f, %s"
                .formatted(what, drone, microphone, spread.ratio(), spread);
        System.out.println(description);
        spreads++;
        readings += count;
        beyond += spread.beyond();
        unconverged += spread.unconverged();
        if (!(spread.ratio() <= 1.25 && spread.ratio() >= spread.leastRatio())) {
            outside.add(description);
        }
        if (50 * spread.beyond() > count) {
            tooMany.add(description);
        }
        if (spread.standsOnFewRays() && count >= 50 || spread.converged() < 2) {
            onFewRays.add(description);
        }
    }
}
