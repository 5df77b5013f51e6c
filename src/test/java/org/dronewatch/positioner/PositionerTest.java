package org.dronewatch.positioner;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;

class PositionerTest {
    private static final Position PLACE = new Position(10, 20, 30);
    private static final double WIDEST = Math.toRadians(60);

    private static final PositionerSettings SETTINGS =
            PositionerSettings.DEFAULT.withCues("radar").withZoom(ZoomSettings.of(rad(8), rad(2)));

    private static double rad(double degrees) {
        return Math.toRadians(degrees);
    }

    private static Positioner positioner(PositionerSettings settings) {
        return new Positioner(settings, PLACE, new Direction(0, 0), WIDEST, 0.04);
    }

    /** A sighting by a sensor that stands elsewhere. */
    private static Sighting at(Position place) {
        Position radar = new Position(-500, 0, 0);
        Position way = place.minus(radar);
        return new Sighting(radar, Direction.of(way), OptionalDouble.of(way.length()));
    }

    private static Position fromPlace(double azimuth, double elevation, double range) {
        return PLACE.plus(new Direction(rad(azimuth), rad(elevation)).unit().times(range));
    }

    @Test
    void itTurnsAsFastAsItMayTheShorterWayAfterTheDelay() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, at(fromPlace(-150, 30, 400)), 1.0);

        // Due at 1.5 s: nothing happens before.
        assertThat(mount.moveTo(1.4).direction()).isEqualTo(new Direction(0, 0));
        mount.moveTo(1.5);
        Pointing halfWay = mount.moveTo(2.5);
        assertThat(halfWay.direction().azimuth()).isCloseTo(rad(-60 * 1.1), within(1e-9));
        assertThat(halfWay.contact()).hasValue(1);
        assertThat(halfWay.panRate()).isCloseTo(rad(-60), within(1e-9));
        Pointing there = mount.moveTo(4.0);
        assertThat(Direction.turn(there.direction().azimuth(), rad(-150))).isCloseTo(0.0, within(1e-9));
        assertThat(there.direction().elevation()).isCloseTo(rad(30), within(1e-9));
    }

    /** A lens that cannot change its field of view, in the shortest time there is. */
    @Test
    void aLensWithoutAnyZoomKeepsItsField() {
        ZoomSettings lens = SettingsForm.with(ZoomSettings.of(WIDEST, WIDEST), "time", Double.MIN_VALUE);
        Positioner mount = positioner(SETTINGS.withZoom(lens));
        mount.cue(1, at(fromPlace(0, 10, 400)), 0.0);
        mount.moveTo(1.0);
        assertThat(mount.moveTo(2.0).fov()).isEqualTo(WIDEST);
    }

    /** A radar with a fan beam believes the drone at the middle of its field until another sensor tells the height. */
    @Test
    void aFanBeamKeepsTheHeightThatOthersMeasured() {
        Position place = fromPlace(40, 10, 400);
        Position radar = new Position(-500, 0, 0);
        Position way = place.minus(radar);
        Direction flat = new Direction(Direction.of(way).azimuth(), 0.0);
        Sighting fan = new Sighting(radar, flat, OptionalDouble.of(way.length()), false);

        Positioner mount = positioner(SETTINGS);
        mount.cue(1, fan, 0.0);
        mount.moveTo(0.5);
        double unknown = mount.moveTo(2.0).direction().elevation();
        assertThat(unknown).isNegative();

        Positioner informed = positioner(SETTINGS);
        informed.cue(1, at(place), 0.0);
        informed.cue(1, fan, 1.0);
        informed.cue(1, fan, 2.0);
        informed.moveTo(0.5);
        Pointing there = informed.moveTo(3.0);
        assertThat(there.direction().elevation()).isCloseTo(rad(10), within(1e-9));
        assertThat(there.direction().azimuth()).isCloseTo(rad(40), within(1e-9));
    }

    @Test
    void itDoesNotTiltBeyondItsLimits() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, at(fromPlace(0, 80, 400)), 0.0);
        mount.moveTo(0.5);

        assertThat(mount.moveTo(2.5).direction().elevation()).isEqualTo(rad(60));
    }

    @Test
    void itZoomsByTheSameFactorInTheSameTime() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, at(fromPlace(0, 0, 400)), 0.0);
        mount.moveTo(0.5);
        // Two seconds from 60 to 2 degrees, a factor of 30: after half a second a factor of 30^(1/4).
        assertThat(mount.moveTo(1.0).fov()).isCloseTo(WIDEST / Math.pow(30, 0.5), within(1e-9));
        assertThat(mount.moveTo(2.5).fov()).isCloseTo(rad(8), within(1e-9));
        // Once it sees the drone itself it zooms in as far as it may, and stays on it.
        mount.see(1, at(fromPlace(1, 0, 400)), 2.5);
        assertThat(mount.moveTo(2.9).fov()).isCloseTo(rad(8) / Math.pow(30, 0.2), within(1e-9));
    }

    @Test
    void itLeadsADroneThatFliesStraight() {
        Positioner mount = positioner(SETTINGS);
        Position start = fromPlace(90, 5, 500);
        Position velocity = new Position(0, 20, 1);
        for (int scan = 0; scan < 20; scan++) {
            mount.moveTo(scan);
            mount.cue(1, at(start.plus(velocity.times(scan))), scan);
        }
        Pointing pointing = mount.moveTo(19.9);
        Direction wanted = Direction.of(start.plus(velocity.times(19.9)).minus(PLACE));

        // Without leading it would point 18 m behind, 2 degrees.
        assertThat(pointing.direction().azimuth()).isCloseTo(wanted.azimuth(), within(rad(0.02)));
        assertThat(pointing.direction().elevation()).isCloseTo(wanted.elevation(), within(rad(0.02)));
    }

    @Test
    void errorsOfTheRadarAreSmoothed() {
        long seed = 20261121;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        Positioner mount = positioner(SETTINGS);
        double raw = 0.0;
        double smoothed = 0.0;
        for (int scan = 0; scan < 2000; scan++) {
            double error = rad(1) * random.nextGaussian();
            Position seen = PLACE.plus(new Direction(rad(40) + error, 0).unit().times(800));
            mount.cue(1, at(seen), scan);
            mount.moveTo(scan + 0.5);
            double off = Direction.turn(
                    rad(40), mount.moveTo(scan + 0.99).direction().azimuth());
            if (scan > 50) {
                raw += error * error;
                smoothed += off * off;
            }
        }
        // An alpha-beta filter leaves (2 a^2 + 2 b + a b) / (a (4 - 2 a - b)) of the variance in what it expects for
        // the
        // next scan (Benedict and Bordner 1962): here it is asked just before that.
        double a = 0.5;
        double b = a * a / (2 - a);
        double left = (2 * a * a + 2 * b + a * b) / (a * (4 - 2 * a - b));
        assertThat(smoothed / raw).isCloseTo(left, within(0.1 * left));
    }

    @Test
    void theFirstIsServedUntilItHasNotBeenSeenForAWhile() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, at(fromPlace(20, 0, 400)), 0.0);
        mount.cue(2, at(fromPlace(-20, 0, 400)), 0.1);
        assertThat(mount.moveTo(1.0).contact()).hasValue(1);
        mount.cue(2, at(fromPlace(-20, 0, 400)), 3.2);
        // 'hold' is 3 s.
        assertThat(mount.moveTo(3.7).contact()).hasValue(2);
        assertThat(mount.moveTo(7.0).contact()).isEmpty();
    }

    @Test
    void aDirectionFromItsOwnPlaceIsTakenAsItIs() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, new Sighting(PLACE, new Direction(rad(33), rad(7)), OptionalDouble.empty()), 0.0);
        mount.moveTo(0.5);
        Pointing pointing = mount.moveTo(2.5);

        assertThat(pointing.direction().azimuth()).isCloseTo(rad(33), within(1e-12));
        assertThat(pointing.direction().elevation()).isCloseTo(rad(7), within(1e-12));
    }

    @Test
    void anOldPlaceIsWorthLessThanANewDirection() {
        Positioner mount = positioner(SETTINGS);
        mount.cue(1, at(fromPlace(0, 0, 400)), 0.0);
        for (int look = 0; look <= 100; look++) {
            // Another camera sees it go on; the radar has lost it.
            Direction seen = new Direction(rad(0.6 * look), 0);
            mount.cue(1, new Sighting(PLACE, seen, OptionalDouble.empty()), 0.1 * look);
            mount.moveTo(0.1 * look + 0.5);
        }
        // The last direction is half a second old, and it turns by 6 degrees a second.
        assertThat(mount.moveTo(10.5).direction().azimuth()).isCloseTo(rad(63), within(rad(0.1)));
    }

    @Test
    void patienceBeginsWhenTheMountIsTold() {
        PositionerSettings slow = new PositionerSettings(
                java.util.List.of("radar"),
                1,
                1,
                -1,
                1,
                5.0,
                2.0,
                6,
                new SearchPattern.Rest(),
                Optional.empty(),
                RangeSearch.DEFAULT);
        Positioner mount = positioner(slow);
        mount.cue(1, at(fromPlace(20, 0, 400)), 0.0);

        assertThat(mount.moveTo(4.9).contact()).isEmpty();
        assertThat(mount.moveTo(5.0).contact()).hasValue(1);
        assertThat(mount.moveTo(6.9).contact()).hasValue(1);
        assertThat(mount.moveTo(7.1).contact()).isEmpty();
    }

    @Test
    void aSlowCameraHoldsFromLookToLook() {
        Positioner mount = new Positioner(SETTINGS, PLACE, new Direction(0, 0), WIDEST, 1.0);
        for (int look = 0; look < 5; look++) {
            mount.moveTo(look);
            mount.see(1, at(fromPlace(2, 0, 400)), look);
        }
        assertThat(mount.moveTo(5).fov()).isCloseTo(rad(2), within(1e-9));
    }

    @Test
    void itSearchesMeanwhile() {
        SearchPattern sweep = new SearchPattern.Sweep(rad(90), 0, 1, rad(10));
        Positioner mount = positioner(PositionerSettings.DEFAULT.withSearch(sweep));
        double[] wanted = {-45, 0, 45, 0, -45};
        for (int i = 0; i < wanted.length; i++) {
            Pointing pointing = mount.moveTo(4.5 * i);
            assertThat(pointing.direction().azimuth()).isCloseTo(rad(wanted[i]), within(1e-9));
            assertThat(pointing.contact()).isEmpty();
        }
    }

    @Test
    void aSweepOfRowsGoesUpAndComesBack() {
        SearchPattern rows = new SearchPattern.Sweep(rad(40), rad(20), 3, rad(10));
        Direction aim = new Direction(rad(100), rad(15));
        double[][] expected = {{0, 80, 5}, {3.9, 119, 5}, {4.1, 119, 15}, {7.9, 81, 15}, {8.1, 81, 25}, {16.1, 81, 15}};
        for (double[] one : expected) {
            Direction at = rows.at(aim, one[0]);
            assertThat(Math.toDegrees(at.azimuth())).as("at %s s", one[0]).isCloseTo(one[1], within(1e-9));
            assertThat(Math.toDegrees(at.elevation())).as("at %s s", one[0]).isCloseTo(one[2], within(1e-9));
        }
    }

    @Test
    void allRoundItTurnsForEver() {
        Direction at = new SearchPattern.Round(rad(30)).at(new Direction(rad(10), rad(2)), 100);

        assertThat(at).isEqualTo(new Direction(rad(10) + 100 * rad(30), rad(2)));
    }

    @Test
    void impossibleMountsAreRefused() {
        assertThatThrownBy(() -> PositionerSettings.DEFAULT.withSpeed(0, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("panSpeed 0 deg/s must be above 0 and at most 600 deg/s");
        assertThatThrownBy(() -> ZoomSettings.of(0, 1)).hasMessageStartingWith("cued 0 deg must be 0.01 to 179 deg");
        assertThatThrownBy(() -> ZoomSettings.of(0.1, 0.2))
                .hasMessage("tracked 11.45916 deg (0.2 rad) must be at most cued 5.729578 deg (0.1 rad):"
                        + " the camera zooms in on the drone that it tracks");
        assertThatThrownBy(() -> PositionerSettings.DEFAULT.withCues("a", "a"))
                .hasMessage("cues [a, a] must not name a sensor twice");
    }
}
