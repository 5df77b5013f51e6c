package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Readings by the default settings scatter as much as they state, wherever the microphone is. 30 seeds determine a
 * standard deviation to 13 %, the 100 of the long form to 7 %, so what is true of all seeds may fall out of these
 * limits by chance; the seeds are fixed. A stated error of half or twice the scatter is found almost certainly. Each
 * reading is judged by the error that it states itself: on the hill, about one in a hundred is 0.1 to 0.2 dB too high
 * and says so, and the others are a few hundredths of a decibel off at most. In the best band, and where no more than
 * {@value #SMALL} dB are stated, up to {@value ReadingSpread#ALLOWANCE} dB of a stated error may be too much: an
 * allowance for rays that were not drawn. From the microphone to the drone on the hill, 0.01 dB are stated, and 400
 * readings scatter by 0.7 times that.
 */
class ReadingErrorTest {
    /** A stated error of at most this may consist of an allowance, dB. */
    private static final double SMALL = 0.02;

    private static final int SEEDS = LongForm.count(30, 100);

    /** Where drone and microphone are. */
    enum Place {
        ROOM(SoundSites::room, new Position(2, 3, 1.5), new Position(7, 5, 1.7)),
        ON_THE_WALL_OF_A_ROOM(SoundSites::room, new Position(8.763, 0.474, 1.368), new Position(4.551, 7.986, 2.864)),
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
        ReadingSpread there =
                check(site, Criterion.A_WEIGHTED, place.drone, place.microphone, place + " to the microphone");
        ReadingSpread back =
                check(site, Criterion.A_WEIGHTED, place.microphone, place.drone, place + ", places exchanged");
        if (LongForm.IS_ON || place == Place.ROOM) {
            check(site, Criterion.BEST_BAND, place.drone, place.microphone, place + ", best band");
        }
        // The means of so many readings, to as many parts of what one allows as the root of their number.
        double error = Math.hypot(there.deviation(), back.deviation()) / Math.sqrt(SEEDS);
        assertThat(there.mean()).as("%s: places exchanged", place).isCloseTo(back.mean(), within(4 * error));
    }

    private static ReadingSpread check(SoundSites site, Criterion criterion, Position from, Position to, String where) {
        ReadingSpread spread = ReadingSpread.of(site, criterion, from, to, SEEDS, 1000);
        System.out.printf("%s: deviations over stated errors %.3f, %s%n", where, spread.ratio(), spread);
        boolean isExact = criterion == Criterion.A_WEIGHTED && spread.stated() > SMALL;
        assertThat(spread.unconverged()).as("%s: readings on few rays", where).isLessThanOrEqualTo(2);
        assertThat(spread.ratio())
                .as("%s: deviations over stated errors of %.3f dB", where, spread.stated())
                .isBetween(isExact ? 0.8 : spread.leastRatio(), 1.25);
        assertThat(spread.beyond())
                .as("%s: readings beyond three stated errors", where)
                .isLessThanOrEqualTo(2);
        return spread;
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
