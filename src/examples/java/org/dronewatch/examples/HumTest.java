package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.drone.SteadyEmission;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HumTest {
    private static final Position HERE = new Position(0, 0, 100);

    @TempDir
    private Path directory;

    private static Drone flying(SoundEmission emission, double speed) {
        return DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(HERE))
                .withSpeed(10.0)
                .withEmission(emission)
                .create("quadrotor", Path.of(""))
                .at(new FlightState(HERE, new Position(0.6 * speed, 0, 0.8 * speed), 0.0));
    }

    /** By 2 dB for each m/s above cruise speed, in all bands, and quieter below it. */
    @Test
    void isLouderTheFasterTheDroneFlies() {
        for (double speed : new double[] {0.0, 10.0, 13.5}) {
            Drone steady = flying(SteadyEmission.DEFAULT, speed);
            Drone hums = flying(Hum.DEFAULT, speed);
            double gain = 2.0 * (speed - 10.0);
            assertThat(hums.soundLevel() - steady.soundLevel()).isCloseTo(gain, within(1e-9));
            for (int band = 0; band < hums.soundPower().size(); band++) {
                assertThat(hums.soundPower().get(band) - steady.soundPower().get(band))
                        .isCloseTo(gain, within(1e-9));
            }
        }
    }

    /** What a microphone hears of a drone that flies past at 12 m/s, 2 m/s above its cruise speed. */
    private List<Observation> heard(SoundEmission emission) {
        RouteLeg leg = new RouteLeg(new Position(60, 40, 30), Optional.of(12.0), true);
        Scene scene = new Scene() {
            @Override
            public Path directory() {
                return directory;
            }

            @Override
            protected void build() {
                loadWorld(load("plain.obj"));
                add(
                        "quadrotor",
                        DroneSettings.of(
                                        loadPackaged("quadrotor.obj"),
                                        RouteFlight.of(new Position(-60, 40, 30), List.of(leg)))
                                .withSpeed(10.0)
                                .withEmission(emission));
                add(
                        "microphone",
                        AcousticSettings.at(new Position(0, 0, 2))
                                .withRate(1.0)
                                .withPropagation(EnergyModel.DEFAULT.withRays(1000)));
                setRun(RunSettings.DEFAULT.withDuration(10.0));
            }
        };
        List<Observation> heard = new ArrayList<>();
        new SceneRunner(scene)
                .onFrame(frame -> heard.addAll(frame.observations()))
                .run();
        return heard;
    }

    @Test
    void isHeardAsMuchLouder() throws IOException {
        Files.writeString(directory.resolve("plain.obj"), "v -90 0 -90\nv 90 0 -90\nv 90 0 90\nf 1 3 2\n");
        List<Observation> steady = heard(SteadyEmission.DEFAULT);
        List<Observation> hum = heard(new Hum(1.5));

        assertThat(hum).hasSameSizeAs(steady).hasSizeGreaterThan(8);
        for (int i = 0; i < hum.size(); i++) {
            assertThat(hum.get(i).value() - steady.get(i).value()).isCloseTo(3.0, within(1e-6));
        }
    }
}
