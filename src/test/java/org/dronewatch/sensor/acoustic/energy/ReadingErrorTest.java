package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Readings by the default settings scatter as much as they say, wherever the microphone is. 100 seeds tell a standard
 * deviation to 7 %, so what is true of all seeds may fall out of these limits by chance; the seeds are fixed.
 */
class ReadingErrorTest {
    private static final int SEEDS = 100;

    /** Where drone and microphone are. */
    enum Place {
        ROOM(SoundSites::room, new Position(2, 3, 1.5), new Position(7, 5, 1.7)),
        NEAR_A_WALL(SoundSites::hill, new Position(50, 20, 140), new Position(12.7, 0, 134)),
        BEHIND_A_HOUSE(SoundSites::hill, new Position(-60, 3, 140), new Position(16, 0, 133.5)),
        CANYON(SoundSites::canyon, new Position(-60, 5, 15), new Position(10, -3, 1.5)),
        HILL(SoundSites::hill, new Position(300, 100, 150), new Position(0, 2, 144.6));

        private final Supplier<SoundSites> site;
        private final Position drone;
        private final Position microphone;

        Place(Supplier<SoundSites> site, Position drone, Position microphone) {
            this.site = site;
            this.drone = drone;
            this.microphone = microphone;
        }
    }

    /**
     * Whatever the criterion, it is the error of what that compares with the background. In the best band, all places
     * are checked in the long form.
     */
    @ParameterizedTest
    @EnumSource
    void readingsScatterAsTheySay(Place place) {
        SoundSites site = place.site.get();
        Sample there = check(site, Criterion.A_WEIGHTED, place.drone, place.microphone, place + " to the microphone");
        Sample back = check(site, Criterion.A_WEIGHTED, place.microphone, place.drone, place + ", places exchanged");
        if (LongForm.IS_ON || place == Place.ROOM) {
            check(site, Criterion.BEST_BAND, place.drone, place.microphone, place + ", best band");
        }
        // The means of a hundred readings, to a tenth of what one allows.
        double error = Math.hypot(there.spread, back.spread) / Math.sqrt(SEEDS);
        assertThat(there.mean).as("%s: places exchanged", place).isCloseTo(back.mean, within(4 * error));
    }

    /** Levels of a hundred readings, dB: mean of the energies, and standard deviation. */
    private record Sample(double mean, double spread) {}

    private static Sample check(SoundSites site, Criterion criterion, Position from, Position to, String where) {
        EnergyTracer microphone = site.microphone(EnergyModel.DEFAULT.withCriterion(criterion), to);
        double[] levels = new double[SEEDS];
        double[] errors = new double[SEEDS];
        for (int seed = 0; seed < SEEDS; seed++) {
            EnergyReading reading =
                    microphone.trace(site.drone(from), new SplittableRandom(1000 + seed), RayRecorder.NONE);
            BandLevels noise = site.world().backgroundNoise().spectrum();
            int band = reading.bestBand(noise);
            levels[seed] = criterion == Criterion.A_WEIGHTED
                    ? reading.aWeightedLevel()
                    : reading.level(band) - noise.level(band);
            errors[seed] = reading.standardError();
        }
        double energy = 0;
        double sum = 0;
        double stated = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            energy += Levels.toRatio(levels[seed]) / SEEDS;
            sum += levels[seed] / SEEDS;
            stated += errors[seed] / SEEDS;
        }
        double truth = Levels.ofRatio(energy);
        double squares = 0;
        int beyond = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            squares += (levels[seed] - sum) * (levels[seed] - sum) / (SEEDS - 1);
            beyond += Math.abs(levels[seed] - truth) > 3 * errors[seed] ? 1 : 0;
        }
        System.out.printf("%s: standard deviation over stated error %.3f%n", where, Math.sqrt(squares) / stated);
        assertThat(Math.sqrt(squares) / stated)
                .as("%s: standard deviation over stated error %.3f dB", where, stated)
                .isBetween(0.8, 1.25);
        assertThat(beyond).as("%s: readings beyond three stated errors", where).isLessThanOrEqualTo(2);
        return new Sample(truth, Math.sqrt(squares));
    }

    /** Nothing gets through opaque walls, whether the drone is inside or outside. */
    @Test
    void nothingGetsThroughOpaqueWalls() {
        SoundSites site = SoundSites.sealed();
        Position outside = new Position(6, 4, 4.3);
        Position inside = new Position(3, 3, 1.5);
        for (int seed = 0; seed < 4; seed++) {
            assertThat(site.microphone(inside)
                            .trace(site.drone(outside), new SplittableRandom(seed), RayRecorder.NONE)
                            .totalLevel())
                    .isEqualTo(Double.NEGATIVE_INFINITY);
            assertThat(site.microphone(outside)
                            .trace(site.drone(inside), new SplittableRandom(seed), RayRecorder.NONE)
                            .totalLevel())
                    .isEqualTo(Double.NEGATIVE_INFINITY);
        }
    }
}
