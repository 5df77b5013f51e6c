package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenes.AcousticRange;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.sound.BandLevels;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SettingsPathTest {
    private final SceneSettings settings = new HillScene().describe();

    @Test
    void aSpectrumIsWrittenAsEightLevelsOrOneByOne() {
        SceneSettings scene = new AcousticRange().describe();
        SceneSettings all = new SettingsPath("world.noiseShape").write(scene, "50, 48, 44 dB, 41, 38, 33, 27, 20");
        assertThat(all.world().noiseShape()).isEqualTo(BandLevels.of(50, 48, 44, 41, 38, 33, 27, 20));
        SceneSettings one = new SettingsPath("world.noiseShape.hz4000").write(all, "30");
        assertThat(one.world().noiseShape().hz4000()).isEqualTo(30.0);
    }

    @Test
    void aConstantOfTwoWordsIsWrittenWithADash() {
        SceneSettings scene = new AcousticRange().describe();
        SceneSettings physical = new SettingsPath("sensors.microphone.propagation").write(scene, "energy-model");
        SettingsPath path = new SettingsPath("sensors.microphone.propagation.criterion");
        assertThat(path.read(path.write(physical, "best-band"))).isEqualTo(EnergyModel.Criterion.BEST_BAND);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> path.write(physical, "any"))
                .withMessageContaining("a-weighted, best-band");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "world.backgroundNoise          | 20        | 20.0",
                "world.models.0.scale           | 2         | 2.0",
                "world.models.0.file            | my.obj    | my.obj",
                "sensors.wide.rate              | 2 kHz     | 2000.0",
                "sensors.wide.width             | 640       | 640",
                "sensors.wide.detection.pixels  | 30        | 30.0",
                "drones.comer.speed             | 36 km/h   | 10.0",
                "drones.comer.flight.from.z     | 200 m     | 200.0",
                "drones.crosser.flight.points.1.x | 7       | 7.0",
                "sensors.dice.luck              | .5        | 0.5",
                "run.seed                       | 77        | 77",
                "world.atmosphere.humidity      | 50 %      | 0.5",
                "world.surfaces.defaultSurface       | concrete_rough | concrete_rough",
                "run.duration                   | 1 min     | 60.0",
            })
    void aValueIsWrittenWhereThePathLeads(String path, String text, String expected) {
        SettingsPath setting = new SettingsPath(path);
        SceneSettings changed = setting.write(settings, text);

        assertThat(setting.read(changed).toString()).isEqualTo(expected);
        assertThat(setting.read(settings)).isNotEqualTo(setting.read(changed));
        assertThat(new SettingsPath(path).write(changed, setting.read(settings).toString()))
                .isEqualTo(settings);
    }

    @Test
    void positionsAndNamesAreWrittenAsPeopleWriteThem() {
        SceneSettings moved = new SettingsPath("drones.comer.flight.from").write(settings, "1, 2 km, -3");
        assertThat(((Approach) moved.drones().get("comer").flight()).from()).isEqualTo(new Position(1, 2000, -3));

        SceneSettings horizontal = new SettingsPath("sensors.wide.fovAxis").write(settings, "horizontal");
        assertThat(((CameraSettings) horizontal.sensors().get("wide")).focalLength())
                .isCloseTo(160 / Math.tan(0.6), within(1e-9));
    }

    @Test
    void oneOfSeveralKindsIsChosenByItsName() {
        SceneSettings scene = new AcousticRange().describe();
        SettingsPath path = new SettingsPath("sensors.microphone.propagation");

        assertThat(path.read(path.write(scene, "energy-model"))).isEqualTo(EnergyModel.DEFAULT);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> path.write(scene, "energetic"))
                .withMessageContaining("'energetic'")
                .withMessageContaining("level-model, energy-model");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SettingsPath("drones.quadrotor.flight").write(scene, "orbit"))
                .withMessage(
                        "drones.quadrotor.flight=orbit: 'orbit' needs centre, radius, which can only be written in the scene file;"
                                + " the kinds"
                                + " are [hover, approach, inbound, waypoints, route, glide, orbit, terrain-following,"
                                + " low-approach, dive,"
                                + " pop-up, steered, recorded, mission, track]");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SettingsPath("drones.quadrotor.flight").write(scene, "obrit"))
                .withMessageStartingWith("drones.quadrotor.flight=obrit: 'obrit' is not one of [hover, approach, ")
                .withMessageEndingWith("]; did you mean 'orbit'?");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SettingsPath("drones.quadrotor.flight").write(scene, "zigzag"))
                .withMessageEndingWith("]; a kind from another jar needs that jar on the class path");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SettingsPath("drones.quadrotor.flight").write(scene, "{kind: orbit}"))
                .withMessageEndingWith("; settings in braces can only be written in the scene file");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "world.noise                    | 3       | no 'noise'    | backgroundNoise",
                "sensors.tall.fov               | 3       | no 'tall'     | wide, narrow, dice, more-dice",
                "sensors.wide.fov.deg           | 3       | no 'deg'      | single value",
                "sensors.wide.fov               | 0       | fov 0 deg   | 0.01 to 179 deg",
                "sensors.wide.fov               | 180 deg | fov 180 deg | 0.01 to 179 deg",
                "sensors.wide.fov               | 3 m     | '3 m'         | rad",
                "sensors.wide.width             | 0       | width 0 px    | 1 to 16384",
                "sensors.wide.width             | 12.5    | 12.5          | whole number",
                "sensors.wide.fovAxis           | round   | round         | vertical, horizontal",
                "sensors.wide.position          | 1, 2    | 1, 2          | must have 3: x, y, z",
                "world.noiseShape               | 40, 38  | 40, 38        | must have 8: hz63",
                "world.noiseShape.hz125         | loud    | loud          | dB",
                "sensors.wide                   | 1       | sensors.wide  | parts",
                "drones.comer.speed             | -5      | speed -5 m/s | 0.001 to 400",
                "drones.comer.speed             | NaN     | NaN           | number",
                "drones.crosser.flight.points.9.x | 1     | no '9'        | 0 to 1",
                "drones.crosser.flight.points.-1.x | 1    | no '-1'       | 0 to 1",
                "run.seed                       | x       | 'x'           | whole number",
                "world.models.0.scale           | -1      | scale -1    | 1e-6 to 1e6",
                "nothing                        | 1       | no 'nothing'  | world, drones, sensors, alert,"
                        + " prices, run, sweep",
                "''                             | 1       | no ''         | world",
                "sweep.parameter                | 1       | parameter     | not set",
            })
    void aMistakeIsNamedWithPathValueAndLimit(String path, String text, String what, String limit) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SettingsPath(path).write(settings, text))
                .withMessageContaining(path)
                .withMessageContaining(what)
                .withMessageContaining(limit);
    }

    /** Every single value of a whole site may be written where it stands, and then reads as before. */
    @Test
    void everyFieldIsReached() {
        for (Path file : List.of(Path.of("scenes/multi-sensor.yaml"), Path.of("scenes/hill-radar.yaml"))) {
            SceneSettings scene = new SceneFile(file).describe();
            List<String> paths = new ArrayList<>();
            collect(scene, "", paths);
            assertThat(paths).hasSizeGreaterThan(50);
            for (String path : paths) {
                SettingsPath setting = new SettingsPath(path);
                Object value = setting.read(scene);
                SceneSettings again = setting.write(scene, textOf(value));
                assertThat(setting.read(again)).as(path).isEqualTo(value);
                assertThat(again).as(path).isEqualTo(scene);
            }
        }
    }

    private static String textOf(Object value) {
        if (value instanceof Optional<?> optional) {
            return textOf(optional.orElseThrow());
        }
        return value instanceof List<?> list
                ? list.stream().map(Object::toString).collect(Collectors.joining(", "))
                : value.toString();
    }

    private static void collect(Object value, String path, List<String> paths) {
        if (value instanceof Optional<?> optional) {
            optional.ifPresent(inner -> collect(inner, path, paths));
        } else if (value instanceof Record settings) {
            String before = path.isEmpty() ? "" : path + ".";
            for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
                collect(SettingsForm.get(settings, part), before + part.getName(), paths);
            }
        } else if (value instanceof Map<?, ?> map) {
            map.forEach((name, inner) -> collect(inner, path + "." + name, paths));
        } else if (value instanceof List<?> list && !list.isEmpty() && list.get(0) instanceof Record) {
            for (int i = 0; i < list.size(); i++) {
                collect(list.get(i), path + "." + i, paths);
            }
        } else {
            paths.add(path);
        }
    }
}
