package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.examples.RouteThroughAField.InverseSquare;
import org.dronewatch.flight.Airframe;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class RouteThroughAFieldTest {
    private static final double SPEED = 15.0;
    private static final double STRENGTH = 200.0;

    /**
     * Towards a sensor at the end, nothing is less exposed than the straight line, whatever the airframe: each ring
     * around the sensor must be crossed, and at no less exposure than at right angles. K / (r^2 + h^2) is integrated in
     * closed form from 2 km to the distance that the drone flies during the response.
     */
    @ParameterizedTest
    @EnumSource(
            value = Airframe.class,
            names = {"MULTIROTOR", "FIXED_WING"})
    void straightTowardsTheSensorTheExposureIsThatOfTheClosedForm(Airframe airframe) {
        InverseSquare field = new InverseSquare(new Position(2000, 0, 0), STRENGTH);
        double expected = STRENGTH / SPEED / 30.0 * (Math.atan(2000.0 / 30.0) - Math.atan(20.0 * SPEED / 30.0));

        WeakestRoute route = RouteThroughAField.search(field, airframe, SPEED, 20.0);
        assertThat(route.exposure()).isCloseTo(expected, within(1e-3 * expected));
        assertThat(route.lower()).isBetween(0.5 * expected, expected);
        assertThat(route.detection()).isCloseTo(1.0 - Math.exp(-expected), within(1e-3));
        assertThat(route.seconds()).isCloseTo(2000.0 / SPEED, within(1e-6));
        assertThat(route.path().points()).allMatch(point -> Math.abs(point.y()) < 1e-6);
    }

    /** Past a sensor on one side, the route turns to the other side, and it is the same for the mirror image. */
    @ParameterizedTest
    @CsvSource({"60", "-60"})
    void theRouteTurnsAwayFromASensor(double north) {
        InverseSquare field = new InverseSquare(new Position(1000, north, 0), STRENGTH);
        WeakestRoute route = RouteThroughAField.search(field, Airframe.MULTIROTOR, SPEED, 20.0);
        WeakestRoute mirrored = RouteThroughAField.search(
                new InverseSquare(new Position(1000, -north, 0), STRENGTH), Airframe.MULTIROTOR, SPEED, 20.0);

        assertThat(route.exposure()).isCloseTo(mirrored.exposure(), within(1e-3 * mirrored.exposure()));
        // Straight past the sensor, at a distance of 60 m and 30 m above it.
        double distance = Math.hypot(60.0, 30.0);
        double straight = STRENGTH / SPEED / distance * (Math.atan(1000.0 / distance) + Math.atan(700.0 / distance));
        assertThat(route.exposure()).isLessThan(0.75 * straight);
        List<Position> points = route.path().points();
        assertThat(points.stream()
                        .mapToDouble(point -> -Math.signum(north) * point.y())
                        .max()
                        .orElseThrow())
                .isGreaterThan(100.0);
    }
}
