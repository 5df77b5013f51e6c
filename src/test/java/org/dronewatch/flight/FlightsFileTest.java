package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Glide;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What is written of a flight is read back as the same flight; what is no flight is refused with its line. */
class FlightsFileTest {
    private static final String HEADER = String.join(",", FlightsFile.COLUMNS);
    private static final double STEP = 0.1;
    private static final double UNTIL = 60.0;

    @TempDir
    private Path directory;

    private FlightsFile written(List<String> rows) throws IOException {
        Path file = directory.resolve("flights.csv");
        List<String> lines = new ArrayList<>(List.of(HEADER));
        lines.addAll(rows);
        Files.write(file, lines, StandardCharsets.UTF_8);
        return FlightsFile.read(file, "flights.csv");
    }

    private FlownPath replayed(FlightPath path, double until) throws IOException {
        return written(Legs.of(path, until, STEP).stream()
                        .map(leg -> String.join(",", FlightsFile.row(3, "a", leg)))
                        .toList())
                .flight(3, "a");
    }

    @Test
    void aSteeredFlightIsReadBackInAllDigits() throws IOException {
        long seed = 77;
        Random random = new Random(seed);
        SteeredFlight flight = Steered.from(new Position(0.1, 1e-7, 123.456)).create(400.0, 1.0, Ground.NONE);
        double time = 0.0;
        for (int i = 0; i < 500; i++) {
            flight.fly(
                    time,
                    new Position(random.nextGaussian(), random.nextGaussian() * 1e-9, 1.0 / 3.0),
                    new Attitude(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()));
            time += random.nextDouble();
        }
        flight.advance(time);
        FlownPath replayed = replayed(flight, time);
        List<Leg> legs = new ArrayList<>(flight.legs());
        legs.add(new Leg(time, flight.at(time)));
        assertThat(replayed.legs()).as("seed " + seed).isEqualTo(legs);
        for (int i = 0; i < 10_000; i++) {
            double when = time * random.nextDouble();
            assertThat(replayed.at(when)).isEqualTo(flight.at(when));
            assertThat(replayed.acceleration(when)).isEqualTo(flight.acceleration(when));
        }
    }

    private static Stream<Arguments> flights() {
        Position a = new Position(10, -20, 30);
        Position b = new Position(170, 200, 80);
        double speed = 8.0;
        return Stream.of(
                Arguments.of(Hover.at(a), 1, 1e-9),
                Arguments.of(new Approach(a, b), 3, 1e-6 + speed * STEP / 4),
                Arguments.of(new Glide(a, b, new Position(300, 300, 60)), 5, 1e-6 + speed * STEP / 2),
                Arguments.of(
                        new Waypoints(List.of(a, b, new Position(-50, 200, 60))), 160, 1.01 * 2.5 * STEP * STEP / 8),
                Arguments.of(Orbit.about(a, 40.0), 600, 1.01 * speed * speed / 40.0 * STEP * STEP / 8));
    }

    /** A straight and even part is one row; elsewhere the chord of an arc is at most a t^2 / 8 beside it. */
    @ParameterizedTest
    @MethodSource("flights")
    void aFlightIsReplayedAsNearAsItIsSampled(FlightPathSettings settings, int rows, double most) throws IOException {
        FlightPath path = settings.create(8.0, 2.5, Ground.NONE);
        FlownPath replayed = replayed(path, UNTIL);
        assertThat(replayed.legs()).hasSizeBetween(2, rows + 1);
        assertThat(replayed.legs().get(replayed.legs().size() - 1)).isEqualTo(new Leg(UNTIL, path.at(UNTIL)));
        double worst = 0.0;
        for (int i = 0; i <= 7000; i++) {
            double time = i * UNTIL / 7000;
            worst = Math.max(
                    worst, path.at(time).position().distance(replayed.at(time).position()));
            // When the motors stop is known to a step.
            double gliding = path.at(time).gliding().orElse(0.0);
            assertThat(replayed.at(time).gliding().orElse(0.0)).isCloseTo(gliding, within(STEP));
        }
        assertThat(worst).isLessThanOrEqualTo(most);
        for (int i = 0; i < 600; i++) {
            double time = i * STEP;
            assertThat(replayed.at(time).position().distance(path.at(time).position()))
                    .as("at a sample")
                    .isLessThan(2e-6);
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            0,a,0,0,0,0,0,0,0,0,0,0 | flights.csv:3: has 12 values but needs 13, one for each column
            0,a,1,0,0,0,0,0,0,0,0,0,\\n0,a,1,0,0,0,0,0,0,0,0,0, | flights.csv:4: time_s 1.0 must be after 1.0, that of the flight's previous row
            0,b,0.5,0,0,0,0,0,0,0,0,0, | flights.csv:3: time_s 0.5 must be 0 in the first row of a flight
            0,a,1,NaN,0,0,0,0,0,0,0,0, | flights.csv:3: x_m NaN must be -1000000.0 to 1000000.0
            0,a,1,0,0,0,1e9,0,0,0,0,0, | flights.csv:3: vx_m_s 1.0E9 must be -1000.0 to 1000.0
            0,a,1,0,0,0,0,0,0,left,0,0, | flights.csv:3: yaw_rad 'left' must be a number
            0.5,a,1,0,0,0,0,0,0,0,0,0, | flights.csv:3: run 0.5 must be a whole number
            0,a,1,0,0,0,0,0,0,0,0,0,-1 | flights.csv:3: gliding_s -1.0 must be 0.0 to 1.0E8
            """)
    void aWrongRowIsNamed(String rows, String message) {
        List<String> all = new ArrayList<>(List.of("0,a,0,0,0,0,0,0,0,0,0,0,"));
        all.addAll(List.of(rows.strip().split("\\\\n")));
        assertThatThrownBy(() -> written(all))
                .isInstanceOf(InputException.class)
                .hasMessage(message);
    }

    @Test
    void aFlightThatIsNotThereIsNamed() throws IOException {
        FlightsFile file = written(List.of("0,hunter,0,0,0,0,0,0,0,0,0,0,", "2,prey,0,0,0,0,0,0,0,0,0,0,"));
        assertThatThrownBy(() -> file.flight(0, "huntr"))
                .isInstanceOf(InputException.class)
                .hasMessage("flights.csv: has no flight of drone 'huntr' in run 0; closest match: hunter");
        assertThatThrownBy(() -> file.flight(1, "hunter"))
                .isInstanceOf(InputException.class)
                .hasMessage("flights.csv: has no flight of run 1");
    }

    @Test
    void otherFilesAreRefused() throws IOException {
        Path file = directory.resolve("flights.csv");
        for (String text :
                List.of("", "v 0 0 0\nv 1 0 0\n", "\0\0\0", "run,run\n0,0\n", "\"open\n", HEADER + "\n\"a")) {
            Files.writeString(file, text);
            assertThatThrownBy(() -> FlightsFile.read(file, "flights.csv").flight(0, "a"))
                    .as(text)
                    .isInstanceOf(InputException.class)
                    .hasMessageStartingWith("flights.csv");
        }
        assertThatThrownBy(() -> FlightsFile.read(directory.resolve("none.csv"), "none.csv"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("none.csv: cannot be read: no such file");
    }

    /** Columns of a table program: another order, more of them, Windows' line ends. */
    @Test
    void columnsAreFoundByTheirNames() throws IOException {
        Path file = directory.resolve("flights.csv");
        List<String> columns = new ArrayList<>(FlightsFile.COLUMNS);
        Collections.reverse(columns);
        Files.writeString(file, "note," + String.join(",", columns) + "\r\nfirst,,0.3,0.2,0.1,6,5,4,3,2,1,0,a,0\r\n");
        FlightState state = FlightsFile.read(file, "flights.csv").flight(0, "a").at(0.0);
        assertThat(state)
                .isEqualTo(new FlightState(new Position(1, 2, 3), new Position(4, 5, 6), new Attitude(0.1, 0.2, 0.3)));
    }
}
