package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Imaging;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.RadioReceiving;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What holds for the settings of every registered kind of sensor, whatever it measures. */
class SensorKindsTest {
    private static final Position HERE = new Position(1, 2, 3);
    private static final Position THERE = new Position(-40, 50, 6);
    private static final Aim NORTH_EAST = new Aim.Direction(Math.PI / 4, 0.1);

    static Stream<SensorSettings<?>> everyKind() {
        return SensorKinds.all().keySet().stream().map(SensorKindsTest::byDefault);
    }

    private static SensorSettings<?> byDefault(String kind) {
        Class<?> type = SensorKinds.all().get(kind);
        Map<String, Object> known = Map.of("position", HERE, "budget", LinkBudget.DataSheet.of(1000.0, 1.0));
        Map<String, Object> values = new LinkedHashMap<>();
        SettingsForm form = SettingsForm.of(type);
        form.required().forEach(part -> values.put(part, known.get(part)));
        if (form.part("positioner").isPresent()) {
            values.put("positioner", Optional.of(PositionerSettings.DEFAULT.withCues("radar")));
        }
        return (SensorSettings<?>) form.create(values);
    }

    /** The components, by name, that differ. */
    private static List<String> changed(SensorSettings<?> before, SensorSettings<?> after) {
        assertThat(after.getClass()).isEqualTo(before.getClass());
        return SettingsForm.of(before.getClass()).parts().stream()
                .filter(part -> !get(before, part).equals(get(after, part)))
                .map(RecordComponent::getName)
                .toList();
    }

    private static Object get(SensorSettings<?> settings, RecordComponent part) {
        return SettingsForm.get((Record) settings, part);
    }

    @ParameterizedTest
    @MethodSource("everyKind")
    void anotherPositionChangesNothingElse(SensorSettings<?> settings) {
        SensorSettings<?> moved = settings.withPosition(THERE);

        assertThat(changed(settings, moved)).containsExactly("position");
        assertThat(moved.position()).isEqualTo(THERE);
        assertThat(settings.position()).isEqualTo(HERE);
        assertThat(moved.withPosition(HERE)).isEqualTo(settings);
    }

    @ParameterizedTest
    @MethodSource("everyKind")
    void anotherAimChangesNothingElse(SensorSettings<?> settings) {
        Optional<Aimed> aimed = settings.as(Aimed.class);

        assertThat(aimed.isPresent())
                .isEqualTo(SettingsForm.of(settings.getClass()).part("aim").isPresent());
        aimed.ifPresent(before -> {
            SensorSettings<?> after = before.withAim(NORTH_EAST);
            assertThat(changed(settings, after)).containsExactly("aim");
            assertThat(after.as(Aimed.class).orElseThrow().aim()).isEqualTo(NORTH_EAST);
        });
    }

    @ParameterizedTest
    @MethodSource("everyKind")
    void whatIsAimedAtAPointStaysAimedAtIt(SensorSettings<?> settings) {
        settings.as(Aimed.class).ifPresent(aimed -> {
            SensorSettings<?> fixed = aimed.withAim(new Aim.Target(THERE));
            assertThat(fixed.withPosition(new Position(9, 9, 9))
                            .as(Aimed.class)
                            .orElseThrow()
                            .aim())
                    .isEqualTo(new Aim.Target(THERE));
            assertThatIllegalArgumentException().isThrownBy(() -> fixed.withPosition(THERE));
        });
    }

    @ParameterizedTest
    @MethodSource("everyKind")
    void aPositionerPointsItsSensorAndNoOther(SensorSettings<?> settings) {
        Pointing pointing = Pointing.still(new Direction(1.0, 0.2), 0.3, OptionalInt.empty());
        SensorSettings<?> pointed = Mounted.pointed(settings, Optional.of(pointing));

        assertThat(Mounted.pointed(settings, Optional.empty())).isSameAs(settings);
        if (settings.as(Mounted.class).isPresent()) {
            assertThat(changed(settings, pointed)).containsExactlyInAnyOrder("aim", "fov", "positioner");
            assertThat(Mounted.positioner(pointed)).isEmpty();
        } else {
            assertThat(pointed).isSameAs(settings);
        }
    }

    @Test
    void capabilitiesOfTheKindsOfTheLibrary() {
        assertThat(having(Aimed.class)).containsExactly("camera", "radar", "rf", "thermal");
        assertThat(having(Mounted.class)).containsExactly("camera", "thermal");
        assertThat(having(Outlined.class)).containsExactly("camera", "acoustic", "radar", "thermal");
        assertThat(having(Imaging.class)).containsExactly("camera", "thermal");
        assertThat(having(DirectionFinding.class)).containsExactly("camera", "radar", "thermal");
        assertThat(having(RadioReceiving.class)).containsExactly("rf");
        assertThat(having(SoundTracing.class)).containsExactly("acoustic");
    }

    private static List<String> having(Class<?> capability) {
        return everyKind()
                .filter(settings -> settings.as(capability).isPresent())
                .map(SensorSettings::kind)
                .toList();
    }

    @Test
    void aMicrophonesBallIsNotAFieldOfView() {
        assertThat(Outlined.outline(byDefault("acoustic"))).containsInstanceOf(Outline.Ball.class);
        assertThat(Outlined.fieldOfView(byDefault("acoustic"), Optional.empty()))
                .isEmpty();
        assertThat(Outlined.fieldOfView(byDefault("rf"), Optional.empty())).isEmpty();
    }

    @Test
    void theFieldOfViewTurnsWithThePositioner() {
        SensorSettings<?> camera = CameraSettings.at(HERE).withPositioner(PositionerSettings.DEFAULT);
        Pointing east = Pointing.still(new Direction(Math.PI / 2, 0.0), 0.3, OptionalInt.empty());

        Outline own = Outlined.fieldOfView(camera, Optional.empty()).orElseThrow();
        Outline turned = Outlined.fieldOfView(camera, Optional.of(east)).orElseThrow();
        assertThat(own.contains(new Position(0, 10, 0))).isTrue();
        assertThat(turned.contains(new Position(0, 10, 0))).isFalse();
        assertThat(turned.contains(new Position(10, 0, 0))).isTrue();
    }

    @Test
    void aPictureHasRowsTimesColumnsOfPixels() {
        assertThat(CameraSettings.at(HERE)
                        .withResolution(640, 480)
                        .as(Imaging.class)
                        .orElseThrow()
                        .pixels())
                .isEqualTo(307_200);
    }
}
