package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.run.Frame;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.array.ArraySettings;
import org.dronewatch.sensor.acoustic.array.ArraySettings.Shape;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.junit.jupiter.api.Test;

/** An array of microphones hears a drone and turns a camera to it. */
class ListeningPostTest {
    private static final Path SCENE = Path.of("src/test/resources/org/dronewatch/sensor/acoustic/listening-post.yaml");
    private static final AcousticSettings MICROPHONE =
            AcousticSettings.at(new Position(0, 0, 2)).withPropagation(EnergyModel.DEFAULT);
    private static final ArraySettings ARRAY = ArraySettings.of(32, 1.0);

    private static SceneRunner scene() {
        return new SceneRunner(new SceneFile(SCENE));
    }

    /** The camera looks south at first, and the drone comes from the north-east. */
    @Thorough
    @Test
    void theArrayTurnsTheCameraToTheDrone() {
        assertThat(scene().run().firstDetectionRange("eye", "quadrotor").orElseThrow())
                .isGreaterThan(200.0);
        assertThat(scene().set("sensors.ears.threshold", "60 dB").run().firstDetectionRange("eye", "quadrotor"))
                .isEmpty();
    }

    /**
     * The direction is that to where the drone was when the sound left it, with errors as stated, drawn anew in each
     * look.
     */
    @Thorough
    @Test
    void directionsAreThoseOfTheSoundAsItLeft() {
        List<Frame> frames = new ArrayList<>();
        scene().set("sensors.ears.array.accuracy", "0.1 deg")
                .set("sensors.ears.rate", "5 Hz")
                .onFrame(frames::add)
                .run();
        Frame first = frames.get(0);
        Frame last = frames.get(frames.size() - 1);
        Position start = first.drones().get(0).origin();
        Position velocity = last.drones().get(0).origin().minus(start).times(1.0 / (last.time() - first.time()));
        double heard = 0.0;
        double seen = 0.0;
        int count = 0;
        for (Frame frame : frames) {
            for (Observation look : frame.observations()) {
                if (look.sensor().equals("ears") && look.isDetected()) {
                    Direction believed = look.sighting().orElseThrow().direction();
                    double error = Math.toRadians(look.figures().get("bearing_error_deg"));
                    Position here = look.sighting().orElseThrow().from();
                    heard += square(
                            offBearing(believed, start.plus(velocity.times(look.time() - first.time())), here) / error);
                    seen += square(offBearing(believed, start.plus(velocity.times(frame.time() - first.time())), here)
                            / error);
                    count++;
                }
            }
        }

        assertThat(count).isGreaterThan(120);
        assertThat(Math.sqrt(heard / count)).isBetween(0.8, 1.25);
        assertThat(seen).isGreaterThan(heard);
    }

    private static double square(double value) {
        return value * value;
    }

    private static double offBearing(Direction believed, Position drone, Position here) {
        double truth = Direction.of(drone.minus(here)).azimuth();
        return Math.IEEEremainder(believed.azimuth() - truth, 2.0 * Math.PI);
    }

    /** 32 microphones gain 15.05 dB, in place of a stated gain, and both at once are refused. */
    @Test
    void theGainIsThatOfTheArray() {
        AcousticSettings array = MICROPHONE.withArray(ARRAY);

        assertThat(array.gain()).isEqualTo(10.0 * Math.log10(32));
        assertThat(array.detectionLevel(30.0)).isEqualTo(30.0 + 15.0 - array.gain());
        assertThat(MICROPHONE.withArrayGain(12.0).gain()).isEqualTo(12.0);
        assertThat(MICROPHONE.withArrayGain(12.0).withArray(ARRAY).arrayGain()).isZero();
        assertThatThrownBy(() -> array.withArrayGain(5.0))
                .hasMessageContaining("arrayGain 5 dB and an array of 32 microphones: set only one of the two");
    }

    /**
     * A line has no directions to tell, a single microphone neither, nor has the level model bands in which to find
     * them.
     */
    @Test
    void onlyArraysThatFindDirectionsCanCue() {
        assertThat(MICROPHONE.as(DirectionFinding.class)).isEmpty();
        assertThat(MICROPHONE.withArray(ARRAY).as(DirectionFinding.class)).isPresent();
        assertThat(MICROPHONE.withArray(ARRAY.withShape(Shape.LINE)).as(DirectionFinding.class))
                .isEmpty();
        assertThat(MICROPHONE
                        .withPropagation(LevelModel.DEFAULT)
                        .withArray(ARRAY)
                        .as(DirectionFinding.class))
                .isEmpty();
    }
}
