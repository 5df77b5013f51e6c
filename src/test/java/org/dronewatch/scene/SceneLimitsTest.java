package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Path;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.PictureMemory;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Values with which a run once broke off half-way, or would never end, are refused beforehand with their limits. */
class SceneLimitsTest {
    private static final Path LIMITS = Path.of("src/test/resources/fuzz/limits.yaml");

    private static SceneRunner runner() {
        return new SceneRunner(new SceneFile(LIMITS));
    }

    @Test
    void theSceneItselfRuns() {
        assertThat(runner().run().complete()).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            sensors.eye.position.x       | 1e155     | -100000 to 100000
            sensors.eye.position         | 1e155,0,9 | x 1e155 m must be -100000 to 100000
            sensors.eye.fov              | 1e-300    | 0.01 to 179 deg
            sensors.eye.fov              | 179.9 deg | 0.01 to 179 deg
            sensors.radar.detection.pulses | 1001    | 1 to 1000
            sensors.radar.budget.power   | 1e300     | 1e-9 to 1e9
            sensors.radar.maxRange       | 1e300     | at most 1e6
            world.noiseShape.hz125       | 100000    | -200 to 200
            world.models.0.scale         | 1e-300    | 1e-6 to 1e6
            world.models.0.position.z    | -1e6      | -100000 to 100000
            drones.d.speed               | 1e-300    | 0.001 to 400
            drones.d.acceleration        | 1e-300    | 0.001 to 10000
            drones.d.flight.radius       | 1e-300    | 0.1 to 100000
            drones.d.radar.crossSection  | 1e-300    | 1e-9 to 1e6
            drones.d.radar.aspects       | 0,101     | aspects.1 101 dB must be -100 to 100
            """)
    void aSettingBeyondReasonIsRefused(String path, String value, String limit) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set(path, value).settings())
                .withMessageContaining(path + "=" + value)
                .withMessageContaining(limit);
    }

    @Test
    void aPictureHasNotMoreThanSoManyPixelsInAll() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set("sensors.eye.width", "16384")
                        .set("sensors.eye.height", "16384")
                        .settings())
                .withMessageContaining("width 16384 px x height 16384 px = 268435456 px must be at most 67108864 px");
    }

    @Test
    void picturesThatDoNotFitIntoMemoryAreRefusedBeforeTheyAreTaken() {
        SceneSettings settings = runner().set("sensors.eye.width", "8192")
                .set("sensors.eye.height", "8192")
                .settings();
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> PictureMemory.check(settings, (256L << 20) - 1))
                .withMessageContaining("sensors: pictures of 67108864 px need 256 MiB")
                .withMessageContaining("more than the 255 MiB");
        assertThatCode(() -> PictureMemory.check(settings, 256L << 20)).doesNotThrowAnyException();
    }

    @Test
    void aRunOfMoreLooksThanAnybodyCanAwaitIsRefused() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set("sensors.eye.rate", "10000")
                        .set("run.duration", "20000")
                        .settings())
                .withMessageContaining("sensors.eye.rate 10000.0 Hz for run.duration 20000.0 s")
                .withMessageContaining("at most 100000000");
    }

    /** In Java a record is made by itself: the scene checks what its constructor did not. */
    @Test
    void aSceneInJavaHasTheSameLimits() {
        Scene scene = new Scene() {
            private static final long serialVersionUID = 1L;

            @Override
            protected void build() {
                loadWorld(loadPackaged("hill.obj"));
                add(
                        "d",
                        DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(1e155, 0, 0))));
                add("eye", CameraSettings.at(new Position(0, 0, 9)));
            }
        };
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(scene).settings())
                .withMessageContaining("drones.d.flight.position.x 1e155 m must be -100000 to 100000");
    }
}
