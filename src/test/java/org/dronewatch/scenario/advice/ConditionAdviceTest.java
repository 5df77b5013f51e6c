package org.dronewatch.scenario.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RotorTones;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.DiceSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.Wind;
import org.dronewatch.world.Light;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ConditionAdviceTest {
    private static final Position HERE = new Position(0, 0, 150);
    private static final WorldSettings HILL = WorldSettings.of(ModelSettings.packaged("hill.obj"));
    private static final WorldSettings NIGHT =
            HILL.withLight(Light.DAY.withIlluminance(0.001).withVisibility(200));

    private static SceneSettings scene(WorldSettings world, SensorSettings<?>... sensors) {
        SceneSettings scene = SceneSettings.of(world);
        for (int i = 0; i < sensors.length; i++) {
            scene = scene.withSensor("s" + i, sensors[i]);
        }
        return scene;
    }

    private static List<String> advice(WorldSettings world, SensorSettings<?>... sensors) {
        return ConditionAdvice.of(List.of(scene(world, sensors)));
    }

    @Test
    void windDoesNothingToTheLevelModelOfSound() {
        WorldSettings windy = HILL.withAtmosphere(Atmosphere.STANDARD.withWind(Wind.CALM.withSpeed(5)));
        WorldSettings inversion = HILL.withAtmosphere(Atmosphere.STANDARD.withTemperatureGradient(0.05));
        AcousticSettings microphone = AcousticSettings.at(HERE);

        assertThat(advice(windy, microphone, CameraSettings.at(HERE), ThermalSettings.at(HERE)))
                .containsExactly("world.atmosphere.wind does not change what is detected by acoustic sensor 's0':"
                        + " 'propagation: energy-model' takes the air into account");
        assertThat(advice(inversion, microphone))
                .containsExactly(
                        "world.atmosphere.temperatureGradient does not change what is detected by acoustic sensor"
                                + " 's0': 'propagation: energy-model' takes the air into account");
        assertThat(advice(windy, microphone.withPropagation(EnergyModel.DEFAULT)))
                .isEmpty();
    }

    @Test
    void turbulenceAndDarkGroundDoNothingToCamerasThatCountPixels() {
        WorldSettings world = HILL.withLight(Light.DAY.withCn2(1e-13).withSkyToGroundRatio(5));
        CameraSettings deciding = CameraSettings.at(HERE).withDetection(TargetTask.DEFAULT);

        assertThat(advice(world, CameraSettings.at(HERE), deciding, ThermalSettings.at(HERE)))
                .containsExactly("world.light.cn2 1e-13 m^-2/3 and world.light.skyToGroundRatio 5 do not change what is"
                        + " detected by camera sensor 's0': 'detection: {kind: target-task}' takes light and weather into"
                        + " account");
    }

    @Test
    void nightAndFogDoNothingToCamerasThatCountPixels() {
        CameraSettings counting = CameraSettings.at(HERE);

        assertThat(advice(NIGHT, counting, counting, counting, counting))
                .containsExactly(
                        "world.light.visibility 200 m and world.light.illuminance 0.001 lx do not change what is detected by camera"
                                + " sensors 's0', 's1' and 2 more: 'detection: {kind: target-task}' takes light and weather into account");
        assertThat(advice(HILL.withLight(Light.DAY.withSun(new Light.Sun(1, 1))), counting))
                .containsExactly(
                        "world.light.sun does not change what is detected by camera sensor 's0': 'detection: {kind:"
                                + " target-task}' takes light and weather into account");
        assertThat(advice(HILL.withLight(Light.DAY.withContrastAtVisibility(0.02)), counting, counting))
                .singleElement()
                .asString()
                .startsWith(
                        "world.light.contrastAtVisibility 0.02 does not change what is detected by camera sensors 's0' and 's1': ");
    }

    @Test
    void whoHeedsAConditionIsNotNamed() {
        CameraSettings byTask = CameraSettings.at(HERE).withDetection(TargetTask.DEFAULT);
        RadarSettings radar = RadarSettings.at(HERE, LinkBudget.DataSheet.of(1000, 0.01));

        assertThat(advice(NIGHT, byTask, radar, RfSettings.at(HERE), AcousticSettings.at(HERE)))
                .isEmpty();
        assertThat(advice(NIGHT, byTask, CameraSettings.at(HERE)))
                .singleElement()
                .asString()
                .contains("camera sensor 's1': ");
        assertThat(advice(HILL.withRain(10), radar, RfSettings.at(HERE))).isEmpty();
    }

    @Test
    void rainAndAirAreHeededByWhoSaysSo() {
        AcousticSettings level = AcousticSettings.at(HERE);
        AcousticSettings energy = level.withPropagation(EnergyModel.DEFAULT);

        assertThat(advice(HILL.withRain(10), level, CameraSettings.at(HERE).withDetection(TargetTask.DEFAULT)))
                .containsExactly(
                        "world.rain 10 mm/h does not change what is detected by acoustic sensor 's0': raise world.backgroundNoise by the noise of"
                                + " the rain");
        assertThat(advice(HILL.withRain(10), CameraSettings.at(HERE)))
                .containsExactly(
                        "world.rain 10 mm/h does not change what is detected by camera sensor 's0': 'detection: {kind:"
                                + " target-task}' takes light and weather into account");
        WorldSettings cold = HILL.withAtmosphere(Atmosphere.STANDARD.withTemperature(263.15));
        assertThat(advice(cold, level, energy))
                .containsExactly(
                        "world.atmosphere does not change what is detected by acoustic sensor 's0': 'propagation: energy-model'"
                                + " takes the air into account");
        assertThat(advice(cold.withRain(1).withLight(NIGHT.light()), ThermalSettings.at(HERE)))
                .containsExactly(
                        "world.light.visibility 200 m, world.rain 1 mm/h and world.atmosphere do not change what is"
                                + " detected by thermal sensor 's0': set its 'transmission' for such weather");
    }

    @Test
    void theSoundOfADroneMattersOnlyToWhoHearsItsBands() {
        AcousticSettings level = AcousticSettings.at(HERE);
        AcousticSettings energy = level.withPropagation(EnergyModel.DEFAULT);
        AcousticSettings tonal =
                level.withPropagation(EnergyModel.DEFAULT.withCriterion(EnergyModel.Criterion.NARROW_BAND));
        DroneSettings drone =
                DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), FlightPathSettings.Hover.at(HERE));
        SceneSettings plain = scene(HILL, level, energy, tonal).withDrone("own", drone);

        assertThat(ConditionAdvice.of(List.of(plain))).isEmpty();
        assertThat(ConditionAdvice.of(List.of(plain.withDrone("own", drone.withTones(RotorTones.of(100))))))
                .containsExactly(
                        "drones.own.tones does not change what is detected by acoustic sensor 's0': 'propagation:"
                                + " energy-model' with 'criterion: narrow-band' uses tones",
                        "drones.own.tones does not change what is detected by acoustic sensor 's1': 'criterion:"
                                + " narrow-band' uses tones");
        assertThat(ConditionAdvice.of(List.of(plain.withDrone("own", drone.withSpectrum(BackgroundNoise.FALLING)))))
                .containsExactly("drones.own.spectrum does not change what is detected by acoustic sensor 's0':"
                        + " 'propagation: energy-model' takes the spectrum into account");
    }

    private static String ignored(SensorSettings<?> sensor, DroneSettings drone) {
        return String.join("; ", ConditionAdvice.of(List.of(scene(HILL, sensor).withDrone("own", drone))));
    }

    @Test
    void theLoudnessOfADroneMustBeStatedForTheModelThatHearsIt() {
        AcousticSettings level = AcousticSettings.at(HERE);
        AcousticSettings energy = level.withPropagation(EnergyModel.DEFAULT);
        DroneSettings drone =
                DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), FlightPathSettings.Hover.at(HERE));
        DroneSettings loud = SettingsForm.with(drone, "soundPowerLevel", 95.0);
        DroneSettings calibrated = drone.withSoundLevel(52);

        assertThat(ignored(level, loud))
                .isEqualTo("drones.own.soundPowerLevel does not change what is detected by acoustic sensor 's0':"
                        + " set the drone's soundLevel, which the level model uses");
        assertThat(ignored(energy, loud)).isEmpty();
        assertThat(ignored(energy, calibrated))
                .isEqualTo("drones.own.soundLevel does not change what is detected by acoustic sensor 's0':"
                        + " set the drone's soundPowerLevel, which the energy model uses");
        assertThat(ignored(level, calibrated)).isEmpty();
        DroneSettings forBoth = loud.withSoundLevel(52);
        assertThat(ignored(level, forBoth)).isEmpty();
        assertThat(ignored(energy, forBoth)).isEmpty();
    }

    @Test
    void theLevelModelHearsNeitherTheKindOfSoundNorItsDirection() {
        DroneSettings measured = DroneSettings.of(
                        ModelSettings.packaged("quadrotor.obj"), FlightPathSettings.Hover.at(HERE))
                .withSound(DroneSounds.get("m300"));

        assertThat(ignored(AcousticSettings.at(HERE), measured))
                .contains("drones.own.sound ", "drones.own.directivity", "drones.own.soundPowerLevel");
        assertThat(ignored(AcousticSettings.at(HERE).withPropagation(EnergyModel.DEFAULT), measured))
                .isEmpty();
    }

    @Test
    void aSoundOfItsOwnNeedsAMicrophone() {
        DroneSettings own = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), FlightPathSettings.Hover.at(HERE))
                .withSpectrum(BackgroundNoise.FALLING);
        PixelThreshold pixels = new PixelThreshold(12);

        assertThat(ignored(CameraSettings.at(HERE).withDetection(pixels), own.withTones(RotorTones.of(100))))
                .isEqualTo("drones.own.spectrum and drones.own.tones have no effect: the scene has no acoustic sensor");
        assertThat(ignored(CameraSettings.at(HERE).withDetection(pixels), own))
                .isEqualTo("drones.own.spectrum has no effect: the scene has no acoustic sensor");
    }

    @Test
    void turbulenceWithoutInterferenceIsSaidToHaveNoEffect() {
        EnergyModel still = EnergyModel.DEFAULT.withTurbulence(0);

        assertThat(AcousticSettings.at(HERE).withPropagation(still).advice())
                .containsExactly("turbulence has no effect without 'ground: coherent'");
        assertThat(AcousticSettings.at(HERE)
                        .withPropagation(still.withGround(EnergyModel.Ground.COHERENT))
                        .advice())
                .isEmpty();
        assertThat(AcousticSettings.at(HERE)
                        .withPropagation(EnergyModel.DEFAULT)
                        .advice())
                .isEmpty();
    }

    /** Of a kind that is not the library's nothing is known, so nothing is claimed. */
    @Test
    void aKindOfTheUsersOwnGetsNoWarning() {
        assertThat(advice(NIGHT.withRain(5), new DiceSettings(HERE, 0.5, 1.0))).isEmpty();
    }

    @Test
    void eachRunOfASweepCounts() {
        SceneSettings clear = scene(HILL, CameraSettings.at(HERE));
        SceneSettings fog = scene(NIGHT, CameraSettings.at(HERE));

        assertThat(ConditionAdvice.of(List.of(clear, fog, fog))).hasSize(1);
    }

    @Test
    void theRunnerNotesEachLineOnce() {
        List<String> notes = new ArrayList<>();
        SceneRunner runner = new SceneRunner(PackagedScene.find("camera-range")
                        .orElseThrow()
                        .factory()
                        .get())
                .notes(notes::add)
                .set("run.duration", "0.2")
                .set("world.light.illuminance", "0.01");
        runner.stage(runner.settingsOfRuns().get(0));
        assertThat(notes).as("a site to be drawn detects nothing").noneMatch(note -> note.startsWith("warning"));
        runner.adviseOnConditions();
        runner.run();

        assertThat(notes.stream().filter(note -> note.contains("does not change what is detected")))
                .containsExactly(
                        "warning: world.light.illuminance 0.01 lx does not change what is detected by camera sensor 'camera':"
                                + " 'detection: {kind: target-task}' takes light and weather into account");
    }

    static List<Scene> packagedScenes() {
        List<Scene> scenes = new ArrayList<>();
        PackagedScene.all().forEach(scene -> scenes.add(scene.factory().get()));
        for (String file : List.of("glider", "cued-camera", "hill-radar", "multi-sensor")) {
            scenes.add(new SceneFile(Path.of("scenes", file + ".yaml")));
        }
        return scenes;
    }

    @ParameterizedTest
    @MethodSource("packagedScenes")
    void thePackagedScenesGetNoWarning(Scene scene) {
        assertThat(ConditionAdvice.of(new SceneRunner(scene).settingsOfRuns())).isEmpty();
    }
}
