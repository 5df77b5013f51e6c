package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.time.EmissionTime;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sound.Atmosphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** By the energy model sound takes its time: what is heard now left the drone where it was before. */
class DelayedSoundTest {
    private static final Position MICROPHONE = new Position(0, 0, 144);
    private static final double SPEED = 40.0;
    private static final double FROM = 400.0;
    private static final double RATE = 10.0;

    private static final class Approaching extends Scene {
        private final Propagation propagation;

        Approaching(Propagation propagation) {
            this.propagation = propagation;
        }

        @Override
        protected void build() {
            loadWorld(loadPackaged("hill.obj"));
            setBackgroundNoise(5.0);
            Position start = MICROPHONE.plus(new Position(0, FROM, 0));
            Position end = MICROPHONE.plus(new Position(0, 20, 0));
            add(
                    "drone",
                    DroneSettings.of(loadPackaged("quadrotor.obj"), new Approach(start, end))
                            .withSpeed(SPEED));
            add("microphone", AcousticSettings.at(MICROPHONE).withRate(RATE).withPropagation(propagation));
            setRun(RunSettings.DEFAULT.withDuration(8.0));
        }
    }

    private static List<Observation> run(Propagation propagation) {
        List<Observation> all = new ArrayList<>();
        new SceneRunner(new Approaching(propagation))
                .onFrame(frame -> all.addAll(frame.observations()))
                .run();
        return all;
    }

    @Test
    void whatIsHeardLeftTheDroneBefore() {
        double c = Atmosphere.STANDARD.speedOfSound();
        List<Observation> all = run(EnergyModel.DEFAULT.withRays(1000));

        assertThat(all.get(0).arrival()).as("nothing arrives before r/c").isCloseTo(1.2, within(1e-9));
        for (Observation heard : all) {
            // From FROM - SPEED t = c (arrival - t).
            double emission = (c * heard.arrival() - FROM) / (c - SPEED);
            assertThat(heard.time()).isCloseTo(emission, within(1e-9));
            assertThat(heard.range()).isCloseTo(FROM - SPEED * emission, within(1e-6));
            assertThat(heard.arrival() * RATE).isCloseTo(Math.rint(heard.arrival() * RATE), within(1e-9));
        }
        assertThat(all).filteredOn(Observation::isDetected).isNotEmpty();
        assertThat(all).filteredOn(heard -> !heard.isDetected()).isNotEmpty();
    }

    @Test
    void theRunTellsWhenItWasDetectedAndFromWhere() {
        SceneResult result = new SceneRunner(new Approaching(EnergyModel.DEFAULT.withRays(1000))).run();
        PairResult pair = result.pairs().get(0);
        double range = pair.range().orElseThrow();
        double emission = (FROM - range) / SPEED;

        assertThat(pair.firstDetected().orElseThrow())
                .isCloseTo(emission + range / Atmosphere.STANDARD.speedOfSound(), within(1e-6));
        assertThat(result.runs().get(0).events().get(0).observation().time()).isCloseTo(emission, within(1e-6));
    }

    @Test
    void theLevelModelHearsAtOnce() {
        List<Observation> all = run(LevelModel.DEFAULT);
        assertThat(all.get(0).arrival()).isZero();
        assertThat(all).allSatisfy(heard -> assertThat(heard.time()).isEqualTo(heard.arrival()));
    }

    /** A drone that flies at half, all and twice the speed of sound, past the sensor. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0, 0.5, 1.0, 2.0})
    void theEmissionSolvesItsEquation(double mach) {
        double c = 340.0;
        Position sensor = new Position(0, 50, 0);
        FlightPath path =
                time -> new FlightState(new Position(-500 + mach * c * time, 0, 10), new Position(mach * c, 0, 0), 0.0);
        int heard = 0;
        for (double time = 0.0; time < 8.0; time += 0.1) {
            double now = time;
            heard += EmissionTime.of(path, sensor, c, now).isPresent() ? 1 : 0;
            EmissionTime.of(path, sensor, c, now).ifPresent(emission -> assertThat(
                            path.at(emission).position().distance(sensor))
                    .isCloseTo(c * (now - emission), within(1e-6)));
        }
        assertThat(heard).isBetween(60, 70);
    }
}
