package org.dronewatch.positioner;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;

/** A positioner that is told the direction of a drone, but not the range, by a sensor that stands elsewhere. */
class RangeScanTest {
    private static final Position EYE = new Position(60, 0, 50);
    private static final Position WIDE = new Position(0, 0, 50);
    private static final double FIELD = Math.toRadians(4);
    private static final ImageShape FULL_HD = new ImageShape(1.0, 1080.0 / 1920.0);
    private static final double INTERVAL = 0.04;
    private static final double NEVER = Double.POSITIVE_INFINITY;

    private static PositionerSettings settings() {
        ZoomSettings lens = SettingsForm.with(ZoomSettings.of(FIELD, FIELD), "time", 0.0);
        return SettingsForm.with(
                PositionerSettings.DEFAULT.withCues("wide").withZoom(lens).withSpeed(1.0, 1.0),
                java.util.Map.of("minTilt", -0.5 * Math.PI, "maxTilt", 0.5 * Math.PI));
    }

    private static Sighting sighting(Position from, Position to, double error, OptionalDouble size) {
        return new Sighting(from, Direction.of(to.minus(from)), OptionalDouble.empty(), true, error, size);
    }

    /** When a drone first is in the image, but for its rim of 2.5 %, s: then a camera that can resolve it sees it. */
    private static double seen(
            PositionerSettings settings,
            Position eye,
            Position wide,
            DoubleFunction<Position> drone,
            OptionalDouble size) {
        Positioner mount =
                new Positioner(settings, eye, new Direction(2.5, 0.0), Math.toRadians(60), FULL_HD, INTERVAL);
        for (int look = 0; look * INTERVAL < 60.0; look++) {
            double now = look * INTERVAL;
            Pointing pointing = mount.moveTo(now);
            if (pointing.contact().isPresent()
                    && isInImage(pointing, drone.apply(now).minus(eye))) {
                return now;
            }
            mount.cue(1, sighting(wide, drone.apply(now), 3e-4, size), now);
        }
        return NEVER;
    }

    private static boolean isInImage(Pointing pointing, Position offset) {
        Position ahead = pointing.direction().unit();
        Position right = new Position(
                Math.cos(pointing.direction().azimuth()),
                -Math.sin(pointing.direction().azimuth()),
                0.0);
        Position up = right.cross(ahead);
        double depth = offset.dot(ahead);
        double half = 0.95 * Math.tan(0.5 * pointing.fov());
        return depth > 0.0
                && Math.abs(offset.dot(right)) <= half * FULL_HD.width() * depth
                && Math.abs(offset.dot(up)) <= half * FULL_HD.height() * depth;
    }

    /** 60 m between the sensors, 300 m to the drone, a field of 4 degrees: the parallax is 11.3 degrees. */
    @Test
    void itLooksAlongTheLineUntilTheDroneIsInTheImage() {
        Position drone = new Position(0, 300, 50);

        // The pan of 143 degrees takes 2.5 s, and half a second of delay comes before it; 16 stops of 0.2 s follow.
        double found = seen(settings(), EYE, WIDE, time -> drone, OptionalDouble.empty());
        assertThat(found).isBetween(2.0, 7.0);
        // Of 0.25 m, it is looked for from 120 to 750 m, where there are five stops.
        double sooner = seen(settings(), EYE, WIDE, time -> drone, OptionalDouble.of(0.25 / 300.0));
        assertThat(sooner).isLessThan(found - 0.8);
    }

    /**
     * Random places of both sensors and of the drone, standing still or flying: wherever it is, it gets into the image.
     */
    @Test
    void whereverTheDroneIsItIsFound() {
        long seed = 7_2026_1124;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        double latest = 0.0;
        for (int i = 0; i < 300; i++) {
            Position eye = somewhere(random, 100.0);
            Position wide = somewhere(random, 100.0);
            Position start =
                    wide.plus(direction(random).times(Math.exp(random.nextDouble(Math.log(120), Math.log(3000)))));
            if (start.distance(eye) < 60.0) {
                continue;
            }
            Position velocity = i % 2 == 0
                    ? new Position(0, 0, 0)
                    : direction(random).times(0.02 * Math.min(start.distance(eye), start.distance(wide)));
            OptionalDouble size = i % 3 == 0 ? OptionalDouble.empty() : OptionalDouble.of(0.3 / start.distance(wide));
            double found = seen(settings(), eye, wide, time -> start.plus(velocity.times(time)), size);
            assertThat(found)
                    .as("case %d: %s, %s, %s, %s", i, eye, wide, start, velocity)
                    .isLessThan(20.0);
            latest = Math.max(latest, found);
        }
        System.out.println("latest " + latest);
    }

    private static Position somewhere(SplittableRandom random, double size) {
        return new Position(
                random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-0.3 * size, size));
    }

    private static Position direction(SplittableRandom random) {
        return new Direction(random.nextDouble(-Math.PI, Math.PI), random.nextDouble(-0.2, 0.7)).unit();
    }

    /** The line leads past the positioner, or through it: the drone may be on either side. */
    @Test
    void aLineThroughThePositionerIsSearchedOnBothSides() {
        for (double aside : new double[] {0.0, 1e-9, 0.5, 20.0}) {
            Position eye = new Position(aside, 200, 50);
            for (double north : new double[] {80, 130, 290, 900}) {
                double found = seen(settings(), eye, WIDE, time -> new Position(0, north, 50), OptionalDouble.empty());
                assertThat(found).as("%s m aside, drone at %s m", aside, north).isLessThan(20.0);
            }
        }
    }

    /** Above each other on a mast: the arc is upright, and the image lower than it is wide. */
    @Test
    void anUprightParallaxIsSearchedToo() {
        Position high = new Position(0, 0, 110);
        for (double north : new double[] {90, 150, 300, 2000}) {
            assertThat(seen(settings(), high, WIDE, time -> new Position(0, north, 50), OptionalDouble.empty()))
                    .as("drone at %s m", north)
                    .isLessThan(15.0);
        }
    }

    /**
     * A drone of 3 m looks like one of 0.5 m that is six times nearer: after two seconds the whole line is searched.
     */
    @Test
    void aWrongSizeDelaysAndDoesNotMislead() {
        OptionalDouble size = OptionalDouble.of(3.0 / 1500.0);
        double found = seen(settings(), EYE, WIDE, time -> new Position(0, 1500, 50), size);

        assertThat(found).isBetween(4.0, 14.0);
    }

    @Test
    void twoSensorsThatSeeItPointStraightAtIt() {
        Position left = new Position(-100, 20, 50);
        Position drone = new Position(0, 300, 50);
        Positioner mount = new Positioner(settings(), EYE, new Direction(0, 0), 1.0, FULL_HD, INTERVAL);
        for (int look = 0; look < 50; look++) {
            mount.moveTo(look * INTERVAL);
            mount.cue(1, sighting(WIDE, drone, 1e-3, OptionalDouble.empty()), look * INTERVAL);
            mount.cue(1, sighting(left, drone, 1e-3, OptionalDouble.empty()), look * INTERVAL);
        }
        Direction exact = Direction.of(drone.minus(EYE));
        Direction found = mount.moveTo(50 * INTERVAL).direction();
        assertThat(found.azimuth()).isCloseTo(exact.azimuth(), within(1e-6));
        assertThat(found.elevation()).isCloseTo(exact.elevation(), within(1e-6));
    }

    /** What another contact's line would add is no range of this one. */
    @Test
    void linesOfAnotherContactDoNotCount() {
        Positioner mount = new Positioner(settings(), EYE, new Direction(0, 0), 1.0, FULL_HD, INTERVAL);
        Positioner alone = new Positioner(settings(), EYE, new Direction(0, 0), 1.0, FULL_HD, INTERVAL);
        for (int look = 0; look < 100; look++) {
            double now = look * INTERVAL;
            assertThat(mount.moveTo(now)).isEqualTo(alone.moveTo(now));
            Sighting seen = sighting(WIDE, new Position(0, 300, 50), 1e-3, OptionalDouble.empty());
            mount.cue(1, seen, now);
            alone.cue(1, seen, now);
            mount.cue(
                    2, sighting(new Position(-90, 0, 50), new Position(0, 500, 50), 1e-3, OptionalDouble.empty()), now);
        }
    }

    /**
     * A direction with an error of 2 degrees does not fit into 4 degrees: the lens stays wide enough for two standard
     * errors.
     */
    @Test
    void theFieldHoldsTheErrorOfTheLine() {
        Positioner mount = new Positioner(settings(), EYE, new Direction(0, 0), 1.0, FULL_HD, INTERVAL);
        double error = Math.toRadians(2);
        mount.cue(1, sighting(WIDE, new Position(0, 300, 50), error, OptionalDouble.empty()), 0.0);
        mount.moveTo(0.5);

        double height = FULL_HD.upwards(mount.moveTo(1.0).fov());
        assertThat(height).isCloseTo(4.0 * error, within(1e-9));
    }

    @Test
    void impossibleSearchesAreRefused() {
        assertThatThrownBy(() -> new RangeSearch(50, 0.7, 0.6, 0.2))
                .hasMessage("minSize 0.7 m must be at most maxSize 0.6 m");
        assertThatThrownBy(() -> new RangeSearch(0, 0.1, 0.6, 0.2)).hasMessageStartingWith("minRange 0 m must be 1 to");
    }
}
