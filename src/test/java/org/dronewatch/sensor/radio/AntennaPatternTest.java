package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The pattern of 3GPP TR 38.901, table 7.3-1, and that it turns with the antenna. */
class AntennaPatternTest {
    private static final AntennaPattern ANTENNA = AntennaPattern.of(Math.toRadians(60), Math.toRadians(20));
    private static final Position NORTH = new Position(0, 1, 0);
    private static final long SEED = 20_261_125;

    /** A direction by azimuth and elevation, degrees. */
    private static Position direction(double azimuth, double elevation) {
        double a = Math.toRadians(azimuth);
        double e = Math.toRadians(elevation);
        return new Position(Math.cos(e) * Math.sin(a), Math.cos(e) * Math.cos(a), Math.sin(e));
    }

    /** The table's {@code -min(12 (a / 60)^2 + 12 (e / 20)^2, 30)}, by hand. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "30, 0, -3",
        "-30, 0, -3",
        "0, 10, -3",
        "0, -10, -3",
        "30, 10, -6",
        "-60, 0, -12",
        "60, 20, -24",
        "0, 31, -28.83",
        "0, 32, -30",
        "180, 0, -30",
        "0, 90, -30"
    })
    void theGainIsThatOfTheTable(double azimuth, double elevation, double decibels) {
        assertThat(ANTENNA.gain(NORTH, direction(azimuth, elevation).times(700)))
                .isCloseTo(decibels, within(1e-9));
    }

    /** Whatever the aim: the antenna and what it receives are turned together, first upwards, then round. */
    @Test
    void thePatternTurnsWithTheAntenna() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 2000; i++) {
            double turn = random.nextDouble(-Math.PI, Math.PI);
            double tilt = random.nextDouble(-0.5 * Math.PI, 0.5 * Math.PI);
            Position seen = direction(random.nextDouble(-180, 180), random.nextDouble(-90, 90));
            assertThat(ANTENNA.gain(
                            turned(NORTH, tilt, turn).times(random.nextDouble(0.1, 9)), turned(seen, tilt, turn)))
                    .as("seed %d, pair %d", SEED, i)
                    .isCloseTo(ANTENNA.gain(NORTH, seen), within(1e-6));
        }
    }

    private static Position turned(Position p, double tilt, double turn) {
        double y = p.y() * Math.cos(tilt) - p.z() * Math.sin(tilt);
        double z = p.y() * Math.sin(tilt) + p.z() * Math.cos(tilt);
        return new Position(
                p.x() * Math.cos(turn) + y * Math.sin(turn), y * Math.cos(turn) - p.x() * Math.sin(turn), z);
    }

    /** Where azimuths mean nothing: an antenna that points straight up, and what passes over it. */
    @Test
    void straightUpItIsAsAnywhere() {
        AntennaPattern round = AntennaPattern.of(Math.toRadians(40), Math.toRadians(40));
        Position up = new Position(0, 0, 3);
        assertThat(round.gain(up, new Position(0, 0, 100))).isZero();
        for (double azimuth = 0; azimuth < 360; azimuth += 90) {
            assertThat(round.gain(up, direction(azimuth, 70))).as("%f", azimuth).isCloseTo(-3, within(1e-9));
            assertThat(round.gain(direction(azimuth, 89.999), up)).isCloseTo(0, within(1e-6));
        }
    }

    /** Of the 41,253 square degrees of a sphere, 60 x 20 are one part in 34.4. */
    @Test
    void aNarrowBeamHasMoreGain() {
        assertThat(ANTENNA.largestGain()).isCloseTo(15.363, within(0.001));
        assertThat(AntennaPattern.of(Math.PI, Math.PI).largestGain()).isCloseTo(1.05, within(0.005));
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> AntennaPattern.of(0, 1))
                .withMessageContaining("azimuthBeamwidth 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ANTENNA.withSideLobes(101))
                .withMessageContaining("sideLobes 101");
    }

    @Test
    void sideLobesAreASetting() {
        AntennaPattern antenna = new AntennaPattern(0.1, 0.2, 20);
        assertThat(antenna.withSideLobes(35)).isEqualTo(new AntennaPattern(0.1, 0.2, 35));
    }
}
